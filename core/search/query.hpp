// Searching a recording: the rows of a table for which an expression is true, and the steps they
// stand for. Names are those of the exported tables (docs/traces.md), so what one reads in a
// notebook is what one asks for here.
#pragma once

#include "core/export/table.hpp"
#include "core/search/expression.hpp"
#include "core/trace/player.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hs::search {

/// What can be searched.
enum class Rows : std::uint8_t {
    vertices,
    triangles,
    fragments,
    steps
};

/// An expression over the rows of one table, up to the player's step.
class Query {
public:
    /// The rows are those of the finest thing that the expression names: `step` before `fragment`
    /// before `triangle` before `vertex`. A fragment's row also knows its `triangle`; a triangle's
    /// also its corners `a`, `b` and `c`, which have the columns of a `vertex`.
    /// Errors: those of Expression::compile; an expression that names nothing; one that names two
    /// things which never meet in a row.
    static Result<Query> prepare(const trace::Player& player, std::string_view expression);

    [[nodiscard]] Rows rows() const;
    [[nodiscard]] std::size_t size() const; ///< how many rows there are
    /// Rows are quick in order. Errors as Expression::operator(). Precondition: row < size().
    Result<bool> matches(std::size_t row);
    /// The step a row ends with: of a vertex its last, of a triangle its first, of a fragment its
    /// fate. Same precondition.
    [[nodiscard]] trace::StepId step_of(std::size_t row) const;

    /// The pixel a row is about: of fragments, and of steps that have one. Quick in order. Same
    /// precondition.
    [[nodiscard]] std::optional<PixelPos> pixel_of(std::size_t row) const;

    /// The names the expression mentions, and what they are at a row. Same precondition. Texts live
    /// as long as the query.
    [[nodiscard]] std::vector<std::string> columns() const;
    [[nodiscard]] std::vector<Value> values(std::size_t row);

private:
    struct Content;
    explicit Query(std::shared_ptr<Content> content);
    std::shared_ptr<Content> content_;
};

/// A name an expression may use, for help and completion.
struct KnownName {
    std::string path;
    std::vector<std::string> meanings;
};
std::vector<KnownName> known_names(const trace::Player& player);

} // namespace hs::search

namespace hs {
template <>
std::span<const Named<search::Rows>> names<search::Rows>();
} // namespace hs
