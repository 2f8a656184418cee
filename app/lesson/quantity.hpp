// The closed list of what a lesson can read from a trace. Questions, placeholders, checks and what
// a step highlights or hides name its rows; there is no other way to a number.
#pragma once

#include "app/lesson/subject.hpp"
#include "app/lesson/value.hpp"
#include "core/base/diagnostic.hpp"
#include "core/trace/recording.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace hs::lesson {

/// What a quantity is a property of. Parts that are needed and not written come from the step the
/// lesson stands on; where that has no object, it is object 0.
enum class QuantityOf : std::uint8_t {
    frame, ///< of the frame, or of an object or triangle if one is written
    vertex,
    triangle,
    triangle_pixel, ///< a triangle at a pixel, covered or not
    fragment,       ///< a triangle at a pixel it covers
    pixel,          ///< a pixel of the finished picture
};

struct Quantity {
    std::string_view name;
    QuantityOf of = QuantityOf::frame;
    std::string_view explanation; ///< one sentence, without a final full stop
    /// Precondition: the subject is complete and exists. Errors: it has no such value, and why.
    Result<Value> (*read)(const trace::Recording& recording, const Subject& subject);
};

/// All quantities: of the frame, of vertices, of triangles, of fragments, of pixels.
std::span<const Quantity> quantities();

/// Null when there is none of that name.
const Quantity* find_quantity(std::string_view name);

/// "no such quantity", with the nearest name.
std::string describe_unknown_quantity(std::string_view name);

/// Whether a name is a quantity or the first word of some ("ndc" of "ndc.x").
bool is_quantity_or_group(std::string_view name);

/// Whether `group` names `quantity` or is its first word.
bool is_in_group(std::string_view quantity, std::string_view group);

/// Reads a quantity of a written subject, completed from the step `stand` stands on. "number of "
/// before a set of pixels counts it.
Result<Value> read_quantity(
    std::string_view name,
    std::string_view of,
    const trace::Recording& recording,
    const trace::Step& stand
);

// The rows, a file per kind.
std::span<const Quantity> frame_quantities();
std::span<const Quantity> vertex_quantities();
std::span<const Quantity> triangle_quantities();
std::span<const Quantity> fragment_quantities();

} // namespace hs::lesson
