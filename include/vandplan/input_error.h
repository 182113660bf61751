// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What exactly is wrong with what I passed in?

#include <stdexcept>
#include <string>

namespace vandplan {

/// Input that cannot be used: the one exception of the library, thrown at its doors only.
/// `what()` is one line, "where: what is wrong, what was expected".
class InputError : public std::runtime_error {
 public:
  /// An error in a place and the problem there, in words. `where` is a key path ("obstacles[2]",
  /// "vehicle.width") in the core, "file:line" from files.
  InputError(const std::string& where, const std::string& problem);

  /// The place that is wrong: a key path, or "file:line".
  [[nodiscard]] const std::string& where() const noexcept { return where_; }
  /// What is wrong there, and what was expected.
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

 private:
  std::string where_;
  std::string problem_;
};

}  // namespace vandplan
