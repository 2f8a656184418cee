#include "app/lesson/quantity.hpp"

#include "core/base/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace hs::lesson {

namespace {

constexpr std::string_view counted = "number of ";

std::vector<Quantity> gather() {
    std::vector<Quantity> all;
    for (const std::span<const Quantity> rows :
         {frame_quantities(), vertex_quantities(), triangle_quantities(), fragment_quantities()}) {
        all.insert(all.end(), rows.begin(), rows.end());
    }
    return all;
}

Diagnostic complain(std::string message) {
    return {"", 0, 0, std::move(message)};
}

bool needs_triangle(QuantityOf of) {
    return of == QuantityOf::triangle || of == QuantityOf::triangle_pixel ||
           of == QuantityOf::fragment;
}

bool needs_pixel(QuantityOf of) {
    return of == QuantityOf::triangle_pixel || of == QuantityOf::fragment ||
           of == QuantityOf::pixel;
}

/// Fills in what is needed and not written. Counts are of what is written, nothing more, and pixels
/// of the picture belong to no triangle.
void complete(Subject& subject, QuantityOf of, const Subject& stand) {
    if (needs_pixel(of) && !subject.pixel) {
        subject.pixel = stand.pixel;
    }
    if (of == QuantityOf::frame || of == QuantityOf::pixel) {
        return;
    }
    const bool same_object = !subject.object || subject.object == stand.object;
    if (!subject.object) {
        subject.object = stand.object.value_or(0);
    }
    if (of == QuantityOf::vertex && !subject.vertex && same_object) {
        subject.vertex = stand.vertex;
    }
    if (needs_triangle(of) && !subject.triangle && same_object) {
        subject.triangle = stand.triangle;
    }
}

/// An example of the part that is still missing, "" when none is.
std::string_view missing_part(const Subject& subject, QuantityOf of) {
    if (of == QuantityOf::vertex && !subject.vertex) {
        return "vertex 0";
    }
    if (needs_triangle(of) && !subject.triangle) {
        return "triangle 0";
    }
    return needs_pixel(of) && !subject.pixel ? "pixel 8,6" : "";
}

} // namespace

std::span<const Quantity> quantities() {
    static const std::vector<Quantity> all = gather();
    return all;
}

const Quantity* find_quantity(std::string_view name) {
    const auto row = std::ranges::find(quantities(), name, &Quantity::name);
    return row == quantities().end() ? nullptr : &*row;
}

std::string describe_unknown_quantity(std::string_view name) {
    std::vector<std::string_view> known;
    for (const Quantity& quantity : quantities()) {
        known.push_back(quantity.name);
    }
    return fmt::format("there is no quantity \"{}\"{}", name, did_you_mean(name, known));
}

bool is_in_group(std::string_view quantity, std::string_view group) {
    if (quantity.starts_with(counted)) {
        quantity.remove_prefix(counted.size()); // who hides a set hides its size
    }
    return quantity == group ||
           (quantity.starts_with(group) && quantity.substr(group.size()).starts_with('.'));
}

bool is_quantity_or_group(std::string_view name) {
    return std::ranges::any_of(quantities(), [name](const Quantity& quantity) {
        return is_in_group(quantity.name, name);
    });
}

Result<Value> read_quantity(
    std::string_view name,
    std::string_view of,
    const trace::Recording& recording,
    const trace::Step& stand
) {
    if (name.starts_with(counted)) {
        Result<Value> set = read_quantity(name.substr(counted.size()), of, recording, stand);
        if (!set || !std::holds_alternative<PixelSet>(*set)) {
            return set ? complain(fmt::format("\"{}\": only sets of pixels are counted", name))
                       : set;
        }
        return Value{static_cast<double>(std::get<PixelSet>(*set).size())};
    }
    const Quantity* const quantity = find_quantity(name);
    if (quantity == nullptr) {
        return complain(describe_unknown_quantity(name));
    }
    Result<Subject> subject = parse_subject(of);
    if (!subject) {
        return subject.diagnostics();
    }
    complete(*subject, quantity->of, subject_of(stand));
    if (const std::string_view missing = missing_part(*subject, quantity->of); !missing.empty()) {
        return complain(fmt::format(
            R"("{0}" needs to know of what: write for instance "{0} of {1}")", name, missing
        ));
    }
    if (std::optional<std::string> problem = find_missing(*subject, recording)) {
        return complain(std::move(*problem));
    }
    return quantity->read(recording, *subject);
}

} // namespace hs::lesson
