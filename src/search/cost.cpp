// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <cmath>

#include "vandplan/search.h"

namespace vandplan::search {

CostRule cost_rule(const CostOptions& options) {
  return {1.0, options.reverse_weight, options.gear_change_cost,
          direction_of(options.initial_gear)};
}

GearSign first_gear(const Piece& piece) {
  return piece.count == 0 ? 0 : gear_of(piece.segments[0]);
}

GearSign last_gear(const Piece& piece) {
  return piece.count == 0 ? 0 : gear_of(piece.segments[piece.count - 1U]);
}

double change_cost(const CostRule& rule, GearSign from, GearSign to) {
  return from * to < 0 ? rule.gear_change_cost : 0.0;
}

double drive_cost(const CostRule& rule, std::span<const Segment> segments, GearSign& gear) {
  double sum = 0.0;
  for (const Segment& segment : segments) {
    if (segment.length == 0.0) continue;
    const GearSign next = gear_of(segment);
    const double weight = next > 0 ? rule.forward_weight : rule.reverse_weight;
    sum += change_cost(rule, gear, next) + weight * std::abs(segment.length);
    gear = next;
  }
  return sum;
}

}  // namespace vandplan::search
