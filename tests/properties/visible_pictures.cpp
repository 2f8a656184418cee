// Whole frames: algorithms that cut what they cannot order show what a z-buffer shows.
//
// They may differ where two surfaces are as good as equally deep, and along edges: a cut puts a new
// corner on an edge that the neighbor keeps straight, and both are snapped to 1/256 pixel; an
// octree also where it says itself that a leaf is undecided.
#include "core/pipeline/window_polygons.hpp"
#include "core/scene/scene_file.hpp"
#include "core/trace/detail.hpp"
#include "core/trace/history.hpp"
#include "core/trace/recording.hpp"
#include "core/trace/visibility_comparison.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_scene.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

using namespace hs;
using scene::Visibility;

namespace {

std::shared_ptr<const trace::Recording> recorded(const scene::Scene& scene) {
    auto recording = trace::record(std::make_shared<scene::Scene>(scene));
    REQUIRE(recording);
    return *recording;
}

/// Triangles anywhere in and around the view volume of a perspective camera, which cross and touch.
scene::Scene crossing_scene(std::uint64_t seed) {
    scene::Scene scene = *tests::random_scene(seed);
    scene.settings = {};
    scene.settings.width = 24;
    scene.settings.height = 24;
    scene.camera.projection.kind = scene::ProjectionKind::perspective;
    for (scene::Object& object : scene.objects) {
        auto mesh = std::make_shared<scene::Mesh>(*object.mesh);
        for (glm::vec4& position : mesh->positions) {
            const float far_out = std::max(1.0F, std::fabs(position.x) / 4.0F);
            position = {position.x / far_out, position.y, position.z, 1.0F};
        }
        object.mesh = mesh;
        object.overrides.clear();
        object.material.reset();
    }
    return scene;
}

/// Distance of a point from a segment, in pixels.
double distance_from_edge(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double length = glm::dot(along, along);
    const double t = length == 0.0 ? 0.0 : std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0);
    return glm::length(p - (a + t * along));
}

/// Whether a pixel's center lies within a hair of an edge of any piece of a triangle.
bool near_an_edge(const trace::Recording& recording, std::uint32_t triangle, PixelPos pixel) {
    constexpr double hair = 3.0 / 256.0;
    const std::uint32_t object = recording.object_of_triangle(triangle);
    const std::uint32_t own = triangle - recording.objects[object].first_triangle;
    const glm::dvec2 center{pixel.x + 0.5, pixel.y + 0.5};
    for (const trace::PieceDetail& piece : trace::triangle_detail(recording, object, own).pieces) {
        std::array<glm::dvec2, 3> corners;
        for (unsigned k = 0; k < 3; ++k) {
            corners[k] = glm::dvec2{glm::vec2{piece.window[k].window.x, piece.window[k].window.y}};
        }
        for (unsigned k = 0; k < 3; ++k) {
            if (distance_from_edge(center, corners[k], corners[(k + 1) % 3]) < hair) {
                return true;
            }
        }
    }
    return false;
}

/// How much depth changes per pixel, by triangle.
using Slopes = std::map<std::uint32_t, double>;

Slopes depth_slopes(const pipeline::Frame& frame) {
    Slopes slopes;
    for (const auto& polygon : pipeline::window_polygons(frame).polygons) {
        const glm::dvec3 origin = polygon.corners.front().position;
        glm::dvec3 normal{0.0};
        for (std::size_t i = 1; i + 1 < polygon.corners.size(); ++i) {
            normal += glm::cross(
                polygon.corners[i].position - origin, polygon.corners[i + 1].position - origin
            );
        }
        slopes[polygon.triangle] =
            (std::fabs(normal.x) + std::fabs(normal.y)) / std::fabs(normal.z);
    }
    return slopes;
}

