// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What have the files of primitives in common?

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "vandplan/primitives.h"

namespace vandplan::io {

/// A primitive as a file has it: poses that were sampled along it, the first one at the origin.
struct SampledPrimitive {
  int line = 1;  ///< of the file, where it begins
  std::int32_t from = 0;
  std::int32_t to = 0;
  std::vector<Pose> poses;  ///< [m, rad]
};

/// All of a file.
struct SampledPrimitives {
  double step = 0.0;             ///< [m]
  std::vector<double> headings;  ///< [rad], exact
  std::vector<SampledPrimitive> all;
  bool in_reverse_too = false;  ///< whether each is also driven back
};

/// Says which line is wrong, and why; throws InputError.
using FailAt = std::function<void(int line, const std::string& problem)>;

/// The exact primitives that pass by the poses. Throws what `fail` throws, for the first that there
/// is none for.
[[nodiscard]] std::shared_ptr<const search::Primitives> exact(const SampledPrimitives& sampled,
                                                              const FailAt& fail);

[[nodiscard]] std::shared_ptr<const search::Primitives> read_nav2_primitives(
    const std::string& file);
[[nodiscard]] std::shared_ptr<const search::Primitives> read_sbpl_primitives(
    const std::string& file);

}  // namespace vandplan::io
