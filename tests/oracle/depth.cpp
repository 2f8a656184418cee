#include "tests/support/catch.hpp"
#include "tests/support/exact_triangle.hpp"
#include "tests/support/mesa.hpp"
#include "tests/support/triangle_soup.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

using namespace hs;

namespace {

/// Triangles of every size that slope in depth, some within and some beyond the image.
tests::Soup sloping_soup(const PixelRect& image, int triangles, tests::Random& random) {
    constexpr std::array kinds{
        tests::SoupKind::anywhere,
        tests::SoupKind::subpixels,
        tests::SoupKind::slivers,
        tests::SoupKind::tiny,
        tests::SoupKind::huge};
    tests::Soup soup;
    for (int i = 0; i < triangles; ++i) {
        const auto kind = kinds[random.below(kinds.size())];
        const float steep = random.one_in(2) ? 0.02F : 0.95F;
        const float around = random.between(-0.95F + steep, 0.95F - steep);
        for (const glm::dvec2& window : tests::soup_triangle(kind, image, random)) {
            const float z = around + random.between(-steep, steep);
            soup.push_back({tests::clip_at(window, z, random.between(0.2F, 10.0F), image)});
        }
    }
    return soup;
}

std::vector<tests::ExactTriangle> exact_triangles(const tests::Soup& soup, const PixelRect& image) {
    std::vector<tests::ExactTriangle> result;
    for (std::size_t i = 0; i < soup.size(); i += 3) {
        const std::array corners{soup[i].clip, soup[i + 1].clip, soup[i + 2].clip};
        result.emplace_back(corners, image);
    }
    return result;
}

scene::Settings settings_for(int width, int height, scene::DepthFormat format) {
    scene::Settings settings;
    settings.width = width;
    settings.height = height;
    settings.clip_enabled = false;
    settings.depth_format = format;
    settings.depth_test_choice = scene::CompareOp::always;
    return settings;
}

} // namespace

TEST_CASE("stored depth agrees with Mesa within each triangle's tolerance", "[oracle][depth]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    tests::Random random(7);
    for (const auto format :
         {scene::DepthFormat::unorm24, scene::DepthFormat::unorm16, scene::DepthFormat::float32}) {
        std::int64_t compared = 0;
        double worst = 0.0; // in tolerances
        for (int round = 0; round < 60; ++round) {
            const bool odd = round % 2 == 1;
            const auto settings = settings_for(odd ? 255 : 256, odd ? 127 : 256, format);
            const tests::Soup soup = sloping_soup(settings.image(), 40, random);
            const auto exact = exact_triangles(soup, settings.image());
            const tests::Drawing ours = tests::drawn(tests::soup_scene(soup, settings));
            const peer::Image theirs =
                tests::drawn_by(*mesa, soup, settings, tests::Sides::do_not_clip);
            const bool same_coverage = ours.triangle == theirs.triangle;
            REQUIRE(same_coverage);
            for (std::size_t i = 0; i < theirs.depth.size(); ++i) {
                if (ours.triangle[i] < 0) {
                    continue;
                }
                const double difference = std::fabs(
                    static_cast<double>(ours.target.depth(ours.pixel(i))) -
                    static_cast<double>(theirs.depth[i])
                );
                const auto& triangle = exact[static_cast<std::size_t>(ours.triangle[i])];
                worst = std::max(worst, difference / tests::depth_tolerance(triangle, settings));
                ++compared;
            }
        }
        INFO(name_of(format) << ": " << compared << " pixels");
        CHECK(worst <= 1.0);
        CHECK(compared > 1'000'000);
    }
}
