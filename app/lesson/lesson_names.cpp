#include "app/lesson/lesson.hpp"

#include <array>

namespace hs {

template <>
std::span<const Named<lesson::QuestionKind>> names<lesson::QuestionKind>() {
    using lesson::QuestionKind;
    static constexpr std::array<Named<QuestionKind>, 4> table{{
        {QuestionKind::choice, "choice", "one of several answers is picked"},
        {QuestionKind::value, "value", "a number is typed"},
        {QuestionKind::pixels, "pixels", "pixels are picked on the grid"},
        {QuestionKind::pass_fail, "pass-fail", "yes or no"},
    }};
    return table;
}

template <>
std::span<const Named<lesson::View>> names<lesson::View>() {
    using lesson::View;
    static constexpr std::array<Named<View>, 23> table{{
        {View::unchanged, "unchanged", "as it was"},
        {View::color, "color", "the color buffer"},
        {View::depth, "depth", "the depth buffer"},
        {View::triangle, "triangle", "which triangle owns each pixel"},
        {View::overdraw, "overdraw", "fragments written per pixel"},
        {View::complexity, "complexity", "fragments generated per pixel"},
        {View::edge0, "edge0", "values of edge function 01"},
        {View::edge1, "edge1", "values of edge function 12"},
        {View::edge2, "edge2", "values of edge function 20"},
        {View::barycentric, "barycentric", "the weights of the three vertices"},
        {View::object, "object", "the mesh in object space"},
        {View::world, "world", "the scene in world space"},
        {View::eye, "eye", "the scene as seen from the eye's place"},
        {View::clip, "clip", "the scene before the divide"},
        {View::ndc, "ndc", "the scene in the cube of NDC"},
        {View::projection, "projection", "what the projection matrix does to one point"},
        {View::precision, "precision", "how depth values are spread"},
        {View::clipping, "clipping", "the triangle against each clip plane"},
        {View::cost, "cost", "what the traversal spends, beside all others"},
        {View::registers, "registers", "the values that an incremental traversal keeps"},
        {View::normals, "normals", "a normal moved by the matrix and by its inverse transpose"},
        {View::order, "order", "how the order in which triangles are drawn is found"},
        {View::search, "search", "vertices, triangles, fragments and steps that match"},
    }};
    return table;
}

template <>
std::span<const Named<lesson::Panel>> names<lesson::Panel>() {
    using lesson::Panel;
    static constexpr std::array<Named<Panel>, 8> table{{
        {Panel::unchanged, "unchanged", "as it was"},
        {Panel::vertex, "vertex", "a vertex through all spaces"},
        {Panel::triangle, "triangle", "a triangle's clip distances, area and edges"},
        {Panel::fragment, "fragment", "a fragment and its tests"},
        {Panel::values, "values", "every value of a step, with where it came from"},
        {Panel::history, "history", "everything that reached a pixel"},
        {Panel::matrices, "matrices", "the three matrices"},
        {Panel::state, "state", "the settings in force"},
    }};
    return table;
}

} // namespace hs
