// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are the bytes of a file read, at once or line by line?

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace vandplan::io {

/// A file that is open for reading; "-" is standard input.
class InputFile {
 public:
  /// Throws InputError if the file cannot be opened, or is one that reading might wait for: pipes
  /// and devices are read under the names of open descriptors alone, "/dev/stdin" and "/dev/fd/3".
  explicit InputFile(const std::string& file);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// What errors call it: the file, or "standard input".
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Appends the next bytes to `content`; false at the end. Throws InputError if they cannot be
  /// read, or if `content` would become larger than `largest` bytes.
  bool append_to(std::string& content, std::size_t largest);
  /// Throws InputError if that is more than `largest` bytes.
  void expect_at_most(std::size_t size, std::size_t largest) const;

 private:
  std::string name_;
  int descriptor_ = -1;
};

/// Hands out the lines of a file one after the other, and never holds more than one of them and a
/// little of what follows.
class LineReader {
 public:
  /// Throws InputError if the file cannot be opened.
  explicit LineReader(const std::string& file) : file_(file) {}

  [[nodiscard]] const std::string& name() const noexcept { return file_.name(); }
  /// The next line without its end; none after the last one. Throws InputError if it cannot be read
  /// or is longer than `largest` bytes.
  [[nodiscard]] std::optional<std::string> next(std::size_t largest);
  /// The number of the line that `next` handed out last, from 1.
  [[nodiscard]] int number() const noexcept { return number_; }
  /// The next piece of all that is left, which stays valid until the next call; empty at the end.
  /// Throws InputError if it cannot be read, or if all pieces have more than `largest` bytes.
  [[nodiscard]] std::string_view next_piece(std::size_t largest);

 private:
  InputFile file_;
  std::size_t handed_out_ = 0;  // in pieces
  std::string buffer_;          // read, and from `used_` on not handed out yet
  std::size_t used_ = 0;
  int number_ = 0;
};

}  // namespace vandplan::io
