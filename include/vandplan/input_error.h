// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What exactly is wrong with what I passed in?

#include <stdexcept>
#include <string>

namespace vandplan {

/// Input that cannot be used: the only exception that the library throws by itself, and only from
/// public functions. `what()` is one line, "where: what is wrong, what was expected".
class InputError : public std::runtime_error {
 public:
  /// An error at a place, and the problem in words. `where` is a key path in the core
  /// ("obstacles[2]", "vehicle.width"), "file:line" for files.
  InputError(const std::string& where, const std::string& problem);

  /// Place of the error: a key path, or "file:line".
  [[nodiscard]] const std::string& where() const noexcept { return where_; }
  /// What is wrong at that place, and what was expected.
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

 private:
  std::string where_;
  std::string problem_;
};

}  // namespace vandplan
