// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/image.h"

#include <fmt/format.h>

#include "vandplan/input_error.h"
#include "vandplan/occupancy_grid.h"

namespace vandplan::io {

void check_image_size(std::uint64_t columns, std::uint64_t rows, const std::string& where) {
  const auto most = static_cast<std::uint64_t>(most_map_cells);
  if (columns >= 1 && rows >= 1 && columns <= most && rows <= most / columns) return;
  throw InputError(where, fmt::format("is {} x {} pixels, expected at least one and at most {}",
                                      columns, rows, most));
}

}  // namespace vandplan::io
