// Any bytes as a mesh file of any format (the first byte chooses): refused with reasons, or a mesh
// that keeps its invariants.
#include "core/scene/mesh_file.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/claims.hpp"
#include "tests/fuzz/target.hpp"

#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

using namespace hs;

namespace {

constexpr std::array<std::string_view, 5> extensions{"obj", "off", "ply", "stl", "om"};

/// A file of this process alone, gone at its end.
class ScratchFile {
public:
    explicit ScratchFile(std::string_view extension)
        : path_(
              std::filesystem::temp_directory_path() /
              ("halfspace-fuzz-" + std::to_string(getpid()) + "." + std::string{extension})
          ) {}
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    ScratchFile(ScratchFile&&) = delete;
    ScratchFile& operator=(ScratchFile&&) = delete;
    ~ScratchFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }

    const std::filesystem::path& write(std::string_view content) {
        std::ofstream file(path_, std::ios::binary | std::ios::trunc);
        file.write(content.data(), static_cast<std::streamsize>(content.size()));
        return path_;
    }

private:
    std::filesystem::path path_;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes bytes(data, size);
    const auto format = bytes.take<std::uint8_t>() % extensions.size();
    const std::string_view content = bytes.rest();
    ScratchFile file(extensions[format]);
    const auto mesh = scene::load_mesh(file.write(content));
    if (!mesh) {
        fuzz::check_diagnostics(mesh.diagnostics(), content);
        return 0;
    }
    HS_CHECK(!mesh->positions.empty(), "an empty mesh is refused");
    fuzz::check_mesh(*mesh);
    return 0;
}
