// What the commands answer when all is well.
#include "core/scene/scene_file.hpp"
#include "core/trace/player.hpp"
#include "tests/command/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <OpenImageIO/imageio.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <sstream>

using namespace hs;
using tests::Outcome;
using tests::run_program;
using tests::TemporaryFolder;

namespace {

const std::string crossing = tests::scene("two-crossing-triangles.toml");
const std::string first_lesson = (test::source_dir() / "lessons/01-one-triangle").string();

/// Runs it and expects success without a word on stderr.
std::string answer(const std::vector<std::string>& arguments) {
    const Outcome outcome = run_program(arguments);
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    return outcome.out;
}

trace::Player crossing_player() {
    auto scene = scene::load_scene(crossing);
    REQUIRE(scene);
    auto recording = trace::record(std::make_shared<scene::Scene>(std::move(*scene)));
    REQUIRE(recording);
    return trace::Player(*recording);
}

std::vector<float> read_image(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    REQUIRE(input);
    const OIIO::ImageSpec& spec = input->spec();
    std::vector<float> values(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    REQUIRE(input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, values.data()));
    return values;
}

} // namespace

TEST_CASE(
    "the depth buffer in the middle of a frame is exported as the player shows it", "[app][command]"
) {
    const TemporaryFolder folder;
    const std::string at = "object 1 / triangle 0 / fragment 31,17 / depth test";
    const std::string out = (folder / "depth.exr").string();
    CHECK(answer({"export", crossing, "--at", at, "--what", "depth", "-o", out}).empty());

    trace::Player player = crossing_player();
    const auto step = trace::find_step(player.recording(), at);
    REQUIRE(step);
    player.seek(*step);
    const std::vector<float> written = read_image(out);
    const int width = player.recording().width();
    REQUIRE(written.size() == static_cast<std::size_t>(width * player.recording().height()));
    int wrong = 0;
    int not_clear = 0;
    for (std::size_t i = 0; i < written.size(); ++i) {
        const auto at_pixel = static_cast<int>(i);
        const float shown = player.pixel({at_pixel % width, at_pixel / width}).depth;
        wrong +=
            std::bit_cast<std::uint32_t>(written[i]) == std::bit_cast<std::uint32_t>(shown) ? 0 : 1;
        not_clear += shown < 1.0F ? 1 : 0;
    }
    CHECK(wrong == 0);
    CHECK(not_clear > 0);
    CHECK(player.fragments_done() < player.recording().fragments.size());
}

TEST_CASE("render draws the picture that recording ends with", "[app][command]") {
    const TemporaryFolder folder;
    const std::string rendered = (folder / "rendered.exr").string();
    const std::string recorded = (folder / "recorded.exr").string();
    answer({"render", crossing, "--size", "90x70", "-o", rendered});
    answer({"export", crossing, "--size", "90x70", "-o", recorded});
    CHECK(read_image(rendered) == read_image(recorded));
    CHECK(read_image(rendered).size() == 4 * 90 * 70);
}

TEST_CASE("compare lists what every traversal spends, as table and JSON", "[app][command]") {
    const auto json = nlohmann::json::parse(answer({"compare", crossing, "--json"}));
    REQUIRE(json.size() == names<scene::TraversalKind>().size());
    CHECK(json[0]["traversal"] == "brute-force");
    const std::uint64_t visits = json[0]["pixels_visited"];
    const int pixels =
        crossing_player().recording().width() * crossing_player().recording().height();
    CHECK(visits == 2 * static_cast<std::uint64_t>(pixels)); // two triangles
    CHECK(json[0]["multiplications"] == 6 * visits);
    for (const nlohmann::json& row : json) {
        CHECK(row["fragments"] == json[0]["fragments"]);
    }

    const auto one = nlohmann::json::parse(
        answer({"compare", crossing, "--at", "object 1 / triangle 0", "--json"})
    );
    CHECK(one[0]["pixels_visited"] == pixels);
    const std::string table = answer({"compare", crossing});
    CHECK(std::count(table.begin(), table.end(), '\n') == 9);
    CHECK(table.find("\nedge-walk ") != std::string::npos);
}

