// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is a number that a caller gave within its range?

#include <cmath>
#include <string>
#include <string_view>

#include "base/text.h"
#include "vandplan/input_error.h"

namespace vandplan::base {

/// Throws an InputError that names `where` and the value, unless `holds`. `expected` is the text of
/// the allowed range.
inline void require(bool holds, std::string_view where, double value, std::string_view expected) {
  if (holds) return;
  throw InputError(std::string(where),
                   "is " + shortest_text(value) + ", expected " + std::string(expected));
}

/// Throws an InputError that names "radius", unless it is a finite number above 0.
inline void require_radius(double radius) {
  require(radius > 0.0 && std::isfinite(radius), "radius", radius, "more than 0 m");
}

}  // namespace vandplan::base
