#include "core/scene/settings.hpp"

#include "core/base/spelling.hpp"
#include "core/scene/setting_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace hs::scene {

namespace {

constexpr std::size_t max_clip_planes = 2;

/// What is wrong with a value, without location; nothing when all is well.
using Complaint = std::optional<std::string>;

/// One row of the table: what people read, and how the value gets in and out.
struct Row {
    SettingInfo info;
    Complaint (*assign)(Settings&, std::string_view key, const SettingValue&);
    SettingValue (*read)(const Settings&); ///< defaults resolved
    bool (*is_set)(const Settings&) = [](const Settings&) { return true; };
};

// ---- rows that follow from a member's type
// -----------------------------------------------------------------------

template <typename Enum>
std::vector<std::string_view> choices() {
    std::vector<std::string_view> list;
    for (const Named<Enum>& row : names<Enum>()) {
        list.push_back(row.name);
    }
    return list;
}

template <typename Enum>
Complaint assign_choice(Enum& target, std::string_view key, const SettingValue& value) {
    const std::string* text = std::get_if<std::string>(&value.value);
    const std::optional<Enum> choice = text == nullptr ? std::nullopt : parse_name<Enum>(*text);
    if (!choice) {
        return must_be(key, list_of_choices(choices<Enum>()), value);
    }
    target = *choice;
    return std::nullopt;
}

/// The text of a row; whether it may stand in an object's settings.
struct Text {
    std::string_view key;
    std::string_view explanation;
    std::string_view opengl;
    bool per_object = false;
};

template <auto member>
Row choice_row(const Text& text) {
    using Enum = std::remove_cvref_t<decltype(Settings{}.*member)>;
    return {
        {text.key,
         SettingType::choice,
         text.explanation,
         text.opengl,
         text.per_object,
         choices<Enum>()},
        [](Settings& settings, std::string_view key, const SettingValue& value) {
            return assign_choice(settings.*member, key, value);
        },
        [](const Settings& settings) {
            return SettingValue{std::string{name_of(settings.*member)}};
        },
    };
}

template <bool Settings::*member>
Row boolean_row(const Text& text) {
    return {
        {text.key, SettingType::boolean, text.explanation, text.opengl, text.per_object, {}},
        [](Settings& settings, std::string_view key, const SettingValue& value) -> Complaint {
            const bool* truth = std::get_if<bool>(&value.value);
            if (truth == nullptr) {
                return must_be(key, "true or false", value);
            }
            settings.*member = *truth;
            return std::nullopt;
        },
        [](const Settings& settings) { return SettingValue{settings.*member}; },
    };
}

SettingInfo info(const Text& text, SettingType type) {
    return {text.key, type, text.explanation, text.opengl, text.per_object, {}};
}

// ---- rows of their own kind
// --------------------------------------------------------------------------------------

Complaint assign_size(Settings& settings, std::string_view key, const SettingValue& value) {
    const std::span<const SettingValue> list = entries(value);
    const bool pair = list.size() == 2;
    const std::optional<int> width = pair ? to_int(list[0], 1, max_size) : std::nullopt;
    const std::optional<int> height = pair ? to_int(list[1], 1, max_size) : std::nullopt;
    if (!width || !height) {
        return must_be(key, "[width, height], two whole numbers from 1 to 8192", value);
    }
    settings.width = *width;
    settings.height = *height;
    return std::nullopt;
}

SettingValue read_size(const Settings& settings) {
    return {SettingValue::List{{std::int64_t{settings.width}}, {std::int64_t{settings.height}}}};
}

Complaint assign_tile_size(Settings& settings, std::string_view key, const SettingValue& value) {
    constexpr std::array sizes{2, 4, 8, 16, 32, 64};
    const std::optional<float> size = to_float(value);
    const auto* const found = std::ranges::find(sizes, size.value_or(0.0F), [](int side) {
        return static_cast<float>(side);
    });
    if (found == sizes.end()) {
        return must_be(key, "2, 4, 8, 16, 32 or 64", value);
    }
    settings.tile_size = *found;
    return std::nullopt;
}

Complaint assign_samples(Settings& settings, std::string_view key, const SettingValue& value) {
    constexpr std::array counts{1, 2, 4, 8};
    const std::optional<float> samples = to_float(value);
    const auto* const found = std::ranges::find(counts, samples.value_or(0.0F), [](int count) {
        return static_cast<float>(count);
    });
    if (found == counts.end()) {
        return must_be(key, "1, 2, 4 or 8", value);
    }
    settings.samples = *found;
    return std::nullopt;
}

Complaint assign_background(Settings& settings, std::string_view key, const SettingValue& value) {
    const std::optional<glm::vec4> color = to_vec4(value);
    if (!color) {
        return must_be(key, "[red, green, blue, alpha], four finite numbers", value);
    }
    settings.background = *color;
    return std::nullopt;
}

Complaint assign_clip_planes(Settings& settings, std::string_view key, const SettingValue& value) {
    constexpr std::string_view expected =
        "a list of at most 2 planes [a, b, c, d] with a, b, c not all 0";
    const std::span<const SettingValue> list = entries(value);
    if (!std::holds_alternative<SettingValue::List>(value.value) || list.size() > max_clip_planes) {
        return must_be(key, expected, value);
    }
    std::vector<glm::vec4> planes;
    for (const SettingValue& entry : list) {
        const std::optional<glm::vec4> plane = to_vec4(entry);
        if (!plane || (plane->x == 0.0F && plane->y == 0.0F && plane->z == 0.0F)) {
            return must_be(key, expected, value);
        }
        planes.push_back(*plane);
    }
    settings.clip_planes = planes;
    return std::nullopt;
}

SettingValue read_clip_planes(const Settings& settings) {
    SettingValue::List list;
    for (const glm::vec4& plane : settings.clip_planes) {
        list.push_back(from_vec4(plane));
    }
    return {list};
}

Complaint assign_depth_clear(Settings& settings, std::string_view key, const SettingValue& value) {
    const std::optional<float> depth = to_float(value);
    if (!depth || *depth < 0.0F || *depth > 1.0F) {
        return must_be(key, "a number from 0 to 1", value);
    }
    settings.depth_clear_choice = *depth;
    return std::nullopt;
}

Complaint assign_guard_band(Settings& settings, std::string_view key, const SettingValue& value) {
    const std::optional<float> times = to_float(value);
    if (!times || *times < 1.0F || *times > 64.0F) {
        return must_be(key, "a number from 1 to 64", value);
    }
    settings.guard_band = *times;
    return std::nullopt;
}

Complaint assign_bsp_seed(Settings& settings, std::string_view key, const SettingValue& value) {
    constexpr int largest = 1'000'000'000;
    const std::optional<int> seed = to_int(value, 0, largest);
    if (!seed) {
        return must_be(key, "a whole number from 0 to 1000000000", value);
    }
    settings.bsp_seed = static_cast<std::uint64_t>(*seed);
    return std::nullopt;
}

Complaint assign_order_limit(Settings& settings, std::string_view key, const SettingValue& value) {
    const std::optional<float> limit = to_float(value);
    if (!limit || *limit < 1.0F || *limit > 1.0e12F) {
        return must_be(key, "a number from 1 to 1e12", value);
    }
    settings.order_limit = static_cast<double>(*limit);
    return std::nullopt;
}

Complaint assign_depth_test(Settings& settings, std::string_view key, const SettingValue& value) {
    CompareOp op = CompareOp::less;
    Complaint complaint = assign_choice(op, key, value);
    if (!complaint) {
        settings.depth_test_choice = op;
    }
    return complaint;
}

Complaint assign_viewport(Settings& settings, std::string_view key, const SettingValue& value) {
    const std::optional<PixelRect> rect = to_rect(value);
    if (!rect || rect->empty()) {
        return must_be(key, "[x, y, width, height] in whole pixels, at least one", value);
    }
    settings.viewport_choice = *rect;
    return std::nullopt;
}

Complaint assign_scissor(Settings& settings, std::string_view key, const SettingValue& value) {
    if (value == SettingValue{false}) {
        settings.scissor.reset();
        return std::nullopt;
    }
    const std::optional<PixelRect> rect = to_rect(value);
    if (!rect) {
        return must_be(key, "[x, y, width, height] in whole pixels, or false", value);
    }
    settings.scissor = *rect;
    return std::nullopt;
}

SettingValue read_scissor(const Settings& settings) {
    return settings.scissor ? from_rect(*settings.scissor) : SettingValue{false};
}

// ---- the table
// ---------------------------------------------------------------------------------------------------

Row depth_test_row() {
    SettingInfo text = info(
        {"depth.test",
         "how a fragment's depth must compare with the stored one; default less, greater when "
         "reversed",
         "glDepthFunc",
         true},
        SettingType::choice
    );
    text.choices = choices<CompareOp>();
    return {text, assign_depth_test, [](const Settings& settings) {
                return SettingValue{std::string{name_of(settings.depth_test())}};
            }};
}

std::vector<Row> image_rows() {
    return {
        {info({"size", "width and height of the image in pixels", ""}, SettingType::list),
         assign_size,
         read_size},
        {info(
             {"background", "the color the image is cleared to", "glClearColor"}, SettingType::color
         ),
         assign_background,
         [](const Settings& settings) { return from_vec4(settings.background); }},
        choice_row<&Settings::color_format>(
            {"color.format", "how the color buffer stores a channel", "glRenderbufferStorage"}
        ),
        {info(
             {"viewport",
              "the part of the image that NDC is mapped to: x, y of its top-left pixel, width, "
              "height",
              "glViewport"},
             SettingType::list
         ),
         assign_viewport,
         [](const Settings& settings) { return from_rect(settings.viewport()); },
         [](const Settings& settings) { return settings.viewport_choice.has_value(); }},
        {info(
             {"scissor",
              "fragments outside this rectangle are discarded: x, y of its top-left pixel, width, "
              "height",
              "glScissor"},
             SettingType::list
         ),
         assign_scissor,
         read_scissor,
         [](const Settings& settings) { return settings.scissor.has_value(); }},
    };
}

std::vector<Row> geometry_rows() {
    return {
        boolean_row<&Settings::clip_enabled>(
            {"clip.enabled", "whether triangles are clipped against the view volume", ""}
        ),
        {info(
             {"guard_band",
              "how many times wider and higher than the view volume the sides that clip are; what "
              "reaches beyond the image is cut by the bounding box instead",
              ""},
             SettingType::number
         ),
         assign_guard_band,
         [](const Settings& settings) {
             return SettingValue{static_cast<double>(settings.guard_band)};
         }},
        {info(
             {"clip.planes",
              "further planes [a, b, c, d] in eye space that cut away where ax + by + cz + d < 0",
              "glClipPlane"},
             SettingType::list
         ),
         assign_clip_planes,
         read_clip_planes},
        choice_row<&Settings::cull>(
            {"cull",
             "which side's triangles are discarded before rasterization",
             "glCullFace",
             true}
        ),
        choice_row<&Settings::front_face>(
            {"front_face",
             "which winding shows the front, on screen with y up",
             "glFrontFace",
             true}
        ),
    };
}

std::vector<Row> fragment_rows() {
    return {
        depth_test_row(),
        boolean_row<&Settings::depth_write>(
            {"depth.write",
             "whether a fragment that passes replaces the stored depth",
             "glDepthMask",
             true}
        ),
        choice_row<&Settings::depth_format>(
            {"depth.format", "how the depth buffer stores a value", "glRenderbufferStorage"}
        ),
        {info(
             {"depth.clear",
              "the depth every pixel starts with; default the far value of the convention",
              "glClearDepth"},
             SettingType::number
         ),
         assign_depth_clear,
         [](const Settings& settings) {
             return SettingValue{static_cast<double>(settings.depth_clear())};
         }},
        choice_row<&Settings::depth_convention>(
            {"depth.convention", "which NDC z the near and the far plane get", "glClipControl"}
        ),
        choice_row<&Settings::depth_order>(
            {"depth.order",
             "whether the depth test comes before or after shading",
             "layout(early_fragment_tests)",
             true}
        ),
        boolean_row<&Settings::blend_enabled>(
            {"blend.enabled",
             "whether a fragment is mixed with the pixel by its alpha instead of replacing it",
             "glEnable(GL_BLEND)",
             true}
        ),
    };
}

std::vector<Row> algorithm_rows() {
    return {
        choice_row<&Settings::visibility>(
            {"visibility", "which algorithm decides what hides what", "glEnable(GL_DEPTH_TEST)"}
        ),
        choice_row<&Settings::painters_key>(
            {"painters.key", "the one depth by which the painter's algorithm sorts a polygon", ""}
        ),
        choice_row<&Settings::bsp_splitter>(
            {"bsp.splitter", "which triangle's plane divides a list of a BSP tree", ""}
        ),
        {info(
             {"bsp.seed", "with which the random splitter begins: a whole number", ""},
             SettingType::number
         ),
         assign_bsp_seed,
         [](const Settings& settings) {
             return SettingValue{static_cast<std::int64_t>(settings.bsp_seed)};
         }},
        choice_row<&Settings::bsp_order>(
            {"bsp.order", "in which direction the BSP tree is walked", ""}
        ),
        {info(
             {"order.limit",
              "how many decisions an ordering may take: what would take more is refused with an "
              "estimate",
              ""},
             SettingType::number
         ),
         assign_order_limit,
         [](const Settings& settings) { return SettingValue{settings.order_limit}; }},
        choice_row<&Settings::traversal>(
            {"traversal", "which pixels are visited to find those a triangle covers", ""}
        ),
        {info(
             {"tile_size",
              "side of the largest tile of the hierarchical traversal in pixels: a power of two, 2 "
              "to 64",
              ""},
             SettingType::number
         ),
         assign_tile_size,
         [](const Settings& settings) { return SettingValue{std::int64_t{settings.tile_size}}; }},
        choice_row<&Settings::line_algorithm>(
            {"line.algorithm", "how the pixels of a line are found", ""}
        ),
        {info(
             {"samples",
              "points at which every pixel is asked whether a triangle covers it: 1, 2, 4 or 8",
              "glRenderbufferStorageMultisample"},
             SettingType::number
         ),
         assign_samples,
         [](const Settings& settings) { return SettingValue{std::int64_t{settings.samples}}; }},
        choice_row<&Settings::sampling>(
            {"sampling",
             "whether several samples share a color, or a pixel counts when it is merely touched",
             "glMinSampleShading"}
        ),
        choice_row<&Settings::shading>(
            {"shading", "where lighting is computed, if at all", "glShadeModel"}
        ),
        choice_row<&Settings::interpolation>(
            {"interpolation",
             "how values at the vertices spread over a triangle",
             "smooth, noperspective, flat"}
        ),
        choice_row<&Settings::fault>(
            {"fault", "a classic mistake, made on purpose: for bug hunts", ""}
        ),
    };
}

const std::vector<Row>& rows() {
    static const std::vector<Row> all = [] {
        std::vector<Row> list;
        for (const auto& group :
             {image_rows(), algorithm_rows(), geometry_rows(), fragment_rows()}) {
            list.insert(list.end(), group.begin(), group.end());
        }
        return list;
    }();
    return all;
}

const Row* find_row(std::string_view key) {
    const auto found = std::ranges::find(rows(), key, [](const Row& row) { return row.info.key; });
    return found == rows().end() ? nullptr : &*found;
}

const Row& known_row(std::string_view key) {
    const Row* row = find_row(key);
    HS_CHECK(row != nullptr, "only keys of the table of settings can be read");
    return *row;
}

} // namespace

