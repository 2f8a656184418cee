// A measured number, and the promise it is held to.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hs::bench {

struct Measurement {
    std::string name; ///< "record.knot870k.1080p"
    double value = 0.0;
    std::string unit{};
    std::string peer{};                 ///< what the value is divided by, "": nothing
    std::optional<double> peer_value{}; ///< in the same unit; empty: the peer could not be asked
    std::optional<double> budget{};     ///< at most: of the ratio where a peer is named, else of
                                        ///< the value
    std::string note{};                 ///< one more sentence, without a final full stop

    /// Empty without a peer.
    [[nodiscard]] std::optional<double> ratio() const;
    /// Empty without a budget, or where the peer could not be asked.
    [[nodiscard]] std::optional<bool> holds() const;
};

/// What a run brought.
struct Results {
    std::vector<Measurement> measurements;
    std::vector<std::string> remarks; ///< what was left out and why, a sentence each
};

} // namespace hs::bench
