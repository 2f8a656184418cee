// Pictures are opened again by OpenImageIO and hold what the player shows.
#include "core/export/picture_file.hpp"
#include "tests/export/recorded.hpp"
#include "tests/export/temporary_folder.hpp"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <map>
#include <memory>
#include <set>

using namespace hs;
using tests::TemporaryFolder;

namespace {

const std::vector<std::string> stage_buffers{
    "color", "depth", "triangle", "overdraw", "complexity"};

std::vector<exporting::Layer>
layers_of(const trace::Player& player, const std::vector<std::string>& names) {
    auto layers = exporting::make_layers(player, names);
    REQUIRE(layers);
    return *layers;
}

/// An image as another program reads it, channels by name.
struct ReadBack {
    OIIO::ImageSpec spec;
    std::map<std::string, std::vector<float>> channels;
};

ReadBack read_floats(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    REQUIRE(input);
    ReadBack image{input->spec(), {}};
    const auto count = static_cast<std::size_t>(image.spec.nchannels);
    const auto pixels = image.spec.image_pixels();
    std::vector<float> values(pixels * count);
    REQUIRE(input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, values.data()));
    for (std::size_t c = 0; c < count; ++c) {
        std::vector<float>& channel = image.channels[image.spec.channelnames[c]];
        for (std::size_t i = 0; i < pixels; ++i) {
            channel.push_back(values[i * count + c]);
        }
    }
    return image;
}

template <typename T>
std::vector<T> read_png(const std::filesystem::path& path, OIIO::TypeDesc type, int channels) {
    OIIO::ImageSpec raw;
    raw.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path.string(), &raw);
    REQUIRE(input);
    REQUIRE(input->spec().format == type);
    REQUIRE(input->spec().nchannels == channels);
    std::vector<T> values(input->spec().image_pixels() * static_cast<std::size_t>(channels));
    REQUIRE(input->read_image(0, 0, 0, -1, type, values.data()));
    return values;
}

bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// How many values of the file differ from what the player shows, in any bit.
int differing(const ReadBack& image, const trace::Player& player) {
    int differing = 0;
    std::size_t i = 0;
    const auto compare = [&](const char* channel, float shown) {
        differing += same_bits(image.channels.at(channel)[i], shown) ? 0 : 1;
    };
    for (int y = 0; y < player.recording().height(); ++y) {
        for (int x = 0; x < player.recording().width(); ++x, ++i) {
            const PixelPos p{x, y};
            const trace::PixelRecord& pixel = player.pixel(p);
            const glm::vec4 color = player.color(p);
            compare("R", color.r);
            compare("G", color.g);
            compare("B", color.b);
            compare("A", color.a);
            compare("Z", pixel.depth);
            compare(
                "triangle",
                pixel.triangle == trace::no_triangle ? -1.0F : static_cast<float>(pixel.triangle)
            );
            compare("overdraw", static_cast<float>(player.overdraw(p)));
            compare("complexity", static_cast<float>(player.complexity(p)));
        }
    }
    return differing;
}

} // namespace

TEST_CASE("an EXR holds the bits that the player shows, at any step", "[export][exr]") {
    const TemporaryFolder folder;
    for (std::uint64_t seed = 0; seed < tests::random_frames; ++seed) {
        INFO("random scene " << seed);
        const trace::Player player = tests::random_player(seed);
        const auto layers = layers_of(player, stage_buffers);
        REQUIRE(exporting::write_exr(folder / "all.exr", layers, {}));
        const ReadBack image = read_floats(folder / "all.exr");
        CHECK(image.spec.format == OIIO::TypeDesc::FLOAT);
        CHECK(image.spec.width == player.recording().width());
        CHECK(image.spec.height == player.recording().height());
        CHECK(image.channels.size() == 8);
        CHECK(differing(image, player) == 0);
    }
}

TEST_CASE("an EXR says which step of which scene it shows", "[export][exr]") {
    const TemporaryFolder folder;
    const trace::Player player = tests::random_player(3);
    const auto layers = layers_of(player, {"depth"});
    REQUIRE(exporting::write_exr(folder / "depth.exr", layers, exporting::attributes_of(player)));
    const ReadBack image = read_floats(folder / "depth.exr");
    CHECK(image.spec.get_string_attribute("halfspace:scene") == "random scene 3");
    CHECK(image.spec.get_string_attribute("halfspace:step") == trace::step_path(player.current()));
    CHECK(
        image.spec.get_string_attribute("halfspace:step_number") ==
        fmt::format("#{}", player.step())
    );
    CHECK(
        image.spec.get_string_attribute("halfspace:settings.depth.test") ==
        scene::print_setting(player.recording().settings(), "depth.test")
    );
}

