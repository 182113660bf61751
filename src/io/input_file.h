// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are the bytes of a file read, as a whole or in parts?

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace vandplan::io {

/// Bytes, and what keeps them.
struct FileBytes {
  std::string_view bytes;
  std::shared_ptr<const void> owner;
};

/// File open for reading; "-" is standard input.
class InputFile {
 public:
  /// Throws InputError if the file cannot be opened, or if reading it might block. Pipes and
  /// devices are read only as open descriptors, "/dev/stdin" and "/dev/fd/3".
  explicit InputFile(const std::string& file);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Name in errors: the file, or "standard input".
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Appends the next bytes to `content`; false at the end. Throws InputError if they cannot be
  /// read, or if `content` would exceed `largest` bytes.
  bool append_to(std::string& content, std::size_t largest);
  /// Number of bytes of a regular file; empty for other files.
  [[nodiscard]] std::optional<std::size_t> size() const;
  /// Bytes of a regular file, where they lie: what nobody looks at is not read. None if the file
  /// cannot be looked into, as standard input cannot.
  [[nodiscard]] std::optional<FileBytes> mapped() const;
  /// Throws InputError if `size` is more than `largest` bytes.
  void expect_at_most(std::size_t size, std::size_t largest) const;

 private:
  std::string name_;
  int descriptor_ = -1;
};

/// Reads a file from begin to end: by lines, pieces or bytes. It keeps only the requested part and
/// a little of what follows in memory.
class FileReader {
 public:
  /// Throws InputError if the file cannot be opened.
  explicit FileReader(const std::string& file) : file_(file), name_(file_->name()) {}
  /// Reads `content` in place of a file with this name.
  FileReader(std::string content, std::string name)
      : name_(std::move(name)), buffer_(std::move(content)) {}

  [[nodiscard]] const std::string& name() const noexcept { return name_; }

  /// Next line without its end; empty after the last line. Throws InputError if the line cannot be
  /// read or is longer than `largest` bytes.
  [[nodiscard]] std::optional<std::string> next(std::size_t largest);
  /// Number of the line that `next` returned last, from 1.
  [[nodiscard]] int number() const noexcept { return number_; }

  /// Next piece of the file, valid until the next call; empty at the end. Throws InputError if it
  /// cannot be read, or if all pieces together exceed `largest` bytes.
  [[nodiscard]] std::string_view next_piece(std::size_t largest);

  /// The bytes that follow, valid until the next call: at least `count`, or all that are left.
  /// Throws InputError if they cannot be read.
  [[nodiscard]] std::string_view ahead(std::size_t count) {
    if (buffer_.size() - used_ < count) fill(count);
    return std::string_view(buffer_).substr(used_);
  }
  /// Skips bytes that `ahead` showed.
  void skip(std::size_t count) noexcept { used_ += count; }
  /// Number of bytes of the whole file. If the file does not state it, the file is read first.
  /// Throws InputError if it exceeds `largest`. Only for files read by `ahead`.
  [[nodiscard]] std::size_t size(std::size_t largest);

 private:
  void fill(std::size_t count);

  std::optional<InputFile> file_ = {};
  std::string name_;
  std::size_t handed_out_ = 0;  // Bytes returned as pieces.
  std::string buffer_ = {};     // Bytes that were read; those from `used_` on are not returned yet.
  std::size_t used_ = 0;
  std::size_t gone_ = 0;  // Bytes that `fill` has dropped.
  int number_ = 0;
};

}  // namespace vandplan::io
