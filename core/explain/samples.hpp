// In words and numbers: what happens at the samples of a pixel, and how they resolve to one color;
// and the pixel's whole square, where coverage is conservative.
#pragma once

#include "core/explain/formulas.hpp"
#include "core/trace/player.hpp"

#include <string>
#include <vector>

namespace hs::explain {

/// "0, 2 and 3"; "none".
std::string sample_list(raster::CoverageMask samples);

/// A sample's place within its pixel, from the top-left corner: "(.375, .125)".
std::string sample_place(const raster::SampleOffset& offset);

/// For sample_test; `who` is "triangle 12".
std::string sample_sentence(
    const std::string& who, const trace::Step& step, const std::vector<trace::SampleDetail>& samples
);
/// For merge, where a pixel has several samples; `who` is "Fragment (31, 17) of triangle 12".
std::string
samples_merge_sentence(const std::string& who, const trace::FragmentRecord& fragment, bool blended);
/// For resolve.
std::string resolve_sentence(const trace::Player& player);

/// For edge_test with conservative coverage; `who` is "triangle 12".
std::string square_sentence(
    const std::string& who,
    const trace::Step& step,
    const raster::TriangleSetup& setup,
    const raster::EdgeValues& center
);

/// The three edge functions at a sample, from their values at the pixel's center.
std::vector<Formula> sample_formulas(
    const raster::TriangleSetup& setup, const trace::Step& step, const trace::SampleDetail& sample
);
/// The three edge functions at the corners of the pixel's square that lie most inside.
std::vector<Formula> square_formulas(
    const raster::TriangleSetup& setup, PixelPos pixel, const raster::EdgeValues& center
);
/// What merging does to each sample that passed; its value is what the pixel would resolve to.
Formula samples_merge_formula(const pipeline::Merge& merge);
/// The average of a pixel's samples.
Formula resolve_formula(const trace::ResolveDetail& resolve);

} // namespace hs::explain
