// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a picture animated?

#include <string>

#include "draw/overlay.h"

namespace vandplan::drawing {

/// The SVG with an endless animation of the vehicle and the moving obstacles. A bar at the foot of
/// the plot grows with time. Browsers play it without a script. The drawing has a path with times.
[[nodiscard]] std::string played(const std::string& svg, const Overlay& film);

}  // namespace vandplan::drawing
