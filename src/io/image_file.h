// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which image format does a file have?

#include "io/image.h"
#include "io/input_file.h"

namespace vandplan::io {

/// Passes on the rows of a PGM (P2, P5) or PNG file and keeps little of it in memory. Throws
/// InputError if the file has another format, is broken, or is too large.
void read_image(FileReader& file, Alpha alpha, const TakeRow& take_row);

}  // namespace vandplan::io
