// Any triangle: all traversals emit the same fragments, each pixel once, inside the bounds; three
// triangles around a point inside share its pixels without gap or overlap.
#include "core/geometry/facing.hpp"
#include "core/raster/traverse.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/target.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

using namespace hs;

namespace {

using Corners = std::array<FixedPosition, 3>;

/// Listens to a traversal and believes nothing.
struct Listener : raster::SilentTraversal {
    explicit Listener(const raster::TriangleSetup& to) : setup(to) {}

    const raster::TriangleSetup& setup;
    int last_unit = -1;

    void unit(int unit) {
        HS_CHECK(unit > last_unit, "units come in order");
        last_unit = unit;
    }
    void edge_test(PixelPos pixel, const raster::EdgeValues& values, bool inside) const {
        HS_CHECK(values == setup.evaluate(pixel), "values do not depend on the way to a pixel");
        HS_CHECK(inside == setup.covers(values), "nor do verdicts");
        HS_CHECK(
            values[0] + values[1] + values[2] == setup.doubled_area,
            "edge functions sum to the doubled area everywhere"
        );
    }
};

/// The pixels a traversal emits, sorted; each once.
std::vector<PixelPos> emitted(
    scene::TraversalKind kind,
    const raster::TriangleSetup& setup,
    const PixelRect& image,
    raster::UnitRange units = {}
) {
    std::vector<PixelPos> pixels;
    Listener listener{setup};
    raster::traverse(
        {kind},
        setup,
        image,
        units,
        listener,
        [&](PixelPos pixel, const raster::EdgeValues&) {
            HS_CHECK(setup.bounds.contains(pixel), "bounds contain what is covered");
            pixels.push_back(pixel);
        }
    );
    std::ranges::sort(pixels);
    HS_CHECK(std::ranges::adjacent_find(pixels) == pixels.end(), "a pixel is emitted once");
    return pixels;
}

/// What a triangle covers, asked of every traversal, whole and in two parts.
std::vector<PixelPos> covered(const Corners& corners, const PixelRect& image, int split) {
    const std::int64_t area = geometry::doubled_area(corners[0], corners[1], corners[2]);
    if (area == 0) {
        return {};
    }
    const raster::TriangleSetup setup = raster::set_up(corners, area, image);
    HS_CHECK(intersect(setup.bounds, image) == setup.bounds || setup.bounds.empty(), "clipped");
    std::vector<PixelPos> expected = emitted(scene::TraversalKind::brute_force, setup, image);
    for (const auto& row : names<scene::TraversalKind>()) {
        HS_CHECK(emitted(row.value, setup, image) == expected, "all traversals agree");
        std::vector<PixelPos> parts = emitted(row.value, setup, image, {0, split});
        const auto second = emitted(row.value, setup, image, {split});
        parts.insert(parts.end(), second.begin(), second.end());
        std::ranges::sort(parts);
        HS_CHECK(parts == expected, "units cut a traversal without gap or overlap");
    }
    return expected;
}

FixedPosition take_position(fuzz::Bytes& bytes, unsigned scale) {
    // Small shifts stay near the image, where ties are; 0 reaches the limit of snapping
    constexpr std::int32_t limit = 1 << 30;
    const auto coordinate = [&] {
        return std::clamp(bytes.take<std::int32_t>() >> scale, -limit, limit);
    };
    const std::int32_t x = coordinate();
    return {x, coordinate()};
}

bool is_inside(const Corners& corners, FixedPosition p) {
    const auto side = [&](std::size_t k) {
        return geometry::doubled_area(corners[k], corners[(k + 1) % 3], p) > 0;
    };
    return side(0) == side(1) && side(1) == side(2);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes bytes(data, size);
    const PixelRect image{
        0, 0, 1 + bytes.take<std::uint8_t>() % 32, 1 + bytes.take<std::uint8_t>() % 32};
    const unsigned scale = bytes.take<std::uint8_t>() % 28U;
    const int split = bytes.take<std::uint8_t>() % 40;
    const Corners corners{
        take_position(bytes, scale), take_position(bytes, scale), take_position(bytes, scale)};
    const auto whole = covered(corners, image, split);

    const FixedPosition middle = take_position(bytes, scale);
    if (!is_inside(corners, middle)) {
        return 0;
    }
    std::vector<PixelPos> parts;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto part = covered({corners[k], corners[(k + 1) % 3], middle}, image, split);
        parts.insert(parts.end(), part.begin(), part.end());
    }
    std::ranges::sort(parts);
    HS_CHECK(parts == whole, "shared edges neither leave gaps nor draw twice");
    return 0;
}
