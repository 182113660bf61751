// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which kind of image is a file?

#include <string>

#include "io/image.h"

namespace vandplan::io {

/// Reads the bytes of a PGM (P2, P5) or PNG file. Throws InputError, `where` standing for the file,
/// if it is neither, broken, or has more than `most_map_cells` pixels.
[[nodiscard]] Image image_from(const std::string& bytes, const std::string& where, Alpha alpha);

}  // namespace vandplan::io
