// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are files read whole, and written whole or not at all?
//
// A file that is written is put beside its place and renamed: what was there stays until all of the
// new one is.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace vandplan {

/// All bytes of a file, "-" is standard input. Throws InputError if it cannot be read or holds more
/// than `largest` bytes.
[[nodiscard]] std::string read_file(const std::string& file, std::size_t largest);

/// All bytes of a table file (table_file.h), checked: what is foreign, truncated, altered or longer
/// than it says is refused before more is read than it promises. "-" is standard input.
[[nodiscard]] std::string read_table_file(const std::string& file);

/// Throws InputError if `write_file` cannot write this file, as far as can be told beforehand.
void expect_writable(const std::string& file);

/// A file that is written piece by piece, and is whole or not at all: what was there stays until
/// `commit`, and for ever without it. "-" is standard output; that, and pipes, get every piece at
/// once. All throw InputError if the file cannot be written.
class FileWriter {
 public:
  explicit FileWriter(const std::string& file);
  ~FileWriter();
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  void write(std::string_view content);
  void commit();

 private:
  struct Target;
  std::unique_ptr<Target> target_;
};

/// Writes all of `content`, "-" is standard output, or, if that fails, leaves what was there and
/// throws InputError.
void write_file(const std::string& file, std::string_view content);

}  // namespace vandplan
