// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <cmath>

#include "vandplan/search.h"

namespace vandplan::search {

CostRule cost_rule(const CostOptions& options) {
  return {.reverse_weight = options.reverse_weight,
          .gear_change_cost = options.gear_change_cost,
          .initial_gear = direction_of(options.initial_gear),
          .curvature_change_cost = options.curvature_change_cost};
}

Driven first_driven(const Piece& piece) {
  if (piece.count == 0) return {};
  const Segment& first = piece.segments[0];
  return {gear_of(first), first.curvature};
}

Driven last_driven(const Segment& segment) {
  return {gear_of(segment), curvature_at(segment, std::abs(segment.length))};
}

Driven last_driven(const Piece& piece) {
  return piece.count == 0 ? Driven{} : last_driven(piece.segments[piece.count - 1U]);
}

double change_cost(const CostRule& rule, const Driven& from, const Driven& to) {
  const double cost = from.gear * to.gear < 0 ? rule.gear_change_cost : 0.0;
  if (rule.curvature_change_cost == 0.0) return cost;
  const double change = std::abs(to.curvature - from.curvature);
  return std::isnan(change) ? cost : cost + rule.curvature_change_cost * change;
}

double drive_cost(const CostRule& rule, std::span<const Segment> segments, Driven& driven) {
  if (rule.is_length()) {  // nothing depends on what was driven
    driven = segments.empty() ? driven : last_driven(segments.back());
    return length(segments);
  }
  double sum = 0.0;
  for (const Segment& segment : segments) {
    if (segment.length == 0.0) continue;
    const double size = std::abs(segment.length);
    const GearSign next = gear_of(segment);
    const double weight = next > 0 ? rule.forward_weight : rule.reverse_weight;
    sum += change_cost(rule, driven, {next, segment.curvature}) + weight * size;
    if (segment.curvature_rate != 0.0) {
      sum += rule.curvature_change_cost * std::abs(segment.curvature_rate) * size;
    }
    driven = last_driven(segment);
  }
  return sum;
}

}  // namespace vandplan::search
