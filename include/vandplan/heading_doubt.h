// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is a heading likely meant in degrees?

#include <string>

namespace vandplan {

/// Doubt about a heading of more than a full turn [rad], which is likely meant in degrees. The text
/// is one line that says how many radians so many degrees are. It is empty if there is no doubt.
[[nodiscard]] std::string heading_doubt(double heading);

}  // namespace vandplan
