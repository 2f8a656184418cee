// The space view: where things are drawn, how they are framed, and the way to NDC.
#include "app/viewer/space_drawing.hpp"
#include "tests/app/window.hpp"
#include "tests/support/catch.hpp"

#include <cmath>

using namespace hs;
using test::Window;
using viewer::Key;
using viewer::Space;

namespace {

constexpr std::string_view far_away = R"(
name = "a far plane far away"
[settings]
size = [16, 16]
[camera]
eye = [0, 0, 3]
target = [0, 0, 0]
projection = { kind = "perspective", fov_y = 60, near = 1, far = 10000 }
[[object]]
name = "triangle"
vertices = [[-1, -1, 0], [1, -1, 0], [0, 1, -1]]
polygons = [[0, 1, 2]]
)";

std::unique_ptr<Window> with_far_plane() {
    auto window = std::make_unique<Window>();
    window->viewer.set_recording(test::record_text(far_away));
    window->settle();
    return window;
}

} // namespace

TEST_CASE("a distant far plane does not shrink the meshes", "[app]") {
    const auto window = with_far_plane();
    viewer::SpaceLines lines;
    for (const Space space : {Space::world, Space::eye, Space::clip}) {
        viewer::SpaceView view = window->state().space;
        viewer::show_space(view, space);
        view.area = {0.0F, 0.0F, 300.0F, 300.0F};
        lines.update(window->viewer.document(), view);
        float left = 1.0e9F;
        float right = -1.0e9F;
        for (const auto& edge : lines.edges()) {
            for (const ImVec2 end : edge) {
                left = std::min(left, end.x);
                right = std::max(right, end.x);
                CHECK((end.x >= 0.0F && end.x < 300.0F && end.y >= 0.0F && end.y < 300.0F));
            }
        }
        INFO(name_of(space));
        CHECK(right - left > 40.0F);
    }
}

TEST_CASE("all of a visible triangle is in the picture, all the way to NDC", "[app]") {
    constexpr std::string_view deep = R"(
[settings]
size = [16, 16]
[camera]
eye = [0, 0, 0]
target = [0, 0, -1]
projection = { kind = "perspective", fov_y = 60, near = 1, far = 1000 }
[[object]]
name = "triangle"
vertices = [[-0.5, -0.5, -2], [0.5, -0.5, -2], [0, 3, -30]]
polygons = [[0, 1, 2]]
)";
    Window window;
    window.viewer.set_recording(test::record_text(deep));
    viewer::SpaceLines lines;
    viewer::SpaceView view;
    view.area = {0.0F, 0.0F, 300.0F, 300.0F};
    for (int quarter = 0; quarter <= 8; ++quarter) {
        const float morph = static_cast<float>(quarter) * 0.25F;
        for (const bool side : {false, true}) {
            viewer::set_morph(view, morph);
            view.side = side;
            lines.update(window.viewer.document(), view);
            INFO(morph << (side ? " from the side" : ""));
            REQUIRE(lines.edges().size() == 3);
            for (const auto& edge : lines.edges()) {
                for (const ImVec2 end : edge) {
                    CHECK((end.x >= 0.0F && end.x < 300.0F && end.y >= 0.0F && end.y < 300.0F));
                }
            }
        }
    }
}

TEST_CASE("in NDC the view volume is the cube, wherever the far plane lies", "[app]") {
    const auto window = with_far_plane();
    viewer::SpaceView view;
    viewer::show_space(view, Space::ndc);
    const trace::Recording& recording = window->viewer.document().recording();
    const viewer::SpaceMap map{recording, view, 0};
    const auto volume = viewer::view_volume(recording);
    REQUIRE(volume);
    CHECK(volume->near_distance == Approx(1.0));
    CHECK(volume->far_distance == Approx(10000.0).epsilon(1.0e-3)); // as the matrix says in float
    for (const glm::vec3& corner : volume->near) {
        const auto place = map.of_eye(corner);
        REQUIRE(place);
        CHECK(std::fabs(place->x) == Approx(1.0));
        CHECK(std::fabs(place->y) == Approx(1.0));
        CHECK(place->z == Approx(1.0)); // drawn nearer than the far plane
    }
    for (const glm::vec3& corner : volume->far) {
        const auto place = map.of_eye(corner);
        REQUIRE(place);
        CHECK(place->z == Approx(-1.0).epsilon(1.0e-3));
    }
}

