#pragma once

#include "osmesa.hpp"
#include "render_target.hpp"
#include "session.hpp"

#include <map>
#include <memory>
#include <vector>

namespace hs::peer {

/// What a Context keeps between pictures.
struct Context::State {
    explicit State(std::shared_ptr<Session> the_session);
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    State(State&&) = delete;
    State& operator=(State&&) = delete;
    ~State();

    /// The target of this shape, made on first use; the session must be current.
    [[nodiscard]] const RenderTarget& target(const TargetShape& shape);

    std::shared_ptr<Session> session;
    std::map<TargetShape, std::unique_ptr<RenderTarget>> targets;
    GLuint vertex_array = 0;
    GLuint vertex_buffer = 0;
    GLuint texture = 0;
    std::vector<std::uint32_t> coverage_bits;
};

} // namespace hs::peer
