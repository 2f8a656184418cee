#include "app/bench/session.hpp"

#include "core/base/check.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace hs::bench {
namespace {

std::filesystem::path data_folder(const BenchOptions& options) {
    if (!options.data.empty()) {
        return options.data;
    }
    const char* const chosen = std::getenv("HALFSPACE_DATA");
    return chosen != nullptr ? chosen : HALFSPACE_DATA_DIR;
}

} // namespace

Session::Session(const BenchOptions& options) : options_(options) {}

bool Session::wants(std::string_view name) const {
    return name.starts_with(options_.only);
}

bool Session::wants_any(std::string_view prefix) const {
    return wants(prefix) || std::string_view{options_.only}.starts_with(prefix);
}

void Session::add(Measurement measurement) {
    if (wants(measurement.name)) {
        results_.measurements.push_back(std::move(measurement));
    }
}

void Session::remark(std::string sentence) {
    results_.remarks.push_back(std::move(sentence));
}

void Session::progress(std::string_view what) const {
    if (!options_.quiet && isatty(STDERR_FILENO) != 0) {
        fmt::print(stderr, "measuring {} …\n", what);
    }
}

const Subject& Session::bunny() {
    if (!bunny_) {
        const std::filesystem::path folder = data_folder(options_);
        bunny_ = mesh_file("bunny", folder / "stanford-bunny.obj");
        if (bunny_->mesh == nullptr) {
            remark("The bunny was skipped: stanford-bunny.obj is not in the data folder; name one "
                   "with HALFSPACE_DATA.");
        }
    }
    return *bunny_;
}

const Subject& Session::knot70k() {
    if (!knot70k_) {
        knot70k_ = knot("knot70k", 70'000);
    }
    return *knot70k_;
}

const Subject& Session::knot870k() {
    if (!knot870k_) {
        knot870k_ = knot("knot870k", 870'000);
    }
    return *knot870k_;
}

const std::shared_ptr<const trace::Recording>& Session::large_recording() {
    if (large_recording_ == nullptr) {
        progress("a recording of knot870k.1080p to step in");
        large_recording_ = record(scene_of(knot870k(), full_hd));
    }
    return large_recording_;
}

peer::Context* Session::mesa() {
    if (!std::exchange(mesa_asked_, true)) {
        std::string why_not;
        mesa_ = peer::Context::create(&why_not);
        if (!mesa_) {
            remark(fmt::format("There is no peer to compare with: {}.", why_not));
        }
    }
    return mesa_ ? &*mesa_ : nullptr;
}

std::shared_ptr<const trace::Recording>
record(const std::shared_ptr<const scene::Scene>& scene, unsigned threads) {
    trace::RecordOptions options;
    options.threads = threads;
    auto recording = trace::record(scene, options);
    HS_CHECK(recording, "a workload can be recorded");
    return *recording;
}

} // namespace hs::bench
