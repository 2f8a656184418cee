// `halfspace render`: the final image, without a trace.
#include "app/command/command.hpp"
#include "core/export/picture_file.hpp"
#include "core/export/whole_file.hpp"
#include "core/pipeline/draw_frame.hpp"
#include "core/pipeline/order_refusal.hpp"

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::filesystem::path out;
};

Result<framebuffer::Framebuffer>
draw(const std::shared_ptr<const scene::Scene>& scene, const Common& common) {
    framebuffer::Framebuffer framebuffer(scene->settings);
    pipeline::Frame frame(scene);
    pipeline::NullTrace nothing;
    const unsigned threads = common.threads == 0 ? hardware_threads() : common.threads;
    pipeline::shade_vertices(frame, nothing, threads);
    if (const auto complaint = pipeline::refuse_order(frame)) {
        return Diagnostic{.file = scene->file, .message = *complaint};
    }
    pipeline::draw_triangles(frame, framebuffer, nothing, threads);
    return framebuffer;
}

exporting::Layer color_layer(const framebuffer::Framebuffer& framebuffer) {
    exporting::Layer layer{
        .name = "color",
        .channels = {"R", "G", "B", "A"},
        .width = framebuffer.width(),
        .height = framebuffer.height(),
        .values = {}};
    layer.values.reserve(
        4 * static_cast<std::size_t>(layer.width) * static_cast<std::size_t>(layer.height)
    );
    for (int y = 0; y < layer.height; ++y) {
        for (int x = 0; x < layer.width; ++x) {
            const glm::vec4 color = framebuffer.color({x, y});
            layer.values.insert(layer.values.end(), {color.r, color.g, color.b, color.a});
        }
    }
    return layer;
}

int render(const Options& options, const Common& common) {
    const Result<std::string> format = output_format(options.out, {".png", ".exr"});
    if (!format) {
        return fail(format.diagnostics());
    }
    if (const Result<Done> good = exporting::check_writable(options.out); !good) {
        return fail(good.diagnostics());
    }
    const Result<Source> source = find_source(options.file, common);
    if (!source) {
        return fail(source.diagnostics());
    }
    const auto scene = load(*source);
    if (!scene) {
        return fail(scene.diagnostics());
    }
    const auto framebuffer = draw(*scene, common);
    if (!framebuffer) {
        return fail(framebuffer.diagnostics());
    }
    const exporting::Layer layer = color_layer(*framebuffer);
    const exporting::Attributes attributes = exporting::attributes_of(**scene);
    const Result<Done> written = *format == ".png"
                                     ? exporting::write_png(options.out, layer, attributes)
                                     : exporting::write_exr(options.out, {&layer, 1}, attributes);
    return written ? status_done : fail(written.diagnostics());
}

} // namespace

Command add_render(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand("render", "Draw the final image, without a trace");
    app->footer("Example:\n  halfspace render bunny.obj --size 1920x1080 -o bunny.png");
    app->add_option("FILE", options->file, file_help)->required();
    app->add_option("-o,--output", options->out, "picture to write: .png or .exr")->required();
    return {app, [options, &common] { return render(*options, common); }, true};
}

} // namespace hs::command
