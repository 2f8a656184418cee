#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hs::explain {

std::string number(float value) {
    constexpr float smallest_shown = 0.00005F;
    constexpr float largest_shown = 1.0e9F;
    const float size = std::fabs(value);
    if (size == 0.0F) {
        return "0.0000"; // whichever sign zero has
    }
    if (size < smallest_shown || !(size < largest_shown)) {
        return fmt::format("{:.3e}", value);
    }
    return fmt::format("{:.4f}", value);
}

std::string signed_number(float value) {
    const std::string text = number(value);
    const bool negative = text.front() == '-';
    return fmt::format("{}{}", negative ? "−" : " ", text.substr(negative ? 1 : 0));
}

std::pair<std::string, std::string> compared(float left, float right) {
    std::pair<std::string, std::string> texts{number(left), number(right)};
    if (left != right && texts.first == texts.second) {
        return {fmt::format("{:.9f}", left), fmt::format("{:.9f}", right)};
    }
    return texts;
}

std::string whole(std::int64_t value) {
    const std::string plain = fmt::format("{}", value);
    const std::size_t digits = plain.size() - (value < 0 ? 1 : 0);
    std::string grouped;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const std::size_t left = plain.size() - i;
        if (left % 3 == 0 && left < digits) {
            grouped += ' ';
        }
        grouped += plain[i];
    }
    return grouped;
}

std::string square_pixels(std::int64_t value) {
    return number(static_cast<float>(static_cast<double>(value) / 65536.0));
}

std::string pixels(std::int64_t value) {
    return number(static_cast<float>(static_cast<double>(value) / 256.0));
}

std::string pixel(PixelPos p) {
    return fmt::format("({}, {})", p.x, p.y);
}

std::string point(float x, float y, float z) {
    return fmt::format("({}, {}, {})", number(x), number(y), number(z));
}

std::string point(const glm::vec4& v) {
    return fmt::format("({}, {}, {}, {})", number(v.x), number(v.y), number(v.z), number(v.w));
}

} // namespace hs::explain
