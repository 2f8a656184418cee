#include "app/viewer/beside.hpp"

#include "app/viewer/setting_text.hpp"
#include "core/scene/scene_entry.hpp"

#include <fmt/format.h>

#include <utility>

namespace hs::viewer {
namespace {

/// A choice is a word, with or without TOML's quotes; everything else is a number, a truth or a
/// list.
scene::SettingValue value_of(const std::string& text) {
    if (std::optional<scene::SettingValue> value = parse_setting_text(text)) {
        return *value;
    }
    const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    scene::SettingValue word;
    word.value.emplace<std::string>(quoted ? text.substr(1, text.size() - 2) : text);
    return word;
}

std::optional<std::string> apply(scene::Scene& scene, const scene::Assignment& change) {
    if (scene::is_scene_entry(change.path)) {
        return scene::change_entry(scene, change);
    }
    const std::optional<std::string> complaint =
        scene::assign(scene.settings, change.path, value_of(change.value));
    return complaint ? complaint : scene::check_combination(scene.settings);
}

} // namespace

std::optional<std::string> Beside::ask(const scene::Assignment& change) {
    if (change.path == "size") {
        return "a picture of another size cannot stand beside this one pixel by pixel";
    }
    if (!scene::is_scene_entry(change.path)) {
        scene::Settings trial;
        const scene::SettingValue value = value_of(change.value);
        if (std::optional<std::string> complaint = scene::assign(trial, change.path, value)) {
            return complaint;
        }
    }
    change_ = change;
    source_.reset();
    return std::nullopt;
}

void Beside::close() {
    change_.reset();
    source_.reset();
    complaint_.clear();
    document_.close();
}

std::shared_ptr<const scene::Scene> Beside::take_work(const Document& main) {
    const bool tried = source_ == main.player().shared_recording();
    if (!change_ || (tried && (document_.is_open() || !complaint_.empty()))) {
        return nullptr;
    }
    source_ = main.player().shared_recording();
    document_.close();
    auto changed = std::make_shared<scene::Scene>(main.scene());
    const std::optional<std::string> complaint = apply(*changed, *change_);
    complaint_ = complaint.value_or("");
    return complaint ? nullptr : changed;
}

void Beside::receive(Opened opened, const Document& main) {
    if (opened.cancelled) {
        close();
    } else if (!change_ || source_ != main.player().shared_recording()) {
        return; // another recording came meanwhile: the next one is made beside that
    } else if (!opened.problems.empty()) {
        complaint_ = opened.problems.front().to_string();
    } else {
        document_.show(std::move(opened.recording));
        difference_ = std::move(opened.difference);
        followed_.reset();
    }
}

bool Beside::is_beside(const Document& main) const {
    return document_.is_open() && main.is_open() && source_ == main.player().shared_recording();
}

void Beside::follow(const Document& main, bool by_count) {
    const trace::Step& step = main.player().current();
    if (followed_ == step.id && by_count_ == by_count) {
        return;
    }
    const trace::Recording& other = document_.recording();
    const trace::Counterpart there =
        by_count ? trace::counterpart_by_count(other, main.recording(), step)
                 : trace::counterpart(other, step);
    document_.player().seek(there.step);
    match_ = there.match;
    followed_ = step.id;
    by_count_ = by_count;
}

} // namespace hs::viewer
