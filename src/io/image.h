// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How bright are the pixels of an image file?

#include <cstdint>
#include <string>
#include <vector>

namespace vandplan::io {

/// What becomes of transparent pixels.
enum class Alpha {
  marked,  ///< a pixel that is not opaque has no brightness
  ignored,
};

/// The brightness of pixels: the sum of their channels, with red, green and blue alike for grey.
struct Image {
  static constexpr std::uint32_t transparent = UINT32_MAX;

  std::int32_t columns = 0;
  std::int32_t rows = 0;
  std::uint32_t white = 0;            ///< the greatest brightness
  std::vector<std::uint32_t> pixels;  ///< row by row from the top; at most `white`
};

/// Throws InputError, `where` standing for the file, for no pixels or more than `most_map_cells`.
void check_image_size(std::uint64_t columns, std::uint64_t rows, const std::string& where);

}  // namespace vandplan::io
