// Every seeded fault is caught: a claim that holds without it fails with it. The claims are closed
// forms and symmetries; none is computed by the code it is about.
#include "core/pipeline/draw.hpp"
#include "core/scene/triangulate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/made_scene.hpp"
#include "tests/support/soup_scene.hpp"
#include "tests/support/triangle_soup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

using namespace hs;
using scene::Fault;

namespace {

constexpr PixelRect image{0, 0, 16, 12};
using Pixels = std::set<PixelPos>;

scene::Settings settings_with(Fault fault) {
    scene::Settings settings;
    settings.width = image.width();
    settings.height = image.height();
    settings.fault = fault;
    return settings;
}

/// Triangles in window pixels, at NDC depth `z` and w = 1.
tests::Soup in_window(const std::vector<glm::dvec2>& corners, float z = 0.0F) {
    tests::Soup soup;
    for (const glm::dvec2& corner : corners) {
        soup.push_back({tests::clip_at(corner, z, 1.0F, image)});
    }
    return soup;
}

Pixels covered(const tests::Soup& soup, const scene::Settings& settings) {
    const tests::Drawing drawing = tests::drawn(tests::soup_scene(soup, settings));
    Pixels pixels;
    for (std::size_t i = 0; i < drawing.covered.size(); ++i) {
        if (drawing.covered[i] > 0) {
            pixels.insert(drawing.pixel(i));
        }
    }
    return pixels;
}

/// How often each pixel is covered by a square of four triangles around a pixel center.
std::set<int> hits_in_square(Fault fault) {
    const glm::dvec2 hub{6.5, 5.5};
    const std::array<glm::dvec2, 4> ring{{{2.5, 1.5}, {10.5, 1.5}, {10.5, 9.5}, {2.5, 9.5}}};
    std::vector<glm::dvec2> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        corners.insert(corners.end(), {hub, ring[i], ring[(i + 1) % 4]});
    }
    scene::Settings settings = settings_with(fault);
    settings.visibility = scene::Visibility::none;
    const tests::Drawing drawing = tests::drawn(tests::soup_scene(in_window(corners), settings));
    std::set<int> hits;
    for (int y = 2; y < 9; ++y) { // strictly inside, so that only shared edges decide
        for (int x = 3; x < 10; ++x) {
            hits.insert(drawing.covered[static_cast<std::size_t>(y * image.width() + x)]);
        }
    }
    return hits;
}

// ---- claims

bool no_pixel_is_covered_twice(Fault fault) {
    return !hits_in_square(fault).contains(2);
}

bool no_pixel_is_left_out(Fault fault) {
    return !hits_in_square(fault).contains(0);
}

/// A right triangle with its vertices on pixel centers keeps its top and left edge.
bool top_and_left_edges_own_ties(Fault fault) {
    Pixels expected;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x + y < 4; ++x) {
            expected.insert({2 + x, 3 + y});
        }
    }
    const tests::Soup soup = in_window({{2.5, 3.5}, {2.5, 7.5}, {6.5, 3.5}});
    return covered(soup, settings_with(fault)) == expected;
}

/// Whether column 4 is covered by a triangle with a vertical left edge that many units of 1/256
/// pixel to the right of its centers.
bool covers_column_4(Fault fault, double units) {
    const double left = 4.5 + units / 256.0;
    const tests::Soup soup = in_window({{left, 0.0}, {left, 12.0}, {left + 9.0, 6.0}});
    return covered(soup, settings_with(fault)).contains({4, 6});
}

/// Half a unit rounds to 0, which is even, and the left edge owns the centers on it.
bool halves_round_to_even(Fault fault) {
    return covers_column_4(fault, 0.5);
}

/// Three quarters of a unit round to 1: the edge lies right of the centers.
bool snapping_rounds_to_nearest(Fault fault) {
    return !covers_column_4(fault, 0.75);
}

/// Pixels 4 to 9 have their centers between x = 4 and x = 10.
bool a_rectangle_covers_its_pixels(Fault fault) {
    const tests::Soup soup = in_window({{4, 2}, {4, 8}, {10, 8}, {4, 2}, {10, 8}, {10, 2}});
    Pixels expected;
    for (int y = 2; y < 8; ++y) {
        for (int x = 4; x < 10; ++x) {
            expected.insert({x, y});
        }
    }
    return covered(soup, settings_with(fault)) == expected;
}

