#include "core/scene/mesh/importer.hpp"

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/Mesh/BaseKernel.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Core/Utils/vector_cast.hh>
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <mutex>
#include <sstream>
#include <stdexcept>

namespace hs::scene::mesh {

namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::Vec2f;
using OpenMesh::Vec3d;
using OpenMesh::Vec3f;
using OpenMesh::Vec3uc;
using OpenMesh::Vec4f;
using OpenMesh::Vec4uc;
using OpenMesh::VertexHandle;
using StatusInfo = OpenMesh::Attributes::StatusInfo;

/// Thrown through OpenMesh's readers to stop them; caught in import_file and nowhere else.
struct StopReading : std::runtime_error {
    using std::runtime_error::runtime_error;
};

glm::vec3 to_glm(const Vec3f& v) {
    return {v[0], v[1], v[2]};
}
glm::vec2 to_glm(const Vec2f& v) {
    return {v[0], v[1]};
}
glm::vec4 to_glm(const Vec4f& v) {
    return {v[0], v[1], v[2], v[3]};
}

/// Collects what the readers report. OBJ reports the normals of a face's corners before the face
/// and their texture coordinates after it; the other formats know both per vertex only; OM reports
/// half-edges instead of corners.
class Collector final : public OpenMesh::IO::BaseImporter {
public:
    explicit Collector(std::size_t file_size) : file_size_(file_size) {}

    // ---- vertices
    VertexHandle add_vertex(const Vec3f& point) override {
        grow(mesh_.positions.size());
        mesh_.positions.push_back(to_glm(point));
        return VertexHandle{static_cast<int>(mesh_.positions.size()) - 1};
    }
    VertexHandle add_vertex() override { return add_vertex(Vec3f{0.0F, 0.0F, 0.0F}); }
    void set_point(VertexHandle v, const Vec3f& point) override {
        mesh_.positions[index(v)] = to_glm(point);
    }
    void set_normal(VertexHandle v, const Vec3f& normal) override {
        mesh_.has_normals = true;
        normals_.resize(mesh_.positions.size(), glm::vec3{0.0F});
        normals_[index(v)] = to_glm(normal);
        pending_normals_.push_back({index(v), {}, to_glm(normal)});
    }
    void set_normal(VertexHandle v, const Vec3d& normal) override {
        set_normal(v, OpenMesh::vector_cast<Vec3f>(normal));
    }
    void set_color(VertexHandle v, const Vec4f& color) override {
        mesh_.colors.resize(mesh_.positions.size(), glm::vec4{1.0F});
        mesh_.colors[index(v)] = to_glm(color);
    }
    void set_color(VertexHandle v, const Vec3f& c) override {
        set_color(v, Vec4f{c[0], c[1], c[2], 1.0F});
    }
    void set_color(VertexHandle v, const Vec4uc& c) override {
        const auto unit = [](unsigned char channel) {
            return static_cast<float>(channel) / 255.0F;
        };
        set_color(v, Vec4f{unit(c[0]), unit(c[1]), unit(c[2]), unit(c[3])});
    }
    void set_color(VertexHandle v, const Vec3uc& c) override {
        set_color(v, Vec4uc{c[0], c[1], c[2], 255});
    }
    void set_texcoord(VertexHandle v, const Vec2f& uv) override {
        mesh_.has_uvs = true;
        uvs_.resize(mesh_.positions.size(), glm::vec2{0.0F});
        uvs_[index(v)] = to_glm(uv);
    }

