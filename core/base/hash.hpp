// FNV-1a, 64 bit: Fowler, Noll and Vo, 1991. Digests tie recorded, stepped and untraced frames to
// each other; they are not meant to resist an adversary.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace hs {

class Digest {
public:
    void add_bytes(std::span<const std::byte> bytes) {
        for (const std::byte byte : bytes) {
            state_ = (state_ ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3ULL;
        }
    }
    /// Adds the object representation; only for types without padding.
    template <typename T>
    void add(const T& value) {
        static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>);
        add_bytes(std::as_bytes(std::span{&value, 1}));
    }
    [[nodiscard]] std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

} // namespace hs
