// Prints one line per digest, `name value`. The lines must not depend on the compiler or its
// optimization level.

#include <bit>
#include <cstdint>
#include <cstdio>

namespace {

constexpr std::uint64_t fnv_offset = 0xcbf29ce484222325U;
constexpr std::uint64_t fnv_prime = 0x100000001b3U;

/// Products and sums as interpolation has them: a fused multiply-add would change the digest.
std::uint64_t arithmetic_digest() {
    std::uint64_t digest = fnv_offset;
    float value = 0.1F;
    for (int i = 1; i < 1000; ++i) {
        const float weight = 1.0F / static_cast<float>(i);
        value = value * weight + (1.0F - weight) * 0.7F;
        digest = (digest ^ std::bit_cast<std::uint32_t>(value)) * fnv_prime;
    }
    return digest;
}

void print(const char* name, std::uint64_t digest) {
    std::printf("%s %016llx\n", name, static_cast<unsigned long long>(digest));
}

} // namespace

int main() {
    print("arithmetic", arithmetic_digest());
    return 0;
}
