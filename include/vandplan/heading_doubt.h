// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is a heading likely meant in degrees?

#include <string>

namespace vandplan {

/// What is odd about a heading beyond a full turn [rad], as one in degrees is: one line that says
/// how many radians so many degrees are. Empty if nothing is odd.
[[nodiscard]] std::string heading_doubt(double heading);

}  // namespace vandplan
