// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which tables of lengths can there be?

#include <cstddef>

#include "vandplan/tables.h"

namespace vandplan::tables {

/// Number of entries of a table with these options. Throws InputError naming the option that is out
/// of range, or `step` if there are too many entries.
[[nodiscard]] std::size_t checked_entries(const HeuristicTableOptions& options);

}  // namespace vandplan::tables
