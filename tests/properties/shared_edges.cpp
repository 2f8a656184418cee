// Meshes have no cracks and no double hits: the pixel centers on a shared edge belong to exactly
// one of its two triangles.
#include "core/scene/triangulate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/rasterized.hpp"
#include "tests/support/soup_scene.hpp"
#include "tests/support/triangle_soup.hpp"

#include <algorithm>
#include <array>
#include <cmath>

using namespace hs;

namespace {

/// How many triangles cover each pixel.
class HitCount {
public:
    explicit HitCount(const PixelRect& image)
        : image_(image),
          viewport_(geometry::make_viewport(image, scene::DepthConvention::opengl)),
          hits_(static_cast<std::size_t>(image.width() * image.height())) {}

    void add(const tests::WindowTriangle& triangle) {
        const std::array corners{
            tests::clip_at(triangle[0], 0.0F, 1.0F, image_),
            tests::clip_at(triangle[1], 0.0F, 1.0F, image_),
            tests::clip_at(triangle[2], 0.0F, 1.0F, image_)};
        tests::rasterize(
            tests::setup_of(tests::placed(corners, viewport_), image_),
            image_,
            next_traversal(),
            [&](PixelPos p, const raster::EdgeValues&) {
                ++hits_[static_cast<std::size_t>(p.y * image_.width() + p.x)];
            }
        );
    }
    /// Pixels that are not covered exactly once.
    [[nodiscard]] std::int64_t wrong() const {
        return std::ranges::count_if(hits_, [](int hits) { return hits != 1; });
    }

private:
    /// Neighbors are drawn by different traversals: each must own its edges alike.
    scene::TraversalKind next_traversal() {
        const auto all = names<scene::TraversalKind>();
        return all[added_++ % all.size()].value;
    }

