// Weights, depth and varyings against exact arithmetic on the snapped triangle.
#include "core/raster/interpolation.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/rasterized.hpp"
#include "tests/support/triangle_soup.hpp"

#include <algorithm>
#include <cmath>

using namespace hs;

namespace {

constexpr double float_step = 0x1p-24; // half a unit in the last place of 1

const PixelRect image{0, 0, 64, 48};

struct Sample {
    raster::Fragment fragment;
    raster::Interpolants in;
    raster::TriangleSetup setup;
    raster::EdgeValues edges{};
};

/// Three vertices' values; `equal` makes them the same at all three.
struct Values {
    std::array<float, 3> depth{};
    std::array<float, 3> inv_w{};
    std::array<math::Varyings, 3> varyings;
};

Values random_values(bool equal, tests::Random& random) {
    Values v;
    for (std::size_t k = 0; k < 3; ++k) {
        v.depth[k] = random.between(0.0F, 1.0F);
        v.inv_w[k] = 1.0F / random.between(0.2F, 10.0F);
        for (int i = 0; i < math::max_varyings; ++i) {
            v.varyings[k][i] = random.between(-2.0F, 2.0F);
        }
        if (equal && k > 0) {
            v.depth[k] = v.depth[0];
            v.varyings[k] = v.varyings[0];
        }
    }
    return v;
}

raster::Interpolants interpolants(const Values& v, bool perspective) {
    return {
        .depth0 = v.depth[0],
        .depth1 = v.depth[1],
        .depth2 = v.depth[2],
        .inv_w0 = v.inv_w[0],
        .inv_w1 = v.inv_w[1],
        .inv_w2 = v.inv_w[2],
        .varyings0 = v.varyings[0].values.data(),
        .varyings1 = v.varyings[1].values.data(),
        .varyings2 = v.varyings[2].values.data(),
        .varying_count = math::max_varyings,
        .perspective = perspective};
}

/// Calls `check(sample)` for every fragment of triangles of every kind.
template <typename Check>
void for_many_fragments(bool equal, Check&& check) {
    tests::Random random(81);
    const auto viewport = geometry::make_viewport(image, scene::DepthConvention::opengl);
    for (int i = 0; i < 2000; ++i) {
        const auto kind = static_cast<tests::SoupKind>(random.below(tests::soup_kinds));
        std::vector<glm::vec4> corners;
        for (const glm::dvec2& window : tests::soup_triangle(kind, image, random)) {
            corners.push_back(tests::clip_at(window, 0.0F, 1.0F, image));
        }
        const auto setup = tests::setup_of(tests::placed(corners, viewport), image);
        const Values values = random_values(equal, random);
        const raster::Interpolants in = interpolants(values, i % 2 == 0);
        tests::rasterize(
            setup,
            image,
            scene::TraversalKind::bounding_box,
            [&](PixelPos pixel, const raster::EdgeValues& e) {
                check(Sample{raster::interpolate(in, *setup, pixel, e), in, *setup, e});
            }
        );
    }
}

/// λ0, λ1, λ2 rounded once.
std::array<double, 3> exact_weights(const Sample& s) {
    const auto area = static_cast<double>(s.setup.doubled_area);
    return {
        static_cast<double>(s.edges[1]) / area,
        static_cast<double>(s.edges[2]) / area,
        static_cast<double>(s.edges[0]) / area};
}

std::array<double, 3> exact_clip_weights(const Sample& s) {
    std::array<double, 3> w = exact_weights(s);
    if (s.in.perspective) {
        w[0] *= static_cast<double>(s.in.inv_w0);
        w[1] *= static_cast<double>(s.in.inv_w1);
        w[2] *= static_cast<double>(s.in.inv_w2);
        const double sum = w[0] + w[1] + w[2];
        for (double& weight : w) {
            weight /= sum;
        }
    }
    return w;
}

double worst_difference(const std::array<float, 3>& computed, const std::array<double, 3>& exact) {
    double worst = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        worst = std::max(worst, std::fabs(static_cast<double>(computed[k]) - exact[k]));
    }
    return worst;
}

} // namespace

