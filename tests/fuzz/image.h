// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is true of the rows of an image, whatever its format?

#include <span>

#include "fuzz/fuzz.h"
#include "io/image.h"

namespace vandplan::fuzz {

/// Calls `read(take_row)` and expects whole rows, all of them, with no pixel brighter than white.
/// Transparent pixels, which have no brightness, are allowed where the format has them.
template <typename Read>
void expect_an_image(bool may_be_transparent, Read read) {
  std::int32_t rows = 0;
  std::int32_t expected = 0;
  read([&](const io::ImageShape& shape, std::span<const std::uint32_t> row) {
    ++rows;
    expected = shape.rows;
    expect(row.size() == static_cast<std::size_t>(shape.columns), "a whole row");
    for (const std::uint32_t pixel : row) {
      expect(pixel <= shape.white || (may_be_transparent && pixel == io::transparent_pixel),
             "no pixel is brighter than white");
    }
  });
  expect(rows > 0 && rows == expected, "all rows are there");
}

}  // namespace vandplan::fuzz
