#include "app/viewer/rich_text.hpp"

#include "app/viewer/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <string_view>

namespace hs::viewer {
namespace {

/// A pen that moves through a column, word by word.
class Pen {
public:
    Pen(const Theme& theme, float indent)
        : theme_(theme),
          start_(ImGui::GetCursorScreenPos()),
          left_(start_.x + indent),
          right_(start_.x + ImGui::GetContentRegionAvail().x),
          x_(left_),
          y_(start_.y),
          widest_(start_.x) {}

    void word(ImFont* font, std::string_view text, ImU32 color, bool on_ground) {
        const ImVec2 size = text_size(font, text);
        if (x_ > left_ && x_ + size.x > right_) {
            new_line();
        }
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float y = y_ + (line() - size.y) * 0.5F;
        if (on_ground) {
            list.AddRectFilled({x_, y}, {x_ + size.x, y + size.y}, theme_[Tone::raised]);
        }
        const std::string shown = shorten(font, text, right_ - left_);
        draw_text(list, font, {x_, y}, color, shown);
        x_ += size.x;
        widest_ = std::max(widest_, std::min(x_, right_));
    }
    void space(ImFont* font) {
        if (x_ > left_) {
            x_ += text_size(font, " ").x;
        }
    }
    void new_line() {
        x_ = left_;
        y_ += line();
    }
    /// Ends the block and gives its room to the layout.
    void finish(float after) {
        const float height = y_ + line() - start_.y + after;
        ImGui::SetCursorScreenPos(start_);
        ImGui::Dummy({widest_ - start_.x, height}); // columns of tables take their width from it
        ImGui::SetCursorScreenPos({start_.x, start_.y + height});
    }
    [[nodiscard]] float line() const { return theme_.fonts.text->FontSize * 1.25F; }

private:
    const Theme& theme_;
    ImVec2 start_;
    float left_;
    float right_;
    float x_;
    float y_;
    float widest_;
};

struct Style {
    ImFont* font = nullptr;
    ImU32 color = 0;
    bool on_ground = false;
};

Style style_of(const Theme& theme, const lesson::Span& span, bool heading) {
    if (span.code || span.quoted) {
        return {theme.fonts.mono, theme[span.quoted ? Tone::accent : Tone::text], span.code};
    }
    const bool strong = heading || span.strong;
    const Tone tone = span.emphasis || !span.link.empty() ? Tone::pass : Tone::text;
    return {strong ? theme.fonts.strong : theme.fonts.text, theme[tone], false};
}

void draw_spans(Pen& pen, const Theme& theme, const lesson::Spans& spans, bool heading) {
    for (const lesson::Span& span : spans) {
        const Style style = style_of(theme, span, heading);
        std::string_view rest = span.text;
        while (!rest.empty()) {
            const std::size_t end = rest.find_first_of(" \n");
            const std::string_view word = rest.substr(0, end);
            if (!word.empty()) {
                pen.word(style.font, word, style.color, style.on_ground);
            }
            if (end == std::string_view::npos) {
                break;
            }
            pen.space(style.font);
            rest.remove_prefix(end + 1);
        }
    }
}

/// Keeps its line breaks; long lines wrap where the column ends.
void draw_code(const Theme& theme, const lesson::Block& block) {
    mono(theme, lesson::to_plain_text(block.spans));
    ImGui::Dummy({0.0F, theme.units(1)});
}

void draw_table(const Theme& theme, const lesson::Block& block) {
    if (block.cells.empty() || block.cells.front().empty()) {
        return;
    }
    const int columns = static_cast<int>(block.cells.front().size());
    const ImGuiTableFlags flags = ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp;
    ImGui::PushID(&block);
    if (ImGui::BeginTable("table", columns, flags)) {
        for (std::size_t r = 0; r < block.cells.size(); ++r) {
            ImGui::TableNextRow();
            for (const lesson::Spans& cell : block.cells[r]) {
                ImGui::TableNextColumn();
                Pen pen(theme, 0.0F);
                draw_spans(pen, theme, cell, r == 0);
                pen.finish(0.0F);
            }
        }
        ImGui::EndTable();
    }
    ImGui::PopID();
}

void draw_flowing(const Theme& theme, const lesson::Block& block) {
    const bool item = block.kind == lesson::BlockKind::list_item;
    const bool quote = block.kind == lesson::BlockKind::quote;
    const int depth = item ? std::max(1, block.level) : quote ? 1 : 0;
    const float indent = theme.units(4) * static_cast<float>(depth);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    if (item) {
        const float marker = text_size(theme.fonts.text, block.marker).x;
        draw_text(
            *ImGui::GetWindowDrawList(),
            theme.fonts.text,
            {start.x + indent - marker - theme.units(1), start.y + theme.pixels(2)},
            theme[Tone::quiet],
            block.marker
        );
    }
    Pen pen(theme, indent);
    draw_spans(pen, theme, block.spans, block.kind == lesson::BlockKind::heading);
    pen.finish(item ? theme.units(0.5F) : theme.units(2));
    if (quote) {
        ImGui::GetWindowDrawList()->AddRectFilled(
            start,
            {start.x + theme.pixels(2), ImGui::GetCursorScreenPos().y - theme.units(2)},
            theme[Tone::hairline]
        );
    }
}

} // namespace

void draw_document(const Theme& theme, const lesson::Document& document) {
    for (const lesson::Block& block : document) {
        switch (block.kind) {
        case lesson::BlockKind::paragraph:
        case lesson::BlockKind::heading:
        case lesson::BlockKind::list_item:
        case lesson::BlockKind::quote: draw_flowing(theme, block); break;
        case lesson::BlockKind::code: draw_code(theme, block); break;
        case lesson::BlockKind::table: draw_table(theme, block); break;
        case lesson::BlockKind::rule: ImGui::Separator(); break;
        }
    }
}

} // namespace hs::viewer
