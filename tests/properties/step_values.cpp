// Every number explains itself: the values of steps of random scenes, held to what was recorded,
// bit for bit, and every operand to the value of the step it is said to come from.
#include "core/explain/step_values.hpp"

#include "core/scene/scene_file.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_scene.hpp"
#include "tests/support/recorded_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

using namespace hs;
using explain::Number;
using explain::StepValue;
using trace::StepKind;

namespace {

constexpr std::uint64_t scenes = 90;

/// What random scenes have none of: lines and points, textures, lights that shine.
std::shared_ptr<const scene::Scene> shipped_scene(std::uint64_t number) {
    using Assignments = std::vector<scene::Assignment>;
    const std::array<std::pair<std::string, Assignments>, 5> made{
        {{"lines-and-points.toml", {{"line.algorithm", "bresenham"}}},
         {"lines-and-points.toml", {{"line.algorithm", "dda"}}},
         {"textured-plane.toml", {}},
         {"lit-torus.toml", {{"shading", "phong"}}},
         {"lit-torus.toml", {{"shading", "flat"}}}}};
    const auto& [file, assignments] = made.at(number);
    auto scene = scene::load_scene(test::source_dir() / "lessons/scenes" / file, assignments);
    REQUIRE(scene);
    return std::make_shared<scene::Scene>(std::move(*scene));
}

std::shared_ptr<const trace::Recording> recorded(std::uint64_t seed) {
    auto scene = std::make_shared<scene::Scene>(
        *(seed < 5        ? shipped_scene(seed)
          : seed % 3 == 0 ? tests::sampled_scene(seed / 3)
                          : tests::random_scene(seed))
    );
    if (scene->settings.visibility == scene::Visibility::ray_cast &&
        scene->settings.shading == scene::Shading::flat) {
        scene->settings.shading =
            scene::Shading::unlit; // outcodes tell the flat color, rays skip them
    }
    auto recording = trace::record(scene);
    REQUIRE(recording);
    return *recording;
}

std::vector<StepValue> values_of(const trace::Recording& recording, const trace::Step& step) {
    return explain::step_values(recording, step, trace::step_detail(recording, step));
}

/// Not a number is one value, whatever its bits: which of two a sum keeps is the compiler's choice.
bool same(const Number& a, const Number& b) {
    const auto nan = [](const Number& n) {
        const auto* f = std::get_if<float>(&n);
        const auto* d = std::get_if<double>(&n);
        return (f != nullptr && std::isnan(*f)) || (d != nullptr && std::isnan(*d));
    };
    return explain::same_bits(a, b) || (nan(a) && nan(b));
}

/// A few steps of every kind the recording has, whatever their share.
std::vector<trace::Step> some_of_each_kind(const trace::Recording& recording, std::uint64_t seed) {
    constexpr std::size_t most = 2;
    tests::Random random(seed);
    std::vector<std::vector<trace::Step>> by_kind(names<StepKind>().size());
    for (int i = 0; i < 150; ++i) {
        const trace::StepId id = random.next() % (recording.end_step + 1);
        const trace::Step step = trace::describe_step(recording, id);
        by_kind[static_cast<std::size_t>(step.kind)].push_back(step);
    }
    by_kind[0].push_back(trace::describe_step(recording, 0));
    std::vector<trace::Step> steps;
    for (std::vector<trace::Step>& kind : by_kind) {
        kind.resize(std::min(kind.size(), most));
        steps.insert(steps.end(), kind.begin(), kind.end());
    }
    return steps;
}

/// The steps that operands came from, each explained once.
class Sources {
public:
    struct Step {
        trace::StepId id = 0;
        std::vector<StepValue> values;
    };

    explicit Sources(const trace::Recording& recording) : recording_(recording) {}

    const Step& of(const explain::Origin& origin) {
        const auto [entry, is_new] = steps_.try_emplace(origin.step);
        if (is_new) {
            const auto source = explain::source_of(recording_, origin);
            REQUIRE(source);
            entry->second.id = source->step;
            entry->second.values =
                values_of(recording_, trace::describe_step(recording_, entry->second.id));
        }
        return entry->second;
    }

private:
    const trace::Recording& recording_;
    std::map<std::string, Step> steps_;
};

} // namespace

TEST_CASE("every value of a step is the one that was recorded", "[property][explain]") {
    std::vector<int> compared(names<StepKind>().size());
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        const auto recording = recorded(seed);
        for (const trace::Step& step : some_of_each_kind(*recording, seed)) {
            const auto values = values_of(*recording, step);
            INFO("seed " << seed << ", " << trace::step_path(step));
            for (const auto& [name, number] : tests::recorded_values(*recording, step)) {
                INFO(name);
                const StepValue* value = explain::find_value(values, name);
                REQUIRE(value != nullptr);
                INFO(
                    explain::in_symbols(*value->expression)
                    << " = " << explain::in_numbers(*value->expression) << " = "
                    << explain::exact_text(*value->expression) << ", recorded "
                    << explain::exact_text({.value = number})
                );
                REQUIRE(same(value->expression->value, number));
                ++compared[static_cast<std::size_t>(step.kind)];
            }
        }
    }
    for (const auto& kind : names<StepKind>()) {
        INFO(kind.name);
        CHECK(
            (compared[static_cast<std::size_t>(kind.value)] > 0) == (kind.value != StepKind::end)
        );
    }
}

TEST_CASE("every explanation gives its value when it is evaluated", "[property][explain]") {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        const auto recording = recorded(seed);
        for (const trace::Step& step : some_of_each_kind(*recording, seed)) {
            const auto values = values_of(*recording, step);
            INFO("seed " << seed << ", " << trace::step_path(step));
            CHECK(values.empty() == (step.kind == StepKind::end));
            for (const StepValue& value : values) {
                REQUIRE(same(explain::evaluate(*value.expression), value.expression->value));
            }
        }
    }
}

TEST_CASE("every operand is the value of the step it came from", "[property][explain]") {
    std::size_t followed = 0;
    for (std::uint64_t seed = 0; seed < scenes; seed += 1 + seed / 4) { // each takes a while
        const auto recording = recorded(seed);
        Sources sources(*recording);
        for (const trace::Step& step : some_of_each_kind(*recording, seed)) {
            for (const StepValue& value : values_of(*recording, step)) {
                for (const auto& operand : explain::operands_of(value.expression)) {
                    INFO(
                        "seed " << seed << ", " << trace::step_path(step) << ", " << value.name
                                << ": " << operand->symbol << ", "
                                << explain::origin_text(operand->origin)
                    );
                    REQUIRE(!explain::origin_text(operand->origin).empty());
                    if (operand->origin.step.empty()) {
                        continue;
                    }
                    const Sources::Step& from = sources.of(operand->origin);
                    REQUIRE(from.id <= step.id);
                    const StepValue* origin =
                        explain::find_value(from.values, operand->origin.value);
                    REQUIRE(origin != nullptr);
                    REQUIRE(same(origin->expression->value, operand->value));
                    ++followed;
                }
            }
        }
    }
    CHECK(followed > 3000);
}

TEST_CASE("names of a step's values are not repeated", "[property][explain]") {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        const auto recording = recorded(seed);
        for (const trace::Step& step : some_of_each_kind(*recording, seed)) {
            std::vector<std::string> names;
            for (const StepValue& value : values_of(*recording, step)) {
                names.push_back(value.name);
            }
            std::ranges::sort(names);
            INFO("seed " << seed << ", " << trace::step_path(step));
            CHECK(std::ranges::adjacent_find(names) == names.end());
        }
    }
}