TEST_CASE("history tells a pixel's story as table, CSV and JSON", "[app][command]") {
    const std::string table = answer({"history", crossing, "--pixel", "30,30"});
    CHECK(table.find("object 1 / triangle 0") != std::string::npos);
    CHECK(std::count(table.begin(), table.end(), '\n') == 6);

    const auto json =
        nlohmann::json::parse(answer({"history", crossing, "--pixel", "30,30", "--json"}));
    REQUIRE(json["fragments"].size() == 2);
    CHECK(json["fragments"][0]["path"] == "object 0 / triangle 0 / fragment 30,30 / merge");
    CHECK(json["fragments"][0]["after"] == json["fragments"][1]["before"]);
    CHECK(json["after"]["color"] == json["fragments"][1]["after"]);

    const std::string csv = answer({"history", crossing, "--pixel", "30,30", "--csv"});
    CHECK(csv.starts_with("step,fragment,object,triangle,depth,stored_depth,fate,"));
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 3);

    const TemporaryFolder folder;
    const std::string out = (folder / "history.csv").string();
    CHECK(answer({"history", crossing, "--pixel", "30,30", "-o", out}).empty());
    CHECK(tests::read_text(out) == csv);
}

TEST_CASE("history at a step knows nothing of what comes after", "[app][command]") {
    const auto json = nlohmann::json::parse(answer(
        {"history",
         crossing,
         "--pixel",
         "30,30",
         "--json",
         "--at",
         "object 0 / triangle 0 / fragment 30,30 / depth test"}
    ));
    CHECK(json["fragments"].empty());
    CHECK(json["after"] == json["before"]);
}

TEST_CASE("--set changes what is drawn, before or behind the command", "[app][command]") {
    const auto fragments = [](const std::vector<std::string>& arguments) {
        return nlohmann::json::parse(answer(arguments))["fragments"];
    };
    const auto plain = fragments({"history", crossing, "--pixel", "31,41", "--json"});
    const auto behind =
        fragments({"history", crossing, "--pixel", "31,41", "--json", "--set", "depth.test=never"});
    const auto before =
        fragments({"--set", "depth.test=never", "--json", "history", crossing, "--pixel", "31,41"});
    REQUIRE_FALSE(plain.empty());
    CHECK(plain[0]["fate"] == "written");
    CHECK(behind[0]["fate"] == "depth failed");
    CHECK(behind == before);
}

TEST_CASE("record says what it recorded, in words or as JSON", "[app][command]") {
    const TemporaryFolder folder;
    const std::string out = (folder / "trace.npz").string();
    CHECK(answer({"record", crossing, "-o", out}).starts_with(out + ": "));
    CHECK(answer({"record", crossing, "-o", out, "--quiet"}).empty());
    const auto json = nlohmann::json::parse(answer({"record", crossing, "-o", out, "--json"}));
    CHECK(json["triangles"] == 2);
    CHECK(folder.names() == std::vector<std::string>{"trace.npz"});
}

TEST_CASE("a mesh and a lesson are accepted wherever a scene is", "[app][command]") {
    const TemporaryFolder folder;
    const auto mesh = folder.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    answer({"render", mesh.string(), "-o", (folder / "mesh.png").string()});
    answer({"render", first_lesson, "-o", (folder / "lesson.png").string()});
    CHECK(read_image(folder / "mesh.png").size() > 0);
    CHECK(read_image(folder / "lesson.png").size() > 0);
}

TEST_CASE("check answers yes with 0 and no with 1 and the places", "[app][command]") {
    CHECK(answer({"check", first_lesson}) == first_lesson + ": all is well\n");
    const std::string bad =
        (test::source_dir() / "tests/must_fail/lessons/check-does-not-hold.md").string();
    const TemporaryFolder folder;
    const auto lesson = folder.write("lesson/lesson.md", tests::read_text(bad));
    const Outcome outcome = run_program({"check", lesson.string()});
    CHECK(outcome.status == 1);
    CHECK(outcome.out.starts_with(lesson.string() + ":"));
    CHECK(outcome.err.empty());
    const Outcome json = run_program({"check", lesson.string(), "--json"});
    CHECK(json.status == 1);
    CHECK(nlohmann::json::parse(json.out)[0]["problems"].size() >= 1);
}

