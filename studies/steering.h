// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do shortest paths look like, forward only and in both gears? (Guo 2020, Fig. 3 and 4)

#include <string>
#include <vector>

#include "studies/study_files.h"

namespace vandplan::studies {

struct SteeringOptions {
  double turning_radius = 7.0;  ///< [m]
};

/// A goal seen from the start at (0, 0, 0), and the shortest paths to it.
struct SteeringExample {
  std::string name;
  Pose goal;
  Piece dubins;
  Piece reeds_shepp;
};

struct SteeringStudy {
  SteeringOptions options;
  std::vector<SteeringExample> examples;
};

/// Goals at fixed multiples of the turning radius.
[[nodiscard]] SteeringStudy study_steering(const SteeringOptions& options);

[[nodiscard]] StudyFiles files_of(const SteeringStudy& study);

}  // namespace vandplan::studies
