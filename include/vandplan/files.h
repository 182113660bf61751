// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are files read whole, and written whole or not at all?
//
// A file is written beside its place and then renamed. The old file stays until the new one is
// complete.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace vandplan {

/// All bytes of a file; "-" is standard input. Throws InputError naming the file if it cannot be
/// read or holds more than `largest` bytes.
[[nodiscard]] std::string read_file(const std::string& file, std::size_t largest);

/// All bytes of a table file (table_file.h), checked; "-" is standard input. Throws InputError
/// naming the file if it is foreign, truncated, altered, or longer than it says. No more is read
/// than its head promises.
[[nodiscard]] std::string read_table_file(const std::string& file);

/// Throws InputError naming the file if `write_file` cannot write it, as far as can be told
/// beforehand.
void expect_writable(const std::string& file);

/// A file that is written piece by piece, and is whole or not at all. The old file stays until
/// `commit`, and for ever without it. "-" is standard output. Standard output and pipes get every
/// piece at once. All functions throw InputError naming the file if it cannot be written.
class FileWriter {
 public:
  /// Begins to write the file.
  explicit FileWriter(const std::string& file);
  ~FileWriter();
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  /// Writes a piece.
  void write(std::string_view content);
  /// Puts the written file in the place of the old one.
  void commit();

 private:
  struct Target;
  std::unique_ptr<Target> target_;
};

/// Writes all of `content` to a file; "-" is standard output. If that fails, the old file stays,
/// and InputError names the file.
void write_file(const std::string& file, std::string_view content);

}  // namespace vandplan