/// Where two cross-ratios decide: a color that is 0 at w = 1 and 1 at w = 3 is ¼ halfway on screen.
bool halfway_on_screen_is_a_quarter_in_space(Fault fault) {
    const glm::vec4 black{0.0F, 0.0F, 0.0F, 1.0F};
    const glm::vec4 white{1.0F};
    const auto at = [](double x, double y, float w) {
        return tests::clip_at({x, y}, 0.0F, w, image);
    };
    const tests::Soup soup{
        {at(-0.5, 0.5, 1.0F), black}, {at(9.5, -20.0, 3.0F), white}, {at(9.5, 40.0, 3.0F), white}};
    scene::Settings settings = settings_with(fault);
    settings.color_format = scene::ColorFormat::rgba32f;
    const tests::Drawing drawing = tests::drawn(tests::soup_scene(soup, settings));
    return std::fabs(drawing.target.color({4, 6}).r - 0.25F) < 0.001F;
}

/// Clip coordinates name directions: (2x, 2y, 2z, 2w) is the same vertex as (x, y, z, w).
bool twice_a_clip_position_is_the_same_place(Fault fault) {
    tests::Soup soup = in_window({{3, 2}, {3, 9}, {12, 5}});
    const Pixels once = covered(soup, settings_with(fault));
    for (tests::Corner& corner : soup) {
        corner.clip *= 2.0F;
    }
    return covered(soup, settings_with(fault)) == once;
}

/// NDC [−1, 1]² is the whole image.
bool the_ndc_square_fills_the_image(Fault fault) {
    const tests::Soup soup{
        {{-1, -1, 0, 1}},
        {{1, -1, 0, 1}},
        {{1, 1, 0, 1}},
        {{-1, -1, 0, 1}},
        {{1, 1, 0, 1}},
        {{-1, 1, 0, 1}}};
    return covered(soup, settings_with(fault)).size() ==
           static_cast<std::size_t>(image.width() * image.height());
}

bool nothing_before_the_near_plane_is_drawn(Fault fault) {
    return covered(in_window({{3, 2}, {3, 9}, {12, 5}}, -1.5F), settings_with(fault)).empty();
}

/// Counterclockwise as seen with y up: down the left side in the window.
bool counterclockwise_triangles_show_their_front(Fault fault) {
    scene::Settings settings = settings_with(fault);
    settings.cull = scene::CullFace::back;
    const Pixels front = covered(in_window({{3, 2}, {3, 9}, {12, 5}}), settings);
    const Pixels back = covered(in_window({{3, 2}, {12, 5}, {3, 9}}), settings);
    return !front.empty() && back.empty();
}

/// Whichever is drawn first.
bool the_nearer_triangle_wins(Fault fault) {
    const std::vector<glm::dvec2> corners{{3, 2}, {3, 9}, {12, 5}};
    tests::Soup near = in_window(corners, -0.5F);
    tests::Soup far = in_window(corners, 0.5F);
    bool wins = true;
    for (const bool near_first : {true, false}) {
        tests::Soup soup = near_first ? near : far;
        const tests::Soup& second = near_first ? far : near;
        soup.insert(soup.end(), second.begin(), second.end());
        const auto scene = tests::soup_scene(soup, settings_with(fault));
        const tests::Drawing drawing = tests::drawn(scene);
        const auto at = static_cast<std::size_t>(5 * image.width() + 5);
        wins = wins && drawing.triangle[at] == (near_first ? 0 : 1);
    }
    return wins;
}

