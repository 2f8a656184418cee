// NumPy's files: .npy headers and the .npz archive around them.
//
// NumPy Enhancement Proposal 1 (A Simple File Format for NumPy Arrays), format version 1.0. The
// archive is a zip whose members are stored, not deflated.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/export/attributes.hpp"
#include "core/export/table.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hs::exporting {

/// The header of an array in row order, little-endian. `type` as NumPy writes it: "<f4".
std::string npy_header(std::string_view type, const std::vector<std::size_t>& shape);

/// One member of an archive: `size` bytes, produced in order on demand, so that nothing large is
/// held twice.
struct Member {
    std::string name; ///< "vertex.clip.npy", "manifest.json"
    std::size_t size = 0;
    /// Writes bytes [first, first + count) to `out`; called with growing `first`.
    std::function<void(std::size_t first, std::size_t count, std::byte* out)> produce;
};

Member text_member(std::string name, std::string text);
/// A column of `rows` rows.
Member column_member(const Column& column, std::size_t rows);
/// An array of texts, as NumPy's fixed-width Unicode. Texts are ASCII.
Member texts_member(const std::string& name, std::span<const std::string> texts);
/// An array already in memory, which must outlive the writing.
Member array_member(
    const std::string& name,
    ColumnType type,
    const std::vector<std::size_t>& shape,
    const void* values
);
/// manifest.json, an object of texts.
Member manifest_member(const Attributes& attributes);

/// Appends a table's columns; a column of enumerators is followed by `<column>.names`, so that
/// `names[column]` reads as words.
void add_columns(std::vector<Member>& members, const Table& table);

/// Writes the archive whole or not at all.
Result<Done> write_archive(const std::filesystem::path& path, const std::vector<Member>& members);

} // namespace hs::exporting
