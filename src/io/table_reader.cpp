// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a table file read, however large it is?

#include <filesystem>
#include <fstream>

#include "vandplan/files.h"
#include "vandplan/table_file.h"

namespace vandplan {
namespace {

constexpr std::size_t largest = table_file_head_size + (std::size_t{1} << 31);

// How large the file may be; throws InputError for a head that is not ours.
std::size_t promised_size(const std::string& file) {
  std::string start(table_file_head_size, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  return table_file_head(start, file).bytes;
}

}  // namespace

std::string read_table_file(const std::string& file) {
  // What can be read once only, a pipe for example, cannot be looked at first.
  std::error_code error;
  const bool twice = file != "-" && std::filesystem::is_regular_file(file, error);
  std::string bytes = read_file(file, twice ? promised_size(file) : largest);
  check_table_file(bytes, file == "-" ? "standard input" : file);
  return bytes;
}

}  // namespace vandplan
