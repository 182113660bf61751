// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
//
// Writes the table of bounds as a C++ header while the library is built.
// Usage: make_bound_table FILE

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tables/bound_builder.h"

int main(int argc, char** argv) {
  namespace simd = vandplan::simd;
  if (argc != 2) {
    std::fputs("usage: make_bound_table FILE\n", stderr);
    return 2;
  }
  std::vector<simd::BoundEntry> entries(simd::bound_cells);
  for (int radial = 0; radial < simd::radial_cells; ++radial) {
    for (int side = 0; side < simd::side_cells; ++side) {
      for (int turn = 0; turn < simd::turn_cells; ++turn) {
        entries[static_cast<std::size_t>(simd::bound_index(radial, side, turn))] =
            vandplan::tables::bound_entry(radial, side, turn);
      }
    }
  }
  std::FILE* file = std::fopen(argv[1], "wb");
  if (file == nullptr) return EXIT_FAILURE;
  std::fputs(
      "#pragma once\n#include \"simd/bound_grid.h\"\n\nnamespace vandplan::simd {\n\n"
      "inline constexpr BoundEntry bound_entries[] = {\n",
      file);
  for (const simd::BoundEntry& entry : entries) {
    std::fprintf(file, "{0x%xU,0x%xU},\n", entry.base_width, entry.slopes);
  }
  std::fputs("};\n\n}  // namespace vandplan::simd\n", file);
  const bool written = std::ferror(file) == 0;
  return std::fclose(file) == 0 && written ? EXIT_SUCCESS : EXIT_FAILURE;
}
