// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is a heading likely meant in degrees?

#include <string>

namespace vandplan::io {

/// What is odd about a heading of a file that is beyond a full turn; empty if nothing is.
[[nodiscard]] std::string heading_doubt(double heading);

}  // namespace vandplan::io
