// `halfspace render`: the final image, without a trace.
#include "app/command/command.hpp"
#include "core/export/picture_file.hpp"
#include "core/pipeline/draw.hpp"

#include <fmt/format.h>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::filesystem::path out;
};

exporting::Layer color_layer(const framebuffer::Framebuffer& framebuffer) {
    exporting::Layer layer{
        .name = "color",
        .channels = {"R", "G", "B", "A"},
        .width = framebuffer.width(),
        .height = framebuffer.height(),
        .values = {}};
    for (int y = 0; y < layer.height; ++y) {
        for (int x = 0; x < layer.width; ++x) {
            const glm::vec4 color = framebuffer.color({x, y});
            layer.values.insert(layer.values.end(), {color.r, color.g, color.b, color.a});
        }
    }
    return layer;
}

int render(const Options& options, const Common& common) {
    const std::string extension = options.out.extension().string();
    if (extension != ".png" && extension != ".exr") {
        return fail({{.file = options.out.string(), .message = "render writes .png or .exr"}});
    }
    const auto scene = load_input(options.file, common);
    if (!scene) {
        return fail(scene.diagnostics());
    }
    pipeline::Frame frame(*scene);
    framebuffer::Framebuffer framebuffer((*scene)->settings);
    pipeline::NullTrace nothing;
    const unsigned threads = common.threads == 0 ? hardware_threads() : common.threads;
    pipeline::draw_frame(frame, framebuffer, nothing, threads);

    const exporting::Layer layer = color_layer(framebuffer);
    const exporting::Attributes attributes{{"halfspace:scene", (*scene)->name}};
    const Result<Done> written = extension == ".png"
                                     ? exporting::write_png(options.out, layer, attributes)
                                     : exporting::write_exr(options.out, {{layer}}, attributes);
    return written ? status_done : fail(written.diagnostics());
}

} // namespace

Command add_render(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand("render", "Draw the final image, without a trace");
    app->add_option("FILE", options->file, "scene, mesh or lesson")->required();
    app->add_option("-o,--output", options->out, "picture to write: .png or .exr")->required();
    return {app, [options, &common] { return render(*options, common); }};
}

} // namespace hs::command
