// Registers: what an incremental traversal keeps of the three edge functions, and the addition that
// led to the current pixel; for a tile, the values at its corners.
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"
#include "core/explain/registers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace hs::viewer {
namespace {

using explain::Registers;
using explain::square_pixels;
using explain::whole;

constexpr std::array edge_names{"E01", "E12", "E20"};
constexpr std::array edge_tones{Tone::vertex_0, Tone::vertex_1, Tone::vertex_2};

/// A register as it is drawn: its name, the value in pixel², and as the integer that is kept.
struct Box {
    std::string name;
    std::int64_t value = 0;
    Tone frame = Tone::hairline;
    bool lit = false; ///< this step wrote it, or added it
};

std::string signed_square_pixels(std::int64_t value) {
    return explain::signed_number(static_cast<float>(static_cast<double>(value) / 65536.0));
}

float width_of(const Theme& theme, const Box& box) {
    return std::max(
        {text_size(theme.fonts.small, box.name).x,
         text_size(theme.fonts.mono, signed_square_pixels(box.value)).x,
         text_size(theme.fonts.small_mono, whole(box.value)).x}
    );
}

void draw_box(const Theme& theme, const Box& box, ImVec2 at, ImVec2 size) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{at.x + size.x, at.y + size.y};
    const float rounding = theme.pixels(3);
    list.AddRectFilled(at, end, theme[box.lit ? Tone::changed : Tone::raised], rounding);
    list.AddRect(at, end, theme[box.frame], rounding, 0, theme.pixels(box.lit ? 2.0F : 1.0F));
    const float x = at.x + theme.units(1.5F);
    float y = at.y + theme.units(0.5F);
    draw_text(list, theme.fonts.small, {x, y}, theme[Tone::quiet], box.name);
    y += theme.fonts.small->FontSize;
    draw_text(list, theme.fonts.mono, {x, y}, theme[Tone::text], signed_square_pixels(box.value));
    y += theme.fonts.mono->FontSize;
    draw_text(list, theme.fonts.small_mono, {x, y}, theme[Tone::quiet], whole(box.value));
}

/// Side by side, all of one width; two in a line where there is no room for all.
void draw_boxes(const Theme& theme, std::span<const Box> boxes) {
    float widest = 0.0F;
    for (const Box& box : boxes) {
        widest = std::max(widest, width_of(theme, box) + theme.units(3));
    }
    const float gap = theme.units(1);
    const float room = ImGui::GetContentRegionAvail().x;
    const auto fitting = static_cast<int>((room + gap) / (widest + gap));
    const int count = static_cast<int>(boxes.size());
    const int columns = fitting >= count ? count : std::clamp(fitting, 1, 2);
    const float width = (room + gap) / static_cast<float>(columns) - gap;
    const float height = theme.fonts.small->FontSize + theme.fonts.mono->FontSize +
                         theme.fonts.small_mono->FontSize + theme.units(1.5F);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const int lines = (static_cast<int>(boxes.size()) + columns - 1) / columns;
    for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
        const auto column = static_cast<float>(i % columns);
        const auto line = static_cast<float>(i / columns);
        draw_box(
            theme,
            boxes[static_cast<std::size_t>(i)],
            {start.x + column * (width + gap), start.y + line * (height + gap)},
            {width, height}
        );
    }
    ImGui::Dummy({room, static_cast<float>(lines) * (height + gap)});
}

/// The addition that led here, with numbers.
void draw_addition(const Theme& theme, const Registers& registers, unsigned k) {
    const explain::EdgeRegisters& edge = registers.edges[k];
    if (registers.move == explain::RegisterMove::evaluated) {
        small_mono(
            theme,
            fmt::format("{} = a·x + b·y + c = {} px²", edge_names[k], square_pixels(edge.now))
        );
        return;
    }
    const std::int64_t added = edge.now - edge.before;
    small_mono(
        theme,
        fmt::format(
            "{} = {} {} {} = {} px²",
            explain::addition(registers, k),
            square_pixels(edge.before),
            added < 0 ? "−" : "+",
            square_pixels(std::abs(added)),
            square_pixels(edge.now)
        ),
        Tone::accent
    );
}

