// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a table file read, however large it is?

#include "io/input_file.h"
#include "vandplan/files.h"
#include "vandplan/tables.h"

namespace vandplan {

std::string read_table_file(const std::string& file) {
  io::InputFile input(file);
  std::string bytes;
  constexpr std::size_t any = std::size_t{1} << 20;
  while (bytes.size() < table_file_head_size && input.append_to(bytes, any)) {
  }
  // A wrong header throws before more is read.
  const std::size_t promised = table_file_head(bytes, input.name()).bytes;
  input.expect_at_most(bytes.size(), promised);
  while (input.append_to(bytes, promised)) {
  }
  check_table_file(bytes, input.name());
  return bytes;
}

}  // namespace vandplan
