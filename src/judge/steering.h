// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Do the wheels turn as the claimed steering allows?

#include <optional>
#include <span>

#include "judge/fault.h"
#include "judge/track.h"
#include "vandplan/problem.h"

namespace vandplan::judge {

/// First fault of a path's curvature under the claimed steering; none if there is none. It is a
/// forbidden jump, a change faster than the vehicle can, or a wrong curvature at an end. `stops`:
/// places where the vehicle stands though it does not change gear.
[[nodiscard]] std::optional<Fault> false_steering(const Track& track, const Task& task,
                                                  Steering claimed, std::span<const Place> stops);

/// Whether the curvature jumps at the begin of stretch `i`, which is not the first one.
[[nodiscard]] bool jumps(const Track& track, const Vehicle& vehicle, std::size_t i);

}  // namespace vandplan::judge
