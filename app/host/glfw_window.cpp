#include "app/host/glfw_window.hpp"

#include "app/host/gl_textures.hpp"
#include "app/host/glfw_keys.hpp"
#include "app/viewer/viewer.hpp"

#include <GL/gl.h>
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <cstdio>
#include <string>

namespace hs::host {
namespace {

/// What GLFW complained about last; its callback has no room for a context.
std::string& last_complaint() {
    static std::string text;
    return text;
}

int fail(std::string_view sentence) {
    const std::string& detail = last_complaint();
    fmt::print(stderr, "halfspace: {}{}{}\n", sentence, detail.empty() ? "" : ": ", detail);
    return 2;
}

// ---- events, in addition to those ImGui's backend takes

struct Events {
    viewer::Viewer* viewer = nullptr;
    bool any = true;
};

Events& events_of(GLFWwindow* window) {
    return *static_cast<Events*>(glfwGetWindowUserPointer(window));
}

void on_key(GLFWwindow* window, int key, int scancode, int action, int mods) {
    Events& events = events_of(window);
    events.any = true;
    if (action == GLFW_PRESS || action == GLFW_REPEAT) {
        events.viewer->key(translate_key(key, scancode, mods));
    }
}

/// "?" is on another key of every keyboard, so that it is taken as text.
void on_character(GLFWwindow* window, unsigned code) {
    Events& events = events_of(window);
    events.any = true;
    if (code == '?') {
        events.viewer->text("?");
    }
}

void on_drop(GLFWwindow* window, int count, const char** paths) {
    Events& events = events_of(window);
    events.any = true;
    if (count > 0) {
        events.viewer->open(paths[0]);
    }
}

void on_move(GLFWwindow* window, double, double) {
    events_of(window).any = true;
}
void on_button(GLFWwindow* window, int, int, int) {
    events_of(window).any = true;
}
void on_scroll(GLFWwindow* window, double, double) {
    events_of(window).any = true;
}
void on_refresh(GLFWwindow* window) {
    events_of(window).any = true;
}
void on_size(GLFWwindow* window, int, int) {
    events_of(window).any = true;
}

void listen(GLFWwindow* window, Events& events) {
    glfwSetWindowUserPointer(window, &events);
    glfwSetKeyCallback(window, on_key);
    glfwSetCharCallback(window, on_character);
    glfwSetDropCallback(window, on_drop);
    glfwSetCursorPosCallback(window, on_move);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetScrollCallback(window, on_scroll);
    glfwSetWindowRefreshCallback(window, on_refresh);
    glfwSetFramebufferSizeCallback(window, on_size);
}

// ---- window

GLFWwindow* open_window(const WindowOptions& options) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    return glfwCreateWindow(options.width, options.height, "Halfspace", nullptr, nullptr);
}

float content_scale(GLFWwindow* window) {
    float x = 1.0F;
    float y = 1.0F;
    glfwGetWindowContentScale(window, &x, &y);
    return x > 0.0F ? x : 1.0F;
}

void draw_frame(GLFWwindow* window, viewer::Viewer& viewer, GlTextures& textures) {
    if (viewer.prepare_fonts(content_scale(window))) {
        ImGui_ImplOpenGL3_DestroyFontsTexture(); // the backend makes another in its next frame
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    viewer.draw(ImGui::GetIO().DisplaySize, textures);
    ImGui::Render();
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    glViewport(0, 0, width, height);
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window);
}

/// Draws while something happens, sleeps otherwise.
void run_loop(GLFWwindow* window, viewer::Viewer& viewer, Events& events, int most_frames) {
    constexpr int frames_to_settle = 3; // ImGui sizes windows from their last frame's content
    constexpr double busy_pause = 0.03;
    GlTextures textures;
    std::string title;
    int unsettled = frames_to_settle;
    for (int drawn = 0; most_frames == 0 || drawn < most_frames;) {
        events.any = false;
        if (viewer.wants_frames()) {
            glfwWaitEventsTimeout(viewer.state().playing ? busy_pause / 2.0 : busy_pause);
            unsettled = frames_to_settle;
        } else if (unsettled > 0 || most_frames > 0) {
            glfwPollEvents();
        } else {
            glfwWaitEvents();
        }
        unsettled = events.any ? frames_to_settle : unsettled - 1;
        if (glfwWindowShouldClose(window) != 0 || viewer.state().quit) {
            return;
        }
        draw_frame(window, viewer, textures);
        ++drawn;
        if (viewer.title() != title) {
            title = viewer.title();
            glfwSetWindowTitle(window, title.c_str());
        }
    }
}

int run_with(GLFWwindow* window, viewer::Viewer& viewer, const WindowOptions& options) {
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    Events events{&viewer, true};
    listen(window, events);

    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.ConfigInputTextCursorBlink = false;      // a blinking cursor would keep the window awake
    ImGui_ImplGlfw_InitForOpenGL(window, true); // calls the callbacks set above, too
    ImGui_ImplOpenGL3_Init("#version 330 core");
    run_loop(window, viewer, events, options.frames);
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    return 0;
}

} // namespace

int run_in_window(viewer::Viewer& viewer, const WindowOptions& options) {
    glfwSetErrorCallback([](int, const char* text) { last_complaint() = text; });
    if (glfwInit() == GLFW_FALSE) {
        return fail(
            "there is no display to open a window on (`halfspace shot` draws the viewer into a "
            "picture without one)"
        );
    }
    int status = 0;
    if (GLFWwindow* window = open_window(options)) {
        status = run_with(window, viewer, options);
        glfwDestroyWindow(window);
    } else {
        status = fail("no window with OpenGL 3.3 could be opened");
    }
    glfwTerminate();
    return status;
}

} // namespace hs::host
