// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/claims.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "judge/drive_time.h"
#include "judge/near_cost.h"
#include "judge/text.h"
#include "judge/zone_prices.h"

namespace vandplan::judge {
namespace {

// Tolerance of lengths [m], and relative tolerance of costs.
constexpr double length_tolerance = 1e-6;
constexpr double near_tolerance = 1e-3;  // relative tolerance of a cost with a price of the ground
constexpr double time_tolerance = 1e-3;  // relative tolerance of a cost that is the time
constexpr double finely_seen = 1e5;      // up to this length of a path `near_cost` is fine [m]
constexpr double gap_tolerance = 1e-6;
constexpr double pose_distance = 0.1;  // largest distance between stated poses [m]
// Tolerance of stated poses [m, rad], curvatures [1/m] and distances [m]. It accepts files far from
// the origin, where doubles are micrometres apart, and rounded figures.
constexpr double stated_tolerance = 1e-5;

std::optional<std::string> false_figures(const Track& track, const PathClaims& claims) {
  const auto length = static_cast<double>(track.length);
  if (claims.length && !(std::abs(*claims.length - length) <= length_tolerance)) {
    return text("the stated length is %.10g m, the path is %.10g m long", *claims.length, length);
  }
  if (claims.gear_changes && *claims.gear_changes != track.gear_changes) {
    return text("the stated gear changes are %d, the path has %d", *claims.gear_changes,
                track.gear_changes);
  }
  return std::nullopt;
}

double cost_of(const Track& track, double surcharge, const CostOptions& stated) {
  const CostOptions rule = filled(stated, shortest_style);
  int changes = track.gear_changes;
  const Real first = track.stretches[0].direction;
  if (track.length > 0 && direction_of(rule.initial_gear) * first < 0) ++changes;
  const Real ahead = track.length - track.reverse_length;
  return static_cast<double>(*rule.forward_weight * ahead +
                             *rule.reverse_weight * track.reverse_length +
                             *rule.gear_change_cost * changes +
                             *rule.curvature_change_cost * track.curvature_change + surcharge);
}

std::optional<std::string> false_gap(const StatedCost& stated) {
  if (!stated.gap || !stated.lower_bound || !(*stated.lower_bound > 0)) return std::nullopt;
  const double gap = stated.cost / *stated.lower_bound - 1;
  if (std::abs(*stated.gap - gap) <= gap_tolerance) return std::nullopt;
  return text("the stated gap is %.10g, cost and bound make it %.10g", *stated.gap, gap);
}

/// Fault of a stated time. With a jerk limit the fastest drive is unknown, but takes no less time
/// than without it.
std::optional<std::string> false_time(const Found& found, const StatedCost& stated) {
  const double least = found.least_time * (1 - time_tolerance) - length_tolerance;
  const double most = found.most_time * (1 + time_tolerance) + length_tolerance;
  if (!(stated.cost >= least && (found.has_jerk_limit || stated.cost <= most))) {
    return text("the stated cost is %.10g s, the fastest drive takes %.10g s%s", stated.cost,
                found.most_time, found.has_jerk_limit ? " without a limit of jerk" : "");
  }
  if (stated.lower_bound && !(*stated.lower_bound <= stated.cost * (1 + gap_tolerance))) {
    return text("the stated bound is %.10g s, the stated cost %.10g s", *stated.lower_bound,
                stated.cost);
  }
  return false_gap(stated);
}

std::optional<std::string> false_cost(const Track& track, const Found& found,
                                      const StatedCost& stated) {
  if (stated.rule.measure == CostMeasure::time) return false_time(found, stated);
  const double cost = cost_of(track, found.most_surcharge, stated.rule);
  const double least = cost_of(track, found.least_surcharge, stated.rule);
  // The cost of clearance is less exact on longer paths.
  const double rough = std::max(1.0, static_cast<double>(track.length) / finely_seen);
  const double tolerance =
      length_tolerance * (1 + cost) +
      (stated.rule.clearance_weight.value_or(0.0) > 0 ? near_tolerance * rough * cost : 0.0) +
      (found.has_priced_ground ? near_tolerance * (1 + cost) : 0.0);
  if (!(stated.cost >= least - tolerance && stated.cost <= cost + tolerance)) {
    return text("the stated cost is %.10g m, the path costs %.10g m", stated.cost, cost);
  }
  if (!stated.lower_bound) return std::nullopt;
  if (!(*stated.lower_bound <= cost + tolerance)) {
    return text("the stated bound is %.10g m, the path costs %.10g m", *stated.lower_bound, cost);
  }
  return false_gap(stated);
}

bool is_near(const Position& position, const Pose& pose) {
  const Real turn = std::remainder(position.heading - static_cast<Real>(pose.heading), full_turn);
  return std::hypot(position.x - pose.x, position.y - pose.y) <= stated_tolerance &&
         std::abs(turn) <= stated_tolerance;
}

bool is_near(const Trailing* trailing, const Place& place, double hitch_angle) {
  if (trailing == nullptr) return hitch_angle == 0;
  const Real off = std::remainder(trailing->angle(place) - hitch_angle, full_turn);
  return std::abs(off) <= stated_tolerance;
}

/// Whether a stated pose lies on a stretch. At a joint it may belong to either side.
bool lies_on(const StatedPose& stated, const Track& track, const Trailing* trailing,
             std::size_t i) {
  const Stretch& stretch = track.stretches[i];
  const Real t = std::clamp<Real>(stated.s - stretch.s, 0, stretch.length);
  if (!(std::abs(stretch.s + t - stated.s) <= stated_tolerance)) return false;
  if (stated.gear && (*stated.gear == Gear::forward) != (stretch.direction > 0)) return false;
  const Real curvature = curvature_at(stretch, t);
  if (stated.curvature && !(std::abs(curvature - *stated.curvature) <= stated_tolerance)) {
    return false;
  }
  if (stated.hitch_angle && !is_near(trailing, {i, t}, *stated.hitch_angle)) return false;
  return is_near(after(stretch, t), stated.pose);
}

std::optional<std::string> false_poses(const Track& track, const Trailing* trailing,
                                       const std::vector<StatedPose>& poses) {
  if (poses.empty()) return std::nullopt;
  const auto fault = [](std::size_t i, const char* problem) {
    return "the stated poses[" + std::to_string(i) + "] " + problem;
  };
  Real last = 0;
  std::size_t i = 0;  // index of the stretch of the last pose
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const StatedPose& stated = poses[k];
    const Real step = stated.s - last;
    if (!(step >= 0 && step <= (k == 0 ? 0 : pose_distance) + stated_tolerance)) {
      return fault(k,
                   k == 0 ? "does not begin at s = 0" : "is not 0 to 0.1 m after the one before");
    }
    while (i + 1 < track.stretches.size() && !lies_on(stated, track, trailing, i)) ++i;
    if (!lies_on(stated, track, trailing, i)) return fault(k, "is not on the path");
    last = stated.s;
  }
  if (std::abs(track.length - last) <= stated_tolerance) return std::nullopt;
  return fault(poses.size() - 1, "is not the end of the path");
}

}  // namespace

