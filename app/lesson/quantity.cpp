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

/// Fills in what is needed and not written; says what cannot be filled in.
std::optional<std::string>
complete(Subject& subject, const Quantity& quantity, const Subject& stand) {
    if (quantity.of == QuantityOf::frame || quantity.of == QuantityOf::pixel) {
        // Counts are of what is written, nothing more; pixels of the picture belong to no triangle
        subject.pixel =
            subject.pixel || quantity.of == QuantityOf::frame ? subject.pixel : stand.pixel;
    } else {
        const bool same_object = !subject.object || subject.object == stand.object;
        subject.object = subject.object ? subject.object : stand.object;
        subject.object = subject.object.value_or(0);
        if (quantity.of == QuantityOf::vertex && !subject.vertex && same_object) {
            subject.vertex = stand.vertex;
        }
        if (needs_triangle(quantity.of) && !subject.triangle && same_object) {
            subject.triangle = stand.triangle;
        }
        if (needs_pixel(quantity.of) && !subject.pixel) {
            subject.pixel = stand.pixel;
        }
    }
    const std::string_view missing =
        quantity.of == QuantityOf::vertex && !subject.vertex ? "vertex 0"
        : needs_triangle(quantity.of) && !subject.triangle   ? "triangle 0"
        : needs_pixel(quantity.of) && !subject.pixel         ? "pixel 8,6"
                                                             : "";
    return missing.empty() ? std::nullopt
                           : std::optional{fmt::format(
                                 "\"{}\" needs to know of what: write for instance \"{} of {}\"",
                                 quantity.name,
                                 quantity.name,
                                 missing
                             )};
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
    if (std::optional<std::string> problem = complete(*subject, *quantity, subject_of(stand))) {
        return complain(std::move(*problem));
    }
    if (std::optional<std::string> problem = find_missing(*subject, recording)) {
        return complain(std::move(*problem));
    }
    return quantity->read(recording, *subject);
}

} // namespace hs::lesson
