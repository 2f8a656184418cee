// Type: Inter for words, JetBrains Mono for numbers, as Debian installs them.
#include "app/viewer/theme.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>

namespace hs::viewer {
namespace {

constexpr std::array text_files{
    "/usr/share/fonts/opentype/inter/Inter-Regular.otf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
};
constexpr std::array strong_files{
    "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
};
constexpr std::array mono_files{
    "/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
};

// Latin, Greek, and the signs that formulas, keys and marks use. Few glyphs make a quick start.
constexpr std::array<ImWchar, 31> glyph_ranges{
    0x0020, 0x007E, // ASCII
    0x00A0, 0x00FF, // Latin-1: · × ° ² ½ umlauts
    0x0391, 0x03C9, // Greek
    0x2010, 0x2027, // dashes, quotes, ellipsis
    0x2032, 0x203A, // primes, ‹ ›
    0x2070, 0x208E, // superscripts and subscripts
    0x2190, 0x2193, // arrows
    0x2202, 0x221E, // ∂ ∈ ∏ ∑ − √ ∞
    0x2227, 0x222B, // ∧ ∨ ∩ ∪ ∫
    0x2248, 0x2265, // ≈ ≠ ≤ ≥
    0x22C5, 0x22C5, // ⋅
    0x2308, 0x230B, // ⌈ ⌉ ⌊ ⌋
    0x25A0, 0x25CF, // ▲ ▼ ▶ ◀ ◆ ○ ●
    0x2713, 0x2717, // ✓ ✗
    0x276E, 0x2771, // ❮ ❯
    0,
};

template <std::size_t n>
std::string first_present(const std::array<const char*, n>& files) {
    for (const char* file : files) {
        std::error_code error;
        if (std::filesystem::exists(file, error)) {
            return file;
        }
    }
    return "";
}

ImFontConfig crisp() {
    ImFontConfig config;
    config.OversampleH = 1; // whole pixels: hosts without texture filtering show the same picture
    config.OversampleV = 1;
    config.PixelSnapH = true;
    return config;
}

/// The first face there is, with the glyphs it lacks from the last one.
template <std::size_t n>
ImFont* load(ImFontAtlas& atlas, const std::array<const char*, n>& files, float size) {
    const std::string first = first_present(files);
    ImFontConfig config = crisp();
    if (first.empty()) {
        config.SizePixels = size;
        return atlas.AddFontDefault(&config);
    }
    ImFont* font = atlas.AddFontFromFileTTF(first.c_str(), size, &config, glyph_ranges.data());
    const std::string last = files[n - 1];
    std::error_code error;
    if (last != first && std::filesystem::exists(last, error)) {
        config.MergeMode = true;
        atlas.AddFontFromFileTTF(last.c_str(), size, &config, glyph_ranges.data());
    }
    return font;
}

} // namespace

Fonts load_fonts(ImFontAtlas& atlas, float scale) {
    constexpr float text_size = 17.0F;
    constexpr float strong_size = 18.0F;
    constexpr float small_size = 15.0F;
    constexpr float mono_size = 16.0F;
    constexpr float small_mono_size = 14.0F;
    const auto pixels = [scale](float size) { return std::round(size * scale); };

    atlas.Clear();
    atlas.Flags |= ImFontAtlasFlags_NoBakedLines;
    Fonts fonts;
    fonts.text = load(atlas, text_files, pixels(text_size));
    fonts.strong = load(atlas, strong_files, pixels(strong_size));
    fonts.small = load(atlas, text_files, pixels(small_size));
    fonts.mono = load(atlas, mono_files, pixels(mono_size));
    fonts.small_mono = load(atlas, mono_files, pixels(small_mono_size));
    atlas.Build();
    return fonts;
}

} // namespace hs::viewer
