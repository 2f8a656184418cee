// The viewer: its own work per frame while a large recording is stepped through. Drawing its
// triangles is the graphics library's work and not counted.
#include "app/bench/session.hpp"
#include "app/bench/timing.hpp"
#include "app/viewer/viewer.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

namespace hs::bench {
namespace {

using viewer::Command;

/// Takes pictures and shows them to nobody.
class NoTextures : public viewer::Textures {
public:
    ImTextureID create(int, int) override { return this; }
    void update(ImTextureID, const PixelRect&, std::span<const framebuffer::Rgba8>) override {}
    void destroy(ImTextureID) override {}
};

/// A window that is laid out but never drawn.
class NoWindow {
public:
    explicit NoWindow(ImVec2 size) : size_(size), context_(ImGui::CreateContext()) {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.LogFilename = nullptr;
        io.DisplaySize = size;
        io.DeltaTime = 1.0F / 60.0F;
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    }
    NoWindow(const NoWindow&) = delete;
    NoWindow& operator=(const NoWindow&) = delete;
    NoWindow(NoWindow&&) = delete;
    NoWindow& operator=(NoWindow&&) = delete;
    ~NoWindow() { ImGui::DestroyContext(context_); }

    void frame(viewer::Viewer& viewer) {
        if (viewer.prepare_fonts(1.0F)) {
            unsigned char* pixels = nullptr;
            int width = 0;
            int height = 0;
            ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        }
        ImGui::NewFrame();
        viewer.draw(size_, textures_);
        ImGui::Render();
    }

private:
    ImVec2 size_;
    ImGuiContext* context_;
    NoTextures textures_;
};

/// Steps of every fine size, forward and back.
void step(viewer::Viewer& viewer, int frame) {
    constexpr std::array commands{
        Command::step_forward,
        Command::operation_forward,
        Command::triangle_forward,
        Command::step_back,
        Command::triangle_back,
        Command::operation_back};
    viewer.run(commands[static_cast<std::size_t>(frame) % commands.size()]);
}

/// Color, depth, triangles …: the whole picture is made anew.
void change_view(viewer::Viewer& viewer, int /*frame*/) {
    viewer.run(Command::next_view);
}

void measure_frames_after(
    Session& session,
    const std::string& name,
    int frames,
    void (*input)(viewer::Viewer& viewer, int frame)
) {
    if (!session.wants(name)) {
        return;
    }
    const auto& recording = session.large_recording();
    session.progress(name);
    NoWindow window({1280.0F, 720.0F});
    viewer::Viewer viewer;
    viewer.set_recording(recording);
    viewer.seek(recording->end_step / 2);
    for (int i = 0; i < 5; ++i) {
        window.frame(viewer); // fonts, first pictures, the layout settles
    }
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(frames));
    for (int i = 0; i < frames; ++i) {
        times.push_back(computing_milliseconds([&] {
            input(viewer, i);
            window.frame(viewer);
        }));
    }
    session.add(
        {.name = name,
         .value = quantile(times, 0.99),
         .unit = "ms",
         .budget = 4.0,
         .note = fmt::format(
             "99th percentile of {} frames; median {:.2f} ms, slowest {:.2f} ms",
             frames,
             median(times),
             quantile(times, 1.0)
         )}
    );
}

} // namespace

void measure_viewer(Session& session) {
    measure_frames_after(session, "frame.viewer.knot870k", 500, step);
    measure_frames_after(session, "frame.viewer.knot870k.change-view", 100, change_view);
}

} // namespace hs::bench
