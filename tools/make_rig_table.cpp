// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
//
// Writes the table of a tractor with a semitrailer as a C++ header while the library is built.
// Usage: make_rig_table FILE

#include <cstdio>
#include <cstdlib>

#include "tables/embedded_rig_table.h"
#include "tables/rig_table.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_rig_table FILE\n", stderr);
    return 2;
  }
  const vandplan::RigTable table(vandplan::tables::rig_of_table());
  std::FILE* file = std::fopen(argv[1], "wb");
  if (file == nullptr) return EXIT_FAILURE;
  std::fputs(
      "#pragma once\n#include <cstdint>\n\nnamespace vandplan::rig_table {\n\n"
      "inline constexpr std::uint16_t entries[] = {\n",
      file);
  int column = 0;
  for (const std::uint16_t entry : table.entries()) {
    std::fprintf(file, "%d,%s", entry, ++column % 25 == 0 ? "\n" : "");
  }
  std::fputs("};\n\n}  // namespace vandplan::rig_table\n", file);
  const bool written = std::ferror(file) == 0;
  return std::fclose(file) == 0 && written ? EXIT_SUCCESS : EXIT_FAILURE;
}
