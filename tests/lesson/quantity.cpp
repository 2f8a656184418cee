#include "app/lesson/quantity.hpp"

#include "app/lesson/recordings.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <set>

namespace hs::lesson {

namespace {

std::shared_ptr<const trace::Recording> record() {
    RecordingCache recordings;
    return recordings.get({test::source_dir() / "lessons/01-one-triangle/triangle.toml", {}}
    ).value();
}

trace::Step stand_on(const trace::Recording& recording, std::string_view path) {
    return describe_step(recording, find_step(recording, path).value());
}

std::string read(std::string_view name, std::string_view of, std::string_view stand = "end") {
    const auto recording = record();
    const Result<Value> value = read_quantity(name, of, *recording, stand_on(*recording, stand));
    return value ? print_value(*value) : value.diagnostics().front().message;
}

} // namespace

TEST_CASE("every quantity has a name of its own and an explanation", "[lesson]") {
    std::set<std::string_view> seen;
    for (const Quantity& quantity : quantities()) {
        INFO(quantity.name);
        CHECK(seen.insert(quantity.name).second);
        CHECK(quantity.explanation.size() > 5);
        CHECK_FALSE(quantity.explanation.ends_with('.'));
        CHECK(find_quantity(quantity.name) == &quantity);
    }
}

TEST_CASE("every quantity can be read of the golden walk", "[lesson]") {
    const auto recording = record();
    const trace::Step end = stand_on(*recording, "end");
    for (const Quantity& quantity : quantities()) {
        INFO(quantity.name);
        const bool of_vertex = quantity.of == QuantityOf::vertex;
        const bool of_frame = quantity.of == QuantityOf::frame;
        const std::string of = of_frame ? "" : of_vertex ? "vertex 2" : "triangle 0 / pixel 8,6";
        CHECK(read_quantity(quantity.name, of, *recording, end));
    }
}

TEST_CASE("a subject left out comes from the step stood on", "[lesson]") {
    CHECK(read("eye.z", "", "vertex stage / object 0 / vertex 2 / eye") == "−8");
    CHECK(read("E12", "", "object 0 / triangle 0 / pixel 11,7") == "0");
    CHECK(read("λ2", "", "object 0 / triangle 0 / fragment 8,6 / shade") == "0.5");
    CHECK(
        read("eye.z", "", "end") ==
        "\"eye.z\" needs to know of what: write for instance \"eye.z of vertex 0\""
    );
}

TEST_CASE("counts are of what is written, whatever one stands on", "[lesson]") {
    const std::string_view somewhere = "object 0 / triangle 0 / pixel 4,4";
    CHECK(read("fragments", "", somewhere) == "34");
    CHECK(read("fragments", "object 0", somewhere) == "34");
    CHECK(read("visits", "object 0 / triangle 0", somewhere) == "80");
    CHECK(read("fragments failed", "frame") == "0");
}

TEST_CASE("number of counts sets of pixels and nothing else", "[lesson]") {
    CHECK(read("number of covered pixels", "triangle 0") == "34");
    CHECK(
        read("number of signed area", "triangle 0") ==
        "\"number of signed area\": only sets of pixels are counted"
    );
}

TEST_CASE("what does not exist is named", "[lesson]") {
    CHECK(read("ndc.x", "object 3 / vertex 0") == "there is no object 3 in the scene");
    CHECK(read("ndc.x", "vertex 3") == "object 0 has no vertex 3");
    CHECK(read("E01", "triangle 1 / pixel 0,0") == "object 0 has no triangle 1");
    CHECK(read("E01", "triangle 0 / pixel 16,0") == "pixel 16,0 is outside the image");
    CHECK(
        read("depth", "triangle 0 / pixel 11,7") ==
        "triangle 0 of object 0 has no fragment at pixel 11,7"
    );
}

TEST_CASE("the coverage rule and its two misreadings differ by the ties", "[lesson]") {
    CHECK(read("number of covered pixels", "triangle 0") == "34");
    CHECK(read("number of touched pixels", "triangle 0") == "38");
    CHECK(read("number of inner pixels", "triangle 0") == "26");
    CHECK(read("number of box pixels", "triangle 0") == "80");
}

TEST_CASE("a group is a name or its first word", "[lesson]") {
    CHECK(is_in_group("ndc.x", "ndc"));
    CHECK(is_in_group("ndc.x", "ndc.x"));
    CHECK(is_in_group("number of covered pixels", "covered pixels"));
    CHECK_FALSE(is_in_group("ndc.x", "nd"));
    CHECK_FALSE(is_in_group("ndc", "ndc.x"));
}

TEST_CASE("values print as people write them", "[lesson]") {
    CHECK(print_value(34.0) == "34");
    CHECK(print_value(-0.0) == "0");
    CHECK(print_value(-0.25) == "−0.25");
    CHECK(print_value(1.0 / 3.0) == "0.333333");
    CHECK(print_value(1.0 / 3.0, 2) == "0.33");
    CHECK(print_value(-1e-9, 2) == "0.00");
    CHECK(print_value(100.0, 0) == "100");
    CHECK(print_value(true) == "yes");
    CHECK(print_value(make_pixel_set({{3, 1}, {2, 1}, {5, 0}, {2, 1}})) == "(5, 0) (2, 1) (3, 1)");
    CHECK(print_value(PixelSet{}) == "none");
}

} // namespace hs::lesson