/// Whether something else is as good as equally deep at a pixel as what the z-buffer shows there:
/// moving both by 1/256 pixel, as snapping may, could exchange them.
bool is_tie(const trace::Recording& reference, PixelPos pixel, const Slopes& slopes) {
    constexpr double rounding = 4.0e-7; // of depths themselves
    constexpr double snapping = 1.0 / 256.0;
    const auto slope = [&slopes](std::uint32_t triangle) {
        const auto found = slopes.find(triangle);
        return found == slopes.end() ? 0.0 : found->second;
    };
    const trace::PixelHistory history = trace::pixel_history(reference, pixel);
    const double shown = slope(reference.final_pixels[pixel].triangle);
    const auto close =
        std::count_if(history.rows.begin(), history.rows.end(), [&](const trace::HistoryRow& row) {
            const double apart = std::fabs(static_cast<double>(row.depth - history.final_depth));
            return apart <= rounding + snapping * (shown + slope(row.frame_triangle));
        });
    return close > 1;
}

/// Whether the algorithm said that it cannot tell which of two triangles is in front.
bool is_undecided(const trace::Recording& painted, std::uint32_t a, std::uint32_t b) {
    const std::size_t count = painted.decisions.size();
    for (std::size_t i = 0; i < count; ++i) {
        const visibility::OrderEvent& event = painted.decisions[i];
        if (event.kind != visibility::OrderEventKind::undecided) {
            continue;
        }
        const auto& polygons = painted.order.polygons;
        const std::uint32_t taken = polygons[static_cast<std::size_t>(event.polygon)].triangle;
        if (taken == a || taken == b) {
            return true;
        }
    }
    return false;
}

bool may_differ(
    const trace::Recording& painted,
    const trace::Recording& reference,
    PixelPos p,
    const Slopes& slopes
) {
    const std::uint32_t shown = painted.final_pixels[p].triangle;
    if (is_tie(reference, p, slopes) ||
        is_undecided(painted, shown, reference.final_pixels[p].triangle)) {
        return true;
    }
    for (const trace::Recording* recording : {&painted, &reference}) {
        for (const trace::HistoryRow& row : trace::pixel_history(*recording, p).rows) {
            if (near_an_edge(painted, row.frame_triangle, p) ||
                near_an_edge(reference, row.frame_triangle, p)) {
                return true;
            }
        }
    }
    return false;
}

/// Two fragments of the z-buffer that are equally deep but for rounding, or a pixel center that
/// lies exactly on an edge: there the order of the file or of rounding decides.
bool is_exact_tie(const trace::Recording& reference, PixelPos pixel) {
    constexpr double rounding = 4.0e-7;
    const trace::PixelHistory history = trace::pixel_history(reference, pixel);
    const auto close =
        std::count_if(history.rows.begin(), history.rows.end(), [&](const trace::HistoryRow& row) {
            return std::fabs(static_cast<double>(row.depth - history.final_depth)) <= rounding;
        });
    if (close > 1) {
        return true;
    }
    for (std::uint32_t t = 0; t < reference.triangles.size(); ++t) {
        const std::uint32_t object = reference.object_of_triangle(t);
        const auto detail =
            trace::triangle_detail(reference, object, t - reference.objects[object].first_triangle);
        for (const trace::PieceDetail& piece : detail.pieces) {
            const raster::EdgeValues e =
                piece.setup ? piece.setup->evaluate(pixel) : raster::EdgeValues{1, 1, 1};
            if (std::ranges::find(e, 0) != e.end()) {
                return true;
            }
        }
    }
    return false;
}

