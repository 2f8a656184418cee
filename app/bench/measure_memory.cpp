// Memory: what a recorded frame keeps.
#include "app/bench/session.hpp"

#include <fmt/format.h>

namespace hs::bench {
namespace {

template <typename T>
std::size_t bytes_of(const std::vector<T>& values) {
    return values.capacity() * sizeof(T);
}

std::size_t mesh_bytes(const scene::Mesh& mesh) {
    return bytes_of(mesh.positions) + bytes_of(mesh.normals) + bytes_of(mesh.colors) +
           bytes_of(mesh.uvs) + bytes_of(mesh.polygon_start) + bytes_of(mesh.polygon_vertices) +
           bytes_of(mesh.triangles) + bytes_of(mesh.triangle_polygon) + bytes_of(mesh.file_vertex);
}

/// Of a scene whose objects do not share meshes.
std::size_t scene_bytes(const trace::Recording& recording) {
    std::size_t bytes = 0;
    for (const pipeline::DrawCall& call : recording.frame->calls()) {
        bytes += mesh_bytes(*call.vertex.mesh) + bytes_of(call.vertices);
    }
    return bytes;
}

} // namespace

void measure_memory(Session& session) {
    constexpr double megabyte = 1e6;
    if (session.wants("memory.knot870k.1080p")) {
        const trace::Recording& recording = *session.large_recording();
        const auto facts = static_cast<double>(recording.bytes());
        const auto scene = static_cast<double>(scene_bytes(recording));
        session.add(
            {.name = "memory.knot870k.1080p",
             .value = (facts + scene) / megabyte,
             .unit = "MB",
             .budget = 400.0,
             .note = fmt::format(
                 "{:.0f} MB of facts, {:.0f} MB of mesh and shaded vertices",
                 facts / megabyte,
                 scene / megabyte
             )}
        );
    }
    if (session.wants("memory.per_fragment")) {
        const trace::Recording& recording = *session.large_recording();
        const auto fragments = static_cast<double>(recording.fragments.size());
        const std::size_t log = recording.fragments.bytes() + recording.color32f.bytes();
        session.add(
            {.name = "memory.per_fragment",
             .value = static_cast<double>(log) / fragments,
             .unit = "bytes",
             .budget = 24.0,
             .note = fmt::format(
                 "{:.2f} million fragments; runs take {:.1f} bytes per fragment more",
                 fragments / 1e6,
                 static_cast<double>(bytes_of(recording.runs)) / fragments
             )}
        );
    }
}

} // namespace hs::bench
