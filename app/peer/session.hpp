#pragma once

#include "gl_functions.hpp"

#include <map>
#include <memory>
#include <string>

namespace hs::peer {

/// One OSMesa context with its entry points and compiled programs. Objects made in it end with it.
class Session {
public:
    /// Null, and the reason in `why_not`, when there is no usable library.
    [[nodiscard]] static std::shared_ptr<Session> create(std::string& why_not);

    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    Session(Session&&) = delete;
    Session& operator=(Session&&) = delete;
    ~Session();

    /// Every public function of the peer begins with this: several sessions may share a thread.
    void make_current();

    /// The program of these two GLSL sources, compiled on first use; 0 when OpenGL refuses them.
    [[nodiscard]] GLuint program(const std::string& vertex, const std::string& fragment);

    /// What OpenGL complained about since the last call, as a sentence; empty when nothing.
    [[nodiscard]] std::string take_error() const;

    [[nodiscard]] const Gl& gl() const { return gl_; }

private:
    Session(const OsMesa& library, OsMesa::Context context);

    const OsMesa& library_;
    OsMesa::Context context_;
    Gl gl_;
    std::map<std::string, GLuint> programs_;
    /// OSMesa insists on a window buffer; all drawing goes to framebuffer objects instead.
    unsigned char window_buffer_[4] = {};
};

} // namespace hs::peer