/// The same scene with whatever scanlines do not ignore.
scene::Scene swept_scene(std::uint64_t seed) {
    scene::Scene scene = crossing_scene(seed);
    scene.settings.depth_convention = static_cast<scene::DepthConvention>(seed % 3);
    scene.settings.cull = static_cast<scene::CullFace>(seed / 3 % 3);
    scene.settings.shading = static_cast<scene::Shading>(seed / 9 % 4);
    scene.settings.interpolation = static_cast<scene::InterpolationKind>(seed / 5 % 3);
    scene.settings.guard_band = seed % 4 == 0 ? 2.5F : 1.0F;
    if (seed % 5 == 0) {
        scene.settings.viewport_choice = PixelRect{3, 5, 20, 21};
    }
    if (seed % 7 == 0) {
        scene.settings.scissor = PixelRect{2, 2, 15, 17};
    }
    return scene;
}

/// The largest difference of a channel, in 1/255.
int color_difference(framebuffer::Rgba8 a, framebuffer::Rgba8 b) {
    int largest = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        const int left = static_cast<int>(a >> shift & 0xFFU);
        const int right = static_cast<int>(b >> shift & 0xFFU);
        largest = std::max(largest, std::abs(left - right));
    }
    return largest;
}

} // namespace

TEST_CASE("scanlines show what a z-buffer shows, to the bit", "[property][visibility]") {
    for (const Visibility visibility : {Visibility::scanline, Visibility::scanline_z}) {
        int agreeing = 0;
        int excused = 0;
        int colored = 0;
        for (std::uint64_t seed = 0; seed < 90; ++seed) {
            scene::Scene scene = swept_scene(seed);
            const auto reference = recorded(scene);
            scene.settings.visibility = visibility;
            const auto swept = recorded(scene);
            swept->final_pixels.for_each([&](PixelPos p, const trace::PixelRecord& pixel) {
                const trace::PixelRecord& expected = reference->final_pixels[p];
                if (pixel.triangle == expected.triangle) {
                    ++agreeing;
                    colored += pixel.color == expected.color ? 0 : 1;
                    return;
                }
                ++excused;
                INFO(name_of(visibility) << ", seed " << seed << ", " << p.x << ',' << p.y);
                CHECK(is_exact_tie(*reference, p));
            });
        }
        INFO(name_of(visibility) << ": " << excused << " excused of " << agreeing);
        CHECK(colored == 0);
        CHECK(excused * 50 < agreeing);
    }
}

TEST_CASE("rays show what a z-buffer shows", "[property][visibility]") {
    int agreeing = 0;
    int excused = 0;
    int colored = 0;
    for (std::uint64_t seed = 0; seed < 90; ++seed) {
        scene::Scene scene = swept_scene(seed);
        if (scene.settings.interpolation == scene::InterpolationKind::linear) {
            // Of a clipped triangle a z-buffer interpolates each piece by itself
            scene.settings.interpolation = scene::InterpolationKind::perspective;
        }
        const auto reference = recorded(scene);
        const Slopes slopes = depth_slopes(*reference->frame);
        scene.settings.visibility = Visibility::ray_cast;
        const auto cast = recorded(scene);
        cast->final_pixels.for_each([&](PixelPos p, const trace::PixelRecord& pixel) {
            const trace::PixelRecord& expected = reference->final_pixels[p];
            if (pixel.triangle == expected.triangle) {
                ++agreeing;
                colored += color_difference(pixel.color, expected.color) <= 1 ? 0 : 1;
                return;
            }
            ++excused;
            INFO("seed " << seed << ", " << p.x << ',' << p.y);
            CHECK(may_differ(*cast, *reference, p, slopes));
        });
    }
    INFO(excused << " excused, " << colored << " colored otherwise of " << agreeing);
    CHECK(excused * 50 < agreeing);
    CHECK(colored == 0); // snapping moves a triangle, and its colors by less than shows
}

TEST_CASE("a pixel of a scanline or ray has one fragment", "[property][visibility]") {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        scene::Scene scene = swept_scene(seed);
        scene.settings.visibility =
            static_cast<Visibility>(static_cast<std::uint64_t>(Visibility::scanline) + seed % 3);
        const auto recording = recorded(scene);
        recording->final_pixels.for_each([&](PixelPos p, const trace::PixelRecord& pixel) {
            INFO("seed " << seed << ", pixel " << p.x << ',' << p.y);
            REQUIRE(pixel.complexity <= 1);
        });
    }
}

