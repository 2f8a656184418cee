// Any text as a step path: it names a step whose own path leads back to it, or is refused with a
// reason.
#include "core/trace/player.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/claims.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/support/random_scene.hpp"

#include <array>

using namespace hs;

namespace {

constexpr std::size_t recordings = 16;

const trace::Recording& recording_number(std::size_t i) {
    static std::array<std::shared_ptr<const trace::Recording>, recordings> made;
    if (made[i] == nullptr) {
        auto recorded = trace::record(tests::random_scene(i));
        HS_CHECK(recorded, "a small scene can be recorded");
        made[i] = *recorded;
    }
    return *made[i];
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes bytes(data, size);
    const trace::Recording& recording = recording_number(bytes.take<std::uint8_t>() % recordings);
    const std::string_view path = bytes.rest();
    const auto step = trace::find_step(recording, path);
    if (!step) {
        fuzz::check_diagnostics(step.diagnostics(), path);
        return 0;
    }
    HS_CHECK(*step <= recording.end_step, "a found step exists");
    const auto again =
        trace::find_step(recording, trace::step_path(trace::describe_step(recording, *step)));
    HS_CHECK(again && *again == *step, "a step's own path leads to it");
    return 0;
}
