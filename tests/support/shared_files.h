// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where are the scenarios, ours and other people's?

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace vandplan {

/// The root of the checkout that this test was built from.
std::filesystem::path repository();

/// The folder of material that may lie beside the repository: tests of it skip where it is absent.
inline std::filesystem::path shared_folder() {
  const char* const named = std::getenv("VANDPLAN_SHARED");
  return named != nullptr ? std::filesystem::path(named) : repository() / ".." / "shared";
}

/// The YAML files of a folder, sorted; none if there is no such folder.
inline std::vector<std::string> yaml_files(const std::filesystem::path& folder) {
  std::vector<std::string> files;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace vandplan
