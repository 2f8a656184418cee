// A second view beside the first: the same scene recorded with one setting, one entry of its camera
// or one of an object changed, its playhead in step with the first one's.
#pragma once

#include "app/viewer/background.hpp"
#include "app/viewer/document.hpp"
#include "app/viewer/screen_picture.hpp"
#include "core/scene/scene_file.hpp"
#include "core/trace/counterpart.hpp"

#include <memory>
#include <optional>
#include <string>

namespace hs::viewer {

class Beside {
public:
    /// Asks for a frame with one thing changed: a setting ("phong", "false", "0.5" as the value),
    /// or a path of the scene file into camera or objects. What is wrong with it, or nothing; of a
    /// path, `complaint` tells later.
    std::optional<std::string> ask(const scene::Assignment& change);
    void close();
    [[nodiscard]] const std::optional<scene::Assignment>& change() const { return change_; }

    /// The scene to record, while what stands here does not belong to `main`, which is open. Null:
    /// nothing to do, or `complaint` says why it cannot be. Call only while no job is under way.
    std::shared_ptr<const scene::Scene> take_work(const Document& main);
    /// What the job brought; ignored when `main` shows another recording meanwhile.
    void receive(Opened opened, const Document& main);
    /// Goes where `main` stands. By count: as many steps into the triangle.
    void follow(const Document& main, bool by_count);

    /// Belongs to what `main` shows, and can be shown beside it.
    [[nodiscard]] bool is_beside(const Document& main) const;
    /// Precondition for all below: is_beside of what is shown.
    [[nodiscard]] Document& document() { return document_; }
    [[nodiscard]] ScreenPicture& picture() { return picture_; }
    [[nodiscard]] trace::Match match() const { return match_; }
    [[nodiscard]] const trace::Difference& difference() const { return difference_; }

    /// Why there is no second frame; empty while it is being made.
    [[nodiscard]] const std::string& complaint() const { return complaint_; }

private:
    std::optional<scene::Assignment> change_;
    std::shared_ptr<const trace::Recording> source_; ///< that it was recorded beside, or will be
    Document document_;
    ScreenPicture picture_;
    std::optional<trace::StepId> followed_; ///< the first one's step
    bool by_count_ = false;
    trace::Match match_ = trace::Match::same_step;
    trace::Difference difference_;
    std::string complaint_;
};

} // namespace hs::viewer
