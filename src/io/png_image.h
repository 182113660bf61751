// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a PNG image read?

#include "io/image.h"
#include "io/input_file.h"

namespace vandplan::io {

/// Passes on the rows of a PNG file. Throws InputError if it is broken or has more pixels than
/// `check_image_size` allows. An interlaced image is kept in memory and may have at most 10^8
/// pixels.
void read_png(FileReader& file, Alpha alpha, const TakeRow& take_row);

}  // namespace vandplan::io
