// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which kind of image is a file?

#include "io/image.h"
#include "io/input_file.h"

namespace vandplan::io {

/// Hands out the rows of a PGM (P2, P5) or PNG file, of which it never holds much. Throws
/// InputError if it is neither, broken, or too large.
void read_image(FileReader& file, Alpha alpha, const TakeRow& take_row);

}  // namespace vandplan::io
