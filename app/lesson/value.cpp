#include "app/lesson/value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hs::lesson {

namespace {

constexpr int most_digits = 6;

std::string print_number(double number, int digits) {
    if (!std::isfinite(number)) {
        return std::isnan(number) ? "not a number" : number > 0 ? "∞" : "−∞";
    }
    std::string text = fmt::format("{:.{}f}", number, digits < 0 ? most_digits : digits);
    if (digits < 0 && text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') {
            text.pop_back();
        }
    }
    // No zero has a sign for readers; other negative numbers carry a real minus
    if (text.find_first_of("123456789") == std::string::npos && text.front() == '-') {
        text.erase(0, 1);
    }
    return text.front() == '-' ? "−" + text.substr(1) : text;
}

std::string print_pixels(const PixelSet& pixels) {
    std::string text;
    for (const PixelPos& pixel : pixels) {
        text += fmt::format("{}({}, {})", text.empty() ? "" : " ", pixel.x, pixel.y);
    }
    return text.empty() ? "none" : text;
}

} // namespace

PixelSet make_pixel_set(std::vector<PixelPos> pixels) {
    std::ranges::sort(pixels, [](const PixelPos& a, const PixelPos& b) {
        return a.y != b.y ? a.y < b.y : a.x < b.x;
    });
    pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
    return pixels;
}

std::string print_value(const Value& value, int digits) {
    if (const auto* const number = std::get_if<double>(&value)) {
        return print_number(*number, digits);
    }
    if (const auto* const yes = std::get_if<bool>(&value)) {
        return *yes ? "yes" : "no";
    }
    if (const auto* const pixels = std::get_if<PixelSet>(&value)) {
        return print_pixels(*pixels);
    }
    return std::get<std::string>(value);
}

} // namespace hs::lesson
