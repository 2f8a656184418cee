// Tables as files: CSV, JSON, NPZ.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/export/attributes.hpp"
#include "core/export/table.hpp"

#include <filesystem>

namespace hs::exporting {

/// A row per line, a column per component, enumerators by name, floats so that they read back
/// exactly.
Result<Done> write_csv(const std::filesystem::path& path, const Table& table);

/// {"vertex.clip": [[x, y, z, w], …], …}: a list per column, enumerators by name, what is not a
/// number as null.
Result<Done> write_json(const std::filesystem::path& path, const Table& table);

/// A zip of .npy members, one per column, and manifest.json; `numpy.load` opens it.
Result<Done>
write_npz(const std::filesystem::path& path, const Table& table, const Attributes& attributes);

} // namespace hs::exporting
