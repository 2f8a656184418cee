#include "core/base/hash.hpp"

#include "tests/support/catch.hpp"

#include <string_view>

using namespace hs;

namespace {

std::uint64_t digest_of(std::string_view text) {
    Digest digest;
    digest.add_bytes(std::as_bytes(std::span{text}));
    return digest.value();
}

} // namespace

TEST_CASE("digests are FNV-1a of 64 bits", "[base]") {
    // Published test vectors
    CHECK(digest_of("") == 0xcbf29ce484222325ULL);
    CHECK(digest_of("a") == 0xaf63dc4c8601ec8cULL);
    CHECK(digest_of("foobar") == 0x85944171f73967e8ULL);
}

TEST_CASE("a value is digested by its bytes", "[base]") {
    Digest by_value;
    by_value.add(std::uint32_t{0x64636261});
    CHECK(by_value.value() == digest_of("abcd"));
}
