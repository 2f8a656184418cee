// Tables, parsed again: CSV by hand, JSON by a JSON library.
#include "core/export/table_file.hpp"
#include "core/scene/scene_file.hpp"
#include "tests/export/recorded.hpp"
#include "tests/export/temporary_folder.hpp"
#include "tests/support/paths.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

using namespace hs;
using tests::TemporaryFolder;

namespace {

exporting::Table table_of(const trace::Player& player, std::string_view name) {
    auto table = exporting::make_table(player, name);
    REQUIRE(table);
    return *table;
}

nlohmann::json as_json(const trace::Player& player, std::string_view name) {
    const TemporaryFolder folder;
    REQUIRE(exporting::write_json(folder / "table.json", table_of(player, name)));
    return nlohmann::json::parse(tests::read_text(folder / "table.json"));
}

std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> result;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) {
        result.push_back(field);
    }
    return result;
}

} // namespace

TEST_CASE(
    "every table has its documented columns and as many rows as the frame has things",
    "[export][table]"
) {
    const trace::Player player = tests::random_player(11);
    const trace::Recording& recording = player.recording();
    CHECK(table_of(player, "triangles").rows == recording.triangles.size());
    CHECK(table_of(player, "fragments").rows == player.fragments_done());
    CHECK(table_of(player, "counters").rows == 1);
    std::size_t vertices = 0;
    for (const trace::ObjectRange& object : recording.objects) {
        vertices += object.vertex_count;
    }
    CHECK(table_of(player, "vertices").rows == vertices);

    const nlohmann::json table = as_json(player, "triangles");
    for (const char* column :
         {"triangle.object_index",
          "triangle.face",
          "triangle.vertices",
          "triangle.primitive",
          "triangle.verdict",
          "triangle.clip_planes",
          "triangle.first_step"}) {
        INFO(column);
        REQUIRE(table.contains(column));
        CHECK(table[column].size() == recording.triangles.size());
    }
}

TEST_CASE("the table of vertices has each vertex in every space", "[export][table]") {
    int hidden = 0;
    for (std::uint64_t seed = 0; seed < tests::random_frames; ++seed) {
        const trace::Player player = tests::random_player(seed);
        const trace::Recording& recording = player.recording();
        const nlohmann::json table = as_json(player, "vertices");
        std::size_t row = 0;
        for (std::uint32_t object = 0; object < recording.objects.size(); ++object) {
            for (std::uint32_t v = 0; v < recording.objects[object].vertex_count; ++v, ++row) {
                const trace::VertexDetail detail = trace::vertex_detail(recording, object, v);
                CHECK(table["vertex.object_index"][row] == object);
                CHECK(table["vertex.world"][row][0].get<float>() == detail.work.world.x);
                CHECK(table["vertex.eye"][row][2].get<float>() == detail.work.eye.z);
                CHECK(table["vertex.clip"][row][3].get<float>() == detail.work.clip.w);
                if (detail.work.clip.w > 0.0F) {
                    CHECK(table["vertex.ndc"][row][1].get<float>() == detail.window.ndc.y);
                    CHECK(
                        table["vertex.window"][row][2].get<float>() == detail.window.window.depth
                    );
                } else {
                    CHECK(table["vertex.ndc"][row][1].is_null());
                    CHECK(table["vertex.window"][row][2].is_null());
                    ++hidden;
                }
            }
        }
    }
    CHECK(hidden > 0);
}

