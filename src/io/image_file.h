// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which kind of image is a file?

#include <string>

#include "io/image.h"

namespace vandplan::io {

/// Hands out the rows of a PGM (P2, P5) or PNG file. Throws InputError, `where` standing for the
/// file, if it is neither, broken, or has more than `most_map_cells` pixels.
void read_image(const std::string& bytes, const std::string& where, Alpha alpha,
                const TakeRow& take_row);

}  // namespace vandplan::io
