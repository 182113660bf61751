// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Do the wheels turn as they may?

#include <optional>
#include <string>

#include "judge/track.h"
#include "vandplan/problem.h"

namespace vandplan::judge {

/// What is wrong about the curvature, in one line, and where.
struct SteeringFault {
  std::string reason;
  Place place;
};

/// The first place at which a path of the task is not steered as somebody says that it is: where
/// the curvature jumps and must not, changes faster than the vehicle can, or is not the one that
/// the task has at an end.
[[nodiscard]] std::optional<SteeringFault> false_steering(const Track& track, const Task& task,
                                                          Steering claimed);

}  // namespace vandplan::judge