    // ---- faces
    FaceHandle add_face(const VHandles& vertices) override {
        grow(mesh_.face_start.size());
        const bool own_normals = pending_belong_to(vertices);
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            Corner corner;
            corner.vertex = index(vertices[i]);
            corner.normal = own_normals ? pending_normals_[i].normal : at(normals_, corner.vertex);
            corner.uv = at(uvs_, corner.vertex);
            mesh_.corners.push_back(corner);
        }
        pending_normals_.clear();
        mesh_.face_start.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
        return FaceHandle{static_cast<int>(n_faces()) - 1};
    }
    /// Where a face names a vertex twice, OpenMesh drops corners but not their texture coordinates:
    /// then those of the vertices stay.
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>& uvs) override {
        const std::uint32_t start = mesh_.face_start[mesh_.face_start.size() - 2];
        if (uvs.size() != mesh_.corners.size() - start) {
            return;
        }
        mesh_.has_uvs = true;
        for (std::size_t i = 0; i < uvs.size(); ++i) {
            mesh_.corners[start + i].uv = to_glm(uvs[i]);
        }
    }

    // ---- half-edges (OM): number 2e runs from the first to the second vertex of edge e, 2e + 1
    // back
    HalfedgeHandle add_edge(VertexHandle from, VertexHandle to) override {
        grow(halfedges_.size() / 2);
        halfedges_.push_back({index(to), 0});
        halfedges_.push_back({index(from), 0});
        return HalfedgeHandle{static_cast<int>(halfedges_.size()) - 2};
    }
    void set_next(HalfedgeHandle halfedge, HalfedgeHandle next) override {
        halfedges_[halfedge_index(halfedge)].next = next.idx();
    }
    FaceHandle add_face(HalfedgeHandle first) override {
        grow(first_halfedges_.size());
        first_halfedges_.push_back(first.idx());
        return FaceHandle{static_cast<int>(first_halfedges_.size()) - 1};
    }

    // ---- counts
    void reserve(unsigned int vertices, unsigned int, unsigned int faces) override {
        if (vertices > file_size_ || faces > file_size_) {
            throw StopReading("the file announces more vertices or faces than it can hold");
        }
    }
    [[nodiscard]] std::size_t n_vertices() const override { return mesh_.positions.size(); }
    [[nodiscard]] std::size_t n_faces() const override { return mesh_.face_start.size() - 1; }
    [[nodiscard]] std::size_t n_edges() const override { return halfedges_.size() / 2; }
    OpenMesh::BaseKernel* kernel() override { return &kernel_; } // OM's reader insists on one

    // ---- what meshes of this program do not have
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f>&) override {}
    void set_face_texindex(FaceHandle, int) override {}
    void set_halfedge(VertexHandle, HalfedgeHandle) override {}
    void set_status(VertexHandle, const StatusInfo&) override {}
    void set_face(HalfedgeHandle, FaceHandle) override {}
    void request_face_texcoords2D() override {}
    void set_texcoord(HalfedgeHandle, const Vec2f&) override {}
    void set_texcoord(VertexHandle, const Vec3f&) override {}
    void set_texcoord(HalfedgeHandle, const Vec3f&) override {}
    void set_status(HalfedgeHandle, const StatusInfo&) override {}
    void set_color(EdgeHandle, const Vec3uc&) override {}
    void set_color(EdgeHandle, const Vec4uc&) override {}
    void set_color(EdgeHandle, const Vec3f&) override {}
    void set_color(EdgeHandle, const Vec4f&) override {}
    void set_status(EdgeHandle, const StatusInfo&) override {}
    void set_normal(FaceHandle, const Vec3f&) override {}
    void set_normal(FaceHandle, const Vec3d&) override {}
    void set_color(FaceHandle, const Vec3uc&) override {}
    void set_color(FaceHandle, const Vec4uc&) override {}
    void set_color(FaceHandle, const Vec3f&) override {}
    void set_color(FaceHandle, const Vec4f&) override {}
    void set_status(FaceHandle, const StatusInfo&) override {}
    void add_texture_information(int, std::string) override {}

    /// To be called once, when reading is over.
    RawMesh take() {
        for (const int first : first_halfedges_) {
            add_face(walk_around(first));
        }
        return std::move(mesh_);
    }

