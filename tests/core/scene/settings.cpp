#include "core/scene/settings.hpp"

#include "core/scene/camera.hpp"
#include "core/scene/scene.hpp"
#include "tests/support/catch.hpp"

#include <limits>
#include <set>

using namespace hs;
using namespace hs::scene;

namespace {

using List = SettingValue::List;

SettingValue whole(std::int64_t number) {
    return {number};
}
SettingValue numbers(std::initializer_list<double> values) {
    List list;
    for (const double value : values) {
        list.emplace_back().value = value;
    }
    return {list};
}
SettingValue wholes(std::initializer_list<std::int64_t> values) {
    List list;
    for (const std::int64_t value : values) {
        list.emplace_back().value = value;
    }
    return {list};
}
SettingValue text(const char* value) {
    return {std::string{value}};
}

template <typename Enum>
void check_table(std::size_t count) {
    const std::span<const Named<Enum>> table = names<Enum>();
    REQUIRE(table.size() == count);
    std::set<std::string_view> distinct;
    for (std::size_t i = 0; i < table.size(); ++i) {
        INFO(table[i].name);
        CHECK(static_cast<std::size_t>(table[i].value) == i);
        CHECK(table[i].explanation.size() > 10);
        CHECK(table[i].explanation.back() != '.');
        CHECK(parse_name<Enum>(table[i].name) == table[i].value);
        distinct.insert(table[i].name);
    }
    CHECK(distinct.size() == count);
}

} // namespace

TEST_CASE("every enumerator of the scene room has a name and a sentence", "[unit][scene]") {
    check_table<Visibility>(10);
    check_table<TraversalKind>(8);
    check_table<CullFace>(3);
    check_table<Winding>(2);
    check_table<Shading>(4);
    check_table<InterpolationKind>(3);
    check_table<CompareOp>(8);
    check_table<DepthFormat>(3);
    check_table<DepthConvention>(3);
    check_table<DepthOrder>(2);
    check_table<ColorFormat>(2);
    check_table<Sampling>(3);
    check_table<Fault>(15);
    check_table<ProjectionKind>(4);
    check_table<Forward>(2);
    check_table<LightKind>(3);
}

TEST_CASE("every setting reads back what it was assigned", "[unit][scene]") {
    const Settings defaults;
    for (const SettingInfo& info : setting_infos()) {
        INFO(info.key);
        CHECK(find_setting(info.key)->key == info.key);
        CHECK(info.explanation.size() > 10);
        Settings settings;
        if (const std::optional<SettingValue> value = read_setting(defaults, info.key)) {
            CHECK(assign(settings, info.key, *value) == std::nullopt);
            CHECK(print_setting(settings, info.key) == print_setting(defaults, info.key));
        }
        for (const std::string_view choice : info.choices) {
            CHECK(assign(settings, info.key, {std::string{choice}}) == std::nullopt);
            CHECK(read_setting(settings, info.key) == SettingValue{std::string{choice}});
        }
        CHECK((info.type == SettingType::choice) == !info.choices.empty());
    }
}

TEST_CASE("no setting is also a group of settings", "[unit][scene]") {
    for (const SettingInfo& a : setting_infos()) {
        for (const SettingInfo& b : setting_infos()) {
            CHECK_FALSE(b.key.starts_with(std::string{a.key} + '.'));
        }
    }
}

TEST_CASE("settings print as the TOML that sets them", "[unit][scene]") {
    Settings settings;
    CHECK(print_setting(settings, "size") == "[64, 64]");
    CHECK(print_setting(settings, "background") == "[0.0, 0.0, 0.0, 1.0]");
    CHECK(print_setting(settings, "depth.test") == "\"less\"");
    CHECK(print_setting(settings, "depth.clear") == "1.0");
    CHECK(print_setting(settings, "viewport") == "[0, 0, 64, 64]");
    CHECK(print_setting(settings, "scissor") == "false");
    CHECK(print_setting(settings, "clip.planes") == "[]");
    CHECK(print_setting(settings, "clip.enabled") == "true");
    REQUIRE(assign(settings, "background", numbers({0.1, 0.25, 1e-8, 1.0})) == std::nullopt);
    CHECK(print_setting(settings, "background") == "[0.1, 0.25, 1e-08, 1.0]");
    REQUIRE(assign(settings, "clip.planes", {List{wholes({1, 0, 0, -2})}}) == std::nullopt);
    CHECK(print_setting(settings, "clip.planes") == "[[1.0, 0.0, 0.0, -2.0]]");
}

TEST_CASE(
    "reversed depth changes the defaults of test and clear, not what was chosen", "[unit][scene]"
) {
    Settings settings;
    REQUIRE(assign(settings, "depth.convention", text("reversed")) == std::nullopt);
    CHECK(print_setting(settings, "depth.test") == "\"greater\"");
    CHECK(print_setting(settings, "depth.clear") == "0.0");
    REQUIRE(assign(settings, "depth.test", text("lequal")) == std::nullopt);
    CHECK(settings.depth_test() == CompareOp::lequal);
}

