// The frames a lesson needs, each recorded once.
#pragma once

#include "app/lesson/lesson.hpp"
#include "core/trace/recording.hpp"

#include <map>
#include <memory>
#include <string>

namespace hs::lesson {

class RecordingCache {
public:
    using Entry = Result<std::shared_ptr<const trace::Recording>>;

    /// The frame of a scene with changes; errors as the scene's loader gives them.
    const Entry& get(const SceneChoice& choice);

private:
    std::map<std::string, Entry> entries_;
};

} // namespace hs::lesson
