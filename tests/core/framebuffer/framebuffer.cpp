#include "core/framebuffer/framebuffer.hpp"

#include "core/base/named.hpp"
#include "tests/support/catch.hpp"

using namespace hs;

namespace {

scene::Settings small(scene::ColorFormat format) {
    scene::Settings settings;
    settings.width = 3;
    settings.height = 2;
    settings.background = {0.2F, 0.4F, 0.6F, 1.0F};
    settings.color_format = format;
    return settings;
}

} // namespace

TEST_CASE("a framebuffer is cleared to the background and the far depth", "[framebuffer]") {
    for (const Named<scene::ColorFormat>& format : names<scene::ColorFormat>()) {
        const framebuffer::Framebuffer target(small(format.value));
        INFO(format.name);
        for (int y = 0; y < 2; ++y) {
            for (int x = 0; x < 3; ++x) {
                CHECK(target.color({x, y}) == glm::vec4{0.2F, 0.4F, 0.6F, 1.0F});
                CHECK(target.depth({x, y}) == 1.0F);
            }
        }
    }
}

TEST_CASE("reversed depth is cleared to 0, and a chosen value wins", "[framebuffer]") {
    scene::Settings settings = small(scene::ColorFormat::rgba8);
    settings.depth_convention = scene::DepthConvention::reversed;
    CHECK(framebuffer::Framebuffer(settings).depth({0, 0}) == 0.0F);
    settings.depth_clear_choice = 0.25F;
    CHECK(framebuffer::Framebuffer(settings).depth({0, 0}) == 0.25F);
    settings.depth_format = scene::DepthFormat::unorm16;
    CHECK(framebuffer::Framebuffer(settings).depth({0, 0}) == 16384.0F / 65535.0F);
}

TEST_CASE("a pixel written changes no other", "[framebuffer]") {
    framebuffer::Framebuffer target(small(scene::ColorFormat::rgba32f));
    target.set_color({2, 1}, glm::vec4{0.5F});
    target.set_depth({0, 1}, 0.125F);
    CHECK(target.color({2, 1}) == glm::vec4{0.5F});
    CHECK(target.color({2, 0}) == glm::vec4{0.2F, 0.4F, 0.6F, 1.0F});
    CHECK(target.depth({0, 1}) == 0.125F);
    CHECK(target.depth({1, 1}) == 1.0F);
}

TEST_CASE("the digest changes with any bit of color or depth", "[framebuffer]") {
    for (const Named<scene::ColorFormat>& format : names<scene::ColorFormat>()) {
        framebuffer::Framebuffer target(small(format.value));
        const std::uint64_t cleared = target.digest();
        CHECK(framebuffer::Framebuffer(small(format.value)).digest() == cleared);
        target.set_depth({1, 1}, 0.99999994F);
        CHECK(target.digest() != cleared);
        target.set_depth({1, 1}, 1.0F);
        CHECK(target.digest() == cleared);
        target.set_color({0, 0}, glm::vec4{0.2F, 0.4F, 0.6F, 0.0F});
        CHECK(target.digest() != cleared);
    }
}