TEST_CASE(
    "viewport and scissor are x, y, width, height and unset until assigned", "[unit][scene]"
) {
    Settings settings;
    CHECK(read_setting(settings, "viewport") == std::nullopt);
    CHECK(read_setting(settings, "scissor") == std::nullopt);
    REQUIRE(assign(settings, "viewport", wholes({8, 4, 32, 16})) == std::nullopt);
    CHECK(settings.viewport() == PixelRect{8, 4, 40, 20});
    CHECK(read_setting(settings, "viewport") == wholes({8, 4, 32, 16}));
    REQUIRE(assign(settings, "scissor", wholes({1, 2, 3, 0})) == std::nullopt);
    CHECK(settings.scissor == PixelRect{1, 2, 4, 2});
    REQUIRE(assign(settings, "scissor", {false}) == std::nullopt);
    CHECK(settings.scissor == std::nullopt);
    CHECK(check_combination(settings) == std::nullopt);
    REQUIRE(assign(settings, "size", wholes({16, 16})) == std::nullopt);
    CHECK(check_combination(settings).value_or("").find("viewport [8, 4, 32, 16]") == 0);
}

TEST_CASE("a refused value leaves the settings as they were", "[unit][scene]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const std::pair<const char*, SettingValue> bad[] = {
        {"size", wholes({0, 8})},
        {"size", wholes({8, 8193})},
        {"size", numbers({8.0, 8.0})},
        {"size", whole(8)},
        {"background", numbers({0.0, nan, 0.0, 1.0})},
        {"background", numbers({0.0, 0.0, infinity, 1.0})},
        {"background", numbers({0.0, 0.0, 1e39, 1.0})},
        {"background", numbers({0.0, 0.0, 0.0})},
        {"visibility", text("warnock")},
        {"depth.write", whole(1)},
        {"depth.clear", {nan}},
        {"depth.clear", {1.5}},
        {"depth.clear", text("1")},
        {"depth.test", text("LESS")},
        {"viewport", wholes({0, 0, 0, 4})},
        {"viewport", wholes({0, 0, 4})},
        {"scissor", {true}},
        {"scissor", wholes({0, 0, -1, 4})},
        {"clip.planes", {List{numbers({0.0, 0.0, 0.0, 1.0})}}},
        {"clip.planes", numbers({1.0, 0.0, 0.0, 1.0})},
        {"clip.planes", text("none")},
        {"guard_band", {0.5}},
        {"guard_band", whole(65)},
        {"guard_band", text("wide")},
        {"tile_size", whole(0)},
        {"tile_size", whole(12)},
        {"tile_size", whole(128)},
        {"tile_size", {8.5}},
        {"tile_size", text("8")},
    };
    for (const auto& [key, value] : bad) {
        INFO(key);
        Settings settings;
        CHECK(assign(settings, key, value).has_value());
        CHECK(settings == Settings{});
    }
}

TEST_CASE("an unknown setting is refused with the nearest known one", "[unit][scene]") {
    Settings settings;
    CHECK(
        assign(settings, "depth.tset", text("less")) ==
        "there is no setting \"depth.tset\"; did you mean \"depth.test\"?"
    );
    CHECK(
        assign(settings, "visibility", text("warnock")) ==
        "visibility must be \"none\", \"z-buffer\", \"painters\", \"front-lists\", "
        "\"newell-sancha\", \"bsp\", \"octree\", \"scanline\", \"scanline-z\" or \"ray-cast\", not "
        "\"warnock\""
    );
    CHECK(find_setting("depth") == nullptr);
}

TEST_CASE(
    "every compare op decides less, equal, greater and NaN as its name says", "[unit][scene]"
) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    struct Row {
        CompareOp op;
        bool less, equal, greater, unordered;
    };
    const Row rows[] = {
        {CompareOp::never, false, false, false, false},
        {CompareOp::less, true, false, false, false},
        {CompareOp::lequal, true, true, false, false},
        {CompareOp::equal, false, true, false, false},
        {CompareOp::gequal, false, true, true, false},
        {CompareOp::greater, false, false, true, false},
        {CompareOp::notequal, true, false, true, true},
        {CompareOp::always, true, true, true, true},
    };
    for (const Row& row : rows) {
        INFO(name_of(row.op));
        CHECK(compare(row.op, 0.25F, 0.5F) == row.less);
        CHECK(compare(row.op, 0.5F, 0.5F) == row.equal);
        CHECK(compare(row.op, 0.75F, 0.5F) == row.greater);
        CHECK(compare(row.op, nan, 0.5F) == row.unordered);
    }
}
