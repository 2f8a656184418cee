// Bad input ends in one located line, status 2 and no file.
#include "tests/command/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

using namespace hs;
using tests::complaint;
using tests::TemporaryFolder;

namespace {

const std::string crossing = tests::scene("two-crossing-triangles.toml");

constexpr const char* triangle = R"([[object]]
vertices = [[-1, -1, 0], [1, -1, 0], [0, 1, 0]]
polygons = [[0, 1, 2]]
)";

/// What every command that draws says about a scene; none may leave a file behind.
std::string refused(const TemporaryFolder& folder, const std::filesystem::path& scene) {
    const auto before = folder.names();
    const std::string out = (folder / "out").string();
    const std::string first = complaint({"render", scene.string(), "-o", out + ".png"});
    CHECK(complaint({"export", scene.string(), "-o", out + ".exr"}) == first);
    CHECK(complaint({"record", scene.string(), "-o", out + ".npz"}) == first);
    CHECK(complaint({"history", scene.string(), "--pixel", "0,0"}) == first);
    CHECK(complaint({"shot", scene.string(), "-o", out + ".png"}) == first);
    CHECK(folder.names() == before);
    const std::string prefix = folder.path().string() + '/';
    return first.starts_with(prefix) ? first.substr(prefix.size()) : first;
}

std::string refused_scene(const std::string& text) {
    const TemporaryFolder folder;
    return refused(folder, folder.write("scene.toml", text));
}

std::string refused_mesh(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    return refused(folder, folder.write(name, text));
}

} // namespace

TEST_CASE("a scene's mistake is one line with file, line and column", "[app][command]") {
    CHECK(refused_scene(std::string{triangle} + "colour = 1\n").starts_with("scene.toml:4:1: "));
    CHECK(refused_scene("[settings]\nsize = \"big\"\n").starts_with("scene.toml:2:8: "));
    CHECK(refused_scene("[camera]\neye = [nan, 0, 3]\n").starts_with("scene.toml:2:7: "));
    CHECK(refused_scene("[settings]\nsize = [0, 64]\n").starts_with("scene.toml:2:"));
    CHECK(refused_scene("[settings]\nsize = [100000, 64]\n").starts_with("scene.toml:2:"));
    CHECK(refused_scene("[[object]]\nvertices = [[0, 0, 0]]\npolygons = [[0, 0, 7]]\n")
              .starts_with("scene.toml:3:"));
    CHECK(refused_scene("[[object]]\nmesh = \"none.obj\"\n").starts_with("scene.toml:2:"));
}

TEST_CASE("further mistakes are counted", "[app][command]") {
    const std::string line = refused_scene("[settings]\nsize = 3\ncull = 7\nnonsense = 1\n");
    CHECK(line.find(" (and 2 more)") != std::string::npos);
}

TEST_CASE("meshes and images that are missing, empty or cut short are refused", "[app][command]") {
    CHECK(refused_mesh("empty.obj", "").starts_with("empty.obj: "));
    CHECK(refused_mesh("empty.ply", "").starts_with("empty.ply"));
    CHECK(refused_mesh("short.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n").starts_with("short.off"));
    CHECK(
        refused_mesh("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n").starts_with("index.obj:4")
    );
    CHECK(
        refused_mesh("lying.off", "OFF\n2000000000 2000000000 0\n0 0 0\n").starts_with("lying.off")
    );

    const TemporaryFolder folder;
    const auto scene = folder.write(
        "scene.toml",
        std::string{triangle} +
            "material = \"m\"\n[[material]]\nname = \"m\"\ntexture = { image = \"short.png\" }\n"
    );
    const std::string whole = tests::read_text(tests::scene("checker.png"));
    const auto image = folder.write("short.png", whole.substr(0, whole.size() / 2));
    CHECK(refused(folder, scene).find("short.png") != std::string::npos);
    std::filesystem::remove(image);
    CHECK(refused(folder, scene).find("short.png") != std::string::npos);
}

TEST_CASE("a file that is not there is refused by every command", "[app][command]") {
    const TemporaryFolder folder;
    CHECK(refused(folder, folder / "none.toml") == "none.toml: there is no such file");
    CHECK(complaint({"open", "none.toml"}) == "none.toml: there is no such file");
    CHECK(complaint({"check", "none"}).starts_with("none: is not a lesson"));
}

TEST_CASE("bad options are refused before the scene is opened", "[app][command]") {
    const auto history = [](const std::string& option, const std::string& value) {
        return complaint({"history", crossing, "--pixel", "1,1", option, value});
    };
    CHECK(
        history("--size", "0x5") ==
        "--size: '0x5' is not a size; write WIDTHxHEIGHT with numbers from 1 to 8192"
    );
    CHECK(history("--size", "9999x1").starts_with("--size: '9999x1' is not a size"));
    CHECK(history("--size", "banana").starts_with("--size: 'banana' is not a size"));
    CHECK(history("--set", "nonsense").find("nonsense") != std::string::npos);
    CHECK(history("--set", "depth.tset=always").find("depth.tset") != std::string::npos);
    CHECK(history("--set", "depth.test=sometimes").find("sometimes") != std::string::npos);
    CHECK(history("--threads", "-3").find("--threads") != std::string::npos);
    CHECK(history("--at", "object 9").starts_with("--at: there is no object 9"));
    CHECK(history("--at", "nowhere at all").starts_with("--at: 'nowhere at all'"));
    CHECK(history("--at", "#99999999").starts_with("--at: there is no step '#99999999'"));
    CHECK(
        complaint({"history", crossing, "--pixel", "64,0"}) ==
        "--pixel: 64,0 lies outside the image; pixels are 0,0 to 63,63"
    );
    CHECK(complaint({"history", crossing, "--pixel", "1;2"})
              .starts_with("--pixel: '1;2' is not a pixel"));
}

