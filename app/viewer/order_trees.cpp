// BSP trees and octrees: what has been built, and where the walk is.
#include "app/viewer/order_views.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::viewer {
namespace {

std::string tree_heading(std::size_t count, std::string_view what, int splits) {
    const auto plural = [](std::size_t n) { return n == 1 ? "" : "s"; };
    return fmt::format(
        "{} {}{}, {} polygon{} cut",
        count,
        what,
        plural(count),
        splits,
        plural(static_cast<std::size_t>(splits))
    );
}

constexpr std::size_t most_drawn = 63; ///< nodes; more are narrower than their labels

/// Where a node stands: columns from left to right in order of the walk, rows by depth.
struct NodePlace {
    int column = 0;
    int row = 0;
};

/// In-order: the back side, the node, the front side. A stack instead of recursion: a tree may be
/// as deep as it has nodes.
std::vector<NodePlace> places_of(const visibility::BspTree& tree) {
    std::vector<NodePlace> places(tree.nodes.size());
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const std::int32_t parent = tree.nodes[i].parent;
        places[i].row = parent < 0 ? 0 : places[static_cast<std::size_t>(parent)].row + 1;
    }
    struct Visit {
        std::int32_t node;
        bool entered;
    };
    std::vector<Visit> stack;
    if (!tree.nodes.empty()) {
        stack.push_back({0, false});
    }
    int column = 0;
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        if (visit.node < 0) {
            continue;
        }
        const visibility::BspNode& node = tree.nodes[static_cast<std::size_t>(visit.node)];
        if (visit.entered) {
            places[static_cast<std::size_t>(visit.node)].column = column++;
            continue;
        }
        stack.push_back({node.front, false});
        stack.push_back({visit.node, true});
        stack.push_back({node.back, false});
    }
    return places;
}

/// The tree as circles and lines: behind to the left, in front to the right.
class TreeDrawing {
public:
    TreeDrawing(Context& context, const trace::OrderDetail& detail)
        : context_(context),
          theme_(context.theme),
          detail_(detail),
          tree_(std::get<trace::BspMoment>(detail.state).tree),
          places_(places_of(tree_)) {
        int rows = 1;
        for (const NodePlace& place : places_) {
            rows = std::max(rows, place.row + 1);
        }
        const float width = ImGui::GetContentRegionAvail().x;
        origin_ = ImGui::GetCursorScreenPos();
        step_.x = width / static_cast<float>(tree_.nodes.size());
        step_.y = std::min(theme_.units(10), theme_.units(80) / static_cast<float>(rows));
        ImGui::Dummy({width, step_.y * static_cast<float>(rows) + theme_.units(2)});
    }

    void draw() const {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
            for (const std::int32_t child : {tree_.nodes[i].back, tree_.nodes[i].front}) {
                if (child >= 0) {
                    list.AddLine(
                        at(i),
                        at(static_cast<std::size_t>(child)),
                        theme_[Tone::hairline],
                        theme_.pixels(1.5F)
                    );
                }
            }
        }
        for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
            draw_node(list, i);
        }
    }

private:
    [[nodiscard]] ImVec2 at(std::size_t node) const {
        const NodePlace& place = places_[node];
        return {
            origin_.x + step_.x * (static_cast<float>(place.column) + 0.5F),
            origin_.y + step_.y * static_cast<float>(place.row) + theme_.units(4)};
    }

    void draw_node(ImDrawList& list, std::size_t node) const {
        const bool current =
            stands_on_decision(context_) && static_cast<std::size_t>(detail_.decision.node) == node;
        const std::string label = label_of(context_, detail_, tree_.nodes[node].polygons.front());
        ImFont* const font = theme_.fonts.small_mono;
        const ImVec2 size = text_size(font, label);
        const float radius =
            std::min(0.5F * step_.x - 1.0F, std::max(theme_.units(3), 0.5F * size.x + 3.0F));
        const ImVec2 center = at(node);
        list.AddCircleFilled(center, radius, theme_[current ? Tone::accent : Tone::raised]);
        list.AddCircle(center, radius, theme_[Tone::quiet], 0, theme_.pixels(1));
        if (size.x <= 2.0F * radius) {
            draw_text(
                list,
                font,
                {center.x - 0.5F * size.x, center.y - 0.5F * size.y},
                theme_[current ? Tone::on_accent : Tone::text],
                label
            );
        }
    }

    Context& context_;
    const Theme& theme_;
    const trace::OrderDetail& detail_;
    const visibility::BspTree& tree_;
    std::vector<NodePlace> places_;
    ImVec2 origin_;
    ImVec2 step_;
};