TEST_CASE("what cuts triangles shows what a z-buffer shows", "[property][visibility]") {
    for (const Visibility visibility :
         {Visibility::newell_sancha, Visibility::bsp, Visibility::octree}) {
        std::size_t parts = 0;
        int agreeing = 0;
        int excused = 0;
        for (std::uint64_t seed = 0; seed < 50; ++seed) {
            scene::Scene scene = crossing_scene(seed);
            const auto reference = recorded(scene);
            const Slopes slopes = depth_slopes(*reference->frame);
            scene.settings.visibility = visibility;
            scene.settings.bsp_splitter = static_cast<scene::BspSplitter>(seed % 3);
            scene.settings.bsp_order = static_cast<scene::BspOrder>(seed / 3 % 2);
            const auto painted = recorded(scene);
            parts += painted->order.parts.size();
            painted->final_pixels.for_each([&](PixelPos p, const trace::PixelRecord& pixel) {
                if (pixel.triangle == reference->final_pixels[p].triangle) {
                    ++agreeing;
                    return;
                }
                ++excused;
                INFO(name_of(visibility) << ", seed " << seed << ", " << p.x << ',' << p.y);
                CHECK(may_differ(*painted, *reference, p, slopes));
            });
        }
        INFO(name_of(visibility) << ": " << parts << " parts, " << excused << " excused");
        CHECK(parts > 100);
        // Copies of a triangle and coplanar ones tie all over; an octree leaves leaves undecided
        const int share = visibility == Visibility::octree ? 10 : 100;
        CHECK(excused * share < agreeing);
    }
}

TEST_CASE("cycles and crossings are drawn right by whatever cuts", "[visibility]") {
    for (const char* const name :
         {"three-triangle-cycle.toml", "crossing-triangles.toml", "long-and-short.toml"}) {
        const auto loaded = scene::load_scene(test::source_dir() / "lessons/scenes" / name);
        REQUIRE(loaded);
        for (const trace::VisibilityOutcome& outcome : trace::compare_visibility(*loaded)) {
            INFO(name << ", " << name_of(outcome.visibility));
            CHECK(outcome.refusal.empty());
            if (outcome.visibility >= Visibility::newell_sancha) { // or decides pixel by pixel
                CHECK(outcome.from_z_buffer.pixels <= 2);          // on the line they cross in
            }
        }
    }
}

TEST_CASE("front to back every pixel is written once", "[property][visibility]") {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        scene::Scene scene = crossing_scene(seed);
        scene.settings.visibility = seed % 2 == 0 ? Visibility::octree : Visibility::bsp;
        scene.settings.bsp_order = scene::BspOrder::front_to_back;
        const auto recording = recorded(scene);
        recording->final_pixels.for_each([&](PixelPos p, const trace::PixelRecord& pixel) {
            INFO("seed " << seed << ", pixel " << p.x << ',' << p.y);
            REQUIRE(pixel.overdraw == (pixel.complexity > 0 ? 1 : 0));
        });
    }
}

TEST_CASE("front lists leave out exactly what they name as stuck", "[visibility]") {
    auto loaded =
        scene::load_scene(test::source_dir() / "lessons/scenes/three-triangle-cycle.toml");
    REQUIRE(loaded);
    loaded->settings.visibility = Visibility::front_lists;
    const auto recording = recorded(*loaded);
    using visibility::OrderEventKind;
    CHECK(recording->counters.decisions[static_cast<std::size_t>(OrderEventKind::stuck)] == 3);
    for (const trace::TriangleRecord& triangle : recording->triangles) {
        CHECK(triangle.verdict == geometry::TriangleVerdict::stuck);
    }
    CHECK(recording->counters.fragments == 0);
}
