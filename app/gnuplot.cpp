// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* log_name = "gnuplot.log";
constexpr int not_installed = 127;  // exit status of shells for an unknown command

/// A temporary folder, which the destructor removes with all files in it.
class ScratchFolder {
 public:
  ScratchFolder() : path_((fs::temp_directory_path() / "vandplan-XXXXXX").string()) {
    if (::mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no temporary folder");
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Runs `gnuplot SCRIPT` in a folder and returns its exit status. Its output goes into a log file.
int run_gnuplot(const std::string& folder, const std::string& script) {
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("cannot start gnuplot");
  if (child == 0) {
    const int nothing = ::open("/dev/null", O_RDONLY);
    if (::chdir(folder.c_str()) != 0) ::_exit(1);
    const int log = ::open(log_name, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(log, STDOUT_FILENO);
    ::dup2(log, STDERR_FILENO);
    ::execlp("gnuplot", "gnuplot", script.c_str(), static_cast<char*>(nullptr));
    ::_exit(errno == ENOENT ? not_installed : 1);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

std::string all_of(const std::string& file) {
  return read_file(file, std::numeric_limits<std::size_t>::max());
}

}  // namespace

void expect_writable_folder(const std::string& folder, const StudyFiles& files) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder, "cannot be made a folder: " + error.message());
  for (const TextFile& file : files.data) expect_writable(folder + "/" + file.name);
  expect_writable(folder + "/" + files.script.name);
  for (const std::string& picture : files.pictures) expect_writable(folder + "/" + picture);
}

bool write_study(const std::string& folder, const StudyFiles& files) {
  const ScratchFolder scratch;
  std::vector<TextFile> texts = files.data;
  texts.push_back(files.script);
  for (const auto& [name, content] : texts) {
    write_file(scratch / name, content);
    write_file(folder + "/" + name, content);
  }
  const int status = run_gnuplot(scratch.path(), files.script.name);
  if (status == not_installed) return false;
  if (status != 0) {
    throw std::runtime_error(
        fmt::format("gnuplot {}/{}: {}", folder, files.script.name, all_of(scratch / log_name)));
  }
  for (const std::string& picture : files.pictures) {
    write_file(folder + "/" + picture, all_of(scratch / picture));
  }
  return true;
}

}  // namespace vandplan::app
