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

#include "vandplan/geometry.h"

namespace vandplan::io {

/// Largest image file that is read [bytes].
inline constexpr std::size_t largest_image = std::size_t{1} << 30;

/// Treatment of transparent pixels.
enum class Alpha {
  marked,   ///< A pixel that is not opaque gets `transparent_pixel`.
  ignored,  // Opacity has no effect.
};

/// Size and range of an image. The brightness of a pixel is the sum of its channels; a grey pixel
/// counts as equal red, green and blue.
struct ImageShape {
  std::int32_t columns = 0;
  std::int32_t rows = 0;
  std::uint32_t white = 0;  ///< Greatest brightness.
};

/// Brightness that stands for a pixel that is not opaque.
inline constexpr std::uint32_t transparent_pixel = UINT32_MAX;

/// Receives the rows of an image, from the top: the brightness of each pixel.
using TakeRow =
    std::function<void(const ImageShape& shape, std::span<const std::uint32_t> brightness)>;

/// Throws InputError for an image without pixels, with more than `most_map_cells` pixels, or with
/// more than 10^8 along a side. `where`: name of the file in the error.
void check_image_size(std::uint64_t columns, std::uint64_t rows, const std::string& where);

/// Throws InputError if a file has fewer than `least` bytes, the least that its pixels need. So no
/// memory is allocated on the word of a header alone. `kind`: "PGM" or "PNG".
void check_image_bytes(const ImageShape& shape, std::size_t bytes, double least, const char* kind,
                       const std::string& where);

/// Reverses the order of rows, from an image to a map: the top row has the largest y and becomes
/// the last one.
void turn_over(std::vector<Cell>& cells, std::int32_t columns);

}  // namespace vandplan::io
