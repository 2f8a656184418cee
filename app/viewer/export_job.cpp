#include "app/viewer/export_job.hpp"

#include "core/base/spelling.hpp"
#include "core/export/layer_file.hpp"
#include "core/export/picture_file.hpp"
#include "core/export/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace hs::viewer {
namespace {

constexpr std::array<std::string_view, 4> endings{".png", ".exr", ".npz", ".csv"};

/// The buffer's name among those of `make_layers`.
std::string layer_name(ScreenContent content) {
    switch (content) {
    case ScreenContent::color: return "color";
    case ScreenContent::depth: return "depth";
    case ScreenContent::triangle: return "triangle";
    case ScreenContent::overdraw: return "overdraw";
    case ScreenContent::complexity: return "complexity";
    case ScreenContent::edge0: return "edge0";
    case ScreenContent::edge1: return "edge1";
    case ScreenContent::edge2: return "edge2";
    case ScreenContent::barycentric: return "barycentric";
    }
    HS_CHECK(false, "every content is exported");
    return "";
}

Result<Done> write(
    const std::filesystem::path& file,
    std::span<const exporting::Layer> layers,
    const exporting::Attributes& attributes
) {
    const std::string ending = file.extension().string();
    if (ending == ".exr") {
        return exporting::write_exr(file, layers, attributes);
    }
    if (ending == ".npz") {
        return exporting::write_npz(file, layers, attributes);
    }
    if (ending == ".csv") {
        return exporting::write_csv(file, layers);
    }
    return exporting::write_png(file, layers.front(), attributes);
}

} // namespace

std::string export_name(const Document& document, ScreenContent content) {
    std::string name = document.scene().name;
    std::ranges::replace_if(
        name, [](char c) { return c == ' ' || c == '/' || c == '\\' || c == ':'; }, '-'
    );
    const char* const ending = content == ScreenContent::color ? "png" : "exr";
    return fmt::format("{}-{}.{}", name, layer_name(content), ending);
}

Result<Background::Job>
export_job(const Document& document, ScreenContent content, const std::filesystem::path& file) {
    if (std::ranges::find(endings, file.extension().string()) == endings.end()) {
        return Diagnostic{
            .file = file.string(),
            .message = fmt::format(
                "the name must end in {}: it chooses the format", list_of_choices(endings)
            )};
    }
    if (const Result<Done> good = exporting::check_writable(file); !good) {
        return good.diagnostics();
    }
    // The numbers are taken now, for the playhead will move on; the file is written beside
    const std::array names{layer_name(content)};
    Result<std::vector<exporting::Layer>> layers = exporting::make_layers(document.player(), names);
    if (!layers) {
        return layers.diagnostics();
    }
    const exporting::Attributes attributes = exporting::attributes_of(document.player());
    const std::string path = trace::step_path(document.player().current());
    return Background::Job{[=, shown = std::move(*layers)](const Background::Progress&) {
        Opened opened;
        if (const Result<Done> written = write(file, shown, attributes); !written) {
            opened.problems = written.diagnostics();
        } else {
            opened.notice = fmt::format("Wrote {} after {} to {}.", names[0], path, file.string());
        }
        return opened;
    }};
}

} // namespace hs::viewer
