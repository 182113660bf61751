// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a table become a file, and how does a file become a table?
//
// The functions convert bytes; vandplan/files.h reads and writes them. Layout: docs/formats.md.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "vandplan/bound_table.h"
#include "vandplan/heuristic_table.h"

namespace vandplan {

/// The table as the bytes of a file, equal on every machine. Layout: docs/formats.md.
[[nodiscard]] std::string table_to_bytes(const HeuristicTable& table);

/// The table that `table_to_bytes` wrote. Throws InputError naming `file` if the bytes are foreign,
/// truncated, altered, or of another version.
[[nodiscard]] HeuristicTable table_from_bytes(std::string_view bytes, const std::string& file);

/// The library's table of bounds (bound_table.h) as the bytes of a file.
[[nodiscard]] std::string bound_table_to_bytes();

/// Head of a table file: what it says about itself before its entries.
struct TableFileHead {
  /// Content of a file: written by `table_to_bytes` (lengths), or by `bound_table_to_bytes`
  /// (bounds).
  enum class Content { lengths, bounds };
  Content content = Content::lengths;
  HeuristicTableOptions options{};  ///< options of a table of lengths
  BoundTableInfo bounds{};          ///< shape of a table of bounds
  std::uint64_t entries = 0;        ///< number of entries
  std::uint64_t bytes = 0;          ///< size of the whole file [bytes]
  std::uint64_t checksum = 0;       ///< checksum of the file
};

/// Number of bytes at the start of a table file that hold its head.
inline constexpr std::size_t table_file_head_size = 96;

/// The head of a table file. `start` holds at least its first bytes. Throws InputError naming
/// `file` when the file is not one of ours or promises more than 2^28 entries.
[[nodiscard]] TableFileHead table_file_head(std::string_view start, const std::string& file);

/// Checks a table file. Throws InputError naming `file` unless all of its bytes are there and the
/// checksum fits.
void check_table_file(std::string_view bytes, const std::string& file);

}  // namespace vandplan
