// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does a piece lead where it should?

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/cases.h"
#include "support/pose_pairs.h"
#include "vandplan/path.h"

namespace vandplan {

inline std::string as_code(const DrawnPair& pair) {
  return "{" + as_code(pair.from) + ", " + as_code(pair.to) + "}";
}

/// Whether driving the segments from one pose leads to the other, within 10^-9 m and rad.
inline testing::AssertionResult leads(const Piece& piece, const Pose& from, const Pose& to) {
  Pose end = from;
  for (const Segment& segment : piece.view()) end = advance(end, segment);
  const double turn = std::remainder(end.heading - to.heading, 2 * std::numbers::pi);
  if (std::abs(end.x - to.x) <= 1e-9 && std::abs(end.y - to.y) <= 1e-9 && std::abs(turn) <= 1e-9) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << as_code(piece.view()) << " from " << as_code(from)
                                     << " leads to " << as_code(end) << ", not to " << as_code(to);
}

}  // namespace vandplan
