// What the order panel shows of each algorithm's state.
#pragma once

#include "app/viewer/order_rows.hpp"

namespace hs::viewer {

/// Both columns of a merge: sorted runs, and what they become.
void draw_painters(Context& context, const trace::OrderDetail& detail);

/// A row per polygon: its front list, and how many lie behind it.
void draw_front_lists(Context& context, const trace::OrderDetail& detail);

/// The pair P and Q with the verdict of every test, and the list.
void draw_depth_sort(Context& context, const trace::OrderDetail& detail);

/// The tree so far, with the current node.
void draw_bsp_tree(Context& context, const trace::OrderDetail& detail);

/// The cells from the root to the current one, and the polygons of its leaf.
void draw_octree(Context& context, const trace::OrderDetail& detail);

} // namespace hs::viewer
