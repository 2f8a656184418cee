// Start-up: from nothing to the first picture of the window, by the program itself.
#include "app/bench/session.hpp"
#include "app/bench/timing.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

extern char** environ; // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace hs::bench {
namespace {

/// The program that is running, if it is halfspace and the system says where it lies.
std::optional<std::filesystem::path> this_program() {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
    return !error && path.filename() == "halfspace" ? std::optional{path} : std::nullopt;
}

/// A folder for one scene and one picture, gone at the end.
class Scratch {
public:
    Scratch()
        : folder_(
              std::filesystem::temp_directory_path() /
              ("halfspace-bench-" + std::to_string(getpid()))
          ) {
        std::filesystem::create_directories(folder_);
        std::ofstream(scene()) << "[[object]]\nshape = { kind = \"cube\" }\n";
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    Scratch(Scratch&&) = delete;
    Scratch& operator=(Scratch&&) = delete;
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    [[nodiscard]] std::filesystem::path scene() const { return folder_ / "cube.toml"; }
    [[nodiscard]] std::filesystem::path picture() const { return folder_ / "window.png"; }

private:
    std::filesystem::path folder_;
};

/// Runs `halfspace shot` to its end; whether it succeeded.
bool shoot(const std::filesystem::path& program, const Scratch& scratch) {
    std::array<std::string, 6> words{
        program.string(),
        "shot",
        scratch.scene().string(),
        "-o",
        scratch.picture().string(),
        "--quiet"};
    std::array<char*, 7> arguments{};
    for (std::size_t i = 0; i < words.size(); ++i) {
        arguments[i] = words[i].data();
    }
    pid_t child = 0;
    int status = 1;
    return posix_spawn(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) == 0 &&
           waitpid(child, &status, 0) == child && status == 0;
}

} // namespace

void measure_startup(Session& session) {
    if (!session.wants("startup")) {
        return;
    }
    const auto program = this_program();
    const Scratch scratch;
    if (!program || !shoot(*program, scratch)) {
        session.remark("startup was skipped: this is not the program, or it cannot draw its window."
        );
        return;
    }
    session.progress("startup");
    const std::array<Contestant, 1> contestants{
        [&] { return milliseconds([&] { static_cast<void>(shoot(*program, scratch)); }); }};
    session.add(
        {.name = "startup",
         .value = take_turns(contestants, 7, 0.0).front() / 1e3,
         .unit = "s",
         .budget = 0.5,
         .note = "the whole of `halfspace shot`: start, window, first picture, its PNG"}
    );
}

} // namespace hs::bench
