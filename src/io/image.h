// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How bright are the pixels of an image file?

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "vandplan/occupancy_grid.h"

namespace vandplan::io {

/// The largest image file that is read [bytes].
inline constexpr std::size_t largest_image = std::size_t{1} << 30;

/// What becomes of transparent pixels.
enum class Alpha {
  marked,  ///< a pixel that is not opaque has no brightness
  ignored,
};

/// What an image says about itself. The brightness of a pixel is the sum of its channels, with red,
/// green and blue alike for grey.
struct ImageShape {
  std::int32_t columns = 0;
  std::int32_t rows = 0;
  std::uint32_t white = 0;  ///< the greatest brightness
};

/// Stands for the brightness of a pixel that is not opaque.
inline constexpr std::uint32_t transparent_pixel = UINT32_MAX;

/// Takes the rows of an image in, from the top: the brightness of each pixel.
using TakeRow =
    std::function<void(const ImageShape& shape, std::span<const std::uint32_t> brightness)>;

/// Throws InputError, `where` standing for the file, for no pixels, more than `most_map_cells`, or
/// more than 10^8 along a side.
void check_image_size(std::uint64_t columns, std::uint64_t rows, const std::string& where);

/// Throws InputError if the bytes of a file are fewer than its pixels take at least: nobody is
/// asked for memory on the word of a header alone. `kind` is "PGM" or "PNG".
void check_image_bytes(const ImageShape& shape, std::size_t bytes, double least, const char* kind,
                       const std::string& where);

/// Puts the rows of an image into the order of a map: the top row, which has the largest y, is its
/// last one.
void turn_over(std::vector<Cell>& cells, std::int32_t columns);

}  // namespace vandplan::io