TEST_CASE(
    "the table of fragments tells what each was tested against and what became of it",
    "[export][table]"
) {
    for (std::uint64_t seed = 0; seed < tests::random_frames; ++seed) {
        const trace::Player player = tests::random_player(seed);
        const trace::Recording& recording = player.recording();
        const nlohmann::json table = as_json(player, "fragments");
        int wrong = 0;
        for (std::uint32_t i = 0; i < player.fragments_done(); ++i) {
            const trace::FragmentRecord& fragment = recording.fragments[i];
            const trace::PixelBefore before = trace::pixel_before(recording, i);
            const bool right =
                table["fragment.pixel"][i] == nlohmann::json{fragment.x, fragment.y} &&
                table["fragment.depth"][i].get<float>() == fragment.depth &&
                table["fragment.stored_depth"][i].get<float>() == before.depth &&
                table["fragment.triangle"][i] == recording.run_of_fragment(i).triangle &&
                table["fragment.fate"][i] == name_of(fragment.fate);
            wrong += right ? 0 : 1;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE(
    "the table of fragments has masks of samples only where a pixel has several", "[export][table]"
) {
    for (std::uint64_t seed = 0; seed < tests::random_frames; ++seed) {
        const trace::Player player = tests::random_player(seed);
        const trace::Recording& recording = player.recording();
        const nlohmann::json table = as_json(player, "fragments");
        REQUIRE(table.contains("fragment.coverage") == recording.samples.active());
        int wrong = 0;
        for (std::uint32_t i = 0; recording.samples.active() && i < player.fragments_done(); ++i) {
            const trace::FragmentRecord& fragment = recording.fragments[i];
            const bool right = table["fragment.coverage"][i] == fragment.coverage &&
                               table["fragment.passed"][i] == fragment.passed &&
                               (fragment.passed & ~fragment.coverage) == 0 &&
                               (fragment.passed != 0) == fragment.written();
            wrong += right ? 0 : 1;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("the table of samples holds what the playhead shows", "[export][table]") {
    for (std::uint64_t seed = 1; seed < tests::random_frames; seed += 2) {
        const trace::Player player = tests::random_player(seed);
        const trace::Recording& recording = player.recording();
        const nlohmann::json table = as_json(player, "samples");
        std::size_t row = 0;
        int wrong = 0;
        for (int y = 0; recording.samples.active() && y < recording.height(); ++y) {
            for (int x = 0; x < recording.width(); ++x) {
                const framebuffer::PixelSamples held = player.samples({x, y});
                for (int s = 0; s < held.count; ++s, ++row) {
                    const bool right =
                        table["sample.pixel"][row] == nlohmann::json{x, y} &&
                        table["sample.number"][row] == s &&
                        table["sample.color"][row][1].get<float>() == held[s].color.g &&
                        table["sample.depth"][row].get<float>() == held[s].depth;
                    wrong += right ? 0 : 1;
                }
            }
        }
        CHECK(table["sample.pixel"].size() == row);
        CHECK(wrong == 0);
    }
}

TEST_CASE("counters go up to the step", "[export][table]") {
    trace::Player player(tests::recorded(tests::random_scene(2)));
    CHECK(as_json(player, "counters")["counters.fragments"][0] == player.counters().fragments);
    player.seek(0);
    CHECK(as_json(player, "counters")["counters.fragments"][0] == 0);
}

TEST_CASE("a CSV table has a name and a number for every component", "[export][table]") {
    const TemporaryFolder folder;
    const trace::Player player = tests::random_player(4);
    for (const exporting::TableName& name : exporting::table_names()) {
        INFO(name.name);
        const exporting::Table table = table_of(player, name.name);
        REQUIRE(exporting::write_csv(folder / "table.csv", table));
        std::istringstream lines(tests::read_text(folder / "table.csv"));
        std::string line;
        REQUIRE(std::getline(lines, line));
        const std::size_t columns = fields(line).size();
        std::size_t rows = 0;
        for (; std::getline(lines, line); ++rows) {
            REQUIRE(fields(line).size() == columns);
        }
        CHECK(rows == table.rows);
    }
}

TEST_CASE(
    "pieces of clipped triangles are weighted means of the triangle's vertices", "[export][table]"
) {
    int pieces = 0;
    for (std::uint64_t seed = 0; seed < tests::random_frames; ++seed) {
        const trace::Player player = tests::random_player(seed);
        const trace::Recording& recording = player.recording();
        const nlohmann::json table = as_json(player, "pieces");
        const nlohmann::json vertices = as_json(player, "piece-vertices");
        for (std::size_t i = 0; i < table["piece.triangle"].size(); ++i, ++pieces) {
            const std::uint32_t triangle = table["piece.triangle"][i];
            const std::uint32_t object = recording.object_of_triangle(triangle);
            const trace::TriangleDetail detail = trace::triangle_detail(
                recording, object, triangle - recording.objects[object].first_triangle
            );
            for (const std::size_t v : table["piece.vertices"][i]) {
                const auto weights = vertices["piece_vertex.weights"][v].get<std::vector<float>>();
                CHECK(weights[0] + weights[1] + weights[2] == Approx(1.0F));
                float x = 0.0F;
                float size = 0.0F;
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    const float own = detail.corners[corner].work.clip.x;
                    x += weights[corner] * own;
                    size += std::abs(own);
                }
                const float clip_x = vertices["piece_vertex.clip"][v][0];
                CHECK(std::abs(clip_x - x) <= 1.0e-5F * size);
            }
        }
    }
    CHECK(pieces > 20);
}

namespace {

trace::Player swept_player(scene::Visibility visibility) {
    auto scene = scene::load_scene(test::source_dir() / "lessons/scenes/scanline-triangles.toml");
    REQUIRE(scene);
    scene->settings.visibility = visibility;
    return trace::Player(tests::recorded(std::make_shared<const scene::Scene>(*scene)));
}

} // namespace

TEST_CASE("spans and rays are what the pixels show", "[export][table]") {
    for (const auto visibility : {scene::Visibility::scanline, scene::Visibility::scanline_z}) {
        const trace::Player player = swept_player(visibility);
        const nlohmann::json table = as_json(player, "spans");
        std::size_t covered = 0;
        for (std::size_t i = 0; i < table["span.row"].size(); ++i) {
            // Pixel centers from x to x_end; of whole pixels all
            const double x = table["span.x"][i];
            const double x_end = table["span.x_end"][i];
            const bool whole = visibility == scene::Visibility::scanline_z;
            const auto last = static_cast<int>(whole ? x_end : std::ceil(x_end - 0.5));
            for (auto p = static_cast<int>(whole ? x : std::ceil(x - 0.5)); p < last; ++p) {
                const PixelPos pixel{p, table["span.row"][i]};
                const auto shown = static_cast<std::int32_t>(player.pixel(pixel).triangle);
                CHECK(table["span.triangle"][i] == shown);
                ++covered;
            }
        }
        CHECK(covered == 400);
    }
    const trace::Player player = swept_player(scene::Visibility::ray_cast);
    const nlohmann::json table = as_json(player, "rays");
    REQUIRE(table["ray.triangle"].size() == 400);
    for (std::size_t i = 0; i < 400; ++i) {
        const auto& at = table["ray.pixel"][i];
        const PixelPos pixel{at[0].get<int>(), at[1].get<int>()};
        CHECK(table["ray.triangle"][i] == static_cast<std::int32_t>(player.pixel(pixel).triangle));
    }
}

TEST_CASE("the decisions of one scanline end with the step's", "[export][table]") {
    trace::Player player = swept_player(scene::Visibility::scanline);
    player.seek(*trace::find_step(player.recording(), "scanline 7 / edge 1"));
    const nlohmann::json table = as_json(player, "sweep");
    const std::size_t rows = table["sweep.decision"].size();
    REQUIRE(rows > 3);
    CHECK(table["sweep.decision"][rows - 1] == "edge");
    CHECK(table["sweep.verdict"][rows - 1] == 1);
    CHECK(table["sweep.triangle"][rows - 1] == 1);
    CHECK(table["sweep.x"][rows - 1] == Approx(9.3));
    player.seek(0);
    CHECK(as_json(player, "sweep")["sweep.decision"].empty());
}

TEST_CASE("an unknown table is refused with the names of those there are", "[export][table]") {
    const auto table = exporting::make_table(tests::random_player(0), "normals");
    REQUIRE_FALSE(table);
    CHECK(
        table.diagnostics().front().message ==
        "'normals' is not a table; known are vertices, triangles, fragments, samples, counters, "
        "runs, pieces, piece-vertices, order, spans, rays, sweep, steps, traversals"
    );
}
