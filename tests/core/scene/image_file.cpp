#include "core/scene/image_file.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <fstream>

using namespace hs;
using namespace hs::scene;

namespace {

std::filesystem::path temporary(const std::string& name) {
    return std::filesystem::temp_directory_path() / ("halfspace-" + name);
}

void write_png(
    const std::filesystem::path& path,
    int width,
    int height,
    int channels,
    const std::vector<unsigned char>& data
) {
    const auto output = OIIO::ImageOutput::create(path.string());
    REQUIRE(output);
    OIIO::ImageSpec spec{width, height, channels, OIIO::TypeDesc::UINT8};
    spec["oiio:UnassociatedAlpha"] = 1;
    REQUIRE(output->open(path.string(), spec));
    REQUIRE(output->write_image(OIIO::TypeDesc::UINT8, data.data()));
    REQUIRE(output->close());
}

} // namespace

TEST_CASE("colors of transparent texels are not multiplied by alpha", "[unit][scene]") {
    const auto path = temporary("alpha.png");
    write_png(path, 2, 1, 4, {255, 51, 0, 0, 255, 51, 0, 102});
    const Result<Texture> texture = load_texture(path);
    std::filesystem::remove(path);
    REQUIRE(texture);
    CHECK(texture->texel(0, 0) == glm::vec4{1.0F, 51.0F / 255.0F, 0.0F, 0.0F});
    CHECK(texture->texel(1, 0) == glm::vec4{1.0F, 51.0F / 255.0F, 0.0F, 102.0F / 255.0F});
}

TEST_CASE("gray becomes RGB, missing alpha 1, row 0 is the top", "[unit][scene]") {
    const auto path = temporary("gray.png");
    write_png(path, 1, 2, 1, {0, 255});
    const Result<Texture> texture = load_texture(path);
    std::filesystem::remove(path);
    REQUIRE(texture);
    CHECK(texture->width == 1);
    CHECK(texture->height == 2);
    CHECK(texture->texel(0, 0) == glm::vec4{0, 0, 0, 1});
    CHECK(texture->texel(0, 1) == glm::vec4{1, 1, 1, 1});
}

TEST_CASE("no prefix of an image crashes or passes for the whole", "[unit][scene]") {
    const auto path = temporary("prefix.png");
    write_png(path, 16, 16, 3, std::vector<unsigned char>(16 * 16 * 3, 77));
    std::ifstream stream{path, std::ios::binary};
    const std::string content{std::istreambuf_iterator<char>{stream}, {}};
    for (std::size_t size = 0; size + 16 < content.size(); ++size) {
        std::ofstream{path, std::ios::binary} << content.substr(0, size);
        const Result<Texture> texture = load_texture(path);
        REQUIRE_FALSE(texture);
        CHECK(texture.diagnostics()[0].file == path.string());
    }
    std::filesystem::remove(path);
    CHECK_FALSE(load_texture(path));
    CHECK_FALSE(load_texture(std::filesystem::temp_directory_path()));
}

TEST_CASE("the checker of the example scenes is small", "[unit][scene]") {
    const auto path = test::source_dir() / "lessons/scenes/checker.png";
    CHECK(std::filesystem::file_size(path) < 10'000);
    const Result<Texture> texture = load_texture(path);
    REQUIRE(texture);
    CHECK(texture->width == 64);
}
