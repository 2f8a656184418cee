// Clipping: what the outcodes decide, and each plane's pass over the triangle, in numbers and drawn
// in homogeneous coordinates, where w <= 0 can be seen.
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/clip_story.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hs::viewer {
namespace {

using explain::ClipPassStory;
using explain::number;
using explain::OutcodeVerdict;
using geometry::ClipPlane;

std::string bits(unsigned code, int planes) {
    std::string text;
    for (int k = 0; k < planes; ++k) {
        text += (code >> static_cast<unsigned>(k) & 1U) != 0 ? "  1" : "  0";
    }
    return text;
}

void draw_outcodes(
    const Theme& theme, const trace::TriangleDetail& triangle, int planes, bool clips
) {
    std::string header = "    ";
    for (int k = 0; k < planes; ++k) {
        constexpr std::array letters{"N", "F", "L", "R", "B", "T", "U", "V"};
        header += fmt::format("{:>3}", letters[static_cast<std::size_t>(k)]);
    }
    small_mono(theme, header, Tone::quiet);
    unsigned any = 0;
    unsigned all = ~0U;
    for (unsigned k = 0; k < 3; ++k) {
        const unsigned code = triangle.outcodes[k];
        any |= code;
        all &= code;
        constexpr std::array tones{Tone::vertex_0, Tone::vertex_1, Tone::vertex_2};
        small_mono(theme, fmt::format("v{}  {}", k, bits(code, planes)), tones[k]);
    }
    small_mono(theme, "or  " + bits(any, planes), Tone::quiet);
    small_mono(theme, "and " + bits(all, planes), Tone::quiet);
    caption(theme, "near, far, left, right, bottom, top: 1 is outside");
    const auto code = static_cast<geometry::Outcode>(any);
    switch (explain::outcode_verdict(triangle.outcodes)) {
    case OutcodeVerdict::accepted:
        words(
            theme, "▲ trivially accepted: “or” is 0, no vertex is outside of any plane", Tone::pass
        );
        return;
    case OutcodeVerdict::rejected:
        words(
            theme,
            fmt::format(
                "▼ trivially rejected: all three are outside of plane {}",
                explain::plane_names(static_cast<geometry::Outcode>(all))
            ),
            Tone::fail
        );
        return;
    case OutcodeVerdict::undecided:
        words(
            theme,
            clips ? fmt::format(
                        "Undecided: it is clipped by {}, in turn.", explain::plane_names(code)
                    )
                  : fmt::format(
                        "Undecided: {} would cut it, but nothing is clipped.",
                        explain::plane_names(code)
                    )
        );
        return;
    }
}

/// The coordinate a plane bounds, drawn over w: there the plane is a line through the origin.
struct Axes {
    int coordinate;
    const char* name;
};

Axes axes_of(ClipPlane plane) {
    switch (plane) {
    case ClipPlane::near:
    case ClipPlane::far: return {2, "z"};
    case ClipPlane::left:
    case ClipPlane::right: return {0, "x"};
    case ClipPlane::bottom:
    case ClipPlane::top: return {1, "y"};
    case ClipPlane::user0:
    case ClipPlane::user1: return {0, "x"};
    }
    HS_CHECK(false, "every clip plane is handled");
    return {};
}

/// Maps one clip coordinate and w into a square of the panel.
class Drawing {
public:
    Drawing(const Theme& theme, const geometry::ClipPolygon& polygon, int coordinate)
        : coordinate_(coordinate) {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        const float height = theme.units(44);
        ImGui::Dummy({width, height});
        min_ = corner;
        max_ = {corner.x + width, corner.y + height};
        float high = 1.0e-6F;
        float low = 0.0F;
        float wide = 1.0e-6F;
        for (int i = 0; i < polygon.count; ++i) {
            const glm::vec4 p = math::to_vec4(polygon[i].position);
            low = std::min(low, p.w);
            high = std::max(high, p.w);
            wide = std::max(wide, std::fabs(p[coordinate]));
        }
        constexpr float margin = 1.15F;
        scale_ = std::min(
            height / ((high - low) * margin), width / (2.0F * std::max(wide, high) * margin)
        );
        origin_ = {
            corner.x + width * 0.5F, corner.y + height * 0.5F + (high + low) * 0.5F * scale_};
    }

    [[nodiscard]] ImVec2 at(float coordinate, float w) const {
        return {origin_.x + coordinate * scale_, origin_.y - w * scale_};
    }
    [[nodiscard]] ImVec2 at(const geometry::ClipVertex& vertex) const {
        const glm::vec4 p = math::to_vec4(vertex.position);
        return at(p[coordinate_], p.w);
    }
    [[nodiscard]] ImVec2 min() const { return min_; }
    [[nodiscard]] ImVec2 max() const { return max_; }
    /// How far lines must reach to leave the drawing.
    [[nodiscard]] float reach() const { return (max_.x - min_.x + max_.y - min_.y) / scale_; }

private:
    int coordinate_;
    ImVec2 min_;
    ImVec2 max_;
    ImVec2 origin_;
    float scale_ = 1.0F;
};

void draw_polygon(
    const Theme& theme, const Drawing& drawing, const geometry::ClipPolygon& polygon, bool after
) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int i = 0; i < polygon.count; ++i) {
        const ImVec2 a = drawing.at(polygon[i]);
        const ImVec2 b = drawing.at(polygon[(i + 1) % polygon.count]);
        list.AddLine(
            a, b, theme[after ? Tone::accent : Tone::quiet], theme.pixels(after ? 2.5F : 1.0F)
        );
    }
}

