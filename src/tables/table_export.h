// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a table become source code or a spreadsheet?

#include <string>
#include <string_view>

#include "vandplan/tables.h"

namespace vandplan::tables {

/// Table as a C++17 header. It defines a namespace `name` with the options and the entries; every
/// float reads back exactly. Throws InputError if `name` is no identifier or the table has more
/// than 2^24 entries.
[[nodiscard]] std::string table_to_header(const HeuristicTable& table, std::string_view name);

/// Table as CSV, one line for each entry: x, y, heading_node, heading_sample, length [m, rad].
/// Throws InputError if the table has more than 2^24 entries.
[[nodiscard]] std::string table_to_csv(const HeuristicTable& table);

/// The library's table of bounds as a C++17 header with a namespace `name` (definitions:
/// docs/formats.md). Throws InputError if `name` is no identifier.
[[nodiscard]] std::string bound_table_to_header(std::string_view name);

/// The library's table of bounds as CSV, one line for each cell with the coefficients of its
/// planes. Columns: docs/formats.md.
[[nodiscard]] std::string bound_table_to_csv();

/// Throws InputError if `name` cannot be the name of a C++ namespace.
void check_identifier(std::string_view name);

}  // namespace vandplan::tables
