#include "app/command/interrupt.hpp"

#include "core/export/whole_file.hpp"

#include <array>
#include <csignal>

namespace hs::command {
namespace {

// Handlers may touch nothing else
volatile std::sig_atomic_t received =
    0; // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

void on_signal(int number) {
    received = number;
    exporting::cancel_writing();
}

} // namespace

void ignore_failed_writes() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

void stop_on_signals() {
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    for (const int number : std::array{SIGINT, SIGTERM, SIGHUP}) {
        // One that is ignored already, as under nohup, stays so
        struct sigaction before {};
        if (sigaction(number, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) {
            sigaction(number, &action, nullptr);
        }
    }
}

bool stop_requested() {
    return received != 0;
}

void die_of_signal() {
    if (received != 0) {
        std::signal(received, SIG_DFL);
        std::raise(received);
    }
}

} // namespace hs::command
