// What the numbers were measured on. Names no user, host or path.
#pragma once

#include <string>

namespace hs::bench {

struct Machine {
    std::string processor; ///< as the system calls it, "" where it does not say
    unsigned threads = 0;
    std::string compiler;
    double load = 0.0; ///< programs that wanted to run in the last minute, ours included
};

Machine this_machine();

} // namespace hs::bench