TEST_CASE("a PNG of depth is 16-bit gray over [0, 1]", "[export][png]") {
    const TemporaryFolder folder;
    for (std::uint64_t seed = 0; seed < tests::random_frames; ++seed) {
        const trace::Player player = tests::random_player(seed);
        const auto layer = layers_of(player, {"depth"}).front();
        REQUIRE(exporting::write_png(folder / "depth.png", layer, {}));
        const auto gray = read_png<std::uint16_t>(folder / "depth.png", OIIO::TypeDesc::UINT16, 1);
        int wrong = 0;
        for (std::size_t i = 0; i < gray.size(); ++i) {
            wrong += gray[i] == std::lround(layer.values[i] * 65535.0F) ? 0 : 1;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("a PNG of colors keeps all four channels as the buffer has them", "[export][png]") {
    const TemporaryFolder folder;
    for (std::uint64_t seed = 0; seed < tests::random_frames; ++seed) {
        const trace::Player player = tests::random_player(seed);
        const auto layer = layers_of(player, {"color"}).front();
        REQUIRE(exporting::write_png(folder / "color.png", layer, {}));
        const auto bytes = read_png<std::uint8_t>(folder / "color.png", OIIO::TypeDesc::UINT8, 4);
        int wrong = 0;
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            wrong += bytes[i] == framebuffer::to_unorm8(layer.values[i]) ? 0 : 1;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("a PNG of counts is 16-bit gray, the count itself", "[export][png]") {
    const TemporaryFolder folder;
    const trace::Player player = tests::random_player(5);
    const auto layer = layers_of(player, {"complexity"}).front();
    REQUIRE(exporting::write_png(folder / "complexity.png", layer, {}));
    const auto gray = read_png<std::uint16_t>(folder / "complexity.png", OIIO::TypeDesc::UINT16, 1);
    for (std::size_t i = 0; i < gray.size(); ++i) {
        REQUIRE(gray[i] == static_cast<std::uint16_t>(layer.values[i]));
    }
}

TEST_CASE("a PNG of triangles gives each number a color of its own", "[export][png]") {
    std::set<framebuffer::Rgba8> seen;
    for (std::int64_t number = -1; number < 100000; ++number) {
        seen.insert(exporting::number_color(number));
    }
    CHECK(seen.size() == 100001);
    CHECK(exporting::number_color(-1) == 0xFF000000U);
    CHECK(exporting::number_color(0) == 0xFF000080U); // the classic color map begins dark red,
    CHECK(exporting::number_color(1) == 0xFF008000U); // dark green,
    CHECK(exporting::number_color(2) == 0xFF008080U); // olive
}

TEST_CASE("edge functions and barycentric weights need a triangle that was set up", "[export]") {
    const trace::Player at_end(tests::recorded(tests::random_scene(1)));
    const auto nothing = exporting::make_layers(at_end, std::vector<std::string>{"edge0"});
    REQUIRE_FALSE(nothing);
    CHECK(
        nothing.diagnostics().front().message ==
        "'edge0' needs a step of a triangle that was set up; end is none"
    );
}

TEST_CASE(
    "barycentric weights add up to 1 and are not negative where a pixel is covered", "[export]"
) {
    int covered = 0;
    for (std::uint64_t seed = 0; seed < tests::random_frames; ++seed) {
        trace::Player player(tests::recorded(tests::random_scene(seed)));
        if (!player.find_stage(trace::Stage::merge, trace::Direction::backward)) {
            continue;
        }
        if (player.recording().settings().visibility == scene::Visibility::ray_cast) {
            continue; // a ray meets triangles without asking their edges
        }
        player.seek(*player.find_stage(trace::Stage::merge, trace::Direction::backward));
        const auto layers = layers_of(player, {"barycentric", "edge0", "edge1", "edge2"});
        const PixelPos p = player.current().pixel;
        const auto at = static_cast<std::size_t>(p.y * player.recording().width() + p.x);
        const float* weights = &layers[0].values[3 * at];
        CHECK(weights[0] + weights[1] + weights[2] == Approx(1.0F));
        CHECK(weights[1] >= 0.0F);
        CHECK(weights[2] >= 0.0F);
        for (int edge = 1; edge <= 3; ++edge) {
            CHECK(layers[static_cast<std::size_t>(edge)].values[at] >= 0.0F);
        }
        ++covered;
    }
    CHECK(covered > 10);
}