TEST_CASE("usage errors name what is wrong and where help is", "[app][command]") {
    CHECK(complaint({"frobnicate"}) == "'frobnicate' is not a command; see halfspace --help");
    CHECK(complaint({"exprot"}) == "'exprot' is not a command; did you mean \"export\"?");
    CHECK(complaint({"render"}) == "FILE is required; see halfspace render --help");
    CHECK(complaint({"render", crossing}).ends_with("see halfspace render --help"));
    CHECK(complaint({"--frobnicate"}).ends_with("see halfspace --help"));
}

TEST_CASE("output that cannot be written is refused and leaves nothing", "[app][command]") {
    const TemporaryFolder folder;
    const auto refused_output = [&folder](const std::string& out) {
        return complaint({"export", crossing, "-o", (folder / out).string()});
    };
    const std::string root = folder.path().string() + '/';
    CHECK(
        refused_output("a.jpg") == root + "a.jpg: the name must end in \".png\", \".exr\", "
                                          "\".npz\" or \".csv\": it chooses the format"
    );
    CHECK(
        refused_output("none/a.png") ==
        root + "none/a.png: cannot be written: there is no folder '" + root + "none'"
    );
    std::filesystem::create_directory(folder / "folder.png");
    CHECK(
        refused_output("folder.png") ==
        root + "folder.png: cannot be written: it is a folder; name a file in it"
    );
    std::filesystem::create_symlink("/dev/full", folder / "full.png");
    CHECK(
        refused_output("full.png") == root + "full.png: cannot be written: it is not a regular file"
    );
    CHECK(complaint({"export", crossing, "-o", "/proc/a.png"})
              .starts_with("/proc/a.png: cannot be written: "));
    CHECK(folder.names() == std::vector<std::string>{"folder.png", "full.png"});
}

TEST_CASE("a disk that fills up while writing leaves nothing behind", "[app][command]") {
    const TemporaryFolder folder;
    const std::string full_disk = "ulimit -f 8; "; // in blocks of 512 or 1024 bytes
    const auto out = [&folder](const char* name) { return (folder / name).string(); };
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"record", crossing, "-o", out("a.npz")},
          {"export", crossing, "--what", "fragments", "-o", out("a.csv")},
          {"export", crossing, "--what", "fragments", "-o", out("a.json")},
          {"export", crossing, "--what", "depth", "-o", out("a.npz")},
          {"shot", crossing, "-o", out("a.png")}}) {
        INFO(arguments[0] << ' ' << arguments.back());
        const std::string line = complaint(arguments, full_disk);
        CHECK(line.starts_with(arguments.back() + ": cannot be written: "));
        CHECK(line.find("File too large") != std::string::npos);
    }
    CHECK(folder.names().empty());
}

TEST_CASE("what does not fit together is refused in one sentence", "[app][command]") {
    const TemporaryFolder folder;
    const auto refused_what = [&folder](const std::string& what, const std::string& out) {
        return complaint({"export", crossing, "--what", what, "-o", (folder / out).string()});
    };
    CHECK(
        refused_what("vertices,depth", "a.npz") ==
        "--what: 'vertices' is a table, which is exported alone"
    );
    CHECK(refused_what("color,dpeth", "a.exr").starts_with("--what: 'dpeth' is neither a buffer (")
    );
    CHECK(refused_what("depth,depth", "a.exr") == "--what: 'depth' is named twice");
    CHECK(refused_what("edge0", "a.exr").starts_with("--what: 'edge0' needs a step of a triangle"));
    CHECK(refused_what("color,depth", "a.png")
              .ends_with("a PNG holds one buffer; write .exr, .npz or .csv for several"));
    CHECK(refused_what("triangles", "a.png")
              .ends_with(
                  "the name must end in \".csv\", \".json\" or \".npz\": it chooses the format"
              ));
    CHECK(complaint({"shot", crossing, "--all", "-o", (folder / "a").string()})
              .ends_with("--all needs a lesson"));
    CHECK(folder.names().empty());
}

TEST_CASE("a wrong expression is one located line", "[app][command]") {
    CHECK(
        complaint({"query", crossing, "fragment.dept < 1"}) ==
        "expression: there is no fragment.dept; did you mean \"fragment.depth\"?"
    );
    CHECK(complaint({"query", crossing, "fragment.depth <"}).starts_with("expression:1: "));
    CHECK(
        complaint({"query", crossing, "fragment.depth"}) ==
        "expression: the answer is a number, not true or false; compare it with something"
    );
    CHECK(complaint({"query", crossing}).starts_with("expression: names nothing to search"));
    CHECK(
        complaint({"query", crossing, "fragment.depth < 1", "-o", "x.png"}).find(".csv") !=
        std::string::npos
    );
}

TEST_CASE("an order that has no meaning or no end in sight is refused", "[app][command]") {
    const std::string settings = "[settings]\nvisibility = ";
    const std::string bent = "[camera]\nprojection = { kind = \"identity\" }\n[[object]]\nvertices "
                             "= [[-1, -1, 0, 1], [1, "
                             "-1, 0, 2], [0, 1, 0, 1]]\npolygons = [[0, 1, 2]]\n";
    CHECK(
        refused_scene(settings + "\"bsp\"\n" + bent) ==
        "scene.toml: visibility \"bsp\" orders triangles in the world, where a vertex needs w = 1; "
        "vertex 1 of object 0 has w = 2"
    );
    CHECK(
        refused_scene(
            settings + "\"front-lists\"\norder.limit = 20\n[[object]]\nshape = { kind = "
                       "\"sphere\", triangles = 500 }\n"
        )
            .find("would take about ") != std::string::npos
    );
}
