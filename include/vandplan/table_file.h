// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a table become a file, and how does a file become a table?
//
// Bytes only; vandplan/io.h moves them. Layout: docs/formats.md.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "vandplan/bound_table.h"
#include "vandplan/heuristic_table.h"

namespace vandplan {

/// The table as a binary file: the same bytes on every machine.
[[nodiscard]] std::string table_to_bytes(const HeuristicTable& table);

/// Reads what `table_to_bytes` wrote. Throws InputError naming `file` when it is foreign,
/// truncated, altered, or of another version.
[[nodiscard]] HeuristicTable table_from_bytes(std::string_view bytes, const std::string& file);

/// The library's table of bounds (bound_table.h) as a binary file.
[[nodiscard]] std::string bound_table_to_bytes();

/// What a table file says about itself before its entries.
struct TableFileHead {
  enum class Content { lengths, bounds };  ///< of `table_to_bytes`, of `bound_table_to_bytes`
  Content content = Content::lengths;
  HeuristicTableOptions options{};  ///< of lengths
  BoundTableInfo bounds{};          ///< of bounds
  std::uint64_t entries = 0;
  std::uint64_t bytes = 0;  ///< of the whole file
  std::uint64_t checksum = 0;
};

/// So many bytes of a file tell its head.
inline constexpr std::size_t table_file_head_size = 96;

/// Reads the head alone. Throws InputError naming `file` when it is not one of ours or promises
/// more than 2^28 entries.
[[nodiscard]] TableFileHead table_file_head(std::string_view start, const std::string& file);

/// Throws InputError naming `file` unless all of it is there and the checksum fits.
void check_table_file(std::string_view bytes, const std::string& file);

}  // namespace vandplan