/// The plane is the line where the distance is 0: coordinate = ±w, or 0.
void draw_boundary(
    const Theme& theme, const Drawing& drawing, ClipPlane plane, scene::DepthConvention convention
) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float far = drawing.reach();
    const std::string_view formula = explain::plane_distance(plane, convention);
    const bool plus = formula.starts_with("w +");
    const bool minus = formula.starts_with("w −");
    const float slope = plus ? -1.0F : minus ? 1.0F : 0.0F;
    list.AddLine(
        drawing.at(-slope * far, -far),
        drawing.at(slope * far, far),
        theme.stage(trace::Stage::clip),
        theme.pixels(2)
    );
    list.AddLine(drawing.at(-far, 0.0F), drawing.at(far, 0.0F), theme.faded(Tone::quiet, 0.7F));
    list.AddLine(drawing.at(0.0F, -far), drawing.at(0.0F, far), theme.faded(Tone::quiet, 0.4F));
    const ImVec2 zero = drawing.at(0.0F, 0.0F);
    ImFont* font = theme.fonts.small_mono;
    const float y =
        std::clamp(zero.y, drawing.min().y, drawing.max().y - font->FontSize - theme.pixels(2));
    draw_text(list, font, {drawing.min().x + theme.units(1), y}, theme[Tone::quiet], "w = 0");
}

void draw_picture(
    const Theme& theme,
    const trace::ClipPass& pass,
    const ClipPassStory& story,
    scene::DepthConvention convention
) {
    const Axes axes = axes_of(pass.plane);
    const Drawing drawing{theme, pass.before, axes.coordinate};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(drawing.min(), drawing.max(), theme[Tone::window]);
    ImGui::PushClipRect(drawing.min(), drawing.max(), true);
    const bool user = pass.plane >= ClipPlane::user0;
    if (!user) {
        draw_boundary(theme, drawing, pass.plane, convention);
    }
    draw_polygon(theme, drawing, pass.before, false);
    draw_polygon(theme, drawing, pass.after, true);
    ImFont* font = theme.fonts.small_mono;
    for (int i = 0; i < pass.before.count; ++i) {
        const ImVec2 at = drawing.at(pass.before[i]);
        const bool inside = math::inside(story.distances[static_cast<std::size_t>(i)]);
        draw_mark(list, at, theme.pixels(4), inside, theme);
        const std::string name = fmt::format("{}", i);
        const float x = std::min(at.x + theme.units(2), drawing.max().x - text_size(font, name).x);
        const float y =
            std::clamp(at.y - font->FontSize, drawing.min().y, drawing.max().y - font->FontSize);
        draw_text(list, font, {x, y}, theme[Tone::text], name);
    }
    for (const explain::ClipCut& cut : story.cuts) {
        list.AddCircleFilled(drawing.at(cut.made), theme.pixels(4), theme[Tone::accent], 12);
    }
    ImGui::PopClipRect();
    caption(
        theme,
        user ? std::string{"x to the right, w up; the plane is one of eye space"}
             : fmt::format(
                   "{} to the right, w up; the line is {} = 0",
                   axes.name,
                   explain::plane_distance(pass.plane, convention)
               )
    );
}

