#include "core/scene/mesh_file.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>

using namespace hs;
using namespace hs::scene;

namespace {

/// A file that exists as long as the test.
class TemporaryFile {
public:
    TemporaryFile(const std::string& name, const std::string& content)
        : path_(std::filesystem::temp_directory_path() / ("halfspace-" + name)) {
        std::ofstream{path_, std::ios::binary} << content;
    }
    ~TemporaryFile() { std::filesystem::remove(path_); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

Mesh load(const std::string& name, const std::string& content) {
    const TemporaryFile file{name, content};
    Result<Mesh> mesh = load_mesh(file.path());
    INFO((mesh ? "" : mesh.diagnostics().front().to_string()));
    REQUIRE(mesh);
    return std::move(*mesh);
}

std::string bytes(std::initializer_list<float> numbers) {
    std::string text;
    for (const float number : numbers) {
        text.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
    return text;
}

Mesh shared_mesh(const char* name, bool& found) {
    const auto path = test::data_file(name);
    found = path.has_value();
    if (!found) {
        WARN("skipped: the shared meshes are not there");
        return {};
    }
    Result<Mesh> mesh = load_mesh(*path);
    REQUIRE(mesh);
    return std::move(*mesh);
}

} // namespace

TEST_CASE("OBJ keeps n-gons, their order, and negative indices", "[unit][scene]") {
    const Mesh mesh = load(
        "order.obj",
        "# a pentagon, a triangle, and one that shares an edge the wrong way\r\n"
        "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 2 0\nv -1 1 0\nf 1 2 3 4 5\nf -5 -4 -1\nv 0 0 1\nf 1 2 "
        "6\nf 1 2 6\n"
    );
    CHECK(mesh.polygon_start == std::vector<std::uint32_t>{0, 5, 8, 11, 14});
    CHECK(
        mesh.polygon_vertices ==
        std::vector<std::uint32_t>{0, 1, 2, 3, 4, 0, 1, 4, 0, 1, 5, 0, 1, 5}
    );
    CHECK(mesh.triangles.size() == 6);
    CHECK(mesh.triangle_polygon == std::vector<std::uint32_t>{0, 0, 0, 1, 2, 3});
    CHECK(mesh.positions.size() == 6);
    CHECK(mesh.normals.size() == 6);
    CHECK(mesh.file_vertex.empty());
    CHECK(mesh.name == "halfspace-order");
}

TEST_CASE("corners with different texture coordinates split their vertex", "[unit][scene]") {
    const Mesh mesh = load(
        "seam.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0.25 0.75\nvt 0.5 0.5\n"
        "f 1/1 2/2 3/3\nf 1/4 3/3 4/1\nf 1/4 2/2 4/1\n"
    );
    CHECK(mesh.positions.size() == 5);
    CHECK(mesh.file_vertex == std::vector<std::uint32_t>{0, 1, 2, 3, 0});
    CHECK(mesh.polygon_vertices == std::vector<std::uint32_t>{0, 1, 2, 4, 2, 3, 4, 1, 3});
    CHECK(mesh.uvs[0] == glm::vec2{0.0F, 1.0F}); // v is up in the file, down in images
    CHECK(mesh.uvs[2] == glm::vec2{0.25F, 0.25F});
    CHECK(mesh.uvs[4] == glm::vec2{0.5F, 0.5F});
    CHECK(mesh.normals[0] == mesh.normals[4]);
}

TEST_CASE("corners with different normals split their vertex", "[unit][scene]") {
    const Mesh mesh = load(
        "crease.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 2\nvn 0 -1 0\nf 1//1 2//1 3//1\nf 1//2 4//2 "
        "2//2\n"
    );
    CHECK(mesh.positions.size() == 6);
    CHECK(mesh.normals[0] == glm::vec3{0, 0, 1});
    CHECK(mesh.normals[mesh.polygon_vertices[3]] == glm::vec3{0, -1, 0});
}

TEST_CASE("OBJ vertex colors arrive, material files are not opened", "[unit][scene]") {
    const Mesh mesh = load(
        "colors.obj",
        "mtllib /dev/zero\nusemtl a\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0.5\nf 1 2 3\n"
    );
    CHECK(mesh.colors == std::vector<glm::vec4>{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 0.5, 1}});
}

TEST_CASE("OFF with colors", "[unit][scene]") {
    const Mesh mesh =
        load("colors.off", "COFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 51\n3 0 1 2\n");
    CHECK(mesh.colors == std::vector<glm::vec4>{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 0.2F, 1}});
    CHECK(mesh.triangles.size() == 1);
}

TEST_CASE("PLY as text and in both byte orders is the same mesh", "[unit][scene]") {
    const auto header = [](const std::string& format) {
        return "ply\nformat " + format +
               " 1.0\ncomment made by hand\nelement vertex 3\nproperty float x\nproperty float "
               "y\nproperty float z\n"
               "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n";
    };
    const std::string color{"\xff\x00\x33", 3};
    std::string little;
    little += bytes({0, 0, 0}) + color + bytes({1, 0, 0}) + color + bytes({0, 1, 0}) + color;
    little += std::string{"\x03\0\0\0\0\1\0\0\0\2\0\0\0", 13};
    std::string big;
    const std::string zero(4, '\0');
    const std::string one{"\x3f\x80\0\0", 4};
    big += zero + zero + zero + color + one + zero + zero + color + zero + one + zero + color;
    big += std::string{"\x03\0\0\0\0\0\0\0\1\0\0\0\2", 13};

    const Mesh text = load(
        "text.ply", header("ascii") + "0 0 0 255 0 51\n1 0 0 255 0 51\n0 1 0 255 0 51\n3 0 1 2\n"
    );
    const Mesh binary = load("little.ply", header("binary_little_endian") + little);
    const Mesh swapped = load("big.ply", header("binary_big_endian") + big);
    CHECK(text.positions == std::vector<glm::vec4>{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}});
    CHECK(text.colors == std::vector<glm::vec4>(3, {1.0F, 0.0F, 0.2F, 1.0F}));
    CHECK(binary.positions == text.positions);
    CHECK(binary.colors == text.colors);
    CHECK(binary.triangles == text.triangles);
    CHECK(swapped.positions == text.positions);
    CHECK(swapped.colors == text.colors);
}

