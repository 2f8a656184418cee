#include "core/explain/depth_precision.hpp"

#include "core/framebuffer/depth.hpp"
#include "core/scene/scene_file.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"

#include <fmt/format.h>

using namespace hs;
using explain::DepthCurve;
using scene::DepthFormat;

namespace {

std::shared_ptr<const trace::Recording> record(const std::string& text) {
    const Result<scene::Scene> scene = scene::parse_scene(text, "test.toml");
    REQUIRE(scene);
    const auto recording = trace::record(std::make_shared<const scene::Scene>(*scene));
    REQUIRE(recording);
    return *recording;
}

/// Two squares facing the camera, both larger than its view.
std::string two_squares(double first, double second, std::string_view settings) {
    std::string text = fmt::format(
        "[settings]\nsize = [8, 8]\n{}\n[camera]\neye = [0, 0, 0]\ntarget = [0, 0, -1]\n"
        "projection = {{ kind = \"perspective\", fov_y = 40, near = 0.1, far = 1000 }}\n",
        settings
    );
    for (const double d : {first, second}) {
        text += fmt::format(
            "[[object]]\nname = \"at {0}\"\nvertices = [[-{1}, -{1}, -{0}], [{1}, -{1}, -{0}], "
            "[{1}, {1}, -{0}], [-{1}, {1}, -{0}]]\npolygons = [[0, 1, 2, 3]]\n",
            d,
            d * 2.0
        );
    }
    return text;
}

} // namespace

TEST_CASE("the curve ends at near and far, and its inverse undoes it", "[explain]") {
    for (const bool perspective : {true, false}) {
        for (const bool reversed : {true, false}) {
            const DepthCurve curve{0.1, 1000.0, perspective, reversed};
            CHECK(curve.depth(0.1) == Approx(reversed ? 1.0 : 0.0).margin(1.0e-12));
            CHECK(curve.depth(1000.0) == Approx(reversed ? 0.0 : 1.0).margin(1.0e-12));
            for (const double d : {0.1, 0.2, 1.0, 33.0, 999.0}) {
                CHECK(curve.distance(curve.depth(d)) == Approx(d));
            }
        }
    }
}

TEST_CASE("half of all depth values lie in front of twice the near plane", "[explain]") {
    // 2nf/(n + f): with a distant far plane that is 2n
    const DepthCurve curve{0.1, 1000.0, true, false};
    CHECK(explain::distance_of_half(curve) == Approx(2.0 * 0.1 * 1000.0 / 1000.1));
    CHECK(explain::distance_of_half({1.0, 9.0, false, false}) == Approx(5.0));
}

TEST_CASE("surfaces as far apart as is resolved differ by one step", "[explain]") {
    for (const bool reversed : {true, false}) {
        const DepthCurve curve{0.1, 1000.0, true, reversed};
        for (const DepthFormat format : {DepthFormat::unorm16, DepthFormat::unorm24}) {
            for (const double d : {0.2, 1.0, 10.0}) {
                const double apart = explain::resolved_distance(curve, d, format);
                const double change = std::abs(curve.depth(d + apart * 1.0e-3) - curve.depth(d));
                CHECK(
                    change * 1.0e3 ==
                    Approx(explain::depth_step(curve.depth(d), format)).epsilon(0.01)
                );
            }
        }
    }
}

TEST_CASE("a step is the distance to the next value the buffer stores", "[explain]") {
    for (const DepthFormat format : {DepthFormat::unorm16, DepthFormat::unorm24}) {
        for (const float depth : {0.25F, 0.5F, 0.9F}) {
            const float stored = framebuffer::store_depth(depth, format);
            const auto step = static_cast<float>(explain::depth_step(0.5, format));
            CHECK(framebuffer::store_depth(stored + step, format) > stored);
            if (format == DepthFormat::unorm16) { // less than half a 24-bit step is no float
                CHECK(framebuffer::store_depth(stored + 0.4F * step, format) == stored);
            }
        }
    }
    CHECK(explain::depth_step(1.0, DepthFormat::float32) == Approx(1.1920929e-07));
    CHECK(explain::depth_step(0.5, DepthFormat::float32) == Approx(5.9604645e-08));
    CHECK(explain::depth_step(0.001, DepthFormat::float32) < 1.2e-10);
}

TEST_CASE("reversed float depth resolves far away what other buffers do not", "[explain]") {
    const DepthCurve plain{0.1, 1000.0, true, false};
    const DepthCurve reversed{0.1, 1000.0, true, true};
    const double far = 900.0;
    CHECK(
        explain::resolved_distance(reversed, far, DepthFormat::float32) * 100.0 <
        explain::resolved_distance(plain, far, DepthFormat::float32)
    );
}

TEST_CASE("float depth resolves no more near the eye than was computed", "[explain]") {
    // A float near 0 has steps of 10⁻⁴⁵, but z was rounded before
    const DepthCurve curve{0.5, 6.0, true, false};
    CHECK(
        explain::resolved_distance(curve, 0.5, DepthFormat::float32) ==
        Approx(explain::resolved_distance(curve, 0.5, DepthFormat::unorm24)).epsilon(0.01)
    );
}

TEST_CASE("the recorded depths lie on the curve", "[explain]") {
    for (const char* const convention : {"opengl", "direct3d", "reversed"}) {
        const auto recording = record(two_squares(
            7.0, 80.0, fmt::format("visibility = \"none\"\ndepth.convention = \"{}\"", convention)
        ));
        const DepthCurve curve =
            explain::depth_curve(recording->scene().camera, recording->settings().depth_convention);
        bool near = false;
        bool far = false;
        for (std::size_t i = 0; i < recording->fragments.size(); ++i) {
            const auto depth = static_cast<double>(recording->fragments[i].depth);
            near = near || std::abs(depth - curve.depth(7.0)) < 1.0e-6;
            far = far || std::abs(depth - curve.depth(80.0)) < 1.0e-6;
        }
        INFO(convention);
        CHECK((near && far));
    }
}

TEST_CASE("pixels fight where two surfaces are closer than the buffer resolves", "[explain]") {
    const char* const coarse = "depth.format = \"unorm16\"";
    const char* const fine = "depth.format = \"unorm24\"";
    const DepthCurve curve{0.1, 1000.0, true, false};
    const double resolved = explain::resolved_distance(curve, 50.0, DepthFormat::unorm16);
    const double apart = resolved * 0.3;
    CHECK(explain::fighting_pixels(*record(two_squares(50.0, 50.0 + apart, coarse))).size() == 64);
    CHECK(explain::fighting_pixels(*record(two_squares(50.0, 50.0 + apart, fine))).empty());
    CHECK(
        explain::fighting_pixels(*record(two_squares(50.0, 50.0 + 8.0 * resolved, coarse))).empty()
    );
}
