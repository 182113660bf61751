// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/image.h"

#include <fmt/format.h>

#include <algorithm>

#include "vandplan/input_error.h"

namespace vandplan::io {

void check_image_size(std::uint64_t columns, std::uint64_t rows, const std::string& where) {
  constexpr std::uint64_t longest = 100'000'000;  // Largest side [pixels].
  const auto most = static_cast<std::uint64_t>(most_map_cells);
  const bool has_sides = columns >= 1 && rows >= 1 && columns <= longest && rows <= longest;
  if (has_sides && rows <= most / columns) return;
  throw InputError(where, fmt::format("is {} x {} pixels, expected at least one and at most {}, {} "
                                      "along a side",
                                      columns, rows, most, longest));
}

void check_image_bytes(const ImageShape& shape, std::size_t bytes, double least, const char* kind,
                       const std::string& where) {
  if (static_cast<double>(bytes) >= least) return;
  throw InputError(
      where, fmt::format("holds {} bytes for {} x {} pixels, expected a whole {} image", bytes,
                         shape.columns, shape.rows, kind));
}

void turn_over(std::vector<Cell>& cells, std::int32_t columns) {
  const auto size = static_cast<std::ptrdiff_t>(columns);
  auto low = cells.begin();
  for (auto high = cells.end(); high - low > size; low += size) {
    high -= size;
    std::swap_ranges(low, low + size, high);
  }
}

}  // namespace vandplan::io