TEST_CASE("STL as text and binary shares equal positions", "[unit][scene]") {
    const Mesh text = load(
        "text.stl",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
        "0\nendloop\nendfacet\n"
        "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 "
        "0\nendloop\nendfacet\nendsolid a\n"
    );
    std::string content(80, ' ');
    content += std::string{"\2\0\0\0", 4};
    content += bytes({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}) + std::string(2, '\0');
    content += bytes({0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0}) + std::string(2, '\0');
    const Mesh binary = load("binary.stl", content);
    CHECK(text.positions.size() == 4);
    CHECK(text.triangles == std::vector<TriangleIndices>{{0, 1, 2}, {1, 3, 2}});
    CHECK(binary.positions == text.positions);
    CHECK(binary.triangles == text.triangles);
}

TEST_CASE("OM keeps its polygons", "[unit][scene]") {
    const Result<Mesh> mesh =
        load_mesh(test::source_dir() / "tests/core/scene/meshes/quad-and-triangle.om");
    REQUIRE(mesh);
    CHECK(mesh->positions.size() == 5);
    CHECK(mesh->polygon_count() == 2);
    CHECK(mesh->triangles.size() == 3);
    CHECK(mesh->colors.size() == 5);
    CHECK(mesh->uvs[0] == glm::vec2{0.25F, 0.5F});
    for (const glm::vec3& n : mesh->normals) {
        CHECK(n == glm::vec3{0, 0, 1});
    }
}

TEST_CASE("names of mesh files end in what is read, in any case", "[unit][scene]") {
    for (const char* name : {"a.obj", "b.OFF", "c.Ply", "d.stl", "e.om"}) {
        CHECK(is_mesh_file(name));
    }
    for (const char* name : {"a.toml", "obj", ".obj", "a.obj.gz", ""}) {
        CHECK_FALSE(is_mesh_file(name));
    }
    CHECK(
        load_mesh("a.gltf").diagnostics()[0].message ==
        "mesh files end in .obj, .off, .ply, .stl or .om"
    );
}

TEST_CASE("every prefix of a mesh file is refused or read, never a crash", "[unit][scene]") {
    const std::filesystem::path folder = test::source_dir() / "tests/core/scene/meshes";
    for (const char* name : {"square.off", "quad-and-triangle.om"}) {
        std::ifstream stream{folder / name, std::ios::binary};
        const std::string content{std::istreambuf_iterator<char>{stream}, {}};
        for (std::size_t size = 0; size < content.size(); ++size) {
            const TemporaryFile file{std::string{"prefix-"} + name, content.substr(0, size)};
            const Result<Mesh> mesh = load_mesh(file.path());
            // At most a line break may be missing.
            CHECK((!mesh || size + 2 >= content.size()));
        }
    }
}

TEST_CASE("the bunny loads in well under a second", "[unit][scene]") {
    const auto start = std::chrono::steady_clock::now();
    bool found = false;
    const Mesh mesh = shared_mesh("stanford-bunny.obj", found);
    if (found) {
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        CHECK(mesh.positions.size() == 35'947);
        CHECK(mesh.triangles.size() == 69'451);
        CHECK(seconds.count() < 2.0); // 0.15 s on an idle machine, more under sanitizers
    }
}

TEST_CASE("spot has as many vertices as texture coordinates", "[unit][scene]") {
    bool found = false;
    const Mesh mesh = shared_mesh("spot.obj", found);
    if (found) {
        CHECK(mesh.positions.size() == 3225);
        CHECK(mesh.triangles.size() == 5856);
        CHECK(mesh.file_vertex.size() == 3225);
    }
}
