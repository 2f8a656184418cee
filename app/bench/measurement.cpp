#include "app/bench/measurement.hpp"

namespace hs::bench {

std::optional<double> Measurement::ratio() const {
    if (!peer_value || *peer_value <= 0.0) {
        return std::nullopt;
    }
    return value / *peer_value;
}

std::optional<bool> Measurement::holds() const {
    const std::optional<double> judged = peer.empty() ? std::optional{value} : ratio();
    if (!budget || !judged) {
        return std::nullopt;
    }
    return *judged <= *budget;
}

} // namespace hs::bench
