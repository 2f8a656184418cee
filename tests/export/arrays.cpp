// Buffers as CSV and NPZ.
#include "core/export/layer_file.hpp"
#include "core/export/npz.hpp"
#include "tests/export/numpy.hpp"
#include "tests/export/recorded.hpp"
#include "tests/export/temporary_folder.hpp"

#include <fmt/format.h>

#include <bit>
#include <sstream>

using namespace hs;
using tests::TemporaryFolder;

TEST_CASE("a CSV of buffers has a row per pixel whose numbers read back exactly", "[export][csv]") {
    const TemporaryFolder folder;
    const trace::Player player = tests::random_player(7);
    const auto layers =
        exporting::make_layers(player, std::vector<std::string>{"depth", "color", "triangle"});
    REQUIRE(layers);
    REQUIRE(exporting::write_csv(folder / "buffers.csv", *layers));

    std::istringstream lines(tests::read_text(folder / "buffers.csv"));
    std::string line;
    std::getline(lines, line);
    CHECK(line == "x,y,depth,color.r,color.g,color.b,color.a,triangle");
    int rows = 0;
    int wrong = 0;
    while (std::getline(lines, line)) {
        PixelPos p;
        float z = 0.0F;
        glm::vec4 c{0.0F};
        int triangle = 0;
        char comma = 0;
        std::istringstream(line) >> p.x >> comma >> p.y >> comma >> z >> comma >> c.r >> comma >>
            c.g >> comma >> c.b >> comma >> c.a >> comma >> triangle;
        const trace::PixelRecord& pixel = player.pixel(p);
        const int owner =
            pixel.triangle == trace::no_triangle ? -1 : static_cast<int>(pixel.triangle);
        wrong += z == pixel.depth && c == player.color(p) && triangle == owner ? 0 : 1;
        ++rows;
    }
    CHECK(rows == player.recording().width() * player.recording().height());
    CHECK(wrong == 0);
}

TEST_CASE("NumPy opens an NPZ of buffers", "[export][npz]") {
    const auto python = tests::python_with_numpy();
    if (!python) {
        return;
    }
    const TemporaryFolder folder;
    const trace::Player player = tests::random_player(7);
    const auto layers =
        exporting::make_layers(player, std::vector<std::string>{"depth", "color", "triangle"});
    REQUIRE(layers);
    const std::filesystem::path file = folder / "buffers.npz";
    REQUIRE(exporting::write_npz(file, *layers, exporting::attributes_of(player)));
    std::string bits;
    for (int y = 0; y < player.recording().height(); ++y) {
        for (int x = 0; x < player.recording().width(); ++x) {
            bits += fmt::format("{:08x}", std::bit_cast<std::uint32_t>(player.pixel({x, y}).depth));
        }
    }
    const std::string script =
        "print(t['depth'].dtype, t['depth'].shape, t['color'].shape, t['triangle'].dtype)\n"
        "print(''.join('%08x' % v for v in t['depth'].view('<u4').ravel()))\n"
        "print(json.loads(t['manifest.json'])['halfspace:step'])";
    CHECK(
        tests::run_numpy(*python, file, script) ==
        fmt::format(
            "float32 ({0}, {1}) ({0}, {1}, 4) int32\n{2}\n{3}\n",
            player.recording().height(),
            player.recording().width(),
            bits,
            trace::step_path(player.current())
        )
    );
}

TEST_CASE("an array's header is what NumPy's format asks for", "[export][npz]") {
    for (const auto& shape : {std::vector<std::size_t>{}, {5}, {1234567, 4}, {1, 2, 3}}) {
        const std::string header = exporting::npy_header("<f4", shape);
        CHECK(header.size() % 64 == 0);
        CHECK(header.starts_with("\x93NUMPY\x01"));
        CHECK(header.back() == '\n');
        const auto length =
            static_cast<unsigned char>(header[8]) + 256U * static_cast<unsigned char>(header[9]);
        CHECK(length + 10 == header.size());
    }
    CHECK(exporting::npy_header("<f4", {7, 4}).find("'shape': (7, 4, ), }") != std::string::npos);
}
