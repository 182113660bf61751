// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/input_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

constexpr std::size_t chunk = std::size_t{1} << 16;  // read at a time [bytes]

[[noreturn]] void refuse(const std::string& name, std::size_t largest) {
  throw InputError(name, "is too large, expected at most " + std::to_string(largest) + " bytes");
}

}  // namespace

InputFile::InputFile(const std::string& file)
    : name_(file == "-" ? "standard input" : file),
      descriptor_(file == "-" ? STDIN_FILENO : ::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
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
  if (content.size() > largest) refuse(name_, largest);
  return count > 0;
}

std::optional<std::string> LineReader::next(std::size_t largest) {
  std::size_t end = buffer_.find('\n', used_);
  while (end == std::string::npos) {
    buffer_.erase(0, std::exchange(used_, 0));
    const std::size_t searched = buffer_.size();
    if (!file_.append_to(buffer_, largest + chunk)) break;
    end = buffer_.find('\n', searched);
  }
  const bool is_last = end == std::string::npos;
  if (is_last && buffer_.empty()) return std::nullopt;
  const std::size_t length = (is_last ? buffer_.size() : end) - used_;
  if (length > largest) refuse(name() + ":" + std::to_string(number_ + 1), largest);
  std::string line = buffer_.substr(used_, length);
  used_ += length + (is_last ? 0 : 1);
  if (used_ == buffer_.size()) buffer_.erase(0, std::exchange(used_, 0));
  ++number_;
  return line;
}

void LineReader::rest(std::string& content, std::size_t largest) {
  content.append(buffer_, used_);
  buffer_.clear();
  used_ = 0;
  if (content.size() > largest) refuse(name(), largest);
  while (file_.append_to(content, largest)) {
  }
}

}  // namespace vandplan::io
