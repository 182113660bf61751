// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/input_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

constexpr std::size_t chunk = std::size_t{1} << 16;  // Bytes read at a time.

[[noreturn]] void refuse(const std::string& name, std::size_t largest) {
  throw InputError(name, "is too large, expected at most " + std::to_string(largest) + " bytes");
}

/// Whether a name stands for a descriptor that the caller's process has opened.
bool is_open_already(const std::string& file) {
  return file == "/dev/stdin" || file.starts_with("/dev/fd/") || file.starts_with("/proc/self/fd/");
}

/// Throws InputError for files where reading, or even opening, might block.
void expect_regular(const std::string& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return;                  // Opening reports the reason.
  if (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode)) return;  // Reading reports a folder.
  const char* const kind = S_ISFIFO(status.st_mode)   ? "a pipe"
                           : S_ISSOCK(status.st_mode) ? "a socket"
                                                      : "a device";
  throw InputError(file,
                   std::string("is ") + kind + ", expected a regular file; - is standard input");
}

int opened(const std::string& file) {
  if (file == "-") return STDIN_FILENO;
  if (is_open_already(file)) return ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  expect_regular(file);
  // Does not block even if a pipe has replaced the file meanwhile.
  return ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

}  // namespace

InputFile::InputFile(const std::string& file)
    : name_(file == "-" ? "standard input" : file), descriptor_(opened(file)) {
  if (descriptor_ < 0) throw InputError(name_, std::string("cannot open: ") + std::strerror(errno));
}

InputFile::~InputFile() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
}

bool InputFile::append_to(std::string& content, std::size_t largest) {
  const std::size_t used = content.size();
  content.resize(used + chunk);
  ssize_t count = 0;
  do {
    count = ::read(descriptor_, content.data() + used, chunk);
  } while (count < 0 && errno == EINTR);
  if (count < 0) throw InputError(name_, std::string("cannot read: ") + std::strerror(errno));
  content.resize(used + static_cast<std::size_t>(count));
  expect_at_most(content.size(), largest);
  return count > 0;
}

std::optional<std::size_t> InputFile::size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return static_cast<std::size_t>(status.st_size);
}

std::optional<FileBytes> InputFile::mapped() const {
  const std::size_t bytes = size().value_or(0);
  if (descriptor_ == STDIN_FILENO || bytes == 0) return std::nullopt;
  void* const begin = ::mmap(nullptr, bytes, PROT_READ, MAP_PRIVATE, descriptor_, 0);
  if (begin == MAP_FAILED) return std::nullopt;
  return FileBytes{{static_cast<const char*>(begin), bytes},
                   {begin, [bytes](void* all) { ::munmap(all, bytes); }}};
}

void InputFile::expect_at_most(std::size_t size, std::size_t largest) const {
  if (size > largest) refuse(name_, largest);
}

std::optional<std::string> FileReader::next(std::size_t largest) {
  std::size_t end = buffer_.find('\n', used_);
  while (end == std::string::npos) {
    buffer_.erase(0, std::exchange(used_, 0));
    const std::size_t searched = buffer_.size();
    if (!file_ || !file_->append_to(buffer_, largest + chunk)) break;
    end = buffer_.find('\n', searched);
  }
  const bool is_last = end == std::string::npos;
  if (is_last && buffer_.empty()) return std::nullopt;
  const std::size_t length = (is_last ? buffer_.size() : end) - used_;
  if (length > largest) refuse(name() + ":" + std::to_string(number_ + 1), largest);
  ++number_;
  const std::size_t after = used_ + length + (is_last ? 0 : 1);
  if (used_ == 0 && length > chunk) {  // Avoids two copies of a long line.
    std::string line = std::exchange(buffer_, buffer_.substr(after));
    line.resize(length);
    return line;
  }
  std::string line = buffer_.substr(used_, length);
  used_ = after;
  if (used_ == buffer_.size()) buffer_.erase(0, std::exchange(used_, 0));
  return line;
}

std::string_view FileReader::next_piece(std::size_t largest) {
  const std::string_view piece = ahead(1);
  skip(piece.size());
  handed_out_ += piece.size();
  if (handed_out_ > largest) refuse(name_, largest);
  return piece;
}

void FileReader::fill(std::size_t count) {
  gone_ += used_;
  buffer_.erase(0, std::exchange(used_, 0));
  while (buffer_.size() < count && file_ && file_->append_to(buffer_, buffer_.max_size())) {
  }
}

std::size_t FileReader::size(std::size_t largest) {
  const std::optional<std::size_t> stated = file_ ? file_->size() : std::nullopt;
  if (file_ && !stated) {
    while (file_->append_to(buffer_, largest)) {
    }
  }
  const std::size_t size = stated.value_or(gone_ + buffer_.size());
  if (size > largest) refuse(name_, largest);
  return size;
}

}  // namespace vandplan::io
