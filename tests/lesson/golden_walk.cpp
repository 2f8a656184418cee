// docs/golden-walk.md against the trace. The page's tables say what they hold: a column is a
// quantity ("clip.x", "2048 · depth" for a multiple), a row is what it is read of. A table whose
// corner is a quantity is a grid of pixels, columns x and rows y.
#include "app/lesson/markdown.hpp"
#include "app/lesson/quantity.hpp"
#include "app/lesson/recordings.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using hs::lesson::Block;
using hs::lesson::BlockKind;

const std::string triangle = "object 0 / triangle 0";

std::vector<Block> read_tables() {
    std::ifstream file(hs::test::source_dir() / "docs/golden-walk.md");
    std::stringstream text;
    text << file.rdbuf();
    std::vector<Block> tables;
    const std::string page = text.str(); // the parser points into it
    hs::lesson::Markdown markdown = hs::lesson::parse_markdown(page);
    for (hs::lesson::MarkdownPart& part : markdown.parts) {
        auto* const block = std::get_if<Block>(&part);
        if (block != nullptr && block->kind == BlockKind::table) {
            tables.push_back(std::move(*block));
        }
    }
    return tables;
}

/// What the cells of the page are held against.
class Walk {
public:
    Walk() {
        hs::lesson::RecordingCache recordings;
        const auto scene = hs::test::source_dir() / "lessons/01-one-triangle/triangle.toml";
        recording_ = recordings.get({scene, {}}).value();
        end_ = hs::trace::describe_step(*recording_, recording_->end_step);
    }

    /// What the page should say: "2048 · depth" of something, as print_value prints it; an empty
    /// text where there is no fragment.
    [[nodiscard]] std::string read(const std::string& heading, const std::string& of) const {
        const std::string dot = " · ";
        const std::size_t at = heading.find(dot);
        const double times = at == std::string::npos ? 1.0 : std::strtod(heading.c_str(), nullptr);
        const std::string name =
            at == std::string::npos ? heading : heading.substr(at + dot.size());
        hs::Result<hs::lesson::Value> value =
            hs::lesson::read_quantity(name, of, *recording_, end_);
        if (!value) {
            return is_uncovered(of) ? "" : value.diagnostics().front().message;
        }
        if (auto* const number = std::get_if<double>(&*value)) {
            *number = static_cast<double>(static_cast<float>(*number * times)); // 8-bit colors
        }
        return hs::lesson::print_value(*value);
    }

private:
    [[nodiscard]] bool is_uncovered(const std::string& of) const {
        const auto covered = hs::lesson::read_quantity("covered", of, *recording_, end_);
        return covered && !std::get<bool>(*covered);
    }

    std::shared_ptr<const hs::trace::Recording> recording_;
    hs::trace::Step end_;
};

/// What a cell is read of, by its row's and column's heading.
struct Address {
    std::string quantity;
    std::string of;
};

Address address(const std::string& corner, const std::string& row, const std::string& column) {
    if (corner.empty()) {
        return {column, row.starts_with("pixel") ? triangle + " / " + row : "object 0 / " + row};
    }
    if (corner == "edge") {
        return {row + "." + column, triangle};
    }
    return {corner, triangle + " / pixel " + column + "," + row};
}

/// Holds one row against the trace; returns how many cells it has.
std::size_t check_row(
    const std::vector<std::string>& head, const std::vector<std::string>& row, const Walk& walk
) {
    if (head[0] == "quantity") {
        CAPTURE(row[0], row[1]);
        CHECK(walk.read(row[0], row[1]) == row[2]);
        return 1;
    }
    for (std::size_t column = 1; column < row.size(); ++column) {
        const Address at = address(head[0], row[0], head[column]);
        CAPTURE(at.quantity, at.of);
        CHECK(walk.read(at.quantity, at.of) == row[column]);
    }
    return row.size() - 1;
}

std::vector<std::string> texts(const std::vector<hs::lesson::Spans>& row) {
    std::vector<std::string> result;
    result.reserve(row.size());
    for (const hs::lesson::Spans& cell : row) {
        result.push_back(hs::lesson::to_plain_text(cell));
    }
    return result;
}

} // namespace

TEST_CASE("every number of the golden walk is what the program computes", "[lesson]") {
    const Walk walk;
    std::size_t cells = 0;
    for (const Block& table : read_tables()) {
        const std::vector<std::string> head = texts(table.cells[0]);
        for (std::size_t row = 1; row < table.cells.size(); ++row) {
            cells += check_row(head, texts(table.cells[row]), walk);
        }
    }
    // vertices, edge coefficients, five grids of 80, ties, one fragment, three lists
    CHECK(cells == 66 + 12 + 5 * 80 + 12 * 4 + 8 + 19);
}