private:
    struct Halfedge {
        std::uint32_t to = 0;
        int next = 0;
    };

    /// Nothing in a file takes less than a byte.
    void grow(std::size_t count) const {
        if (count >= file_size_) {
            throw StopReading("the file announces more than it can hold");
        }
    }
    [[nodiscard]] std::uint32_t index(VertexHandle v) const {
        if (v.idx() < 0 || static_cast<std::size_t>(v.idx()) >= mesh_.positions.size()) {
            throw StopReading(fmt::format(
                "face {} names vertex {}, but there are {}",
                n_faces(),
                v.idx(),
                mesh_.positions.size()
            ));
        }
        return static_cast<std::uint32_t>(v.idx());
    }
    [[nodiscard]] std::size_t halfedge_index(HalfedgeHandle halfedge) const {
        if (halfedge.idx() < 0 || static_cast<std::size_t>(halfedge.idx()) >= halfedges_.size()) {
            throw StopReading(fmt::format("there is no half-edge {}", halfedge.idx()));
        }
        return static_cast<std::size_t>(halfedge.idx());
    }
    template <typename T>
    static T at(const std::vector<T>& list, std::uint32_t i) {
        return i < list.size() ? list[i] : T{0.0F};
    }
    [[nodiscard]] bool pending_belong_to(const VHandles& vertices) const {
        return std::ranges::equal(
            pending_normals_,
            vertices,
            [](const Corner& corner, VertexHandle v) {
                return static_cast<int>(corner.vertex) == v.idx();
            }
        );
    }
    [[nodiscard]] VHandles walk_around(int first) const {
        VHandles vertices;
        int halfedge = first;
        do {
            const Halfedge& current = halfedges_[halfedge_index(HalfedgeHandle{halfedge})];
            vertices.emplace_back(static_cast<int>(current.to));
            halfedge = current.next;
            // The faces together have at most as many corners as there are half-edges.
            if (mesh_.corners.size() + vertices.size() > halfedges_.size()) {
                throw StopReading("the half-edges of a face do not close");
            }
        } while (halfedge != first);
        return vertices;
    }

    std::size_t file_size_;
    OpenMesh::BaseKernel kernel_;
    RawMesh mesh_;
    std::vector<glm::vec3> normals_; ///< the latest per vertex
    std::vector<glm::vec2> uvs_;     ///< the latest per vertex
    std::vector<Corner> pending_normals_;
    std::vector<Halfedge> halfedges_;
    std::vector<int> first_halfedges_;
};

/// From the first mesh on OpenMesh complains here instead of on the terminal. Connected once and
/// for all: its streams leak every target they let go.
std::ostringstream& complaints_of_openmesh() {
    // NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): so is what it is given to
    static std::ostringstream& text = []() -> std::ostringstream& {
        static std::ostringstream stream;
        omerr().disconnect(std::cerr);
        omerr().connect(stream);
        omlog().disable();
        return stream;
    }();
    return text;
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

/// OBJ files pull in material files from anywhere; colors and textures are the scene's business.
std::string without_materials(std::string bytes) {
    for (const std::string_view word : {"mtllib", "usemtl"}) {
        for (std::size_t at = bytes.find(word); at != std::string::npos;
             at = bytes.find(word, at)) {
            bytes[at] = '#';
        }
    }
    return bytes;
}

bool read(const std::filesystem::path& path, const std::string& bytes, Collector& collector) {
    using OpenMesh::IO::Options;
    Options options;
    options += Options::VertexNormal;
    options += Options::VertexColor;
    options += Options::VertexTexCoord;
    options += Options::FaceTexCoord;
    if (path.extension() == ".obj" || path.extension() == ".OBJ") {
        std::istringstream stream{without_materials(bytes)};
        return OpenMesh::IO::IOManager().read(stream, "obj", collector, options);
    }
    // The other readers learn the kind of file (text or binary) only when they are given its name.
    return OpenMesh::IO::IOManager().read(path.string(), collector, options);
}

} // namespace

Result<RawMesh> import_file(const std::filesystem::path& path, const std::string& bytes) {
    static std::mutex readers_are_shared; // and keep state between calls
    const std::scoped_lock lock{readers_are_shared};
    std::ostringstream& complaints = complaints_of_openmesh();
    complaints.str("");
    Collector collector{bytes.size()};
    const auto complaint = [&](const std::string& message) {
        return Diagnostic{path.string(), 0, 0, message};
    };
    try {
        if (!read(path, bytes, collector)) {
            const std::string reason = first_line(complaints.str());
            return complaint(reason.empty() ? "the file is damaged or not of its kind" : reason);
        }
        return collector.take();
    } catch (const StopReading& stop) {
        return complaint(stop.what());
    }
}

} // namespace hs::scene::mesh