TEST_CASE("sections lie at round distances between near and far, equally spaced", "[app]") {
    const auto window = with_far_plane();
    const auto volume = viewer::view_volume(window->viewer.document().recording());
    REQUIRE(volume);
    const std::vector<float> distances = viewer::section_distances(*volume, 6.0F, 40);
    REQUIRE(distances.size() == 40);
    CHECK(distances.front() > volume->near_distance);
    CHECK(distances[1] - distances[0] == Approx(1.0));
    for (std::size_t i = 2; i < distances.size(); ++i) {
        CHECK(distances[i] - distances[i - 1] == Approx(1.0));
    }
    CHECK(viewer::section_distances(*volume, 10000.0F, 40).back() < 10000.0F);
}

TEST_CASE("M morphs from the pyramid of view to NDC and back, and comes to rest", "[app]") {
    const auto window = with_far_plane();
    window->viewer.state().space.space = Space::world;
    window->host.key({.key = Key::m});
    window->host.frame(window->viewer);
    window->host.frame(window->viewer);
    CHECK(window->viewer.moving());
    CHECK(window->viewer.wants_frames());
    CHECK(window->state().space.morph < 1.0F);
    window->settle();
    CHECK_FALSE(window->viewer.moving());
    CHECK(window->state().space.morph == 2.0F);
    CHECK(window->state().space.space == Space::ndc);
    window->key(Key::m);
    CHECK(window->state().space.morph == 0.0F);
    CHECK(window->state().space.space == Space::eye);
}

TEST_CASE("a space set from outside is stood in at once", "[app]") {
    const auto window = with_far_plane();
    for (const Space space : {Space::ndc, Space::eye, Space::clip, Space::world, Space::ndc}) {
        window->viewer.state().space.space = space;
        window->settle();
        CHECK(window->state().space.space == space);
        if (viewer::is_on_the_way(space)) {
            const int station = static_cast<int>(space) - static_cast<int>(Space::eye);
            CHECK(window->state().space.morph == static_cast<float>(station));
        }
    }
}

TEST_CASE("dragging the slider stops between the stations", "[app]") {
    const auto window = with_far_plane();
    const viewer::Rect& area = window->state().space.area;
    const ImVec2 middle{area.x + area.width * 0.45F, area.y - 16.0F}; // the slider's row
    window->click(middle);
    CHECK(window->state().space.morph > 0.0F);
    CHECK(window->state().space.morph < 2.0F);
    CHECK(viewer::is_on_the_way(window->state().space.space));
    CHECK(window->host.cut_text().empty());
}

TEST_CASE("from the side, distance runs to the right and nothing turns", "[app]") {
    const auto window = with_far_plane();
    window->viewer.state().space.space = Space::eye;
    window->viewer.state().space.side = true;
    window->settle();
    viewer::SpaceLines lines;
    const viewer::SpaceView view = window->state().space;
    lines.update(window->viewer.document(), view);
    const auto near = lines.camera().project({0.5F, 0.0F, -1.0F});
    const auto far = lines.camera().project({-0.5F, 0.0F, -2.0F});
    const auto above = lines.camera().project({0.0F, 1.0F, -1.0F});
    REQUIRE((near && far && above));
    CHECK(far->x > near->x);
    CHECK(far->y == Approx(near->y));
    CHECK(above->x == Approx(near->x));
    CHECK(above->y < near->y);
    const ImVec2 at{view.area.x + 40.0F, view.area.y + 40.0F};
    window->host.move_mouse(at.x, at.y);
    window->host.press(host::MouseButton::left);
    window->host.move_mouse(at.x + 60.0F, at.y + 30.0F);
    window->host.release(host::MouseButton::left);
    window->settle();
    CHECK(window->state().space.yaw == view.yaw);
}
