// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a heuristic table become a file, and how does a file become a table?
//
// Bytes only; vandplan/io.h moves them. Layout: docs/formats.md.

#include <cstdint>
#include <string>
#include <string_view>

#include "vandplan/heuristic_table.h"

namespace vandplan {

/// The table as a binary file: the same bytes on every machine.
[[nodiscard]] std::string table_to_bytes(const HeuristicTable& table);

/// Reads what `table_to_bytes` wrote. Throws InputError naming `file` when it is foreign,
/// truncated, altered, or of another version.
[[nodiscard]] HeuristicTable table_from_bytes(std::string_view bytes, const std::string& file);

/// Checksum of a table file's content (FNV-1a, 64 bits).
[[nodiscard]] std::uint64_t table_checksum(std::string_view bytes) noexcept;

/// The table as a C++17 header that defines a namespace `name` with the options and the entries,
/// every float written so that it reads back exactly. Throws InputError if `name` is no identifier.
[[nodiscard]] std::string table_to_header(const HeuristicTable& table, std::string_view name);

}  // namespace vandplan
