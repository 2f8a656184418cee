// One run of the benchmark: what was asked for, what several measurements share, what came out.
#pragma once

#include "app/bench/bench.hpp"
#include "app/bench/measurement.hpp"
#include "app/bench/workload.hpp"
#include "app/peer/osmesa.hpp"
#include "core/base/parallel.hpp"
#include "core/trace/recording.hpp"

#include <memory>
#include <optional>
#include <string_view>

namespace hs::bench {

class Session {
public:
    explicit Session(const BenchOptions& options);

    /// Whether a measurement of this name was asked for.
    [[nodiscard]] bool wants(std::string_view name) const;
    /// Whether any measurement whose name begins like this was asked for.
    [[nodiscard]] bool wants_any(std::string_view prefix) const;

    void add(Measurement measurement);
    void remark(std::string sentence);
    /// Tells a waiting person what is going on.
    void progress(std::string_view what) const;

    // Shared by several measurements, made when first asked for
    /// Null mesh where the shared data is absent.
    const Subject& bunny();
    const Subject& knot70k();
    const Subject& knot870k();
    /// The frame that the playhead's budgets are about: knot870k at 1080p.
    const std::shared_ptr<const trace::Recording>& large_recording();
    /// Null, with a remark, where Mesa cannot be used.
    peer::Context* mesa();

    [[nodiscard]] const Results& results() const { return results_; }

private:
    const BenchOptions& options_;
    Results results_;
    std::optional<Subject> bunny_;
    std::optional<Subject> knot70k_;
    std::optional<Subject> knot870k_;
    std::shared_ptr<const trace::Recording> large_recording_;
    std::optional<peer::Context> mesa_;
    bool mesa_asked_ = false;
};

/// Records or says in a check why not: the workloads are made so that recording succeeds.
std::shared_ptr<const trace::Recording>
record(const std::shared_ptr<const scene::Scene>& scene, unsigned threads = hardware_threads());

// The measurements, one file each.
void measure_frames(Session& session);
void measure_playhead(Session& session);
void measure_memory(Session& session);
void measure_viewer(Session& session);
void measure_startup(Session& session);
void measure_growth(Session& session);
void measure_limits(Session& session);

} // namespace hs::bench
