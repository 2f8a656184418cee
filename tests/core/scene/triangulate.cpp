#include "core/scene/triangulate.hpp"

#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace hs::scene;

namespace {

Mesh mesh_of(const std::vector<glm::vec3>& corners) {
    Mesh mesh;
    mesh.polygon_start.push_back(0);
    for (const glm::vec3& p : corners) {
        mesh.polygon_vertices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.emplace_back(p, 1.0F);
    }
    mesh.polygon_start.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
    return mesh;
}

Mesh finished(const std::vector<glm::vec3>& corners) {
    Mesh mesh = mesh_of(corners);
    finish_mesh(mesh);
    return mesh;
}

/// Signed by +z.
double area(const Mesh& mesh, const TriangleIndices& t) {
    const glm::dvec3 a{mesh.positions[t.a]};
    return 0.5 *
           glm::cross(glm::dvec3{mesh.positions[t.b]} - a, glm::dvec3{mesh.positions[t.c]} - a).z;
}

double polygon_area(const std::vector<glm::vec3>& p) {
    double sum = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const glm::dvec3 a{p[i]};
        const glm::dvec3 b{p[(i + 1) % p.size()]};
        sum += 0.5 * (a.x * b.y - a.y * b.x);
    }
    return sum;
}

/// All triangles have positive area and together that of the polygon: with n − 2 (or n around a
/// kernel point) this means that they tile it.
void check_tiles(const std::vector<glm::vec3>& corners, std::size_t triangles) {
    const Mesh mesh = finished(corners);
    CHECK(mesh.triangles.size() == triangles);
    double sum = 0.0;
    for (const TriangleIndices& t : mesh.triangles) {
        CHECK(area(mesh, t) > 0.0);
        sum += area(mesh, t);
    }
    CHECK(sum == Approx(polygon_area(corners)));
}

} // namespace

TEST_CASE("a triangle stays as it is", "[unit][scene]") {
    const Mesh mesh = finished({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(mesh.triangles == std::vector<TriangleIndices>{{0, 1, 2}});
    CHECK(mesh.normals == std::vector<glm::vec3>(3, {0, 0, 1}));
}

TEST_CASE("a convex polygon is fanned from its corner 0", "[unit][scene]") {
    const Mesh mesh = finished({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}});
    CHECK(mesh.triangles == std::vector<TriangleIndices>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
    CHECK(mesh.triangle_polygon == std::vector<std::uint32_t>{0, 0, 0});
}

TEST_CASE("a dart is fanned from its lowest corner that sees all others", "[unit][scene]") {
    // Corner 2 is reflex: only it and the tip opposite see everything.
    CHECK(
        finished({{0, 3, 0}, {-2, -2, 0}, {0, -1, 0}, {2, -2, 0}}).triangles[0] ==
        TriangleIndices{0, 1, 2}
    );
    CHECK(
        finished({{-2, -2, 0}, {0, -1, 0}, {2, -2, 0}, {0, 3, 0}}).triangles[0] ==
        TriangleIndices{1, 2, 3}
    );
}

TEST_CASE("a star without such a corner is fanned from a kernel point", "[unit][scene]") {
    std::vector<glm::vec3> star;
    for (int i = 0; i < 10; ++i) {
        const float angle = static_cast<float>(i) * std::numbers::pi_v<float> / 5.0F;
        const float radius = i % 2 == 0 ? 2.0F : 0.6F;
        star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0F);
    }
    check_tiles(star, 10);
    Mesh mesh = mesh_of(star);
    for (const glm::vec4& p : mesh.positions) {
        mesh.colors.emplace_back(p.x, p.y, 0.25F, 1.0F); // a linear function of the place
        mesh.uvs.emplace_back(3.0F * p.x - p.y, 1.0F);
    }
    finish_mesh(mesh);
    REQUIRE(mesh.positions.size() == 11);
    const glm::vec4 kernel = mesh.positions[10];
    CHECK(mesh.colors[10].x == Approx(kernel.x).margin(1e-6));
    CHECK(mesh.colors[10].y == Approx(kernel.y).margin(1e-6));
    CHECK(mesh.colors[10].z == 0.25F);
    CHECK(mesh.uvs[10].x == Approx(3.0F * kernel.x - kernel.y).margin(1e-6));
    CHECK(mesh.uvs[10].y == 1.0F);
    CHECK(mesh.normals.size() == 11);
}

TEST_CASE("a polygon without kernel is cut ear by ear", "[unit][scene]") {
    check_tiles(
        {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}, 6
    ); // U
    // A comb, whose teeth see nothing of each other.
    std::vector<glm::vec3> comb{{0, -1, 0}};
    for (int i = 0; i < 20; ++i) {
        comb.emplace_back(static_cast<float>(2 * i), 5.0F, 0.0F);
        comb.emplace_back(static_cast<float>(2 * i + 1), 0.0F, 0.0F);
    }
    std::reverse(comb.begin(), comb.end());
    check_tiles(comb, comb.size() - 2);
}

TEST_CASE("points on straight edges make no triangles without area", "[unit][scene]") {
    check_tiles({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, 3);
    check_tiles(
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}}, 6
    );
}

