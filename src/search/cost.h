// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does driving cost?
//
// Metres, weighted by gear, and a price per gear change; charged alike inside a piece, at the joint
// of two pieces and at the start. docs/algorithms/anytime.md says what is optimal under it.

#include <cmath>
#include <span>

#include "vandplan/path.h"
#include "vandplan/plan_options.h"

namespace vandplan {

/// 1 forward, -1 reverse, 0 not driven yet.
using GearSign = int;

/// Neutral values make the cost the length.
struct CostRule {
  double forward_weight = 1.0;    ///< per metre driven forward; >= 1
  double reverse_weight = 1.0;    ///< per metre driven in reverse; >= 1
  double gear_change_cost = 0.0;  ///< of one change [m]; >= 0
  GearSign initial_gear = 0;      ///< before the first metre; 0: any, and the first is free

  [[nodiscard]] bool is_length() const {
    return forward_weight == 1.0 && reverse_weight == 1.0 && gear_change_cost == 0.0;
  }
};

inline CostRule cost_rule(const PlanOptions& options) {
  return {1.0, options.reverse_weight, options.gear_change_cost,
          direction_of(options.initial_gear)};
}

inline GearSign gear_of(const Segment& segment) { return segment.length < 0.0 ? -1 : 1; }

inline GearSign first_gear(const Piece& piece) {
  return piece.count == 0 ? 0 : gear_of(piece.segments[0]);
}

inline GearSign last_gear(const Piece& piece) {
  return piece.count == 0 ? 0 : gear_of(piece.segments[piece.count - 1U]);
}

/// Of getting from one gear into another [m].
inline double change_cost(const CostRule& rule, GearSign from, GearSign to) {
  return from * to < 0 ? rule.gear_change_cost : 0.0;
}

/// Of driving the segments; `gear` is the one before them and becomes the one after them.
inline double drive_cost(const CostRule& rule, std::span<const Segment> segments, GearSign& gear) {
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

}  // namespace vandplan