TEST_CASE(
    "shot draws the viewer, and a lesson's every step under a predictable name", "[app][command]"
) {
    const TemporaryFolder folder;
    const std::string out = (folder / "shot.png").string();
    answer(
        {"shot", crossing, "--at", "object 0 / triangle 0 / setup", "--size", "800x600", "-o", out}
    );
    CHECK(read_image(out).size() == 4 * 800 * 600);
    std::filesystem::remove(out);
    answer({"shot", first_lesson, "--all", "--size", "640x400", "-o", (folder / "steps").string()});
    CHECK(std::filesystem::exists(folder / "steps/step-01.png"));
    CHECK(std::filesystem::exists(folder / "steps/step-02.png"));
    CHECK(folder.names() == std::vector<std::string>{"steps"});
}

TEST_CASE(
    "help names every command, and each command's help its options and an example", "[app][command]"
) {
    const std::string help = answer({"--help"});
    for (const char* command :
         {"open", "render", "record", "export", "history", "compare", "shot", "check", "bench"}) {
        INFO(command);
        CHECK(help.find(std::string{"\n  "} + command) != std::string::npos);
        const std::string own = answer({command, "--help"});
        CHECK(own.find(std::string{"Usage: halfspace "} + command) != std::string::npos);
    }
    CHECK(answer({"--version"}).ends_with("\n"));
}

TEST_CASE(
    "a reader that goes away is no crash, a full disk behind stdout is a complaint",
    "[app][command]"
) {
    const std::vector<std::string> arguments{"history", crossing, "--pixel", "30,30"};
    const Outcome closed = run_program(arguments, "", "| true");
    CHECK(closed.err.empty());
    const Outcome full = run_program(arguments, "", ">/dev/full");
    CHECK(full.status == 2);
    CHECK(full.err == "halfspace: standard output: cannot be written: No space left on device\n");
}

TEST_CASE("a command that is interrupted leaves nothing and dies of the signal", "[app][command]") {
    // A large frame, so that a second is not enough; `timeout` reports 128 + the signal. In the
    // foreground it sends one signal, else a second to the whole group: the second kills at once
    const TemporaryFolder folder;
    const auto scene = folder.write(
        "scene.toml",
        "[settings]\nsize = [2048, 2048]\n[[object]]\nshape = { kind = \"torus-knot\", triangles = "
        "870000 }\n"
    );
    const Outcome outcome = run_program(
        {"record", scene.string(), "-o", (folder / "trace.npz").string()},
        "timeout --foreground --preserve-status --signal=INT 1 "
    );
    CHECK(outcome.status == 130);
    CHECK(folder.names() == std::vector<std::string>{"scene.toml"});
}

TEST_CASE(
    "what a query finds is the same as text, CSV and JSON, and can be gone to", "[app][command]"
) {
    const TemporaryFolder folder;
    const std::string question = "fragment.fate == 'depth failed' and fragment.pixel.x == 33";
    const auto document = nlohmann::json::parse(answer({"query", crossing, question, "--json"}));
    CHECK(document["searched"] == "fragments");
    REQUIRE(document["count"] > 3);
    REQUIRE(document["matches"].size() == document["count"]);

    const trace::Player player = crossing_player();
    for (const auto& match : document["matches"]) {
        CHECK(match["fragment.fate"] == "depth failed");
        CHECK(match["fragment.pixel.x"] == 33);
        const auto step = trace::find_step(player.recording(), match["path"].get<std::string>());
        REQUIRE(step);
        CHECK(*step == match["step"]);
        CHECK_FALSE(trace::describe_step(player.recording(), *step).passed);
    }

    const auto lines_of = [](const std::string& text) {
        return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    };
    const std::size_t count = document["count"];
    CHECK(lines_of(answer({"query", crossing, question})) == count + 1);
    CHECK(lines_of(answer({"query", crossing, question, "--csv"})) == count + 1);
    CHECK(answer({"query", crossing, question, "--count"}) == std::to_string(count) + "\n");
    CHECK(lines_of(answer({"query", crossing, question, "--limit", "2"})) == 4);
    CHECK(answer({"query", crossing, question, "-o", (folder / "found.csv").string()}).empty());
    CHECK(answer({"query", crossing, "--names"}).find("fragment.fate") != std::string::npos);
}

TEST_CASE("a query without a match answers no", "[app][command]") {
    const Outcome outcome = run_program({"query", crossing, "fragment.depth > 2", "--count"});
    CHECK(outcome.status == 1);
    CHECK(outcome.out == "0\n");
    CHECK(outcome.err.empty());
}
