// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <bit>

#include "bound_entries.h"
#include "tables/table_bytes.h"
#include "vandplan/tables.h"

namespace vandplan {

namespace table_bytes = tables::table_bytes;

std::string bound_table_to_bytes() {
  constexpr auto cells = static_cast<std::uint64_t>(simd::radial_cells) |
                         static_cast<std::uint64_t>(simd::side_cells) << 16 |
                         static_cast<std::uint64_t>(simd::turn_cells) << 32 |
                         static_cast<std::uint64_t>(simd::slope_step) << 48;
  std::string bytes =
      table_bytes::start_of({.kind = &table_bytes::bounds,
                             .parameters = {std::bit_cast<std::uint64_t>(1.0),
                                            std::bit_cast<std::uint64_t>(simd::radial_reach),
                                            std::bit_cast<std::uint64_t>(simd::bound_unit), cells},
                             .count = simd::bound_cells});
  for (const simd::BoundEntry& entry : simd::bound_entries) {
    table_bytes::append(bytes, entry.base_width);
    table_bytes::append(bytes, entry.slopes);
  }
  table_bytes::seal(bytes);
  return bytes;
}

}  // namespace vandplan