std::string attributes_text(const geometry::ClipVertex& vertex) {
    const glm::vec4 color = vertex.varyings.color();
    return fmt::format(
        "p = {}\ncolor = {}", explain::point(math::to_vec4(vertex.position)), explain::point(color)
    );
}

void draw_pass(
    const Theme& theme,
    const trace::ClipPass& pass,
    const ClipPassStory& story,
    const scene::Settings& settings,
    bool lit
) {
    words(
        theme,
        fmt::format(
            "plane {}: {} → {} vertices", name_of(pass.plane), pass.before.count, pass.after.count
        ),
        lit ? Tone::accent : Tone::text
    );
    small_mono(
        theme,
        fmt::format("d = {}", explain::plane_distance(pass.plane, settings.depth_convention)),
        Tone::quiet
    );
    for (std::size_t i = 0; i < story.distances.size(); ++i) {
        const float d = story.distances[i];
        const bool inside = math::inside(d);
        small_mono(
            theme,
            fmt::format(
                "{}  {} d = {} {}", i, inside ? "▲" : "▼", number(d), inside ? "inside" : "outside"
            ),
            inside ? Tone::pass : Tone::fail
        );
    }
    for (const explain::ClipCut& cut : story.cuts) {
        small_mono(
            theme,
            fmt::format(
                "edge {}–{}: t = {} / ({} − {}) = {}\n{}",
                cut.inside,
                cut.outside,
                number(cut.d_inside),
                number(cut.d_inside),
                number(cut.d_outside),
                number(cut.t),
                attributes_text(cut.made)
            )
        );
    }
    if (story.cuts.empty()) {
        caption(theme, "Planes before it have cut off what was outside: nothing is left to cut.");
    }
    draw_picture(theme, pass, story, settings.depth_convention);
    ImGui::Dummy({0.0F, theme.units(2)});
}

void draw_reasons(const Theme& theme, const trace::TriangleDetail& triangle, bool clipped) {
    const std::vector<std::string> reasons = explain::reasons_to_clip(triangle);
    if (clipped && reasons.empty()) {
        return;
    }
    heading(theme, clipped ? "Why before the divide" : "Clipping is off");
    if (!clipped) {
        words(
            theme,
            reasons.empty() ? "All three vertices lie in front of the eye, so the divide does no "
                              "harm here: pixels outside of the image are just not visited."
                            : "Every vertex is divided, wherever it lies:",
            reasons.empty() ? Tone::text : Tone::fail
        );
    }
    for (const std::string& reason : reasons) {
        words(theme, reason);
    }
}

} // namespace

void draw_clipping(Context& context) {
    const Theme& theme = context.theme;
    const trace::TriangleDetail* triangle = context.document.triangle_detail();
    if (triangle == nullptr) {
        empty_note(
            theme,
            "Step into a triangle (→, or Ctrl+→) to see its outcodes, and what each plane of the "
            "view volume cuts off."
        );
        return;
    }
    const pipeline::DrawCall& call = context.document.recording().frame->calls()[triangle->object];
    const scene::PrimitiveKind kind = triangle->primitive.kind;
    heading(
        theme,
        fmt::format(
            "{} {} of object {} against the view volume",
            kind == scene::PrimitiveKind::triangle ? "Triangle"
            : kind == scene::PrimitiveKind::line   ? "Line"
                                                   : "Point",
            triangle->primitive.number,
            triangle->object
        )
    );
    draw_outcodes(theme, *triangle, call.volume.count, call.settings.clip_enabled);
    draw_reasons(theme, *triangle, call.settings.clip_enabled);
    const std::vector<ClipPassStory> story = explain::clip_story(*triangle, call.settings);
    if (story.empty()) {
        return;
    }
    heading(theme, "Each plane in turn");
    const trace::Step& step = context.document.player().current();
    for (std::size_t i = 0; i < story.size(); ++i) {
        const bool lit = step.kind == trace::StepKind::clip_plane && step.plane == story[i].plane;
        draw_pass(theme, triangle->passes[i], story[i], call.settings, lit);
    }
}

} // namespace hs::viewer
