// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
//
// Writes one of the thesis' tables as a C++ header while the library is built.
// Usage: make_thesis_table NUMBER FILE

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include "tables/table_export.h"
#include "vandplan/tables.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: make_thesis_table NUMBER FILE\n";
    return 2;
  }
  const std::string number = argv[1];
  const vandplan::HeuristicTable table(vandplan::thesis_table_options(std::atoi(argv[1])));
  std::ofstream file(argv[2], std::ios::binary);
  file << vandplan::tables::table_to_header(table, "hlut_" + number);
  file.close();
  return file ? EXIT_SUCCESS : EXIT_FAILURE;
}