std::span<const SettingInfo> setting_infos() {
    static const std::vector<SettingInfo> infos = [] {
        std::vector<SettingInfo> list;
        for (const Row& row : rows()) {
            list.push_back(row.info);
        }
        return list;
    }();
    return infos;
}

const SettingInfo* find_setting(std::string_view key) {
    const Row* row = find_row(key);
    return row == nullptr ? nullptr : &row->info;
}

std::optional<std::string>
assign(Settings& settings, std::string_view key, const SettingValue& value) {
    if (const Row* row = find_row(key)) {
        return row->assign(settings, row->info.key, value);
    }
    std::vector<std::string_view> keys;
    for (const Row& row : rows()) {
        keys.push_back(row.info.key);
    }
    return fmt::format("there is no setting \"{}\"{}", key, did_you_mean(key, keys));
}

std::string print_setting(const Settings& settings, std::string_view key) {
    return print_value(known_row(key).read(settings));
}

std::optional<SettingValue> read_setting(const Settings& settings, std::string_view key) {
    const Row& row = known_row(key);
    return row.is_set(settings) ? std::optional{row.read(settings)} : std::nullopt;
}

namespace {

/// Which traversals can ask what the sampling asks: samples, or whole pixels. Across the eye there
/// are no edge functions to ask samples with.
Complaint check_sampling(const Settings& settings) {
    const bool conservative = settings.sampling == Sampling::conservative;
    if (conservative && settings.samples != 1) {
        return fmt::format(
            "sampling \"conservative\" asks whole pixels and needs samples = 1, not {}",
            settings.samples
        );
    }
    if (settings.sampling == Sampling::supersample && settings.samples != 4) {
        return fmt::format("sampling \"supersample\" needs samples = 4, not {}", settings.samples);
    }
    const TraversalKind kind = settings.traversal;
    const bool boxed = kind == TraversalKind::bounding_box || kind == TraversalKind::incremental ||
                       kind == TraversalKind::serpentine || kind == TraversalKind::hierarchical;
    if (settings.samples > 1 && kind == TraversalKind::homogeneous) {
        return fmt::format(
            "traversal \"homogeneous\" asks pixel centers only; with {} samples it must be another",
            settings.samples
        );
    }
    if (conservative && !boxed) {
        return fmt::format(
            "traversal \"{}\" cannot ask whole pixels; with sampling \"conservative\" it must "
            "be \"bounding-box\", \"incremental\", \"serpentine\" or \"hierarchical\"",
            name_of(kind)
        );
    }
    return std::nullopt;
}

/// Rows that show the nearest triangle at each pixel center have no use for what needs several
/// fragments a pixel, or several points; rays, for what needs the view volume's planes.
Complaint check_sweep(const Settings& settings) {
    const std::string_view name = name_of(settings.visibility);
    if (settings.samples > 1 || settings.sampling != Sampling::multisample) {
        return fmt::format(
            "visibility \"{}\" decides at pixel centers; it needs samples = 1 and sampling "
            "\"multisample\"",
            name
        );
    }
    if (settings.blend_enabled) {
        return fmt::format(
            "visibility \"{}\" draws only the nearest triangle of a pixel; with blend.enabled = "
            "true "
            "those behind it are needed too",
            name
        );
    }
    const bool rays = settings.visibility == Visibility::ray_cast;
    if (rays && (!settings.clip_enabled || !settings.clip_planes.empty())) {
        return "visibility \"ray-cast\" cuts no triangles: its rays run from the near plane to the "
               "far plane; it needs clip.enabled = true and no clip.planes";
    }
    return std::nullopt;
}

} // namespace

std::optional<std::string> check_combination(const Settings& settings) {
    if (intersect(settings.viewport(), settings.image()) != settings.viewport()) {
        return fmt::format(
            "viewport {} does not lie within the image of {} x {} pixels",
            print_setting(settings, "viewport"),
            settings.width,
            settings.height
        );
    }
    if (settings.splits_triangles() && settings.traversal == TraversalKind::homogeneous) {
        return fmt::format(
            R"(visibility "{}" may cut triangles, which traversal "homogeneous" draws whole)",
            name_of(settings.visibility)
        );
    }
    if (settings.sweeps()) {
        return check_sweep(settings);
    }
    return check_sampling(settings);
}

} // namespace hs::scene
