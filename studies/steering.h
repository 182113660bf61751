// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do shortest paths look like, forward only and in both gears? (Guo 2020, Fig. 3 and 4)

#include <string>
#include <vector>

#include "studies/study_files.h"

namespace vandplan::studies {

struct SteeringOptions {
  double turning_radius = 7.0;  ///< turning radius of the vehicle [m]
};

/// A goal and the shortest paths to it; the start is (0, 0, 0).
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

/// Study of goals at fixed multiples of the turning radius.
[[nodiscard]] SteeringStudy study_steering(const SteeringOptions& options);

[[nodiscard]] StudyFiles files_of(const SteeringStudy& study);

}  // namespace vandplan::studies
