#include "core/explain/normal_story.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hs::explain {
namespace {

/// Ends of the edges at a vertex, from the first triangles of a mesh however large.
std::vector<std::uint32_t> neighbors(const scene::Mesh& mesh, std::uint32_t vertex) {
    constexpr std::size_t most_triangles = 100000;
    std::vector<std::uint32_t> ends;
    for (std::size_t i = 0; i < std::min(most_triangles, mesh.triangles.size()); ++i) {
        const scene::TriangleIndices& t = mesh.triangles[i];
        if (t.a != vertex && t.b != vertex && t.c != vertex) {
            continue;
        }
        for (int corner = 0; corner < 3; ++corner) {
            if (t[corner] != vertex) {
                ends.push_back(t[corner]);
            }
        }
    }
    return ends;
}

bool nearly_equal(const glm::mat3& a, const glm::mat3& b) {
    float largest = 0.0F;
    float apart = 0.0F;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            largest = std::max(largest, std::fabs(a[column][row]));
            apart = std::max(apart, std::fabs(a[column][row] - b[column][row]));
        }
    }
    return apart <= 1.0e-4F * largest;
}

/// The story for one edge; empty where the edge runs along the normal.
std::optional<NormalStory>
along_edge(const NormalStory& vertex, const glm::vec3& edge, std::uint32_t end) {
    NormalStory story = vertex;
    const glm::vec3 flat = edge - glm::dot(edge, story.normal) * story.normal;
    if (glm::length(flat) <= 1.0e-6F * glm::length(edge)) {
        return std::nullopt;
    }
    story.edge_end = end;
    story.tangent = glm::normalize(flat);
    story.moved_tangent = glm::normalize(story.matrix * story.tangent);
    story.dot_before = glm::dot(story.normal, story.tangent);
    story.dot_by_matrix = glm::dot(story.by_matrix, story.moved_tangent);
    story.dot_by_inverse_transpose = glm::dot(story.by_inverse_transpose, story.moved_tangent);
    return story;
}

} // namespace

std::optional<NormalStory>
normal_story(const trace::Recording& recording, std::uint32_t object, std::uint32_t vertex) {
    const pipeline::VertexInputs& inputs = recording.frame->calls()[object].vertex;
    const scene::Mesh& mesh = *inputs.mesh;
    const pipeline::Transforms& t = inputs.transforms;
    NormalStory base;
    base.matrix = glm::mat3{t.view.matrix * t.model.matrix};
    base.normal = mesh.normals[vertex];
    if (glm::determinant(base.matrix) == 0.0F || glm::length(base.normal) == 0.0F) {
        return std::nullopt;
    }
    base.normal = glm::normalize(base.normal);
    base.inverse_transpose = glm::transpose(glm::inverse(base.matrix));
    base.by_matrix = glm::normalize(base.matrix * base.normal);
    base.by_inverse_transpose = glm::normalize(base.inverse_transpose * base.normal);
    base.executed = nearly_equal(t.normal, base.inverse_transpose);

    // Of all edges the one whose tangent the wrong normal leans on most
    std::optional<NormalStory> best;
    for (const std::uint32_t end : neighbors(mesh, vertex)) {
        const glm::vec3 edge{mesh.positions[end] - mesh.positions[vertex]};
        const std::optional<NormalStory> story = along_edge(base, edge, end);
        if (story && (!best || std::fabs(story->dot_by_matrix) > std::fabs(best->dot_by_matrix))) {
            best = story;
        }
    }
    return best;
}

} // namespace hs::explain
