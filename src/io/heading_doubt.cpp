// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/files.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vandplan {

std::string heading_doubt(double heading) {
  constexpr double full_turn = 2 * std::numbers::pi;
  // Headings slightly above a full turn are rounding errors.
  if (!std::isfinite(heading) || std::abs(heading) <= full_turn + 1e-3) return "";
  return fmt::format("is {} rad, more than a full turn; {} degrees are {:.4f} rad", heading,
                     heading, heading / 180 * std::numbers::pi);
}

}  // namespace vandplan