void draw_edge(const Theme& theme, const Registers& registers, unsigned k) {
    using explain::RegisterMove;
    const explain::EdgeRegisters& edge = registers.edges[k];
    const RegisterMove move = registers.move;
    const Tone tone = edge_tones[k];
    const bool along = move == RegisterMove::right || move == RegisterMove::left;
    const bool down = move == RegisterMove::down || move == RegisterMove::next_row;
    std::vector<Box> boxes;
    if (registers.keeps_rows) {
        boxes.push_back({"row start", edge.row, tone, !along});
    }
    boxes.push_back({fmt::format("{} now", edge_names[k]), edge.now, tone, true});
    boxes.push_back({"a: one right", edge.a, Tone::hairline, along});
    boxes.push_back({"b: one down", edge.b, Tone::hairline, down});
    draw_addition(theme, registers, k);
    draw_boxes(theme, boxes);
}

/// Where the values came from, in words.
std::string story(const Registers& registers) {
    using explain::RegisterMove;
    const std::string from = explain::pixel(registers.from);
    switch (registers.move) {
    case RegisterMove::evaluated:
        return "The first pixel: all three are evaluated here, once, with two multiplications "
               "each.";
    case RegisterMove::right:
    case RegisterMove::left:
        return fmt::format("From pixel {} one addition each: a, the step along the row.", from);
    case RegisterMove::down:
        return fmt::format(
            "From pixel {} one addition each: b, one row down; the way turns around, so no row "
            "start is kept.",
            from
        );
    case RegisterMove::next_row:
        return fmt::format(
            "The row start at pixel {} moves one row down by b, and the row begins there.", from
        );
    }
    HS_CHECK(false, "every move has a sentence");
    return "";
}

void draw_registers_at(const Theme& theme, const Registers& registers) {
    heading(theme, fmt::format("Registers at pixel {}", explain::pixel(registers.pixel)));
    caption(theme, story(registers));
    for (unsigned k = 0; k < 3; ++k) {
        draw_edge(theme, registers, k);
    }
    caption(theme, "In pixel²; below, the integer that is kept: 1/65536 pixel².");
}

/// A tile is judged by its corners; the first is where its pixels' values start from.
void draw_corners(
    const Theme& theme, const raster::TileTest& tile, const raster::TriangleSetup& setup
) {
    constexpr std::array corner_names{"top left", "top right", "bottom left", "bottom right"};
    heading(
        theme,
        fmt::format(
            "Corners of tile {}, {} × {}", explain::pixel(tile.origin), tile.size, tile.size
        )
    );
    caption(
        theme,
        fmt::format(
            "The tile is {}. Evaluated at the centers of its corner pixels within the bounding "
            "box{}.",
            name_of(tile.verdict),
            tile.reach.in != tile.reach.out ? "; in or out with all their samples" : ""
        )
    );
    for (unsigned k = 0; k < 3; ++k) {
        words(theme, edge_names[k], edge_tones[k]);
        std::vector<Box> boxes;
        for (unsigned corner = 0; corner < 4; ++corner) {
            const std::int64_t value = tile.corners[corner][k];
            const bool outside = value + setup.top_left_bias[k] + tile.reach.in[k] < 0;
            const bool inside = value + setup.top_left_bias[k] + tile.reach.out[k] >= 0;
            const char* const side = outside ? "out" : inside ? "in" : "some in";
            boxes.push_back(
                {fmt::format("{}, {}", corner_names[corner], side),
                 value,
                 outside  ? Tone::fail
                 : inside ? Tone::pass
                          : Tone::quiet}
            );
        }
        draw_boxes(theme, boxes);
    }
    caption(theme, "In pixel²; below, the integer that is kept: 1/65536 pixel².");
}

} // namespace

void draw_registers(Context& context) {
    const trace::Player& player = context.document.player();
    const trace::Step& step = player.current();
    const trace::StepDetail& detail = player.detail();
    const scene::TraversalKind traversal = context.document.settings().traversal;
    const bool traversed = !context.document.settings().sweeps();
    const auto registers =
        traversed ? explain::registers_at(detail, step, traversal) : std::nullopt;
    if (registers) {
        draw_registers_at(context.theme, *registers);
        return;
    }
    if (step.kind == trace::StepKind::tile_test && detail.traversal && detail.traversal->tile) {
        const auto& piece = detail.triangle->pieces[static_cast<std::size_t>(step.piece)];
        draw_corners(context.theme, *detail.traversal->tile, *piece.setup);
        return;
    }
    empty_note(
        context.theme,
        "Stand on a pixel while traversal is incremental, serpentine or hierarchical to see the "
        "values it keeps and adds to; or on a tile to see its corners. All other traversals "
        "evaluate their edge functions afresh."
    );
}

} // namespace hs::viewer
