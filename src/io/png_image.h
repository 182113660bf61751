// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a PNG image read?

#include <string>

#include "io/image.h"

namespace vandplan::io {

/// Reads the bytes of a PNG file. Throws InputError, `where` standing for the file, if it is broken
/// or has more than `most_map_cells` pixels.
[[nodiscard]] Image image_from_png(const std::string& bytes, const std::string& where, Alpha alpha);

}  // namespace vandplan::io
