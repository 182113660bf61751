// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the built command line answer?

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "support/cases.h"
#include "support/temporary_folder.h"

namespace vandplan {

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

inline void write_content(const std::filesystem::path& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
}

/// How a call ended: `status` is the exit status, or minus the signal that killed it.
struct Outcome {
  int status = 0;
  std::string out;
  std::string err;
};

struct ProcessOptions {
  std::string input = "/dev/null";          // becomes standard input
  std::string output = {};                  // becomes standard output, instead of Outcome::out
  std::string error = {};                   // becomes standard error, instead of Outcome::err
  std::optional<rlim_t> largest_file = {};  // no file may grow beyond this [bytes]
  std::optional<rlim_t> memory = {};        // it may ask for [bytes]
  std::vector<int> closed = {};             // standard descriptors
};

/// Whether the built command line may be given less memory: sanitizers ask for terabytes.
inline constexpr bool memory_can_be_limited = !is_sanitized;

/// A call of the command line that is under way.
class Process {
 public:
  explicit Process(const std::vector<std::string>& arguments, const ProcessOptions& options = {}) {
    std::vector<std::string> words = {VANDPLAN_EXECUTABLE};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const std::string out = options.output.empty() ? folder_ / "out" : options.output;
    const std::string err = options.error.empty() ? folder_ / "err" : options.error;
    id_ = ::fork();
    if (id_ == 0) {
      redirect(STDIN_FILENO, options.input, O_RDONLY);
      redirect(STDOUT_FILENO, out, O_WRONLY | O_CREAT);
      redirect(STDERR_FILENO, err, O_WRONLY | O_CREAT);
      if (options.largest_file) {
        const rlimit limit{*options.largest_file, *options.largest_file};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        std::signal(SIGXFSZ, SIG_IGN);  // writing fails with an error instead
      }
      if (options.memory) {
        const rlimit limit{*options.memory, *options.memory};
        ::setrlimit(RLIMIT_AS, &limit);
      }
      for (const int descriptor : options.closed) ::close(descriptor);
      ::execv(argv[0], argv.data());
      ::_exit(127);
    }
  }

  void send(int signal) const { ::kill(id_, signal); }
  [[nodiscard]] pid_t id() const { return id_; }

  Outcome wait() {
    int status = 0;
    ::waitpid(id_, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
            content_of(folder_ / "out"), content_of(folder_ / "err")};
  }

 private:
  static void redirect(int descriptor, const std::string& file, int flags) {
    const int opened = ::open(file.c_str(), flags, 0600);
    if (opened < 0 || ::dup2(opened, descriptor) < 0) ::_exit(126);
  }

  TemporaryFolder folder_;
  pid_t id_ = -1;
};

inline Outcome run_vandplan(const std::vector<std::string>& arguments,
                            const ProcessOptions& options = {}) {
  return Process(arguments, options).wait();
}

}  // namespace vandplan
