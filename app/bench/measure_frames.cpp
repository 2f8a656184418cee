// Frames: drawn without a trace, and recorded with one, each beside llvmpipe on two threads.
#include "app/bench/peer_frame.hpp"
#include "app/bench/session.hpp"
#include "app/bench/timing.hpp"
#include "core/base/check.hpp"
#include "core/pipeline/draw_frame.hpp"

#include <fmt/format.h>

namespace hs::bench {
namespace {

constexpr unsigned threads = 2; // as llvmpipe has: see peer::Context

/// One table cell: a subject at a size, drawn by everyone who was asked for.
class Cell {
public:
    Cell(Session& session, const Subject& subject, const ImageSize& size)
        : session_(session),
          subject_(subject),
          name_(subject.name + "." + size.name),
          scene_(scene_of(subject, size)),
          frame_(scene_),
          target_(scene_->settings) {}

    void measure() {
        session_.progress(name_);
        std::optional<PeerFrame> peer;
        if (const peer::Context* const mesa = session_.mesa()) {
            peer = PeerFrame::create(*mesa, subject_, *scene_);
        }
        std::vector<Contestant> contestants{[this] { return draw_untraced(); }};
        if (peer) {
            contestants.emplace_back([&peer] { return peer->draw(); });
        }
        if (session_.wants("record." + name_)) {
            contestants.emplace_back([this] { return draw_recorded(); });
        }
        const std::vector<double> times = take_turns(contestants, 9, 1.5);
        const auto llvmpipe = peer ? std::optional{times[1]} : std::nullopt;
        const std::string note = peer ? compare(*peer) : std::string{};
        report("untraced.", times.front(), llvmpipe, 1.0, note);
        if (session_.wants("record." + name_)) {
            report("record.", times.back(), llvmpipe, 2.0, note);
        }
    }

private:
    double draw_untraced() {
        return milliseconds([this] {
            pipeline::NullTrace nothing;
            target_.clear(threads);
            pipeline::draw_frame(frame_, target_, nothing, threads);
        });
    }

    /// Letting the recording go is not measured: it happens when a person has seen enough.
    double draw_recorded() {
        std::shared_ptr<const trace::Recording> recording;
        return milliseconds([&] { recording = record(scene_, threads); });
    }

    /// Both must have drawn the same picture, else comparing their times means nothing.
    [[nodiscard]] std::string compare(const PeerFrame& peer) const {
        const PeerFrame::Agreement agreement = peer.compare(target_);
        HS_CHECK(agreement.same_picture(), "the peer draws the same scene");
        return fmt::format(
            "{} of {} covered pixels differ from the peer's", agreement.differing, agreement.covered
        );
    }

    void report(
        const std::string& kind,
        double value,
        std::optional<double> llvmpipe,
        double budget,
        const std::string& note
    ) {
        session_.add(
            {.name = kind + name_,
             .value = value,
             .unit = "ms",
             .peer = "llvmpipe",
             .peer_value = llvmpipe,
             .budget = budget,
             .note = note}
        );
    }

    Session& session_;
    const Subject& subject_;
    std::string name_;
    std::shared_ptr<const scene::Scene> scene_;
    pipeline::Frame frame_;
    framebuffer::Framebuffer target_;
};

using SubjectOf = const Subject& (Session::*)();

struct NamedSubject {
    std::string name;
    SubjectOf subject;
};

} // namespace

void measure_frames(Session& session) {
    const std::array<NamedSubject, 3> subjects{{
        {"bunny", &Session::bunny},
        {"knot70k", &Session::knot70k},
        {"knot870k", &Session::knot870k},
    }};
    for (const NamedSubject& named : subjects) {
        for (const ImageSize& size : {square_512, full_hd}) {
            const std::string name = named.name + "." + size.name;
            if (!session.wants("untraced." + name) && !session.wants("record." + name)) {
                continue;
            }
            const Subject& subject = (session.*named.subject)();
            if (subject.mesh != nullptr) {
                Cell(session, subject, size).measure();
            }
        }
    }
}

} // namespace hs::bench
