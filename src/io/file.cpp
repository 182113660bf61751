// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How are files read and written, so that a file is written completely or not at all?

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>

#include "io/input_file.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace io;

/// File descriptor that is closed at the end, except for standard streams.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ > STDERR_FILENO) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

[[noreturn]] void cannot(const std::string& file, const std::string& verb) {
  throw InputError(file, "cannot " + verb + ": " + std::strerror(errno));
}

[[noreturn]] void fail(const std::string& file, const std::string& verb, int error) {
  errno = error;
  cannot(file, verb);
}

/// Writes all bytes. Returns 0, or the error number.
int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = ::write(descriptor, content.data(), content.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

std::string folder_of(const std::string& file) {
  const std::size_t slash = file.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : file.substr(0, slash);
}

/// Target of the symbolic link `file`, relative to the working directory; empty if it is no link.
std::string link_of(const std::string& file) {
  char buffer[PATH_MAX];
  const ssize_t size = ::readlink(file.c_str(), buffer, sizeof buffer);
  if (size <= 0) return "";
  const std::string target(buffer, static_cast<std::size_t>(size));
  return target.starts_with('/') ? target : folder_of(file) + "/" + target;
}

/// The file behind all symbolic links of `file`. It need not exist: like a shell's `>`, a dangling
/// link says where to create it.
std::string target_of(const std::string& file) {
  char resolved[PATH_MAX];
  std::string target = file;
  for (int links = 0; links < 40; ++links) {
    if (::realpath(target.c_str(), resolved) != nullptr) return resolved;
    const std::string next = errno == ENOENT ? link_of(target) : "";
    if (next.empty()) return target;
    target = next;
  }
  return target;
}

/// Creates an empty file in the folder of `file` and returns its name. `descriptor` is -1 if that
/// fails.
std::string create_beside(const std::string& file, mode_t mode, int& descriptor) {
  std::string name;
  for (int i = 0; i < 1000; ++i) {
    name = folder_of(file) + "/.vandplan-" + std::to_string(::getpid()) + "-" + std::to_string(i) +
           ".tmp";
    descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor >= 0 || errno != EEXIST) return name;
  }
  return name;
}

}  // namespace

std::string read_file(const std::string& file, std::size_t largest) {
  InputFile input(file);
  std::string content;
  while (input.append_to(content, largest)) {
  }
  return content;
}

void expect_writable(const std::string& file) {
  if (file == "-") return;
  const std::string target = target_of(file);
  const std::string folder = folder_of(target) + "/.";
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (!exists && errno != ENOENT) cannot(file, "write");  // For example links in a circle.
  if (exists && S_ISDIR(old.st_mode)) fail(file, "write", EISDIR);
  if (exists && ::access(target.c_str(), W_OK) != 0) cannot(file, "write");
  // A regular file is replaced by a new one, written in the same folder.
  if (exists && !S_ISREG(old.st_mode)) return;
  if (file.empty()) fail(file, "write", ENOENT);
  if (::access(folder.c_str(), W_OK) != 0) cannot(file, "write");
}

struct FileWriter::Target {
  std::string file;        ///< Name given by the caller.
  std::string place = {};  ///< Final place of the content.
  /// Place of the content until then; empty if it is written directly.
  std::string temporary = {};
  int descriptor = -1;

  ~Target() {
    if (descriptor > STDERR_FILENO) ::close(descriptor);
    if (descriptor >= 0 && !temporary.empty()) ::unlink(temporary.c_str());
  }
};

FileWriter::FileWriter(const std::string& file) : target_(std::make_unique<Target>()) {
  Target& target = *target_;
  if (file == "-") {
    target.file = "standard output";
    target.descriptor = STDOUT_FILENO;
    return;
  }
  expect_writable(file);
  target.file = file;
  target.place = target_of(file);
  struct stat old {};
  const bool exists = ::stat(target.place.c_str(), &old) == 0;
  if (exists && !S_ISREG(old.st_mode)) {  // Pipes, terminals and the like cannot be replaced.
    target.descriptor = ::open(target.place.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    target.temporary = create_beside(target.place, 0666, target.descriptor);
  }
  if (target.descriptor < 0) cannot(file, "write");
  const bool replaces = exists && !target.temporary.empty();
  if (replaces && ::fchmod(target.descriptor, old.st_mode & 07777) != 0) cannot(file, "write");
}

FileWriter::~FileWriter() = default;

void FileWriter::write(std::string_view content) {
  const int error = write_all(target_->descriptor, content);
  if (error != 0) fail(target_->file, "write", error);
}

void FileWriter::commit() {
  if (target_->temporary.empty()) return;
  if (::fsync(target_->descriptor) != 0 ||
      ::rename(target_->temporary.c_str(), target_->place.c_str()) != 0) {
    cannot(target_->file, "write");
  }
  target_->temporary.clear();
  const Descriptor folder(
      ::open(folder_of(target_->place).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.is_open()) (void)::fsync(folder.number());  // Makes the new name survive a crash.
}

void write_file(const std::string& file, std::string_view content) {
  FileWriter writer(file);
  writer.write(content);
  writer.commit();
}

}  // namespace vandplan
