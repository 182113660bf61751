// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How large are the errors of estimated lengths? (Guo 2020, Algorithm 4 and Fig. 15; also for rigs)

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/study_files.h"
#include "vandplan/vehicle.h"

namespace vandplan::studies {

struct AccuracyOptions {
  std::int64_t pairs = 1'000'000;
  /// Largest |x| and |y| of a node [m].
  double reach = 10.0;
  double turning_radius = 7.0;  ///< turning radius of the vehicle [m]
  std::uint64_t seed = 1;
  /// Rig whose states are drawn; its turning radius is `turning_radius`. None: poses are drawn and
  /// compared with Reeds-Shepp lengths. Hitch angles are the limit times the cube of a uniform
  /// number from -1 to 1. Lengths are those of `RigSteering`. Pairs that it cannot join are drawn
  /// again.
  std::optional<Vehicle> rig = {};
};

/// Estimate of the length from a node to a sample [m]; hitch angles are 0 without a rig.
struct NamedEstimate {
  std::string name;
  std::function<double(const State& node, const State& sample)> length;
  bool is_drawn = true;
};

inline constexpr std::array percents{1, 5, 25, 50, 75, 95, 99};

/// Distribution of differences.
struct Spread {
  double least = 0.0;
  double largest = 0.0;
  double mean = 0.0;
  std::array<double, percents.size()> percentiles{};
};

/// Errors of one estimate over all pairs.
struct Accuracy {
  std::string name;
  bool is_drawn = true;
  Spread relative;              ///< distribution of (estimate - length) / length
  Spread metres;                ///< distribution of estimate - length [m]
  double within_a_tenth = 0.0;  ///< share of pairs with a relative difference in [-0.1, 0.1]
  double over = 0.0;            ///< share of pairs with an estimate above the length
  /// Histogram of the relative difference, from -1 on; the last bin contains all values from 1 on.
  std::vector<std::int64_t> histogram;
};

inline constexpr int bins_of_unity = 50;  ///< number of bins of a histogram from 0 to 1

struct AccuracyStudy {
  AccuracyOptions options;
  std::vector<Accuracy> estimates;  ///< results of the estimates, all for the same pairs
};

[[nodiscard]] AccuracyStudy study_accuracy(const AccuracyOptions& options,
                                           const std::vector<NamedEstimate>& estimates);

[[nodiscard]] StudyFiles files_of(const AccuracyStudy& study);

}  // namespace vandplan::studies
