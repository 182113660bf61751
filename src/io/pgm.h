// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a portable grey map read?

#include <string>

#include "io/image.h"

namespace vandplan::io {

/// Hands out the rows of a PGM file, whose bytes begin with P2 or P5. Throws InputError, `where`
/// standing for the file, if it is broken or has more than `most_map_cells` pixels.
void read_pgm(const std::string& bytes, const std::string& where, const TakeRow& take_row);

}  // namespace vandplan::io