    PixelRect image_;
    geometry::Viewport viewport_;
    std::vector<int> hits_;
    std::size_t added_ = 0;
};

/// Where the vertices of a mesh may lie.
struct Lattice {
    const char* name;
    double step; ///< 0: anywhere
    double offset;
    [[nodiscard]] glm::dvec2 nearest(const glm::dvec2& p) const {
        return step == 0.0 ? p : offset + step * glm::round((p - offset) / step);
    }
};
constexpr std::array<Lattice, 6> lattices{{
    {"anywhere", 0.0, 0.0},
    {"pixel centers", 1.0, 0.5},
    {"pixel corners", 1.0, 0.0},
    {"half pixels", 0.5, 0.0},
    {"1/256 pixels", 1.0 / 256.0, 0.0},
    {"1/512 pixels", 1.0 / 512.0, 0.0},
}};

double jitter(tests::Random& random, double reach) {
    return (static_cast<double>(random.below(2001)) / 1000.0 - 1.0) * reach;
}

/// Vertices of a grid that reaches beyond the image, each moved by up to a fifth of a cell: cells
/// stay convex.
class JitteredGrid {
public:
    JitteredGrid(const PixelRect& image, double cell, const Lattice& lattice, tests::Random& random)
        : columns_(static_cast<int>(image.width() / cell) + 5),
          rows_(static_cast<int>(image.height() / cell) + 5) {
        for (int j = 0; j < rows_; ++j) {
            for (int i = 0; i < columns_; ++i) {
                const glm::dvec2 regular{(i - 2) * cell, (j - 2) * cell};
                vertices_.push_back(lattice.nearest(
                    regular + glm::dvec2{jitter(random, 0.2 * cell), jitter(random, 0.2 * cell)}
                ));
            }
        }
    }
    /// Two triangles per cell, along either diagonal and in any winding.
    void draw(HitCount& hits, tests::Random& random) const {
        for (int j = 0; j + 1 < rows_; ++j) {
            for (int i = 0; i + 1 < columns_; ++i) {
                const std::array corners{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
                const std::size_t k = random.below(2);
                for (const std::size_t turn : {k, k + 2}) {
                    tests::WindowTriangle t{
                        corners[turn % 4], corners[(turn + 1) % 4], corners[(turn + 2) % 4]};
                    if (random.one_in(2)) {
                        std::swap(t[0], t[1]);
                    }
                    hits.add(t);
                }
            }
        }
    }

private:
    [[nodiscard]] glm::dvec2 at(int i, int j) const {
        return vertices_[static_cast<std::size_t>(j * columns_ + i)];
    }
    int columns_;
    int rows_;
    std::vector<glm::dvec2> vertices_;
};

/// Points on a rectangle around the image, its corners among them, in angular order.
std::vector<glm::dvec2>
ring(const PixelRect& image, const Lattice& lattice, int extra, tests::Random& random) {
    const double x0 = -20.0;
    const double y0 = -20.0;
    const double x1 = image.width() + 20.0;
    const double y1 = image.height() + 20.0;
    std::vector<glm::dvec2> points{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    for (int i = 0; i < extra; ++i) {
        const double along = (1.0 + jitter(random, 1.0)) / 2.0;
        const double x = x0 + along * (x1 - x0);
        const double y = y0 + along * (y1 - y0);
        const std::array<glm::dvec2, 4> sides{{{x, y0}, {x, y1}, {x0, y}, {x1, y}}};
        points.push_back(sides[random.below(4)]);
    }
    for (glm::dvec2& p : points) {
        p = lattice.nearest(p);
    }
    return points;
}

} // namespace

TEST_CASE("every pixel of a jittered mesh is covered exactly once", "[property][raster]") {
    tests::Random random(61);
    std::int64_t wrong = 0;
    for (const PixelRect& image : {PixelRect{0, 0, 64, 64}, PixelRect{0, 0, 61, 37}}) {
        for (const Lattice& lattice : lattices) {
            for (const double cell : {2.5, 6.0, 40.0}) {
                for (int round = 0; round < 25; ++round) {
                    HitCount hits(image);
                    JitteredGrid(image, cell, lattice, random).draw(hits, random);
                    wrong += hits.wrong();
                }
                INFO("vertices at " << lattice.name << ", cells of " << cell << " pixels");
                CHECK(wrong == 0);
            }
        }
    }
}

TEST_CASE("every pixel around the hub of a fan is covered exactly once", "[property][raster]") {
    tests::Random random(62);
    const PixelRect image{0, 0, 48, 40};
    for (const Lattice& lattice : lattices) {
        std::int64_t wrong = 0;
        for (int round = 0; round < 200; ++round) {
            const glm::dvec2 hub =
                lattice.nearest({24.0 + jitter(random, 23.0), 20.0 + jitter(random, 19.0)});
            std::vector<glm::dvec2> points = ring(image, lattice, 40, random);
            std::ranges::sort(points, {}, [&](const glm::dvec2& p) {
                return std::atan2(p.y - hub.y, p.x - hub.x);
            });
            HitCount hits(image);
            for (std::size_t i = 0; i < points.size(); ++i) {
                hits.add({hub, points[i], points[(i + 1) % points.size()]});
            }
            wrong += hits.wrong();
        }
        INFO("vertices at " << lattice.name);
        CHECK(wrong == 0);
    }
}

namespace {

/// A cube of side 2 whose faces are grids of vertices, jittered within their face; neighbors share
/// theirs. Lattice points inside the cube exist and are not used.
std::shared_ptr<scene::Mesh> jittered_room(int cells, tests::Random& random) {
    auto mesh = std::make_shared<scene::Mesh>();
    const float cell = 2.0F / static_cast<float>(cells);
    const auto index = [&](int i, int j, int k) { return (k * (cells + 1) + j) * (cells + 1) + i; };
    for (int n = 0; n < (cells + 1) * (cells + 1) * (cells + 1); ++n) {
        const std::array at{
            n % (cells + 1), n / (cells + 1) % (cells + 1), n / (cells + 1) / (cells + 1)};
        glm::vec4 p{0.0F, 0.0F, 0.0F, 1.0F};
        for (int axis = 0; axis < 3; ++axis) {
            const int coordinate = at[static_cast<std::size_t>(axis)];
            const bool inner = coordinate > 0 && coordinate < cells;
            p[axis] = -1.0F + cell * static_cast<float>(coordinate) +
                      (inner ? random.between(-0.2F, 0.2F) * cell : 0.0F);
        }
        mesh->positions.push_back(p);
    }
    const auto quad = [&](int a, int b, int c, int d) {
        for (const int corner : {a, b, c, a, c, d}) {
            mesh->polygon_vertices.push_back(static_cast<std::uint32_t>(corner));
        }
    };
    for (int u = 0; u < cells; ++u) {
        for (int v = 0; v < cells; ++v) {
            for (const int side : {0, cells}) {
                quad(
                    index(u, v, side),
                    index(u + 1, v, side),
                    index(u + 1, v + 1, side),
                    index(u, v + 1, side)
                );
                quad(
                    index(u, side, v),
                    index(u + 1, side, v),
                    index(u + 1, side, v + 1),
                    index(u, side, v + 1)
                );
                quad(
                    index(side, u, v),
                    index(side, u + 1, v),
                    index(side, u + 1, v + 1),
                    index(side, u, v + 1)
                );
            }
        }
    }
    for (std::uint32_t i = 0; i <= mesh->polygon_vertices.size(); i += 3) {
        mesh->polygon_start.push_back(i);
    }
    scene::finish_mesh(*mesh);
    return mesh;
}

/// A room seen from inside, in a random direction.
std::shared_ptr<scene::Scene> room(int cells, tests::Random& random) {
    auto scene = std::make_shared<scene::Scene>();
    scene->settings.width = 80;
    scene->settings.height = 60;
    scene->settings.visibility = scene::Visibility::none;
    scene->objects.emplace_back().mesh = jittered_room(cells, random);
    const auto point = [&random](float reach) {
        return glm::vec3{
            random.between(-reach, reach),
            random.between(-reach, reach),
            random.between(-reach, reach)};
    };
    scene->camera.eye = point(0.7F);
    scene->camera.target = scene->camera.eye + point(1.0F);
    scene->camera.projection.fov_y = random.between(30.0F, 120.0F);
    scene->camera.projection.near = 0.01F;
    return scene;
}

std::int64_t not_hit(const tests::Drawing& drawing, bool (*right)(int)) {
    return std::ranges::count_if(drawing.covered, [right](int hits) { return !right(hits); });
}

} // namespace

TEST_CASE("a room around the eye covers every pixel exactly once", "[property][clip]") {
    tests::Random random(63);
    for (const int cells : {1, 3, 9}) {
        std::int64_t wrong = 0;
        for (int round = 0; round < 60; ++round) {
            wrong += not_hit(tests::drawn(room(cells, random)), [](int hits) { return hits == 1; });
        }
        INFO(cells << " cells along an edge");
        CHECK(wrong == 0);
    }
}

TEST_CASE("a room around the eye needs no clipping to be watertight", "[property][clip]") {
    tests::Random random(65);
    for (const bool clips : {true, false}) {
        std::int64_t wrong = 0;
        for (const int cells : {1, 3}) {
            for (int round = 0; round < 40; ++round) {
                const auto scene = room(cells, random);
                scene->settings.traversal = scene::TraversalKind::homogeneous;
                scene->settings.clip_enabled = clips;
                wrong += not_hit(tests::drawn(scene), [](int hits) { return hits == 1; });
            }
        }
        INFO("clipping " << (clips ? "on" : "off"));
        CHECK(wrong == 0);
    }
}

TEST_CASE("a room cut by near and user planes covers no pixel twice", "[property][clip]") {
    tests::Random random(64);
    std::int64_t wrong = 0;
    for (int round = 0; round < 100; ++round) {
        const auto scene = room(5, random);
        scene->camera.projection.near = random.between(0.3F, 1.0F);
        scene->settings.clip_planes = {{0.3F, 0.5F, 0.2F, random.between(0.0F, 0.5F)}};
        wrong += not_hit(tests::drawn(scene), [](int hits) { return hits <= 1; });
    }
    CHECK(wrong == 0);
}
