// Why a triangle does not show at a pixel: every triangle at every pixel of random scenes has one
// reason, and the reason is a fact of the recording or a closed form.
#include "core/explain/why_not.hpp"

#include "core/explain/why_color.hpp"
#include "core/pipeline/homogeneous.hpp"
#include "core/scene/scene_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_scene.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>

using namespace hs;
using explain::PixelRole;
using explain::TriangleAtPixel;
using fragment::FragmentFate;
using geometry::TriangleVerdict;

namespace {

constexpr std::uint64_t scenes = 45;

/// Scenes in which happens what random ones have none of: a ring that front lists cannot draw, one
/// that is drawn front to back, and pixels beyond the viewport.
std::shared_ptr<const scene::Scene> rare_scene(std::uint64_t number) {
    using Assignments = std::vector<scene::Assignment>;
    const std::array<std::pair<std::string, Assignments>, 3> made{
        {{"three-triangle-cycle.toml", {{"visibility", "front-lists"}}},
         {"three-triangle-cycle.toml", {{"visibility", "bsp"}, {"bsp.order", "front-to-back"}}},
         {"two-crossing-triangles.toml", {{"viewport", "[0, 0, 20, 20]"}, {"guard_band", "4"}}}}};
    const auto& [file, assignments] = made.at(number);
    auto scene = scene::load_scene(test::source_dir() / "lessons/scenes" / file, assignments);
    REQUIRE(scene);
    return std::make_shared<scene::Scene>(std::move(*scene));
}

trace::Player player_of(std::uint64_t seed) {
    const auto scene = seed < 3        ? rare_scene(seed)
                       : seed % 4 == 0 ? tests::sampled_scene(seed / 4)
                                       : tests::random_scene(300 + seed);
    const auto recording = trace::record(scene);
    REQUIRE(recording);
    return trace::Player(*recording);
}

/// What the log has of a triangle at a pixel, up to the playhead.
struct Facts {
    std::vector<FragmentFate> fates; ///< first to last
    bool owns = false;               ///< it wrote last
};

Facts facts_of(const trace::Player& player, PixelPos pixel, std::uint32_t triangle) {
    const trace::Recording& recording = player.recording();
    Facts facts;
    facts.owns = player.pixel(pixel).triangle == triangle;
    for (std::uint32_t i = 0; i < player.fragments_done(); ++i) {
        const trace::FragmentRecord& record = recording.fragments[i];
        if (record.pixel() == pixel && recording.run_of_fragment(i).triangle == triangle) {
            facts.fates.push_back(record.fate);
        }
    }
    return facts;
}

PixelRole role_of(FragmentFate fate) {
    switch (fate) {
    case FragmentFate::depth_failed: return PixelRole::depth_failed;
    case FragmentFate::scissor_failed: return PixelRole::scissor_failed;
    case FragmentFate::pixel_closed: return PixelRole::pixel_closed;
    case FragmentFate::written: break;
    }
    return PixelRole::overwritten;
}

std::optional<PixelRole> role_of(TriangleVerdict verdict) {
    switch (verdict) {
    case TriangleVerdict::outside: return PixelRole::outside;
    case TriangleVerdict::back_facing: return PixelRole::back_facing;
    case TriangleVerdict::front_facing: return PixelRole::front_facing;
    case TriangleVerdict::degenerate: return PixelRole::degenerate;
    case TriangleVerdict::behind_the_eye: return PixelRole::behind_the_eye;
    case TriangleVerdict::too_large: return PixelRole::too_large;
    case TriangleVerdict::stuck: return PixelRole::stuck;
    case TriangleVerdict::drawn:
    case TriangleVerdict::unseen:
    case TriangleVerdict::no_sample_covered: break;
    }
    return std::nullopt;
}

/// No piece covers the pixel's center: asked of the edge functions themselves.
bool covers_nowhere(const trace::TriangleDetail& detail, PixelPos pixel) {
    return std::ranges::none_of(detail.pieces, [pixel](const trace::PieceDetail& piece) {
        return piece.planes  ? raster::test_planes(*piece.planes, pixel).inside
               : piece.setup ? piece.setup->bounds.contains(pixel) &&
                                   piece.setup->covers(piece.setup->evaluate(pixel))
                             : false;
    });
}

void check_reason(const trace::Player& player, PixelPos pixel, const TriangleAtPixel& reason) {
    const trace::Recording& recording = player.recording();
    const Facts facts = facts_of(player, pixel, reason.triangle);
    const bool written = std::ranges::count(facts.fates, FragmentFate::written) > 0;
    if (recording.settings().samples == 1) {
        REQUIRE((reason.role == PixelRole::shows) == facts.owns);
    } else if (facts.owns) {
        REQUIRE(reason.role == PixelRole::shows);
    }
    if (written) {
        REQUIRE((reason.role == PixelRole::shows || reason.role == PixelRole::overwritten));
        return;
    }
    if (!facts.fates.empty()) {
        REQUIRE(reason.role == role_of(facts.fates.back()));
        return;
    }
    const trace::TriangleRecord& record = recording.triangles[reason.triangle];
    if (reason.role == PixelRole::not_drawn_yet) {
        REQUIRE(trace::last_step_of_triangle(recording, reason.triangle) > player.step());
        return;
    }
    if (const auto role = role_of(record.verdict)) {
        REQUIRE(reason.role == *role);
        return;
    }
    const std::uint32_t object = recording.object_of_triangle(reason.triangle);
    const pipeline::DrawCall& call = recording.frame->calls()[object];
    if (reason.role == PixelRole::cut_away) {
        REQUIRE(record.crossed != 0);
        return;
    }
    if (reason.role == PixelRole::hidden) {
        REQUIRE(recording.settings().sweeps());
        const std::uint32_t last = recording.final_pixels[pixel].last_fragment;
        REQUIRE(last != trace::no_fragment);
        REQUIRE(recording.run_of_fragment(last).triangle != reason.triangle);
        return;
    }
    REQUIRE((reason.role == PixelRole::beyond_viewport) == !call.drawable().contains(pixel));
    if (reason.role == PixelRole::not_covered && recording.settings().samples == 1) {
        REQUIRE(covers_nowhere(
            trace::triangle_detail(
                recording, object, reason.triangle - recording.objects[object].first_triangle
            ),
            pixel
        ));
    }
}

} // namespace

