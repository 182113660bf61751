// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How bright are the pixels of an image file?

#include <cstdint>
#include <string>
#include <vector>

namespace vandplan::io {

/// What becomes of transparency.
enum class Alpha {
  marked,  ///< a pixel that is not opaque has no brightness
  ignored,
};

/// Brightness: the sum of the channels, red, green and blue alike for grey.
struct Image {
  static constexpr std::uint32_t transparent = UINT32_MAX;

  std::int32_t columns = 0;
  std::int32_t rows = 0;
  std::uint32_t white = 0;            ///< the greatest brightness
  std::vector<std::uint32_t> pixels;  ///< row by row from the top; at most `white`
};

/// Reads PGM (P2, P5) or PNG. Throws InputError, `where` standing for the file, if it is neither,
/// broken, or has more than `most_map_cells` pixels.
[[nodiscard]] Image image_from(const std::string& bytes, const std::string& where, Alpha alpha);

/// The parts of it.
[[nodiscard]] Image image_from_pgm(const std::string& bytes, const std::string& where);
[[nodiscard]] Image image_from_png(const std::string& bytes, const std::string& where, Alpha alpha);

/// Throws InputError for a size that no map has.
void check_image_size(std::uint64_t columns, std::uint64_t rows, const std::string& where);

}  // namespace vandplan::io
