// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are the bytes of a file read, at once or one after the other?

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

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
  /// How many bytes it has, if it is a regular file.
  [[nodiscard]] std::optional<std::size_t> size() const;
  /// Throws InputError if that is more than `largest` bytes.
  void expect_at_most(std::size_t size, std::size_t largest) const;

 private:
  std::string name_;
  int descriptor_ = -1;
};

/// Hands out a file from its begin to its end: by lines, pieces or bytes. It never holds more of it
/// than what was asked for and a little of what follows.
class FileReader {
 public:
  /// Throws InputError if the file cannot be opened.
  explicit FileReader(const std::string& file) : file_(file), name_(file_->name()) {}
  /// What stands for a file of that name.
  FileReader(std::string content, std::string name)
      : name_(std::move(name)), buffer_(std::move(content)) {}

  [[nodiscard]] const std::string& name() const noexcept { return name_; }

  /// The next line without its end; none after the last one. Throws InputError if it cannot be read
  /// or is longer than `largest` bytes.
  [[nodiscard]] std::optional<std::string> next(std::size_t largest);
  /// The number of the line that `next` handed out last, from 1.
  [[nodiscard]] int number() const noexcept { return number_; }

  /// The next piece of all that is left, which stays valid until the next call; empty at the end.
  /// Throws InputError if it cannot be read, or if all pieces have more than `largest` bytes.
  [[nodiscard]] std::string_view next_piece(std::size_t largest);

  /// What comes next, at least so many bytes of it unless fewer are left, and valid until the next
  /// call. Throws InputError if it cannot be read.
  [[nodiscard]] std::string_view ahead(std::size_t count) {
    if (buffer_.size() - used_ < count) fill(count);
    return std::string_view(buffer_).substr(used_);
  }
  /// Passes over bytes that `ahead` showed.
  void skip(std::size_t count) noexcept { used_ += count; }
  /// How many bytes the whole file has, for who goes by bytes. One that does not say is read for
  /// it; throws InputError if it has more than `largest`.
  [[nodiscard]] std::size_t size(std::size_t largest);

 private:
  void fill(std::size_t count);

  std::optional<InputFile> file_ = {};
  std::string name_;
  std::size_t handed_out_ = 0;  // in pieces
  std::string buffer_ = {};     // read, and from `used_` on not handed out yet
  std::size_t used_ = 0;
  std::size_t gone_ = 0;  // bytes that `fill` has dropped
  int number_ = 0;
};

}  // namespace vandplan::io