TEST_CASE("random star-shaped polygons are tiled in any plane", "[unit][scene]") {
    std::mt19937 random{11};
    for (int round = 0; round < 300; ++round) {
        const int count = 4 + static_cast<int>(random() % 12);
        std::vector<glm::vec3> flat;
        for (int i = 0; i < count; ++i) {
            const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) /
                                static_cast<float>(count);
            const float radius = 0.3F + static_cast<float>(random() % 1000) / 1000.0F;
            flat.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0F);
        }
        const double expected = polygon_area(flat);
        // Tilt: the same polygon over another plane has a multiple of the area.
        std::vector<glm::vec3> tilted;
        for (const glm::vec3& p : flat) {
            tilted.emplace_back(p.y, p.x + 0.25F * p.y, -3.0F * p.x + 0.5F);
        }
        const Mesh mesh = finished(tilted);
        glm::dvec3 sum{0.0};
        double sizes = 0.0;
        for (const TriangleIndices& t : mesh.triangles) {
            const glm::dvec3 a{mesh.positions[t.a]};
            const glm::dvec3 n =
                0.5 * glm::cross(
                          glm::dvec3{mesh.positions[t.b]} - a, glm::dvec3{mesh.positions[t.c]} - a
                      );
            sum += n;
            sizes += glm::length(n);
        }
        // No triangle is turned over when the sizes add up like the vectors.
        REQUIRE(sizes == Approx(glm::length(sum)));
        REQUIRE(
            sizes / expected == Approx(glm::length(glm::dvec3{-3.0, -0.75, -1.0})).epsilon(0.2)
        );
    }
}

TEST_CASE("degenerate polygons give n - 2 triangles and finite normals", "[unit][scene]") {
    const std::vector<std::vector<glm::vec3>> polygons{
        {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},                    // a point
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}},       // a line
        {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},                    // a bow tie
        {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 0, 0}},         // there and back
        {{0, 0, 0}, {3e38F, 0, 0}, {3e38F, 3e38F, 0}, {0, 3e38F, 0}},    // huge
        {{0, 0, 0}, {1e-40F, 0, 0}, {1e-40F, 1e-40F, 0}, {0, 1e-40F, 0}} // tiny
    };
    for (const std::vector<glm::vec3>& polygon : polygons) {
        const Mesh mesh = finished(polygon);
        CHECK(mesh.triangles.size() == polygon.size() - 2);
        for (const glm::vec3& n : mesh.normals) {
            CHECK(glm::length(n) == Approx(1.0F));
        }
    }
}

TEST_CASE("a polygon that reaches behind the eye is fanned from corner 0", "[unit][scene]") {
    Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    mesh.positions[2].w = -1.0F;
    finish_mesh(mesh);
    CHECK(mesh.triangles == std::vector<TriangleIndices>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE(
    "vertex normals weigh faces by area and are shared across split vertices", "[unit][scene]"
) {
    Mesh mesh;
    mesh.positions = {
        {0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 0, 1}, {0, 3, 0, 1}, {0, 0, 1, 1}};
    mesh.polygon_start = {0, 3, 6};
    mesh.polygon_vertices = {0, 1, 2, 3, 4, 5};
    mesh.file_vertex = {0, 1, 2, 0, 3, 4};
    finish_mesh(mesh);
    const glm::vec3 shared = glm::normalize(glm::vec3{3.0F, 0.0F, 1.0F});
    CHECK(mesh.normals[0] == mesh.normals[3]);
    CHECK(glm::length(mesh.normals[0] - shared) < 1e-6F);
    CHECK(mesh.normals[1] == glm::vec3{0, 0, 1});
}

TEST_CASE("given normals come to unit length, those of length 0 are computed", "[unit][scene]") {
    Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    mesh.normals = {{0, 5, 0}, {0, 0, 0}, {1e-30F, 0, 0}};
    finish_mesh(mesh);
    CHECK(mesh.normals == std::vector<glm::vec3>{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}});
}

TEST_CASE(
    "fitting puts the middle of the box at the origin and the farthest vertex at 1", "[unit][scene]"
) {
    Mesh mesh = mesh_of({{10, 20, 30}, {14, 20, 30}, {10, 23, 30}});
    fit_to_unit_sphere(mesh);
    CHECK(mesh.positions[0] == glm::vec4{-0.8F, -0.6F, 0.0F, 1.0F});
    CHECK(mesh.positions[1] == glm::vec4{0.8F, -0.6F, 0.0F, 1.0F});
    Mesh point = mesh_of({{7, 7, 7}, {7, 7, 7}, {7, 7, 7}});
    fit_to_unit_sphere(point);
    CHECK(point.positions[0] == glm::vec4{7, 7, 7, 1});
    Mesh empty;
    fit_to_unit_sphere(empty);
    finish_mesh(empty);
    CHECK(empty.triangles.empty());
}