TEST_CASE("every triangle has one true reason at every pixel", "[property][explain]") {
    std::set<PixelRole> seen;
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        trace::Player player = player_of(seed);
        const trace::Recording& recording = player.recording();
        tests::Random random(seed);
        for (int i = 0; i < 8; ++i) {
            player.seek(i < 4 ? recording.end_step : random.next() % (recording.end_step + 1));
            const PixelPos pixel{
                static_cast<int>(random.below(static_cast<std::uint32_t>(recording.width()))),
                static_cast<int>(random.below(static_cast<std::uint32_t>(recording.height())))};
            for (std::uint32_t t = 0; t < recording.triangles.size(); ++t) {
                const TriangleAtPixel reason = explain::triangle_at_pixel(player, pixel, t);
                INFO(
                    "seed " << seed << ", pixel " << pixel.x << ',' << pixel.y << " at #"
                            << player.step() << ": " << reason.sentence
                );
                REQUIRE(reason.triangle == t);
                REQUIRE(reason.sentence.ends_with('.'));
                REQUIRE(
                    (reason.step <= player.step()) == (reason.role != PixelRole::not_drawn_yet)
                );
                check_reason(player, pixel, reason);
                seen.insert(reason.role);
            }
        }
    }
    // Every reason was met but the two that need vertices in odd places
    for (const auto& role : names<PixelRole>()) {
        INFO(role.name);
        const bool rare =
            role.value == PixelRole::behind_the_eye || role.value == PixelRole::too_large;
        CHECK((seen.contains(role.value) || rare));
    }
}

TEST_CASE("who could have colored a pixel includes all who reached it", "[property][explain]") {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        const trace::Player player = player_of(seed);
        const trace::Recording& recording = player.recording();
        const PixelPos pixel{recording.width() / 2, recording.height() / 2};
        const auto list = explain::triangles_at_pixel(player, pixel);
        INFO("seed " << seed);
        for (std::uint32_t i = 0; i < recording.fragments.size(); ++i) {
            if (recording.fragments[i].pixel() == pixel) {
                const std::uint32_t triangle = recording.run_of_fragment(i).triangle;
                CHECK(std::ranges::count(list, triangle, &TriangleAtPixel::triangle) == 1);
            }
        }
        const auto shows = std::ranges::count(list, PixelRole::shows, &TriangleAtPixel::role);
        const bool background = player.pixel(pixel).triangle == trace::no_triangle;
        CHECK((shows > 0) == !background);
    }
}

TEST_CASE("the way back from a color ends at a row of a matrix", "[property][explain]") {
    int to_the_matrix = 0;
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        trace::Player player = player_of(seed);
        const trace::Recording& recording = player.recording();
        tests::Random random(seed);
        for (int i = 0; i < 4 && recording.fragments.size() > 0; ++i) {
            const std::uint32_t at =
                random.below(static_cast<std::uint32_t>(recording.fragments.size()));
            const PixelPos pixel = recording.fragments[at].pixel();
            const auto links = explain::why_this_color(player, pixel);
            INFO("seed " << seed << ", pixel " << pixel.x << ',' << pixel.y);
            REQUIRE(!links.empty());
            for (const explain::ColorLink& link : links) {
                REQUIRE(trace::describe_step(recording, link.step).id == link.step);
                REQUIRE(!link.value.name.empty());
            }
            if (player.pixel(pixel).triangle == trace::no_triangle) {
                CHECK(links.size() == 1);
                continue;
            }
            const glm::vec4 color = player.color(pixel);
            const std::string& first = links.front().value.name;
            if (recording.settings().samples == 1) {
                const char channel = first.back();
                const float shown = channel == 'r' ? color.r : channel == 'g' ? color.g : color.b;
                CHECK(std::get<float>(links.front().value.expression->value) == shown);
            }
            to_the_matrix += links.back().value.name.starts_with("clip.") ? 1 : 0;
        }
    }
    CHECK(to_the_matrix > 30);
}
