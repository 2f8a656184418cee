// Claims about whole frames with several samples a pixel.
#include "core/pipeline/draw_frame.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"
#include "tests/support/soup_scene.hpp"
#include "tests/support/triangle_soup.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <span>
#include <vector>

using namespace hs;

namespace {

constexpr std::array sample_counts{2, 4, 8};

framebuffer::Framebuffer rendered(const std::shared_ptr<const scene::Scene>& scene) {
    pipeline::Frame frame(scene);
    framebuffer::Framebuffer target(scene->settings);
    pipeline::NullTrace nothing;
    pipeline::draw_frame(frame, target, nothing);
    return target;
}

std::shared_ptr<scene::Scene> variant_of(const scene::Scene& scene) {
    return std::make_shared<scene::Scene>(scene);
}

/// Triangles of one color each, of these kinds in turn.
tests::Soup one_colored(
    const scene::Settings& settings, std::uint64_t seed, std::span<const tests::SoupKind> kinds
) {
    tests::Random random(seed);
    tests::Soup soup;
    for (std::size_t k = 0; k < 20; ++k) {
        const glm::vec4 color{
            random.between(0.0F, 1.0F),
            random.between(0.0F, 1.0F),
            0.5F,
            random.between(0.25F, 1.0F)};
        const tests::SoupKind kind = kinds[k % kinds.size()];
        for (const glm::dvec2& at : tests::soup_triangle(kind, settings.image(), random)) {
            const float z = random.between(-0.9F, 0.9F);
            soup.push_back({tests::clip_at(at, z, 1.0F, settings.image()), color});
        }
    }
    return soup;
}

/// The same as seen by a sample: moved so that it comes to lie on the pixel's center.
tests::Soup moved(const tests::Soup& soup, const raster::SampleOffset& offset) {
    constexpr float side = 16.0F;
    tests::Soup result = soup;
    for (tests::Corner& corner : result) {
        corner.clip.x -= 2.0F * static_cast<float>(offset.x) / 256.0F / side;
        corner.clip.y += 2.0F * static_cast<float>(offset.y) / 256.0F / side;
    }
    return result;
}

scene::Settings small_image() {
    scene::Settings settings;
    settings.width = 20;
    settings.height = 16;
    settings.clip_enabled = false;
    return settings;
}

/// The two triangles of a quadrilateral, split along a diagonal through its inside.
tests::Soup split_quad(const scene::Settings& settings, tests::Random& random) {
    const auto corner = [&](float x, float y) {
        const glm::dvec2 jitter{
            static_cast<double>(random.between(-4.0F, 4.0F)),
            static_cast<double>(random.between(-4.0F, 4.0F))};
        return tests::clip_at(
            glm::dvec2{static_cast<double>(x), static_cast<double>(y)} + jitter,
            0.0F,
            1.0F,
            settings.image()
        );
    };
    const std::array quad{
        corner(-6.0F, -6.0F), corner(26.0F, -6.0F), corner(26.0F, 22.0F), corner(-6.0F, 22.0F)};
    const std::size_t turn = random.below(2);
    tests::Soup soup;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
        soup.push_back({quad[(k + turn) % 4]});
    }
    for (const std::size_t k : {std::size_t{0}, std::size_t{2}, std::size_t{3}}) {
        soup.push_back({quad[(k + turn) % 4]});
    }
    return soup;
}

} // namespace

// The quadrilateral covers the whole image, so every sample is covered once. Color counts:
// each triangle adds, by blending 1/2 of white over black, half of what is left.
TEST_CASE("every sample on a shared edge is covered exactly once", "[property][raster]") {
    tests::Random random(5);
    for (int i = 0; i < 400; ++i) {
        scene::Settings settings = small_image();
        settings.samples = sample_counts[random.below(3)];
        settings.visibility = scene::Visibility::none;
        settings.color_format = scene::ColorFormat::rgba32f;
        settings.blend_enabled = true;
        tests::Soup soup = split_quad(settings, random);
        for (tests::Corner& corner : soup) {
            corner.color = {1.0F, 1.0F, 1.0F, 0.5F};
        }
        const framebuffer::Framebuffer target = rendered(tests::soup_scene(soup, settings));
        for (int y = 0; y < settings.height; ++y) {
            for (int x = 0; x < settings.width; ++x) {
                const framebuffer::PixelSamples held = target.samples({x, y});
                for (int s = 0; s < held.count; ++s) {
                    REQUIRE(held[s].color.r == 0.5F); // 0: never covered; 0.75: twice
                }
            }
        }
    }
}

// One sample's picture is the whole pipeline's picture of the scene moved by its offset, exact for
// vertices on a lattice in an image whose size is a power of two; a box filter averages them.
TEST_CASE("a resolved picture is the box filter over shifted pictures", "[property][raster]") {
    constexpr std::array lattices{
        tests::SoupKind::pixel_centers,
        tests::SoupKind::pixel_corners,
        tests::SoupKind::half_pixels,
        tests::SoupKind::subpixels,
        tests::SoupKind::subpixel_ties};
    scene::Settings settings = small_image();
    settings.width = 16;
    settings.visibility = scene::Visibility::none;
    settings.color_format = scene::ColorFormat::rgba32f;
    const int pixels = settings.width * settings.height;
    const auto at = [&](int i) { return PixelPos{i % settings.width, i / settings.width}; };
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const tests::Soup soup = one_colored(settings, seed, lattices);
        for (const int samples : sample_counts) {
            scene::Settings sampled = settings;
            sampled.samples = samples;
            const auto ours = rendered(tests::soup_scene(soup, sampled));
            std::vector<glm::dvec4> sums(static_cast<std::size_t>(pixels));
            for (const raster::SampleOffset& offset : raster::sample_pattern(samples)) {
                const auto shifted = rendered(tests::soup_scene(moved(soup, offset), settings));
                for (int i = 0; i < pixels; ++i) {
                    sums[static_cast<std::size_t>(i)] += glm::dvec4(shifted.color(at(i)));
                }
            }
            INFO("seed " << seed << ", " << samples << " samples");
            for (int i = 0; i < pixels; ++i) {
                const glm::dvec4 box =
                    sums[static_cast<std::size_t>(i)] / static_cast<double>(samples);
                REQUIRE(glm::length(box - glm::dvec4(ours.color(at(i)))) < 1e-6);
            }
        }
    }
}

TEST_CASE(
    "shading every sample changes nothing where triangles have one color", "[property][raster]"
) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        scene::Settings settings = small_image();
        settings.samples = 4;
        settings.interpolation = scene::InterpolationKind::flat;
        settings.blend_enabled = seed % 2 == 0;
        constexpr std::array kinds{
            tests::SoupKind::anywhere,
            tests::SoupKind::slivers,
            tests::SoupKind::tiny,
            tests::SoupKind::huge,
            tests::SoupKind::half_pixels};
        const auto once = tests::soup_scene(one_colored(settings, seed, kinds), settings);
        auto each = variant_of(*once);
        each->settings.sampling = scene::Sampling::supersample;
        REQUIRE(rendered(once).digest() == rendered(each).digest());
    }
}
