// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is it true what somebody says about a path?

#include <optional>
#include <string>

#include "judge/track.h"
#include "vandplan/path_check.h"

namespace vandplan::judge {

/// The first claim that is false, and what is true; one line. `near` is what being near things adds
/// to the cost [m].
[[nodiscard]] std::optional<std::string> false_claim(const Track& track, double near,
                                                     const PathClaims& claims);

}  // namespace vandplan::judge
