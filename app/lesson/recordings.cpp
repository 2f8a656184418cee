#include "app/lesson/recordings.hpp"

namespace hs::lesson {

namespace {

RecordingCache::Entry record(const SceneChoice& choice) {
    Result<scene::Scene> scene = scene::load_scene(choice.file, choice.assignments);
    if (!scene) {
        return scene.diagnostics();
    }
    return trace::record(std::make_shared<const scene::Scene>(std::move(*scene)));
}

} // namespace

const RecordingCache::Entry& RecordingCache::get(const SceneChoice& choice) {
    std::string key = choice.file.string();
    for (const scene::Assignment& assignment : choice.assignments) {
        key.append("\n").append(assignment.path).append("=").append(assignment.value);
    }
    const auto known = entries_.find(key);
    return known != entries_.end() ? known->second
                                   : entries_.emplace(std::move(key), record(choice)).first->second;
}

} // namespace hs::lesson
