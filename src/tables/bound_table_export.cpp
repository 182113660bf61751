// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <cstdint>
#include <string>

#include "base/text.h"
#include "bound_entries.h"
#include "tables/table_export.h"

namespace vandplan::tables {
namespace {

using simd::bound_unit;
using simd::BoundEntry;

// Bits `skip` to `skip + count` of a word, counted from the highest one, as a signed number.
double signed_bits(std::uint32_t word, int skip, int count) {
  return static_cast<double>(static_cast<std::int32_t>(word << skip) >> (32 - count));
}

// Base, width and slopes of an entry as CSV fields, each after a comma [turning radii].
std::string planes_of(const BoundEntry& entry) {
  const double slope_unit = simd::slope_step * bound_unit;
  const double numbers[] = {signed_bits(entry.base_width, 0, 16) * bound_unit,
                            static_cast<double>(entry.base_width & 0xFFFFU) * bound_unit,
                            signed_bits(entry.slopes, 0, 11) * slope_unit,
                            signed_bits(entry.slopes, 11, 11) * slope_unit,
                            signed_bits(entry.slopes, 22, 10) * bound_unit};
  std::string text;
  for (const double number : numbers) text += "," + base::shortest_text(number);
  return text;
}

}  // namespace

std::string bound_table_to_header(std::string_view name) {
  check_identifier(name);
  std::string text =
      "// Bounds of Reeds-Shepp lengths for turning radius 1, written by vandplan. Row-major\n"
      "// entries[radial][side][turn][2]; see docs/formats.md of vandplan.\n"
      "#pragma once\n\nnamespace ";
  text.append(name).append(" {\n\n");
  const auto constant = [&text](const char* what, double value) {
    text.append("inline constexpr ").append(what).append(" = ");
    text.append(base::shortest_text(value)).append(";\n");
  };
  constant("int radial_cells", simd::radial_cells);
  constant("int side_cells", simd::side_cells);
  constant("int turn_cells", simd::turn_cells);
  constant("double radial_reach", simd::radial_reach);
  constant("double unit", bound_unit);
  constant("int slope_step", simd::slope_step);
  text.append("\ninline constexpr unsigned entries[][2] = {");
  int column = 0;
  for (const BoundEntry& entry : simd::bound_entries) {
    text.append(column++ % 4 == 0 ? "\n    " : " ");
    text.append("{").append(std::to_string(entry.base_width)).append("U, ");
    text.append(std::to_string(entry.slopes)).append("U},");
  }
  return text.append("\n};\n\n}  // namespace ").append(name).append("\n");
}

std::string bound_table_to_csv() {
  std::string text = "radial,side,turn,base,width,slope_radial,slope_side,slope_turn\n";
  for (int radial = 0; radial < simd::radial_cells; ++radial) {
    for (int side = 0; side < simd::side_cells; ++side) {
      for (int turn = 0; turn < simd::turn_cells; ++turn) {
        const BoundEntry& entry = simd::bound_entries[simd::bound_index(radial, side, turn)];
        text += std::to_string(radial) + "," + std::to_string(side) + "," + std::to_string(turn) +
                planes_of(entry) + "\n";
      }
    }
  }
  return text;
}

}  // namespace vandplan::tables