void find_surcharges(const Task& task, std::span<const Body> bodies, const Trailing* trailing,
                     const CostOptions& rule, Found& found) {
  const Surroundings& ground = task.world->local();
  const Track& track = bodies.front().track;
  const auto surcharge = [&](AtEdge at_edge) {
    const std::vector<PricedPart> parts =
        priced_parts(ground, task.vehicle, track, trailing, at_edge);
    return zone_cost(track, rule, parts) + near_cost(bodies, rule, parts);
  };
  found.most_surcharge = surcharge(AtEdge::inside);
  found.has_priced_ground = has_prices(ground);
  found.least_surcharge =
      found.has_priced_ground ? surcharge(AtEdge::outside) : found.most_surcharge;
}

void find_times(const Task& task, const Track& track, const Trailing* trailing,
                const std::vector<Place>& stops, Found& found) {
  const Surroundings& ground = task.world->local();
  const auto time = [&](AtEdge at_edge) {
    return drive_time(track, task.vehicle, task.curvatures.start,
                      priced_parts(ground, task.vehicle, track, trailing, at_edge), stops);
  };
  found.most_time = time(AtEdge::inside);
  found.least_time = has_prices(ground) ? time(AtEdge::outside) : found.most_time;
}

std::optional<std::string> false_claim(const Track& track, const Trailing* trailing,
                                       const Found& found, const PathClaims& claims) {
  if (claims.start_hitch_angle && !is_near(trailing, {0, 0}, *claims.start_hitch_angle)) {
    return text("the stated hitch angle at the start is %.10g rad, it is %.10g rad",
                *claims.start_hitch_angle,
                trailing == nullptr ? 0.0 : static_cast<double>(trailing->angle({0, 0})));
  }
  if (auto reason = false_figures(track, claims)) return reason;
  if (claims.cost) {
    if (auto reason = false_cost(track, found, *claims.cost)) return reason;
  }
  return false_poses(track, trailing, claims.poses);
}

}  // namespace vandplan::judge
