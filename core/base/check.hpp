// Checks for the programmer's mistakes. The user's mistakes are diagnostics (diagnostic.hpp), never
// checks.
#pragma once

namespace hs {

/// Prints file, line, the condition and what it means when it fails, then aborts.
[[noreturn]] void
check_failed(const char* file, int line, const char* condition, const char* meaning);

} // namespace hs

/// Always on: cheap conditions whose failure would corrupt what a person is shown.
#define HS_CHECK(condition, meaning)                                                               \
    ((condition) ? static_cast<void>(0)                                                            \
                 : ::hs::check_failed(__FILE__, __LINE__, #condition, meaning))

/// Only in builds without NDEBUG: conditions inside hot loops.
#ifdef NDEBUG
#define HS_DCHECK(condition, meaning) static_cast<void>(0)
#else
#define HS_DCHECK(condition, meaning) HS_CHECK(condition, meaning)
#endif
