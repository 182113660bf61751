// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/commands/short_strokes.h"

#include <algorithm>
#include <cmath>

namespace vandplan::commands {
namespace {

constexpr double price = 1e3;  // price of a metre that strokes are too short [m or s]

/// Sum of the lengths by which strokes are shorter than `least` [m]; 0 without a gear change.
double missing(std::span<const Segment> segments, double least) {
  double sum = 0.0;
  double stroke = 0.0;
  bool changes_gear = false;
  for (const Segment& segment : segments) {
    if (segment.length * stroke < 0.0) {
      sum += std::max(0.0, least - std::abs(stroke));
      stroke = 0.0;
      changes_gear = true;
    }
    stroke += segment.length;
  }
  return changes_gear ? sum + std::max(0.0, least - std::abs(stroke)) : 0.0;
}

}  // namespace

double price_of_lack(std::span<const Segment> segments, double least) {
  return price * missing(segments, least);
}

}  // namespace vandplan::commands