TEST_CASE("barycentric weights are areas and sum to one", "[property][raster]") {
    double worst = 0.0;
    double worst_sum = 0.0;
    double lowest = 0.0;
    for_many_fragments(false, [&](const Sample& s) {
        const auto& [l0, l1, l2] = s.fragment.barycentric;
        worst = std::max(worst, worst_difference(s.fragment.barycentric, exact_weights(s)));
        worst_sum = std::max(worst_sum, std::fabs(static_cast<double>(l0 + l1 + l2) - 1.0));
        lowest = std::min({lowest, static_cast<double>(l1), static_cast<double>(l2)});
    });
    CHECK(worst <= 4.0 * float_step);
    CHECK(worst_sum <= 2.0 * float_step);
    CHECK(lowest == 0.0); // λ1 and λ2 of a covered pixel are never negative
}

TEST_CASE("perspective-correct weights are those of exact arithmetic", "[property][raster]") {
    // 1/w spans a factor of 50 here. Its interpolation loses a few last bits of the largest 1/w,
    // which count up to 50 times where 1/w is smallest.
    double worst = 0.0;
    for_many_fragments(false, [&](const Sample& s) {
        worst =
            std::max(worst, worst_difference(s.fragment.barycentric_clip, exact_clip_weights(s)));
    });
    CHECK(worst <= 50.0 * 2.0 * float_step);
}

TEST_CASE("depth and varyings are those of exact arithmetic", "[property][raster]") {
    double worst_depth = 0.0;
    double worst_varying = 0.0;
    for_many_fragments(false, [&](const Sample& s) {
        const std::array<double, 3> l = exact_weights(s);
        const double depth = l[0] * static_cast<double>(s.in.depth0) +
                             l[1] * static_cast<double>(s.in.depth1) +
                             l[2] * static_cast<double>(s.in.depth2);
        worst_depth =
            std::max(worst_depth, std::fabs(static_cast<double>(s.fragment.depth) - depth));
        const std::array<double, 3> b = exact_clip_weights(s);
        for (int i = 0; i < math::max_varyings; ++i) {
            const double value = b[0] * static_cast<double>(s.in.varyings0[i]) +
                                 b[1] * static_cast<double>(s.in.varyings1[i]) +
                                 b[2] * static_cast<double>(s.in.varyings2[i]);
            const double difference =
                std::fabs(static_cast<double>(s.fragment.varyings[i]) - value);
            worst_varying = std::max(worst_varying, difference);
        }
    });
    CHECK(worst_depth <= 4.0 * float_step);
    CHECK(worst_varying <= 4.0 * 50.0 * 2.0 * float_step); // values differ by up to 4
}

TEST_CASE("values equal at all vertices are interpolated exactly", "[property][raster]") {
    std::int64_t wrong = 0;
    std::int64_t fragments = 0;
    for_many_fragments(true, [&](const Sample& s) {
        bool equal = s.fragment.depth == s.in.depth0;
        for (int i = 0; i < math::max_varyings; ++i) {
            equal = equal && s.fragment.varyings[i] == s.in.varyings0[i];
        }
        wrong += equal ? 0 : 1;
        ++fragments;
    });
    CHECK(fragments > 100'000);
    CHECK(wrong == 0);
}

TEST_CASE("the weighted sum would not interpolate equal values exactly", "[property][raster]") {
    std::int64_t wrong = 0;
    std::int64_t fragments = 0;
    for_many_fragments(true, [&](const Sample& s) {
        const auto& [l0, l1, l2] = s.fragment.barycentric;
        const float sum = l0 * s.in.depth0 + l1 * s.in.depth1 + l2 * s.in.depth2;
        wrong += sum == s.in.depth0 ? 0 : 1;
        ++fragments;
    });
    CHECK(wrong > fragments / 10); // why interpolation is in difference form
}
