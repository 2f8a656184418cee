// What the timeline shows, gathered once per recording and per triangle: never linear in the trace.
#pragma once

#include "app/viewer/document.hpp"

#include <optional>
#include <string>
#include <vector>

namespace hs::viewer {

/// Steps [first, last] of something.
struct Band {
    trace::StepId first = 0;
    trace::StepId last = 0;
    trace::Stage stage = trace::Stage::application;
    std::string label;
};

class TimelineBands {
public:
    /// Brings both rows up to date. Precondition: a document is open.
    void update(Document& document, const std::optional<PixelPos>& selected);

    /// The whole frame: each object's vertices, their order if it is found, each object's
    /// triangles.
    [[nodiscard]] const std::vector<Band>& frame() const { return frame_; }
    /// The unit the playhead is in: a triangle's steps by stage; empty outside of triangles.
    [[nodiscard]] const std::vector<Band>& unit() const { return unit_; }
    [[nodiscard]] const Band& unit_range() const { return unit_range_; }

    /// Where fragments of the picked pixel met their fate.
    struct Mark {
        trace::StepId step = 0;
        bool passed = true;
    };
    [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }

private:
    void gather_marks(Document& document);
    void gather_frame(const trace::Recording& recording);
    void gather_draws(const trace::Recording& recording);
    void gather_unit(const trace::Recording& recording, std::uint32_t draw);

    std::optional<unsigned> document_;
    std::optional<std::uint32_t> draw_;
    std::vector<Band> frame_;
    std::vector<Band> unit_;
    Band unit_range_;
    std::optional<PixelPos> selected_;
    std::vector<Mark> marks_;
};

} // namespace hs::viewer
