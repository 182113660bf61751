// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far off are estimates of a length? (Guo 2020, Algorithm 4 and Fig. 15; for rigs, too)

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/study_files.h"
#include "vandplan/rig.h"

namespace vandplan::studies {

struct AccuracyOptions {
  std::int64_t pairs = 1'000'000;
  double reach = 10.0;          ///< of |x| and |y| [m]
  double turning_radius = 7.0;  ///< [m]
  std::uint64_t seed = 1;
  /// Draws states of this rig, with hitch angles that are its limit times the cube of an even
  /// number from -1 to 1, and compares with lengths of `RigSteering`; pairs that it does not join
  /// are drawn again. None: poses, and Reeds-Shepp lengths. Its radius is `turning_radius`.
  std::optional<Vehicle> rig = {};
};

/// An estimate of the length from a node to a sample [m]; hitch angles are 0 without a rig.
struct NamedEstimate {
  std::string name;
  std::function<double(const RigState& node, const RigState& sample)> length;
  bool is_drawn = true;
};

inline constexpr std::array percents{1, 5, 25, 50, 75, 95, 99};

/// How differences are spread.
struct Spread {
  double least = 0.0;
  double largest = 0.0;
  double mean = 0.0;
  std::array<double, percents.size()> percentiles{};
};

/// One estimate over all pairs.
struct Accuracy {
  std::string name;
  bool is_drawn = true;
  Spread relative;              ///< of (estimate - length) / length
  Spread metres;                ///< of estimate - length [m]
  double within_a_tenth = 0.0;  ///< share of pairs with a relative difference in [-0.1, 0.1]
  double over = 0.0;            ///< share of pairs with an estimate above the length
  std::vector<std::int64_t> histogram;  ///< of the relative difference, from -1 on; the last bin
                                        ///< takes what lies beyond 1
};

inline constexpr int bins_of_unity = 50;  ///< bins of a histogram from 0 to 1

struct AccuracyStudy {
  AccuracyOptions options;
  std::vector<Accuracy> estimates;  ///< all for the same pairs
};

[[nodiscard]] AccuracyStudy study_accuracy(const AccuracyOptions& options,
                                           const std::vector<NamedEstimate>& estimates);

[[nodiscard]] StudyFiles files_of(const AccuracyStudy& study);

}  // namespace vandplan::studies
