// Every enumerator has a name and a sentence, in the one table beside its enumeration.
#include "core/explain/why_not.hpp"
#include "core/fragment/fate.hpp"
#include "core/geometry/clip_volume.hpp"
#include "core/geometry/facing.hpp"
#include "core/raster/tile.hpp"
#include "core/scene/scene.hpp"
#include "core/search/query.hpp"
#include "core/trace/counterpart.hpp"
#include "core/trace/step.hpp"
#include "core/visibility/order_names.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/enumerators.hpp"
#include "tests/support/paths.hpp"

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

using namespace hs;

namespace {

enum class Three {
    a,
    b,
    c
};
static_assert(tests::enumerator_count<Three>() == 3);
static_assert(tests::enumerator_count<scene::CompareOp>() == 8);

template <typename Enum>
void check_table(const char* enumeration) {
    INFO(enumeration);
    const std::span<const Named<Enum>> table = names<Enum>();
    REQUIRE(table.size() == tests::enumerator_count<Enum>());
    std::set<std::string_view> seen;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const Named<Enum>& row = table[i];
        INFO(row.name);
        CHECK(static_cast<std::size_t>(row.value) == i);
        CHECK(!row.name.empty());
        CHECK(seen.insert(row.name).second);
        REQUIRE(!row.explanation.empty());
        CHECK(row.explanation.back() != '.');
        CHECK(parse_name<Enum>(row.name) == row.value);
        CHECK(name_of(row.value) == row.name);
    }
}

/// The tables of core that are checked, by the name in their declaration.
struct Table {
    const char* enumeration;
    void (*check)(const char* enumeration);
};
constexpr Table tables[] = {
    {"explain::PixelRole", check_table<explain::PixelRole>},
    {"fragment::FragmentFate", check_table<fragment::FragmentFate>},
    {"geometry::ClipPlane", check_table<geometry::ClipPlane>},
    {"geometry::TriangleVerdict", check_table<geometry::TriangleVerdict>},
    {"raster::TileVerdict", check_table<raster::TileVerdict>},
    {"scene::BspOrder", check_table<scene::BspOrder>},
    {"scene::BspSplitter", check_table<scene::BspSplitter>},
    {"scene::ColorFormat", check_table<scene::ColorFormat>},
    {"scene::CompareOp", check_table<scene::CompareOp>},
    {"scene::CullFace", check_table<scene::CullFace>},
    {"scene::DepthConvention", check_table<scene::DepthConvention>},
    {"scene::DepthFormat", check_table<scene::DepthFormat>},
    {"scene::DepthOrder", check_table<scene::DepthOrder>},
    {"scene::Fault", check_table<scene::Fault>},
    {"scene::Forward", check_table<scene::Forward>},
    {"scene::InterpolationKind", check_table<scene::InterpolationKind>},
    {"scene::LightKind", check_table<scene::LightKind>},
    {"scene::LineAlgorithm", check_table<scene::LineAlgorithm>},
    {"scene::PrimitiveKind", check_table<scene::PrimitiveKind>},
    {"scene::PaintersKey", check_table<scene::PaintersKey>},
    {"scene::ProjectionKind", check_table<scene::ProjectionKind>},
    {"scene::Sampling", check_table<scene::Sampling>},
    {"scene::Shading", check_table<scene::Shading>},
    {"scene::TraversalKind", check_table<scene::TraversalKind>},
    {"scene::Visibility", check_table<scene::Visibility>},
    {"scene::Winding", check_table<scene::Winding>},
    {"search::Rows", check_table<search::Rows>},
    {"trace::Granularity", check_table<trace::Granularity>},
    {"trace::Match", check_table<trace::Match>},
    {"trace::Stage", check_table<trace::Stage>},
    {"trace::StepKind", check_table<trace::StepKind>},
    {"visibility::NewellTest", check_table<visibility::NewellTest>},
    {"visibility::OrderEventKind", check_table<visibility::OrderEventKind>},
    {"visibility::SweepEventKind", check_table<visibility::SweepEventKind>},
    {"visibility::Side", check_table<visibility::Side>},
};

/// Every `names<…>()` that a header of core declares.
std::set<std::string> declared_tables() {
    constexpr std::string_view before = ">> names<";
    std::set<std::string> found;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(test::source_dir() / "core")) {
        if (entry.path().extension() != ".hpp") {
            continue;
        }
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);) {
            const std::size_t begin = line.find(before);
            if (begin != std::string::npos && !line.starts_with("///")) {
                const std::size_t name = begin + before.size();
                found.insert(line.substr(name, line.find('>', name) - name));
            }
        }
    }
    return found;
}

} // namespace

TEST_CASE("every enumerator has its name and its sentence, in order", "[property][names]") {
    for (const Table& table : tables) {
        table.check(table.enumeration);
    }
}

TEST_CASE("no table of names in core escapes the test above", "[property][names]") {
    std::set<std::string> checked;
    for (const Table& table : tables) {
        checked.insert(table.enumeration);
    }
    CHECK(declared_tables() == checked);
}