/// Polygons in the order they were emitted, the last ones of many.
void draw_emitted(
    Context& context, const trace::OrderDetail& detail, const std::vector<std::int32_t>& order
) {
    if (order.empty()) {
        return;
    }
    heading(context.theme, fmt::format("Order of drawing: {} so far", order.size()));
    const bool deciding = stands_on_decision(context);
    const DecidedPair pair = decided_pair(detail.decision);
    const auto count = static_cast<int>(order.size());
    const RowRange range = rows_around(deciding ? count : 0, count);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
    for (int i = range.first; i < range.last; ++i) {
        OrderRow row{.polygon = order[static_cast<std::size_t>(i)], .text = fmt::format("{}", i)};
        if (deciding) {
            light(row, pair);
        } else {
            light_drawn(context, detail, row);
        }
        ImGui::PushID(i);
        draw_order_row(context, detail, row, ImGui::GetContentRegionAvail().x);
        ImGui::PopID();
    }
    ImGui::PopStyleVar();
}

void draw_cell(
    const Theme& theme, const visibility::Octree& tree, std::int32_t index, bool current
) {
    const visibility::OctreeCell& cell = tree.cells[static_cast<std::size_t>(index)];
    const float indent = theme.units(2) * static_cast<float>(cell.depth);
    ImGui::Indent(indent + 1.0F);
    const std::size_t count = cell.polygons.size();
    const std::string what = !cell.leaf   ? std::string{"divided"}
                             : count == 1 ? std::string{"1 polygon"}
                                          : fmt::format("{} polygons", count);
    caption(theme, fmt::format("cell {}, {}", index, what), current ? Tone::accent : Tone::text);
    ImGui::Unindent(indent + 1.0F);
}

} // namespace

void draw_bsp_tree(Context& context, const trace::OrderDetail& detail) {
    const Theme& theme = context.theme;
    const auto& [tree, walk] = std::get<trace::BspMoment>(detail.state);
    heading(theme, tree_heading(tree.nodes.size(), "node", tree.splits));
    if (tree.nodes.size() > most_drawn) {
        caption(theme, "Too many nodes to draw; the numbers stand above.");
    } else if (!tree.nodes.empty()) {
        caption(theme, "Behind a plane to the left, in front of it to the right.");
        TreeDrawing(context, detail).draw();
    }
    draw_emitted(context, detail, walk.order);
}

void draw_octree(Context& context, const trace::OrderDetail& detail) {
    const Theme& theme = context.theme;
    const auto& [tree, walk] = std::get<trace::OctreeMoment>(detail.state);
    heading(theme, tree_heading(tree.cells.size(), "cell", tree.splits));
    if (stands_on_decision(context) && detail.decision.node >= 0) {
        std::vector<std::int32_t> path;
        for (std::int32_t cell = detail.decision.node; cell >= 0;
             cell = tree.cells[static_cast<std::size_t>(cell)].parent) {
            path.push_back(cell);
        }
        for (auto cell = path.rbegin(); cell != path.rend(); ++cell) {
            draw_cell(theme, tree, *cell, *cell == detail.decision.node);
        }
    }
    draw_emitted(context, detail, walk.order);
}

} // namespace hs::viewer
