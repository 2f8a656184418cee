#include "core/search/query.hpp"

#include "core/export/column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

namespace hs::search {
namespace {

using exporting::Column;
using exporting::ColumnType;
using exporting::SharedRecording;
using exporting::Table;

/// A table, and which of its rows a row of the query means.
struct Source {
    std::string group; ///< what its columns are called: "a" for "vertex.clip" of a first corner
    std::shared_ptr<const Table> table;
    std::function<std::size_t(std::size_t)> row_of;
};

std::size_t same_row(std::size_t row) {
    return row;
}

template <typename T>
T number_at(const std::byte* bytes, std::size_t component) {
    T value;
    std::memcpy(&value, bytes + component * sizeof(T), sizeof(T));
    return value;
}

/// One number of a column's row, as an expression sees it.
Value value_of(const Column& column, std::size_t component, std::size_t row) {
    std::array<std::byte, 4 * sizeof(std::uint64_t)> bytes{};
    column.read(row, bytes.data());
    std::int64_t whole = 0;
    switch (column.type) {
    case ColumnType::float32: return static_cast<double>(number_at<float>(bytes.data(), component));
    case ColumnType::float64: return number_at<double>(bytes.data(), component);
    case ColumnType::uint8: whole = number_at<std::uint8_t>(bytes.data(), component); break;
    case ColumnType::uint16: whole = number_at<std::uint16_t>(bytes.data(), component); break;
    case ColumnType::int32: whole = number_at<std::int32_t>(bytes.data(), component); break;
    case ColumnType::uint32: whole = number_at<std::uint32_t>(bytes.data(), component); break;
    case ColumnType::uint64:
        whole = static_cast<std::int64_t>(number_at<std::uint64_t>(bytes.data(), component));
        break;
    }
    if (!column.meanings.empty()) {
        return std::string_view{column.meanings[static_cast<std::size_t>(whole)]};
    }
    return whole;
}

/// "vertex.clip.x" of the source called "a" is "a.clip.x".
std::string path_of(const Source& source, const Column& column, std::size_t component) {
    const std::string name = exporting::component_name(column.name, column.components, component);
    return source.group + name.substr(name.find('.'));
}

SharedRecording recording_of(const trace::Player& player) {
    return player.shared_recording();
}

std::vector<Source> vertex_sources(const trace::Player& player) {
    const auto vertices = std::make_shared<Table>(exporting::vertex_table(recording_of(player)));
    return {{"vertex", vertices, same_row}};
}

/// A triangle and its corners, for rows whose triangle `triangle_of` tells.
void add_triangle(
    std::vector<Source>& sources,
    const trace::Player& player,
    const std::function<std::size_t(std::size_t)>& triangle_of
) {
    const auto triangles = std::make_shared<Table>(exporting::triangle_table(recording_of(player)));
    const auto vertices = std::make_shared<Table>(exporting::vertex_table(recording_of(player)));
    const auto corners = std::find_if(
        triangles->columns.begin(),
        triangles->columns.end(),
        [](const Column& column) { return column.name == "triangle.vertices"; }
    );
    HS_CHECK(corners != triangles->columns.end(), "the table of triangles has their vertices");
    sources.push_back({"triangle", triangles, triangle_of});
    constexpr std::array<const char*, 3> names{"a", "b", "c"};
    for (std::size_t k = 0; k < names.size(); ++k) {
        const auto vertex_of = [triangles, read = corners->read, triangle_of, k](std::size_t row) {
            std::array<std::uint32_t, 3> vertices_of_row{};
            read(triangle_of(row), vertices_of_row.data());
            return std::size_t{vertices_of_row[k]};
        };
        sources.push_back({names[k], vertices, vertex_of});
    }
}

std::vector<Source> triangle_sources(const trace::Player& player) {
    std::vector<Source> sources;
    add_triangle(sources, player, same_row);
    return sources;
}

std::vector<Source> fragment_sources(const trace::Player& player) {
    const auto fragments = std::make_shared<Table>(
        exporting::fragment_table(recording_of(player), player.fragments_done())
    );
    std::vector<Source> sources{{"fragment", fragments, same_row}};
    const SharedRecording recording = recording_of(player);
    add_triangle(sources, player, [recording](std::size_t row) -> std::size_t {
        return recording->run_of_fragment(static_cast<std::uint32_t>(row)).triangle;
    });
    return sources;
}

std::vector<Source> step_sources(const trace::Player& player) {
    const auto steps =
        std::make_shared<Table>(exporting::step_table(recording_of(player), player.step()));
    return {{"step", steps, same_row}};
}

/// What each kind of row is searched by; the first group names the kind.
std::vector<Source> sources_of(Rows rows, const trace::Player& player) {
    switch (rows) {
    case Rows::vertices: return vertex_sources(player);
    case Rows::triangles: return triangle_sources(player);
    case Rows::fragments: return fragment_sources(player);
    case Rows::steps: return step_sources(player);
    }
    HS_CHECK(false, "every kind of row has its sources");
    return {};
}

/// Which groups an expression names.
struct Groups {
    bool vertex = false;
    bool triangle = false; ///< or a corner of one
    bool fragment = false;
    bool step = false;
};

Groups groups_in(std::string_view expression) {
    Groups groups;
    for (const std::string& name : words_of(expression).names) {
        const std::string group = name.substr(0, name.find('.'));
        groups.vertex = groups.vertex || group == "vertex";
        groups.triangle =
            groups.triangle || group == "triangle" || group == "a" || group == "b" || group == "c";
        groups.fragment = groups.fragment || group == "fragment";
        groups.step = groups.step || group == "step";
    }
    return groups;
}

Result<Rows> rows_for(std::string_view expression) {
    const Groups groups = groups_in(expression);
    const bool of_triangle = groups.triangle || groups.fragment;
    if (groups.vertex && of_triangle) {
        return Diagnostic{
            .file = "expression",
            .message = "vertex stands for every vertex of the frame; a triangle's corners are "
                       "called a, b and c"};
    }
    if (groups.step && (groups.vertex || of_triangle)) {
        return Diagnostic{
            .file = "expression",
            .message = "step cannot be joined with others; it has step.kind, step.triangle and "
                       "step.pixel of its own"};
    }
    if (groups.step) {
        return Rows::steps;
    }
    if (groups.fragment) {
        return Rows::fragments;
    }
    if (groups.triangle) {
        return Rows::triangles;
    }
    if (groups.vertex) {
        return Rows::vertices;
    }
    return Diagnostic{
        .file = "expression",
        .message = "names nothing to search; begin with vertex, triangle, fragment or step, for "
                   "example fragment.depth < 0.5"};
}

} // namespace

struct Query::Content {
    SharedRecording recording;
    Rows rows = Rows::fragments;
    std::size_t size = 0;
    /// Of steps: where each stands, moving on with the rows.
    std::optional<exporting::StepAddresses> addresses;
    std::vector<std::string> paths;
    std::vector<std::function<Value()>> readers; ///< of the current row
    std::size_t row = 0;
    std::optional<Expression> expression;
};

Query::Query(std::shared_ptr<Content> content) : content_(std::move(content)) {}

namespace {

/// A component of a column, of the row that `row` holds when asked.
Name name_of(const Source& source, const Column& column, std::size_t i, const std::size_t* row) {
    return {
        path_of(source, column, i),
        [table = source.table, &column, i, row, row_of = source.row_of] {
            return value_of(column, i, row_of(*row));
        },
        column.meanings};
}

/// Every name a row has.
std::vector<Name> names_of(const std::vector<Source>& sources, const std::size_t* row) {
    std::vector<Name> result;
    for (const Source& source : sources) {
        for (const Column& column : source.table->columns) {
            for (std::size_t i = 0; i < column.components; ++i) {
                result.push_back(name_of(source, column, i, row));
            }
        }
    }
    return result;
}

} // namespace

Result<Query> Query::prepare(const trace::Player& player, std::string_view expression) {
    const Result<Rows> rows = rows_for(expression);
    if (!rows) {
        return rows.diagnostics();
    }
    const std::vector<Source> sources = sources_of(*rows, player);
    auto content = std::make_shared<Content>();
    content->recording = player.shared_recording();
    content->rows = *rows;
    content->size = sources.front().table->rows;
    if (*rows == Rows::steps) {
        content->addresses.emplace(content->recording);
    }
    std::vector<Name> names = names_of(sources, &content->row);
    for (const Name& name : names) {
        content->paths.push_back(name.path);
        content->readers.push_back(name.read);
    }
    Result<Expression> compiled = Expression::compile(expression, std::move(names));
    if (!compiled) {
        return compiled.diagnostics();
    }
    content->expression.emplace(std::move(*compiled));
    return Query(std::move(content));
}

Rows Query::rows() const {
    return content_->rows;
}

std::size_t Query::size() const {
    return content_->size;
}

Result<bool> Query::matches(std::size_t row) {
    HS_CHECK(row < size(), "a row of this query");
    content_->row = row;
    return (*content_->expression)();
}

trace::StepId Query::step_of(std::size_t row) const {
    HS_CHECK(row < size(), "a row of this query");
    const trace::Recording& recording = *content_->recording;
    switch (content_->rows) {
    case Rows::vertices: {
        const auto after = std::upper_bound(
            recording.objects.begin(),
            recording.objects.end(),
            row,
            [](std::size_t r, const trace::ObjectRange& object) { return r < object.first_vertex; }
        );
        const trace::ObjectRange& object = *(after - 1);
        const trace::StepId number{row - object.first_vertex + 1};
        return object.first_vertex_step +
               number * static_cast<trace::StepId>(object.steps_per_vertex) - 1;
    }
    case Rows::triangles: return recording.triangles[row].first_step;
    case Rows::fragments:
        return trace::last_step_of_fragment(recording, static_cast<std::uint32_t>(row));
    case Rows::steps: return row;
    }
    HS_CHECK(false, "every kind of row has its step");
    return 0;
}

std::optional<PixelPos> Query::pixel_of(std::size_t row) const {
    HS_CHECK(row < size(), "a row of this query");
    if (content_->rows == Rows::fragments) {
        return content_->recording->fragments[row].pixel();
    }
    if (content_->rows == Rows::steps) {
        const trace::Step& step = (*content_->addresses)(row);
        return step.has_pixel() ? std::optional{step.pixel} : std::nullopt;
    }
    return std::nullopt;
}

std::vector<std::string> Query::columns() const {
    std::vector<std::string> result;
    for (const std::size_t i : content_->expression->mentioned()) {
        result.push_back(content_->paths[i]);
    }
    return result;
}

std::vector<Value> Query::values(std::size_t row) {
    HS_CHECK(row < size(), "a row of this query");
    content_->row = row;
    std::vector<Value> result;
    for (const std::size_t i : content_->expression->mentioned()) {
        result.push_back(content_->readers[i]());
    }
    return result;
}

std::vector<KnownName> known_names(const trace::Player& player) {
    std::vector<KnownName> result;
    const std::size_t nowhere = 0;
    for (const Rows rows : {Rows::vertices, Rows::fragments, Rows::steps}) {
        for (Name& name : names_of(sources_of(rows, player), &nowhere)) {
            result.push_back({std::move(name.path), std::move(name.meanings)});
        }
    }
    return result;
}

} // namespace hs::search

namespace hs {

template <>
std::span<const Named<search::Rows>> names<search::Rows>() {
    using search::Rows;
    static constexpr std::array<Named<Rows>, 4> table{{
        {Rows::vertices, "vertices", "every vertex of the frame"},
        {Rows::triangles, "triangles", "every triangle, with its corners a, b and c"},
        {Rows::fragments, "fragments", "every fragment, with its triangle"},
        {Rows::steps, "steps", "every step up to the playhead"},
    }};
    return table;
}

} // namespace hs
