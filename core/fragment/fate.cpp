#include "core/fragment/fate.hpp"

namespace hs {

template <>
std::span<const Named<fragment::FragmentFate>> names<fragment::FragmentFate>() {
    using fragment::FragmentFate;
    static constexpr std::array<Named<FragmentFate>, fragment::fate_count> table{{
        {FragmentFate::written, "written", "it passed every test and changed the pixel"},
        {FragmentFate::scissor_failed,
         "scissor failed",
         "its pixel lies outside the scissor rectangle"},
        {FragmentFate::depth_failed,
         "depth failed",
         "the comparison with the stored depth was false"},
        {FragmentFate::pixel_closed,
         "pixel closed",
         "a nearer triangle was written there before, front to back"},
    }};
    return table;
}

} // namespace hs
