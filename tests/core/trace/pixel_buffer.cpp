#include "core/trace/pixel_buffer.hpp"

#include "tests/support/catch.hpp"

#include <array>

using namespace hs;
using trace::PixelBuffer;

namespace {

scene::Settings image(int width, int height) {
    scene::Settings settings;
    settings.width = width;
    settings.height = height;
    settings.background = {0.5F, 0.25F, 0.0F, 1.0F};
    return settings;
}

} // namespace

TEST_CASE("every pixel of a new buffer is cleared, to the rim of odd sizes", "[trace]") {
    const scene::Settings settings = image(70, 33);
    const PixelBuffer buffer(settings);
    int pixels = 0;
    int wrong = 0;
    buffer.for_each([&](PixelPos p, const trace::PixelRecord& pixel) {
        ++pixels;
        const bool inside = settings.image().contains(p);
        wrong += inside && pixel.depth == 1.0F && pixel.triangle == trace::no_triangle ? 0 : 1;
    });
    CHECK(pixels == 70 * 33);
    CHECK(wrong == 0);
    CHECK(buffer[{69, 32}].color == framebuffer::pack(settings.background));
}

TEST_CASE("writing through one copy never shows in another", "[trace]") {
    PixelBuffer first(image(70, 33));
    first.writable({40, 2}).depth = 0.25F;
    PixelBuffer second = first;
    second.writable({40, 2}).depth = 0.75F;
    CHECK(first[{40, 2}].depth == 0.25F);
    first.writable({41, 2}).depth = 0.5F;
    CHECK(second[{41, 2}].depth == 1.0F);
    CHECK(second[{40, 2}].depth == 0.75F);
}

TEST_CASE("two buffers differ at most where a tile was written", "[trace]") {
    const PixelBuffer first(image(100, 100));
    PixelBuffer second = first;
    CHECK(first.difference(second).empty());
    second.writable({40, 70}).overdraw = 1;
    CHECK(first.difference(second) == PixelRect{32, 64, 64, 96});
    second.writable({99, 99}).overdraw = 1;
    CHECK(first.difference(second) == PixelRect{32, 64, 100, 100});
}

TEST_CASE("tiles that copies share are counted once", "[trace]") {
    PixelBuffer first(image(64, 64));
    for (const PixelPos p : {PixelPos{0, 0}, {32, 0}, {0, 32}, {32, 32}}) {
        first.writable(p).overdraw = 1;
    }
    const PixelBuffer second = first;
    const std::array<const PixelBuffer*, 1> one{&first};
    const std::array<const PixelBuffer*, 2> both{&first, &second};
    CHECK(PixelBuffer::bytes_together(one) == first.bytes());
    CHECK(PixelBuffer::bytes_together(both) < first.bytes() + 1024);
}

TEST_CASE("float frames keep exact colors beside the records", "[trace]") {
    scene::Settings settings = image(3, 3);
    settings.color_format = scene::ColorFormat::rgba32f;
    PixelBuffer buffer(settings);
    CHECK(buffer.color({2, 2}) == settings.background);
    buffer.set_color32f({2, 2}, {0.1F, 2.0F, -1.0F, 0.5F});
    CHECK(buffer.color({2, 2}) == glm::vec4{0.1F, 2.0F, -1.0F, 0.5F});
    CHECK(buffer.color({1, 2}) == settings.background);
}
