// Long work beside the window: one job at a time, with progress, and it can be stopped.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/trace/counterpart.hpp"
#include "core/trace/recording.hpp"

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace hs::lesson {
class Session;
}

namespace hs::viewer {

/// What a job brings back. Either problems, or a recording, or a lesson (which brings its own), or
/// only a notice that something was written.
struct Opened {
    std::filesystem::path file; ///< empty: the settings of the open scene were changed
    std::shared_ptr<const trace::Recording> recording;
    std::shared_ptr<lesson::Session> session;
    std::string at; ///< the step path to stand on; "" for the end
    Diagnostics problems;
    std::string notice;
    bool beside = false; ///< the recording goes beside the open one, and differs from it here:
    trace::Difference difference;
    bool cancelled = false;
};

class Background {
public:
    /// Reports the part done in [0, 1]; false: stop.
    using Progress = std::function<bool(double)>;
    using Job = std::function<Opened(const Progress&)>;

    Background() = default;
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;
    Background(Background&&) = delete;
    Background& operator=(Background&&) = delete;
    ~Background();

    /// Stops the job under way, if any, and starts another.
    void start(std::string title, Job job);
    void cancel();
    /// What a finished job brought, once.
    std::optional<Opened> take();
    /// Waits for the job to finish; `take` then has its result.
    void wait();

    [[nodiscard]] bool running() const { return thread_.joinable(); }
    [[nodiscard]] double progress() const { return progress_; }
    [[nodiscard]] const std::string& title() const { return title_; }

private:
    std::thread thread_;
    std::string title_;
    std::atomic<double> progress_{0.0};
    std::atomic<bool> stop_{false};
    std::atomic<bool> finished_{false};
    Opened result_; ///< the thread's until `finished_`
};

} // namespace hs::viewer
