// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "base/hash.h"
#include "evaluation/run_record.h"
#include "vandplan/version.h"

namespace vandplan::evaluation {
namespace {

// Text behind `key` and a separator on the first line that begins with `key`, without quotes.
std::string value_of(const char* file, const std::string& key) {
  std::ifstream input(file);
  for (std::string line; std::getline(input, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t begin = line.find_first_not_of(" \t:=\"", key.size());
    if (begin == std::string::npos) break;
    return line.substr(begin, line.find_last_not_of(" \"") + 1 - begin);
  }
  return "unknown";
}

std::string fingerprint(const char* file) {
  const std::ifstream input(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << input.rdbuf();
  return fmt::format("{:016x}", base::hash_of(bytes.str()));
}

}  // namespace

Environment this_environment() {
  const BuildInfo build = build_info();
  // The file has tens of megabytes and does not change while the program runs, so it is hashed
  // once.
  static const std::string executable = fingerprint("/proc/self/exe");
  return {.version = std::string(build.version),
          .compiler = std::string(build.compiler),
          .build_type = std::string(build.build_type),
          .executable = executable,
          .processor = value_of("/proc/cpuinfo", "model name"),
          .cores = static_cast<int>(std::thread::hardware_concurrency()),
          .system = value_of("/etc/os-release", "PRETTY_NAME")};
}

bool is_profiled(const RunRecord& run) {
  const OptionValue* const profile = run.options->planner.find("profile");
  return profile != nullptr && *profile == OptionValue(true);
}

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", utc.tm_year + 1900, utc.tm_mon + 1,
                     utc.tm_mday, utc.tm_hour, utc.tm_min, utc.tm_sec);
}

}  // namespace vandplan::evaluation
