// Written whole or not at all.
#include "core/export/whole_file.hpp"

#include "core/export/npz.hpp"
#include "core/export/picture_file.hpp"
#include "tests/export/temporary_folder.hpp"
#include "tests/support/catch.hpp"

#include <sys/resource.h>

#include <csignal>
#include <stdexcept>

using namespace hs;
using tests::TemporaryFolder;
using Names = std::vector<std::string>;

namespace {

/// While it lives, files cannot grow beyond a few kilobytes: a full disk for those who write.
class SmallFiles {
public:
    SmallFiles() : before_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &limit_);
        rlimit small = limit_;
        small.rlim_cur = 4096;
        ::setrlimit(RLIMIT_FSIZE, &small);
    }
    SmallFiles(const SmallFiles&) = delete;
    SmallFiles& operator=(const SmallFiles&) = delete;
    SmallFiles(SmallFiles&&) = delete;
    SmallFiles& operator=(SmallFiles&&) = delete;
    ~SmallFiles() {
        ::setrlimit(RLIMIT_FSIZE, &limit_);
        std::signal(SIGXFSZ, before_);
    }

private:
    rlimit limit_{};
    void (*before_)(int);
};

const std::string much_text(200000, 'x');

/// Noise that no compression makes small.
exporting::Layer noise() {
    exporting::Layer layer{
        .name = "depth", .channels = {"Z"}, .width = 128, .height = 128, .values = {}};
    std::uint32_t state = 1;
    for (int i = 0; i < 128 * 128; ++i) {
        state = state * 1664525U + 1013904223U;
        layer.values.push_back(static_cast<float>(state >> 8U) * 0x1p-24F);
    }
    return layer;
}

} // namespace

TEST_CASE("a file written whole replaces the older one", "[export][whole-file]") {
    const TemporaryFolder folder;
    const auto file = folder.write("a.txt", "old");
    REQUIRE(exporting::write_text(file, "new"));
    CHECK(tests::read_text(file) == "new");
    CHECK(folder.names() == Names{"a.txt"});
}

TEST_CASE("a disk that fills up leaves the older file and nothing else", "[export][whole-file]") {
    const TemporaryFolder folder;
    const auto text = folder.write("a.txt", "old");
    const auto picture = folder.write("a.png", "old");
    const auto floats = folder.write("a.exr", "old");
    const auto archive = folder.write("a.npz", "old");
    const exporting::Layer layer = noise();
    Diagnostics problems;
    {
        const SmallFiles full_disk;
        const auto note = [&problems](const Result<Done>& written) {
            if (!written) {
                problems.push_back(written.diagnostics().front());
            }
        };
        note(exporting::write_text(text, much_text));
        note(exporting::write_png(picture, layer, {}));
        note(exporting::write_exr(floats, {&layer, 1}, {}));
        note(exporting::write_archive(archive, {exporting::text_member("a", much_text)}));
    }
    REQUIRE(problems.size() == 4);
    CHECK(problems[0].file == text.string());
    for (const Diagnostic& problem : problems) {
        INFO(problem.to_string());
        CHECK(problem.message.find("File too large") != std::string::npos);
    }
    CHECK(folder.names() == Names{"a.exr", "a.npz", "a.png", "a.txt"});
    for (const auto& file : {text, picture, floats, archive}) {
        CHECK(tests::read_text(file) == "old");
    }
}

TEST_CASE("an exception while writing leaves nothing", "[export][whole-file]") {
    const TemporaryFolder folder;
    const auto fails = [](exporting::ByteSink& sink) {
        sink.write(much_text);
        throw std::runtime_error("in the middle");
    };
    CHECK_THROWS_AS(exporting::write_bytes(folder / "a.txt", fails), std::runtime_error);
    CHECK(folder.names().empty());
}

TEST_CASE(
    "a member that cannot be produced is a sentence, not an exception through libzip",
    "[export][whole-file]"
) {
    const TemporaryFolder folder;
    const exporting::Member member{
        .name = "a.npy", .size = 100, .produce = [](std::size_t, std::size_t, std::byte*) {
            throw std::bad_alloc();
        }};
    const Result<Done> written = exporting::write_archive(folder / "a.npz", {member});
    REQUIRE_FALSE(written);
    CHECK(written.diagnostics().front().file == (folder / "a.npz").string());
    CHECK(folder.names().empty());
}

TEST_CASE("what cannot be written is said before anything is", "[export][whole-file]") {
    const TemporaryFolder folder;
    const auto sentence = [](const std::filesystem::path& path) {
        const Result<Done> written = exporting::check_writable(path);
        return written ? "" : written.diagnostics().front().message;
    };
    CHECK(sentence(folder / "a.png").empty());
    CHECK(sentence(folder.path()) == "cannot be written: it is a folder; name a file in it");
    CHECK(
        sentence(folder / "none" / "a.png") ==
        "cannot be written: there is no folder '" + (folder / "none").string() + "'"
    );
    CHECK(sentence("/dev/full") == "cannot be written: it is not a regular file");
    CHECK(sentence("") == "cannot be written: it names no file");
}

TEST_CASE("a name as long as the file system allows can be written", "[export][whole-file]") {
    const TemporaryFolder folder;
    const std::string name = std::string(251, 'n') + ".txt";
    CHECK(exporting::write_text(folder / name, "text"));
    CHECK(folder.names() == Names{name});
}
