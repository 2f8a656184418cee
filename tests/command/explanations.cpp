// `explain` and `why` from outside.
#include "tests/command/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

using namespace hs;
using tests::Outcome;
using tests::run_program;

namespace {

const std::string crossing = tests::scene("two-crossing-triangles.toml");

std::string answer(const std::vector<std::string>& arguments) {
    const Outcome outcome = run_program(arguments);
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    return outcome.out;
}

nlohmann::json explained(const std::string& at, const std::string& value) {
    const auto document =
        nlohmann::json::parse(answer({"explain", crossing, "--at", at, value, "--json"}));
    REQUIRE(document["values"].size() == 1);
    return document["values"][0];
}

void check_refused(const std::vector<std::string>& arguments, const std::string& complaint) {
    const Outcome outcome = run_program(arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find(complaint) != std::string::npos);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

} // namespace

TEST_CASE("a depth can be followed from the pixel to the camera's matrix", "[app][command]") {
    std::string at = "object 1 / triangle 0 / fragment 31,17 / merge";
    std::string name = "pixel depth";
    std::vector<std::string> names;
    for (int hop = 0; hop < 20; ++hop) {
        const nlohmann::json value = explained(at, name);
        names.push_back(value["name"]);
        const auto& operands = value["operands"];
        const auto next = std::find_if(operands.begin(), operands.end(), [](const auto& operand) {
            return operand.contains("step") && operand["name"] != "λ1" && operand["name"] != "λ2";
        });
        if (next == operands.end() || name.starts_with("clip.")) {
            break;
        }
        at = (*next)["step"];
        name = (*next)["name"];
        CHECK(explained(at, name)["value"] == (*next)["value"]);
    }
    CHECK(
        names ==
        std::vector<std::string>{
            "pixel depth",
            "fragment depth",
            "depth",
            "v0.window.depth",
            "v0.ndc.z",
            "clip.z"}
    );
}

TEST_CASE("without a value all values of the step are listed", "[app][command]") {
    const std::string text =
        answer({"explain", crossing, "--at", "object 1 / triangle 0 / fragment 31,17 / interpolate"}
        );
    CHECK(text.find("λ1                       0.1409             = E20·(1/2A)") != std::string::npos);
    CHECK(text.find("fragment (31, 17)") == std::string::npos); // but as a sentence begins
    CHECK(text.find("Fragment (31, 17) of triangle 0 of object 1") != std::string::npos);
}

TEST_CASE("why names the pixel's triangle and whom it hides", "[app][command]") {
    const auto document =
        nlohmann::json::parse(answer({"why", crossing, "--pixel", "31,17", "--json"}));
    REQUIRE(document["triangles"].size() == 2);
    CHECK(document["triangles"][0]["role"] == "overwritten");
    CHECK(document["triangles"][1]["role"] == "shows");
    CHECK(document["because"].front()["name"] == "pixel color.b");
    CHECK(document["because"].back()["name"] == "clip.x");
    const std::string one =
        answer({"why", crossing, "--pixel", "0,0", "--triangle", "1"});
    CHECK(one.find("Triangle 0 of object 1 does not cover the pixel: E") != std::string::npos);
    const std::string early = answer({"why", crossing, "--pixel", "31,17", "--at", "start"});
    CHECK(early.find("Triangle 0 of object 1 comes later.") != std::string::npos);
}

TEST_CASE("the narration says of every step what explain says", "[app][command]") {
    const std::string from = "object 1 / triangle 0 / pixel 31,17";
    const std::string to = "object 1 / triangle 0 / fragment 31,17 / merge";
    const auto story =
        nlohmann::json::parse(answer({"narrate", crossing, "--from", from, "--to", to, "--json"}));
    REQUIRE(story.size() == 5); // edge test, interpolate, shade, depth test, merge
    for (const auto& told : story) {
        const auto document = nlohmann::json::parse(
            answer({"explain", crossing, "--at", told["path"].get<std::string>(), "--json"})
        );
        CHECK(document["sentence"] == told["sentence"]);
        CHECK(document["step"] == told["step"]);
    }
    const std::string stages = answer({"narrate", crossing, "--by", "stage"});
    CHECK(stages.starts_with("#0 start: The framebuffer is cleared"));
    CHECK(stages.find(" end: ") != std::string::npos);
    check_refused({"narrate", crossing, "--by", "pixel"}, "'pixel' is none of");
}

TEST_CASE("what cannot be explained is refused in one line", "[app][command]") {
    const std::string setup = "object 1 / triangle 0 / setup";
    check_refused({"explain", crossing, "--at", setup, "E1.a"}, "did you mean \"E01.a\"?");
    check_refused({"explain", crossing, "--at", "end", "E01.a"}, "end computes no values");
    check_refused({"explain", crossing}, "--at");
    check_refused({"why", crossing, "--pixel", "64,0"}, "64,0 lies outside the image");
    check_refused({"why", crossing, "--pixel", "x"}, "'x' is not a pixel");
    check_refused(
        {"why", crossing, "--pixel", "1,1", "--triangle", "2"}, "its triangles are 0 to 1"
    );
}
