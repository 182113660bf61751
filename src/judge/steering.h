// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Do the wheels turn as the claimed steering allows?

#include <optional>
#include <string>

#include "judge/track.h"
#include "vandplan/problem.h"

namespace vandplan::judge {

/// Fault of the curvature in one line, and its place.
struct SteeringFault {
  std::string reason;
  Place place;
};

/// First fault of a path's curvature under the claimed steering; none if there is none. It is a
/// forbidden jump, a change faster than the vehicle can, or a wrong curvature at an end.
[[nodiscard]] std::optional<SteeringFault> false_steering(const Track& track, const Task& task,
                                                          Steering claimed);

}  // namespace vandplan::judge
