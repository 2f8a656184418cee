// Growth: recording must cost in proportion to triangles and fragments, however many there are.
#include "app/bench/session.hpp"
#include "app/bench/timing.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>

namespace hs::bench {
namespace {

/// From one point of a curve to the next, an item may cost so much more: caches end, the law does
/// not.
constexpr double growth_budget = 1.5;

double record_time(const std::shared_ptr<const scene::Scene>& scene, std::size_t rounds) {
    const std::array<Contestant, 1> contestants{[&scene] {
        std::shared_ptr<const trace::Recording> recording;
        return milliseconds([&] { recording = record(scene); });
    }};
    return take_turns(contestants, rounds, 0.0).front();
}

/// Adds points of a curve; each is held against the one before.
class Curve {
public:
    Curve(Session& session, std::string item) : session_(session), item_(std::move(item)) {}

    void add(const std::string& name, double nanoseconds) {
        Measurement point{.name = name, .value = nanoseconds, .unit = "ns/" + item_};
        if (!last_name_.empty()) {
            point.peer = last_name_;
            point.peer_value = last_;
            point.budget = growth_budget;
        }
        last_ = nanoseconds;
        last_name_ = name.substr(name.rfind('.') + 1);
        session_.add(std::move(point));
    }

private:
    Session& session_;
    std::string item_;
    double last_ = 0.0;
    std::string last_name_;
};

void measure_triangles(Session& session) {
    Curve curve(session, "triangle");
    for (const int thousands : {14, 55, 220, 870, 3500}) {
        const std::string name = fmt::format("curve.triangles.{}k", thousands);
        session.progress(name);
        const auto scene = scene_of(knot("knot", thousands * 1000), square_512);
        const auto triangles = static_cast<double>(scene->objects.front().mesh->triangles.size());
        curve.add(name, record_time(scene, 7) * 1e6 / triangles);
    }
}

/// Memory that could be used now, in bytes.
double free_memory() {
    return static_cast<double>(sysconf(_SC_AVPHYS_PAGES)) *
           static_cast<double>(sysconf(_SC_PAGESIZE));
}

void measure_fragments(Session& session) {
    constexpr double bytes_needed = 30.0; // per fragment, with room to spare
    constexpr double fragments_of_sheet = 1920.0 * 1080.0;
    Curve curve(session, "fragment");
    for (const int count : {1, 5, 16, 49}) {
        const double fragments = fragments_of_sheet * count;
        const std::string name = fmt::format("curve.fragments.{:.0f}m", fragments / 1e6);
        if (fragments * bytes_needed > free_memory()) {
            session.remark(fmt::format("{} was skipped: it needs more memory than is free.", name));
            continue;
        }
        session.progress(name);
        curve.add(name, record_time(sheets(count, full_hd), 3) * 1e6 / fragments);
    }
}

} // namespace

void measure_growth(Session& session) {
    if (session.wants_any("curve.triangles.")) {
        measure_triangles(session);
    }
    if (session.wants_any("curve.fragments.")) {
        measure_fragments(session);
    }
}

} // namespace hs::bench
