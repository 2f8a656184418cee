#include "app/viewer/background.hpp"

#include <utility>

namespace hs::viewer {

Background::~Background() {
    cancel();
    wait();
    if (thread_.joinable()) {
        thread_.join();
    }
}

void Background::start(std::string title, Job job) {
    cancel();
    if (thread_.joinable()) {
        thread_.join();
    }
    title_ = std::move(title);
    progress_ = 0.0;
    stop_ = false;
    finished_ = false;
    thread_ = std::thread([this, work = std::move(job)] {
        result_ = work([this](double part) {
            progress_ = part;
            return !stop_;
        });
        finished_ = true;
        finished_.notify_all();
    });
}

void Background::cancel() {
    stop_ = true;
}

std::optional<Opened> Background::take() {
    if (!finished_ || !thread_.joinable()) {
        return std::nullopt;
    }
    thread_.join();
    Opened opened = std::exchange(result_, {});
    opened.cancelled = stop_;
    return opened;
}

void Background::wait() {
    if (thread_.joinable()) {
        finished_.wait(false);
    }
}

} // namespace hs::viewer
