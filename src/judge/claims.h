// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is it true what somebody says about a path?

#include <optional>
#include <string>

#include "judge/track.h"
#include "judge/trailing.h"
#include "vandplan/path_check.h"

namespace vandplan::judge {

/// What was found of the cost of a path.
struct Found {
  double near = 0.0;  ///< what being near things adds to it [m]
  double time = 0.0;  ///< of the fastest drive without a limit of jerk [s], where the cost is that
  bool has_jerk_limit = false;
};

/// The first claim that is false, and what is true; one line. `trailing` is null without a trailer.
[[nodiscard]] std::optional<std::string> false_claim(const Track& track, const Trailing* trailing,
                                                     const Found& found, const PathClaims& claims);

}  // namespace vandplan::judge