/// A plane through (1, 0, 0) and (0, 0, 1) parallel to y keeps facing its normal when the model
/// squashes x: n·l for light along the squashed plane's own normal is 1.
bool normals_stay_perpendicular(Fault fault) {
    auto scene = std::make_shared<scene::Scene>();
    scene->settings = settings_with(fault);
    scene->settings.shading = scene::Shading::gouraud;
    scene->settings.color_format = scene::ColorFormat::rgba32f;
    auto mesh = std::make_shared<scene::Mesh>();
    mesh->positions = {{1, -1, 0, 1}, {1, 1, 0, 1}, {0, 0, 1, 1}};
    mesh->normals.assign(3, glm::normalize(glm::vec3{1, 0, 1}));
    mesh->polygon_start = {0, 3};
    mesh->polygon_vertices = {0, 1, 2};
    scene::finish_mesh(*mesh);
    scene::Object& object = scene->objects.emplace_back();
    object.mesh = mesh;
    object.transform.push_back(
        {.kind = scene::TransformStep::Kind::scale, .vector = {0.25F, 1.0F, 1.0F}}
    );
    scene->lights.push_back({.to_light = {4.0F, 0.0F, 1.0F}}); // x/¼ + z = 1: normal (4, 0, 1)
    const pipeline::Frame frame(scene);
    const pipeline::VertexWork work = pipeline::run_vertex(frame.calls().front().vertex, 0);
    return std::fabs(work.terms->diffuse.r - 1.0F) < 0.001F;
}

bool the_target_is_seen_in_the_middle(Fault fault) {
    auto scene = std::make_shared<scene::Scene>();
    scene->settings = settings_with(fault);
    scene->camera.eye = {3.0F, 2.0F, 5.0F};
    scene->camera.target = {1.0F, 1.0F, -1.0F};
    auto mesh = std::make_shared<scene::Mesh>();
    mesh->positions = {glm::vec4{scene->camera.target, 1.0F}};
    scene::finish_mesh(*mesh);
    scene->objects.emplace_back().mesh = mesh;
    const pipeline::Frame frame(scene);
    const math::ClipPosition clip = pipeline::run_vertex(frame.calls().front().vertex, 0).clip;
    return clip.w > 0.0F && std::fabs(clip.x) < 1.0e-4F * clip.w &&
           std::fabs(clip.y) < 1.0e-4F * clip.w;
}

struct Claim {
    Fault fault; ///< that breaks it
    bool (*holds)(Fault);
};

constexpr Claim claims[] = {
    {Fault::ties_to_all, no_pixel_is_covered_twice},
    {Fault::ties_to_none, no_pixel_is_left_out},
    {Fault::ties_to_bottom_right, top_and_left_edges_own_ties},
    {Fault::half_up_rounding, halves_round_to_even},
    {Fault::floor_snapping, snapping_rounds_to_nearest},
    {Fault::increment_before_test, a_rectangle_covers_its_pixels},
    {Fault::affine_interpolation, halfway_on_screen_is_a_quarter_in_space},
    {Fault::no_divide, twice_a_clip_position_is_the_same_place},
    {Fault::viewport_without_parentheses, the_ndc_square_fills_the_image},
    {Fault::near_plane_forgotten, nothing_before_the_near_plane_is_drawn},
    {Fault::reversed_winding, counterclockwise_triangles_show_their_front},
    {Fault::inverted_depth_test, the_nearer_triangle_wins},
    {Fault::normals_like_points, normals_stay_perpendicular},
    {Fault::camera_not_inverted, the_target_is_seen_in_the_middle},
};

} // namespace

TEST_CASE("a pipeline without faults keeps every claim", "[property][fault]") {
    for (const Claim& claim : claims) {
        INFO("the claim that breaks with " << name_of(claim.fault));
        CHECK(claim.holds(Fault::none));
    }
}

TEST_CASE("every seeded fault breaks the claim made against it", "[property][fault]") {
    std::set<Fault> caught{Fault::none};
    for (const Claim& claim : claims) {
        INFO(name_of(claim.fault));
        CHECK_FALSE(claim.holds(claim.fault));
        caught.insert(claim.fault);
    }
    CHECK(caught.size() == names<Fault>().size());
}

TEST_CASE("a fault changes nothing but what it is about", "[property][fault]") {
    // Clip positions with w = 1 off every tie, unlit and without perspective
    const tests::Soup soup = in_window({{3.2, 2.1}, {3.4, 9.3}, {12.7, 5.2}});
    const Pixels right = covered(soup, settings_with(Fault::none));
    for (const Fault fault :
         {Fault::ties_to_all,
          Fault::ties_to_none,
          Fault::ties_to_bottom_right,
          Fault::no_divide,
          Fault::half_up_rounding,
          Fault::affine_interpolation,
          Fault::near_plane_forgotten,
          Fault::reversed_winding,
          Fault::normals_like_points}) {
        INFO(name_of(fault));
        CHECK(covered(soup, settings_with(fault)) == right);
    }
}
