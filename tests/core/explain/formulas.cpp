#include "core/explain/formulas.hpp"

#include "core/explain/numbers.hpp"
#include "core/scene/scene_file.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"

#include <cstdio>
#include <limits>

using namespace hs;

namespace {

constexpr std::string_view scene_text = R"(
[settings]
size = [8, 8]
shading = "gouraud"
[camera]
eye = [0, 0, 2]
target = [0, 0, 0]
[[object]]
name = "lit"
vertices = [[-1, -1, 0], [3, -1, 0], [0, 1, 0.5]]
polygons = [[0, 1, 2]]
[[light]]
kind = "directional"
to_light = [0, 0, 1]
color = [1, 1, 1]
)";

trace::Player player() {
    const Result<scene::Scene> scene = scene::parse_scene(scene_text, "test.toml");
    REQUIRE(scene);
    const auto recording = trace::record(std::make_shared<const scene::Scene>(*scene));
    REQUIRE(recording);
    return trace::Player{*recording};
}

std::vector<explain::Formula> formulas_of(const trace::Player& at) {
    const scene::Scene& scene = at.recording().scene();
    return explain::formulas(
        at.detail(), at.current(), scene::object_settings(scene, scene.objects.front())
    );
}

} // namespace

TEST_CASE("every step between start and end has a formula with a value", "[explain]") {
    trace::Player at = player();
    for (trace::StepId step = 1; step < at.end(); ++step) {
        at.seek(step);
        const std::vector<explain::Formula> list = formulas_of(at);
        INFO(trace::step_path(at.current()));
        REQUIRE_FALSE(list.empty());
        for (const explain::Formula& formula : list) {
            REQUIRE_FALSE(formula.title.empty());
            REQUIRE_FALSE(formula.symbolic.empty());
            REQUIRE_FALSE(formula.value.empty());
        }
    }
}

TEST_CASE("start and end compute nothing", "[explain]") {
    trace::Player at = player();
    CHECK(formulas_of(at).empty());
    at.seek(0);
    CHECK(formulas_of(at).empty());
}

TEST_CASE("a matrix formula shows the numbers it multiplied", "[explain]") {
    trace::Player at = player();
    at.seek(*trace::find_step(at.recording(), "vertex stage / object 0 / vertex 0 / eye"));
    const std::vector<explain::Formula> list = formulas_of(at);
    REQUIRE(list.size() == 1);
    CHECK(list[0].value == "(-1.0000, -1.0000, -2.0000, 1.0000)");
    CHECK(list[0].with_numbers.find("1.0000·-1.0000") != std::string::npos);
}

TEST_CASE("edge functions are explained in pixels and add up as written", "[explain]") {
    trace::Player at = player();
    at.seek(*trace::find_step(at.recording(), "object 0 / triangle 0 / pixel 4,5"));
    const std::vector<explain::Formula> list = formulas_of(at);
    REQUIRE(list.size() == 3);
    for (const explain::Formula& formula : list) {
        INFO(formula.with_numbers << " = " << formula.value);
        double a = 0.0;
        double b = 0.0;
        double c = 0.0;
        double value = 0.0;
        REQUIRE(std::sscanf(formula.with_numbers.c_str(), "%lf·4 + %lf·5 + %lf", &a, &b, &c) == 3);
        REQUIRE(std::sscanf(formula.value.c_str(), "%lf px²", &value) == 1);
        CHECK(a * 4.0 + b * 5.0 + c == Approx(value).margin(0.001));
    }
}

TEST_CASE("numbers keep their digits and compared ones are told apart", "[explain]") {
    CHECK(explain::number(0.5F) == "0.5000");
    CHECK(explain::number(-0.0F) == "0.0000");
    CHECK(explain::number(1.0e-7F) == "1.000e-07");
    CHECK(explain::signed_number(1.0F) == " 1.0000");
    CHECK(explain::signed_number(-1.0F) == "−1.0000");
    CHECK(explain::whole(0) == "0");
    CHECK(explain::whole(-1234567) == "-1 234 567");
    CHECK(explain::whole(std::numeric_limits<std::int64_t>::min()) == "-9 223 372 036 854 775 808");
    CHECK(explain::square_pixels(65536 * 16) == "16.0000");
    CHECK(explain::square_pixels(-98304) == "-1.5000");
    CHECK(explain::square_pixels(1) == "1.526e-05");
    CHECK(explain::pixels(-2560) == "-10.0000");
    const auto [a, b] = explain::compared(0.50000003F, 0.5F);
    CHECK(a != b);
}
