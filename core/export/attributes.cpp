#include "core/export/attributes.hpp"

#include "core/base/version.hpp"

#include <fmt/format.h>

namespace hs::exporting {

Attributes attributes_of(const scene::Scene& scene) {
    Attributes attributes{
        {"halfspace:version", std::string{program_version()}}, {"halfspace:scene", scene.name}};
    for (const scene::SettingInfo& info : scene::setting_infos()) {
        attributes.emplace_back(
            fmt::format("halfspace:settings.{}", info.key),
            scene::print_setting(scene.settings, info.key)
        );
    }
    return attributes;
}

Attributes attributes_of(const trace::Player& player) {
    Attributes attributes = attributes_of(player.recording().scene());
    attributes.emplace_back("halfspace:step", trace::step_path(player.current()));
    attributes.emplace_back("halfspace:step_number", fmt::format("#{}", player.step()));
    return attributes;
}

} // namespace hs::exporting
