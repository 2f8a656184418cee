// A fuzzer's input as numbers. When the bytes run out, zeros follow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace hs::fuzz {

class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    [[nodiscard]] bool empty() const { return at_ >= size_; }

    template <typename T>
    T take() {
        static_assert(std::is_trivially_copyable_v<T>);
        T value{};
        const std::size_t left = size_ - at_;
        const std::size_t count = sizeof(T) < left ? sizeof(T) : left;
        if (count > 0) {
            std::memcpy(&value, data_ + at_, count);
        }
        at_ += count;
        return value;
    }

    /// All that is left, as text.
    [[nodiscard]] std::string_view rest() const {
        return empty() ? std::string_view{}
                       : std::string_view{reinterpret_cast<const char*>(data_) + at_, size_ - at_};
    }

private:
    const std::uint8_t* data_;
    std::size_t size_;
    std::size_t at_ = 0;
};

} // namespace hs::fuzz
