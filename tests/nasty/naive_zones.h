// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does a path break the rule of a zone, and what do its metres cost? A look at every millimetre.

#include <string>

#include "vandplan/path.h"
#include "vandplan/problem.h"

namespace vandplan::nasty {

/// What was seen in zones and masks.
struct ZoneLook {
  std::string flaw = {};        ///< rule that is broken by more than `allowed_depth`; empty: none
  double priced_length = 0.0;   ///< sum of metres, each as many times as it costs [m]
  double unsure = 0.0;          ///< by how much that may be off [m]
  double least_duration = 0.0;  ///< duration, if nothing but zones and masks limits the speed [s]
};

/// Looks at places that are at most a millimetre apart, on paths of up to 300 m; further apart on
/// longer ones.
[[nodiscard]] ZoneLook naive_look_at_zones(const Scenario& scenario, const Path& path);

}  // namespace vandplan::nasty
