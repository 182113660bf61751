// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do the files of primitives have in common?

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "vandplan/graphs.h"

namespace vandplan::io {

/// Primitive as a file states it: poses sampled along it, the first one at the origin.
struct SampledPrimitive {
  int line = 1;  ///< Line of the file where it begins.
  std::int32_t from = 0;
  std::int32_t to = 0;
  std::vector<Pose> poses;  ///< [m, rad]
};

/// All primitives of a file.
struct SampledPrimitives {
  double step = 0.0;             ///< Distance of grid points [m].
  std::vector<double> headings;  ///< Exact headings [rad].
  std::vector<SampledPrimitive> all;
  bool in_reverse_too = false;  ///< Whether each primitive is also driven in reverse.
};

/// Throws InputError naming the wrong line and the reason.
using FailAt = std::function<void(int line, const std::string& problem)>;

/// Exact primitives that pass the sampled poses. Calls `fail`, which throws, for the first
/// primitive that has none.
[[nodiscard]] std::shared_ptr<const search::Primitives> exact(const SampledPrimitives& sampled,
                                                              const FailAt& fail);

[[nodiscard]] std::shared_ptr<const search::Primitives> read_nav2_primitives(
    const std::string& file);
[[nodiscard]] std::shared_ptr<const search::Primitives> read_sbpl_primitives(
    const std::string& file);

}  // namespace vandplan::io
