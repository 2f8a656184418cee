// How the values of a step are gathered, for the files that know a stage each.
#pragma once

#include "core/explain/step_values.hpp"

#include <array>
#include <utility>

namespace hs::explain {

/// The values of one step, in the order they are computed.
class ValueList {
public:
    explicit ValueList(std::string path) : path_(std::move(path)) {}

    /// Names a value. What is returned stands for it in later formulas, of this step and others.
    template <typename T>
    Term<T> add(std::string name, const Term<T>& term) {
        values_.push_back({name, term.expression()});
        return operand(name, term.value(), {path_, name, {}}, term.expression()->subpixels);
    }
    [[nodiscard]] std::vector<StepValue> take() { return std::move(values_); }

private:
    std::string path_;
    std::vector<StepValue> values_;
};

/// The step whose values are asked for.
struct StepContext {
    const trace::Recording& recording;
    const trace::Step& step;
    const trace::StepDetail& detail;

    [[nodiscard]] const pipeline::DrawCall& call() const {
        return recording.frame->calls()[step.object];
    }
    /// Precondition: the step belongs to a piece.
    [[nodiscard]] const trace::PieceDetail& piece() const {
        return detail.triangle->pieces[static_cast<std::size_t>(step.piece)];
    }
    /// The path of another step of the same vertex, piece or fragment.
    [[nodiscard]] std::string path(trace::StepKind kind) const {
        trace::Step other = step;
        other.kind = kind;
        other.sample = kind >= trace::StepKind::sample_test ? step.sample : -1;
        return trace::step_path(other);
    }
    /// A value that another step of the same vertex, piece or fragment computed.
    template <typename T>
    [[nodiscard]] Term<T>
    value(trace::StepKind kind, const std::string& name, T value, int subpixels = 0) const {
        return operand(name, value, {path(kind), name, {}}, subpixels);
    }
};

inline constexpr std::array edge_names{"E01", "E12", "E20"};
inline constexpr std::array axis_names{"x", "y", "z", "w"};
inline constexpr std::array channel_names{"r", "g", "b", "a"};

/// A coordinate of a pixel's center as a traversal counts it: whole pixels, in 1/256 pixel.
[[nodiscard]] inline Whole pixel_coordinate(const char* axis, int coordinate) {
    return operand(axis, std::int64_t{coordinate} * subpixel_scale, {{}, {}, "the pixel asked"}, 1);
}

/// "color.r", "uv.u", "normal.x", "eye.x": what a varying is called.
[[nodiscard]] std::string varying_name(const math::VaryingLayout& layout, int index);

/// A vertex on its way through clipping: its numbers, with where they came from.
struct TermVertex {
    std::vector<Real> position; ///< x, y, z, w in clip space
    std::vector<Real> varyings;
};

/// The three corners of the step's piece. Precondition: the step belongs to a piece.
[[nodiscard]] std::array<TermVertex, 3> corners_of_piece(const StepContext& context);

/// An edge function at a pixel, from what setup made of it.
[[nodiscard]] Whole edge_term(const StepContext& context, unsigned edge, PixelPos pixel);

/// The same at a sample of the pixel.
[[nodiscard]] Whole
sample_edge_term(const StepContext& context, unsigned edge, PixelPos pixel, int sample);

/// An edge function where the step's fragment, or its test of one sample, takes it: as a step of
/// its own asked it, or computed now by the traversals that know what is covered without asking.
Whole add_edge_value(ValueList& list, const StepContext& context, unsigned edge);

/// Three numbers in eye space or three channels.
using Triple = std::array<Real, 3>;

/// A point to be lit; its color counts without alpha.
struct SurfaceTerms {
    Triple position;
    Triple normal;
    Triple color;
};
/// What each light adds, and the color: values "light 0 n·l", "ambient.r", "`prefix`r" and so on.
void add_lighting(
    ValueList& list,
    const pipeline::DrawCall& call,
    const SurfaceTerms& surface,
    std::string_view prefix
);

// The values of each stage's steps
void add_vertex_values(ValueList& list, const StepContext& context);
void add_order_values(ValueList& list, const StepContext& context);
void add_sweep_values(ValueList& list, const StepContext& context);
void add_outcode_values(ValueList& list, const StepContext& context);
void add_clip_values(ValueList& list, const StepContext& context);
void add_divide_values(ValueList& list, const StepContext& context);
void add_viewport_values(ValueList& list, const StepContext& context);
void add_facing_values(ValueList& list, const StepContext& context);
void add_setup_values(ValueList& list, const StepContext& context);
void add_scan_values(ValueList& list, const StepContext& context);
void add_edge_test_values(ValueList& list, const StepContext& context);
void add_sample_test_values(ValueList& list, const StepContext& context);
void add_tile_values(ValueList& list, const StepContext& context);
void add_plane_setup_values(ValueList& list, const StepContext& context);
void add_plane_test_values(ValueList& list, const StepContext& context);
void add_plane_facing_values(ValueList& list, const StepContext& context);
void add_line_setup_values(ValueList& list, const StepContext& context);
void add_line_step_values(ValueList& list, const StepContext& context);
void add_interpolation_values(ValueList& list, const StepContext& context);
void add_shading_values(ValueList& list, const StepContext& context);
void add_test_values(ValueList& list, const StepContext& context);
void add_merge_values(ValueList& list, const StepContext& context);
void add_start_values(ValueList& list, const StepContext& context);
void add_resolve_values(ValueList& list, const StepContext& context);

} // namespace hs::explain
