// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are the bytes of a file read, at once or line by line?

#include <cstddef>
#include <optional>
#include <string>

namespace vandplan::io {

/// A file that is open for reading; "-" is standard input.
class InputFile {
 public:
  /// Throws InputError if the file cannot be opened.
  explicit InputFile(const std::string& file);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// What errors call it: the file, or "standard input".
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Appends the next bytes to `content`; false at the end. Throws InputError if they cannot be
  /// read, or if `content` would become larger than `largest` bytes.
  bool append_to(std::string& content, std::size_t largest);

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
  /// Appends all that is left to `content`. Throws InputError as `InputFile::append_to` does.
  void rest(std::string& content, std::size_t largest);

 private:
  InputFile file_;
  std::string buffer_;  // read, and from `used_` on not handed out yet
  std::size_t used_ = 0;
  int number_ = 0;
};

}  // namespace vandplan::io
