#include "core/pipeline/order.hpp"

#include "core/pipeline/draw_frame.hpp"
#include "core/scene/scene_file.hpp"
#include "core/trace/recording.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"
#include "tests/support/soup_scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>

using namespace hs;

namespace {

/// A random frame after its vertex stage.
std::unique_ptr<pipeline::Frame> shaded_frame(std::uint64_t seed) {
    auto frame = std::make_unique<pipeline::Frame>(tests::random_scene(seed));
    pipeline::NullTrace nothing;
    for (pipeline::DrawCall& call : frame->calls()) {
        pipeline::run_vertex_stage(call, nothing);
    }
    return frame;
}

std::size_t triangle_count(const pipeline::Frame& frame) {
    std::size_t count = 0;
    for (const pipeline::DrawCall& call : frame.calls()) {
        count += call.triangles().size();
    }
    return count;
}

/// Tells whether anything of a triangle was drawn.
struct Verdict : pipeline::NullTrace {
    bool fragments = false;
    void fragment_end(fragment::FragmentFate) { fragments = true; }
};

} // namespace

TEST_CASE("an order draws every triangle once, whatever it leaves out", "[pipeline][property]") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto frame = shaded_frame(seed);
        pipeline::NullTrace nothing;
        const pipeline::DrawOrder order = pipeline::order_triangles(*frame, nothing);
        std::set<std::pair<std::uint32_t, std::uint32_t>> drawn;
        std::size_t rows = 0;
        for (const pipeline::Draw& draw : order.draws) {
            if (draw.row >= 0) {
                ++rows; // of all triangles
            } else {
                drawn.insert({draw.object, draw.triangle});
            }
        }
        INFO("seed " << seed);
        CHECK(drawn.size() == triangle_count(*frame));
        if (order.parts.empty()) {
            CHECK(order.draws.size() == drawn.size() + rows);
        }
    }
}

TEST_CASE("nothing is seen of what takes no part in ordering", "[pipeline][property]") {
    int unseen = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const auto frame = shaded_frame(seed);
        framebuffer::Framebuffer target(frame->settings());
        for (const pipeline::Draw& draw : pipeline::window_polygons(*frame).unseen) {
            const pipeline::DrawCall& call = frame->calls()[draw.object];
            if (call.settings.traversal == scene::TraversalKind::homogeneous) {
                continue; // decides by exact planes, not by snapped areas
            }
            Verdict verdict;
            pipeline::draw_triangle(call, draw.triangle, {}, target, verdict);
            INFO("seed " << seed << ", object " << draw.object << ", triangle " << draw.triangle);
            CHECK_FALSE(verdict.fragments);
            ++unseen;
        }
    }
    CHECK(unseen > 100);
}

TEST_CASE("weights lead from the window back to clip space", "[pipeline][property]") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto frame = shaded_frame(seed);
        std::uint32_t first = 0;
        std::vector<std::uint32_t> firsts;
        for (const pipeline::DrawCall& call : frame->calls()) {
            firsts.push_back(first);
            first += static_cast<std::uint32_t>(call.triangles().size());
        }
        for (const auto& polygon : pipeline::window_polygons(*frame).polygons) {
            const auto object = static_cast<std::size_t>(
                std::upper_bound(firsts.begin(), firsts.end(), polygon.triangle) - firsts.begin() -
                1
            );
            const pipeline::DrawCall& call = frame->calls()[object];
            const auto& indices = call.triangles()[polygon.triangle - firsts[object]];
            for (const auto& corner : polygon.corners) {
                glm::dvec4 clip{0.0};
                for (int k = 0; k < 3; ++k) {
                    clip += corner.weights[k] *
                            glm::dvec4{math::to_vec4(call.vertices[indices[k]].clip)};
                }
                // Weights are divided by w: w comes back as one
                const double window_x =
                    static_cast<double>(call.viewport.center_x) +
                    clip.x / clip.w * static_cast<double>(call.viewport.half_width);
                INFO("seed " << seed << ", triangle " << polygon.triangle);
                CHECK(clip.w == Approx(1.0).epsilon(1e-5));
                CHECK(window_x == Approx(corner.position.x).margin(1e-4));
            }
        }
    }
}

TEST_CASE("painter's paints over what is farther, not over what came before", "[pipeline]") {
    const glm::vec4 red{1.0F, 0.0F, 0.0F, 1.0F};
    const glm::vec4 white{1.0F};
    tests::Soup soup;
    for (const auto& [depth, color] : {std::pair{-0.5F, red}, std::pair{0.5F, white}}) {
        soup.push_back({{-1.0F, -1.0F, depth, 1.0F}, color});
        soup.push_back({{3.0F, -1.0F, depth, 1.0F}, color});
        soup.push_back({{-1.0F, 3.0F, depth, 1.0F}, color});
    }
    scene::Settings settings;
    settings.width = settings.height = 8;
    for (const auto& [visibility, expected] :
         {std::pair{scene::Visibility::none, white}, std::pair{scene::Visibility::painters, red}}) {
        settings.visibility = visibility;
        const tests::Drawing drawing = tests::drawn(tests::soup_scene(soup, settings));
        CHECK(drawing.target.color({3, 4}) == expected);
        CHECK(drawing.target.depth({3, 4}) == settings.depth_clear());
    }
}

TEST_CASE("lines and points are refused where only triangles have a place", "[unit][pipeline]") {
    for (const char* setting : {"visibility = \"painters\"", "samples = 4"}) {
        INFO(setting);
        auto scene = scene::parse_scene(
            std::string{"[settings]\n"} + setting +
                "\n[[object]]\nvertices = [[0, 0, 0], [1, 0, 0]]\nlines = [[0, 1]]\n",
            "lines.toml"
        );
        REQUIRE(scene);
        const auto recording = trace::record(std::make_shared<scene::Scene>(std::move(*scene)));
        REQUIRE_FALSE(recording);
        CHECK(recording.diagnostics().front().message.find("object 0") != std::string::npos);
        CHECK(recording.diagnostics().front().message.find("lines or points") != std::string::npos);
    }
}
