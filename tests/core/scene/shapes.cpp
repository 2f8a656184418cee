#include "core/scene/shapes.hpp"

#include "core/scene/mesh_file.hpp"
#include "core/scene/triangulate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

using namespace hs;
using namespace hs::scene;

namespace {

constexpr std::array<std::string_view, 6> kinds{
    "plane", "cube", "sphere", "torus", "torus-knot", "teapot"};
constexpr std::array<std::string_view, 4> closed{"cube", "sphere", "torus", "torus-knot"};

Mesh shape(std::string_view kind, int triangles = 0) {
    Result<Mesh> mesh = make_shape(kind, {triangles});
    REQUIRE(mesh);
    return std::move(*mesh);
}

glm::dvec3 corner(const Mesh& mesh, const TriangleIndices& t, int i) {
    return glm::dvec3{mesh.positions[t[i]]};
}

double volume(const Mesh& mesh) {
    double sum = 0.0;
    for (const TriangleIndices& t : mesh.triangles) {
        sum +=
            glm::dot(corner(mesh, t, 0), glm::cross(corner(mesh, t, 1), corner(mesh, t, 2))) / 6.0;
    }
    return sum;
}

/// Directed edges, by position, that no opposite edge answers.
std::size_t open_edges(const Mesh& mesh) {
    std::map<std::array<double, 6>, int> balance;
    for (const TriangleIndices& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 p = corner(mesh, t, i) + 0.0; // -0 becomes 0
            const glm::dvec3 q = corner(mesh, t, (i + 1) % 3) + 0.0;
            ++balance[{p.x, p.y, p.z, q.x, q.y, q.z}];
            --balance[{q.x, q.y, q.z, p.x, p.y, p.z}];
        }
    }
    return static_cast<std::size_t>(std::ranges::count_if(balance, [](const auto& edge) {
        return edge.second != 0;
    }));
}

/// The greatest distance from a vertex of one mesh to the nearest vertex of the other.
double distance_to(const Mesh& from, const Mesh& to) {
    double farthest = 0.0;
    for (const glm::vec4& p : from.positions) {
        double nearest = 1e9;
        for (const glm::vec4& q : to.positions) {
            nearest = std::min(nearest, glm::length(glm::dvec3{p} - glm::dvec3{q}));
        }
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

} // namespace

TEST_CASE("shapes have normals and texture coordinates, and face outward", "[unit][scene]") {
    for (const std::string_view kind : kinds) {
        INFO(kind);
        const Mesh mesh = shape(kind);
        REQUIRE(mesh.normals.size() == mesh.positions.size());
        REQUIRE(mesh.uvs.size() == mesh.positions.size());
        REQUIRE(mesh.triangle_polygon.size() == mesh.triangles.size());
        std::size_t against = 0;
        for (const TriangleIndices& t : mesh.triangles) {
            const glm::dvec3 a = corner(mesh, t, 0);
            const glm::dvec3 normal = glm::cross(corner(mesh, t, 1) - a, corner(mesh, t, 2) - a);
            for (int i = 0; i < 3; ++i) {
                against += glm::dot(normal, glm::dvec3{mesh.normals[t[i]]}) > 0.0 ? 0U : 1U;
            }
        }
        CHECK(against == 0);
        for (const glm::vec3& n : mesh.normals) {
            REQUIRE(glm::length(n) == Approx(1.0F));
        }
        for (const glm::vec2& uv : mesh.uvs) {
            REQUIRE((uv.x >= 0.0F && uv.x <= 1.0F && uv.y >= 0.0F && uv.y <= 1.0F));
        }
    }
}

TEST_CASE("closed shapes are watertight to the last bit at every resolution", "[unit][scene]") {
    for (const std::string_view kind : closed) {
        for (const int triangles : {0, 1, 100, 1001, 7000}) {
            INFO(kind << " of " << triangles);
            CHECK(open_edges(shape(kind, triangles)) == 0);
        }
    }
    // The plane's border: the four corner edges of a square of two triangles, both directions.
    CHECK(open_edges(shape("plane")) == 8);
}

TEST_CASE("fine shapes have the volume of the formula", "[unit][scene]") {
    const double pi = std::numbers::pi;
    CHECK(volume(shape("cube")) == Approx(8.0));
    CHECK(volume(shape("sphere", 70'000)) == Approx(4.0 / 3.0 * pi).epsilon(1e-3));
    CHECK(volume(shape("torus", 70'000)) == Approx(2.0 * pi * pi * 0.7 * 0.3 * 0.3).epsilon(1e-3));
    CHECK(volume(shape("torus-knot", 70'000)) > 0.5);
    CHECK(volume(shape("teapot")) > 0.5);
}

TEST_CASE("a shape comes near the wanted number of triangles", "[unit][scene]") {
    CHECK(shape("plane").triangles.size() == 2);
    CHECK(shape("plane", 8).triangles.size() == 8);
    CHECK(shape("cube").triangles.size() == 12);
    CHECK(shape("cube", 48).triangles.size() == 48);
    CHECK(shape("teapot").triangles.size() == 6320);
    for (const std::string_view kind : kinds) {
        INFO(kind);
        const auto made = static_cast<double>(shape(kind, 870'000).triangles.size());
        CHECK(made == Approx(870'000.0).epsilon(0.01));
    }
    const auto knot = static_cast<double>(shape("torus-knot", 870'000).triangles.size());
    CHECK(knot == Approx(870'000.0).epsilon(1e-4));
}

TEST_CASE("the tube of the torus knot does not touch itself", "[unit][scene]") {
    // Neighboring strands keep a distance: no vertex comes nearer to another part of the knot than
    // a tenth of the tube.
    const Mesh mesh = shape("torus-knot", 2000);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const glm::vec3 apart{mesh.positions[i] - mesh.positions[j]};
            const bool other_strand = glm::dot(mesh.normals[i], mesh.normals[j]) < -0.5F;
            if (other_strand) {
                REQUIRE(glm::length(apart) > 0.015F);
            }
        }
    }
}

TEST_CASE("the teapot is Newell's", "[unit][scene]") {
    const auto path = test::data_file("teapot.obj");
    if (!path) {
        WARN("skipped: the shared meshes are not there");
        return;
    }
    Result<Mesh> file = load_mesh(*path);
    REQUIRE(file);
    fit_to_unit_sphere(*file);
    const Mesh mesh = shape("teapot");
    CHECK(distance_to(*file, mesh) < 1e-6);
    CHECK(distance_to(mesh, *file) < 1e-6);
}

TEST_CASE("unknown shapes and absurd counts are refused", "[unit][scene]") {
    CHECK(make_shape("tours", {}).diagnostics()[0].message.ends_with("did you mean \"torus\"?"));
    CHECK_FALSE(make_shape("cube", {-1}));
    CHECK_FALSE(make_shape("cube", {20'000'001}));
}
