// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a portable grey map (PGM) read?

#include "io/image.h"
#include "io/input_file.h"

namespace vandplan::io {

/// Passes on the rows of a PGM file, which begins with P2 or P5. Throws InputError if it is broken
/// or has more pixels than `check_image_size` allows.
void read_pgm(FileReader& file, const TakeRow& take_row);

}  // namespace vandplan::io
