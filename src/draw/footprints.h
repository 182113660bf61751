// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a picture show under the mouse?

#include <string>

#include "draw/overlay.h"

namespace vandplan::drawing {

/// The SVG with what shows under the mouse: at a place of the path, the footprint of vehicle and
/// trailer; at an obstacle or kerb, its number in the scenario. A style sheet does it, no script.
[[nodiscard]] std::string with_footprints(const std::string& svg, const Overlay& overlay);

}  // namespace vandplan::drawing
