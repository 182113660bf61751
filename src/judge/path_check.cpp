// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "judge/body.h"
#include "judge/claims.h"
#include "judge/contacts.h"
#include "judge/fault.h"
#include "judge/goals.h"
#include "judge/ground.h"
#include "judge/steering.h"
#include "judge/text.h"
#include "judge/track.h"
#include "judge/vias.h"
#include "judge/zones.h"

namespace vandplan {
namespace {

using namespace judge;

constexpr double stated_tolerance = 1e-5;  // tolerance of stated, rounded goals [m, rad]
constexpr double position_tolerance = 1e-6;
constexpr double heading_tolerance = 1e-6;
constexpr double curvature_slack = 1e-9;  // relative tolerance of curvatures
constexpr double bounds_slack = 1e-9;     // tolerance of the bounds [m]
// ---- What can be wrong ----

/// First number of a path that cannot be integrated.
std::optional<Fault> out_of_reason(const Path& path) {
  const Pose& start = path.start;
  if (!std::isfinite(start.x) || !std::isfinite(start.y) || !std::isfinite(start.heading)) {
    return Fault{"the start of the path is not finite", {}};
  }
  Real stretches_of_all = 0;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const Segment& segment = path.segments[i];
    const auto fault = [i](const char* problem) {
      return Fault{"segments[" + std::to_string(i) + "] " + problem, {}};
    };
    if (!std::isfinite(segment.curvature) || !std::isfinite(segment.length) ||
        !std::isfinite(segment.curvature_rate)) {
      return fault("is not finite");
    }
    const Real stretches = stretches_of(segment);
    if (segment.curvature_rate != 0) stretches_of_all += stretches;
    if (!(stretches <= most_stretches && stretches_of_all <= most_stretches_of_all)) {
      return fault("winds too often to be judged");
    }
  }
  return std::nullopt;
}

std::optional<Fault> off_pose(const Position& actual, const Pose& expected, const char* what,
                              const Place& place) {
  const auto distance =
      static_cast<double>(std::hypot(actual.x - expected.x, actual.y - expected.y));
  const auto angle = static_cast<double>(
      std::abs(std::remainder(actual.heading - static_cast<Real>(expected.heading), full_turn)));
  if (distance <= position_tolerance && angle <= heading_tolerance) return std::nullopt;
  return Fault{text("the path %s %.3g m and %.3g rad away", what, distance, angle), place};
}

std::optional<Fault> too_tight(const Track& track, double radius) {
  const Real limit = (1 + static_cast<Real>(curvature_slack)) / radius;
  for (std::size_t i = 0; i < track.stretches.size(); ++i) {
    const Stretch& stretch = track.stretches[i];
    for (const Real t : {Real{0}, stretch.length}) {
      const Real curvature = curvature_at(stretch, t);
      if (std::abs(curvature) <= limit) continue;
      return Fault{text("curvature %.10g is tighter than the turning radius of %.10g m allows",
                        static_cast<double>(curvature), radius),
                   Place{i, t}};
    }
  }
  return std::nullopt;
}

/// Appends places within a stretch where it has turned by `turn`: curvature t + rate t^2 / 2 =
/// turn.
void add_places_of(const Stretch& stretch, Real turn, std::vector<Real>& places) {
  const auto add = [&](Real t) {
    if (t > 0 && t < stretch.length) places.push_back(t);
  };
  const Real curvature = stretch.curvature;
  const Real rate = stretch.rate;
  const Real square = curvature * curvature + 2 * rate * turn;
  if (square < 0) return;
  const Real sum = curvature + std::copysign(std::sqrt(square), curvature);
  if (sum != 0) add(2 * turn / sum);
  add(-sum / rate);
}

/// Places of a clothoid's stretch where x or y can be extreme. It turns by less than a quarter.
std::vector<Real> extremes_of_clothoid(const Stretch& stretch) {
  std::vector<Real> places = {0, stretch.length};
  const Real first = stretch.start.heading / (full_turn / 4);
  for (const Real axis : {std::floor(first), std::ceil(first)}) {
    const Real turn = stretch.direction * (axis * (full_turn / 4) - stretch.start.heading);
    add_places_of(stretch, turn, places);
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// Places of a stretch where x or y can be extreme: its ends, and where it points along an axis.
std::vector<Real> extremes(const Stretch& stretch) {
  if (stretch.rate != 0) return extremes_of_clothoid(stretch);
  std::vector<Real> places = {0, stretch.length};
  const Real turn_rate = stretch.curvature * stretch.direction;
  if (turn_rate == 0) return places;
  for (int axis = 0; axis < 4; ++axis) {
    const Real turn = (axis * full_turn / 4 - stretch.start.heading) * (turn_rate > 0 ? 1 : -1);
    const Real t = (turn - full_turn * std::floor(turn / full_turn)) / std::abs(turn_rate);
    if (t < stretch.length) places.push_back(t);
  }
  std::sort(places.begin(), places.end());
  return places;
}

std::optional<Fault> out_of_bounds(const Track& track, const Bounds& bounds) {
  for (std::size_t i = 0; i < track.stretches.size(); ++i) {
    for (const Real t : extremes(track.stretches[i])) {
      const Position p = after(track.stretches[i], t);
      const Real outside = std::max(
          {bounds.x_min - p.x, p.x - bounds.x_max, bounds.y_min - p.y, p.y - bounds.y_max});
      if (outside <= bounds_slack) continue;
      return Fault{text("the rear axle is %.3g m outside the bounds", static_cast<double>(outside)),
                   Place{i, t}, Hit{HitKind::bounds}};
    }
  }
  return std::nullopt;
}

/// Fault of the start: vehicle and trailer must begin in the same `inside` area. Later they would
/// hit a fence.
std::optional<Fault> begins_outside(const Track& track, const Trailing* trailing,
                                    const std::vector<Polygon>& inside) {
  if (inside.empty()) return std::nullopt;
  const auto is_in = [](const Polygon& area, const Position& axle) {
    return distance_from(area, axle.x, axle.y) <= static_cast<Real>(position_tolerance);
  };
  bool is_begun = false;
  for (const Polygon& area : inside) {
    if (!is_in(area, track.stretches[0].start)) continue;
    is_begun = true;
    if (trailing == nullptr || is_in(area, trailing->position({0, 0}))) return std::nullopt;
  }
  return Fault{text("the %s begins outside of what the vehicle stays inside of",
                    is_begun ? "axle of the trailer" : "rear axle"),
               Place{0, 0}, Hit{HitKind::inside}};
}

/// First place where the hitch angle exceeds its limit.
std::optional<Fault> jackknife(const Trailing& trailing, double limit) {
  const auto place = trailing.first_beyond(static_cast<Real>(limit) + heading_tolerance);
  if (!place) return std::nullopt;
  return Fault{text("the rig folds up (jackknife): the hitch angle is %.6f rad, its limit %.6f rad",
                    static_cast<double>(trailing.angle(*place)), limit),
               place};
}

std::optional<Fault> off_hitch_angle(Real actual, double expected, const char* what,
                                     const Place& place) {
  const auto off = static_cast<double>(std::abs(std::remainder(actual - expected, full_turn)));
  if (off <= heading_tolerance) return std::nullopt;
  return Fault{text("the path %s with a hitch angle %.3g rad off", what, off), place};
}

/// First stretch that is driven in a gear that is not allowed.
std::optional<Fault> wrong_gear(const Track& track, AllowedGears allowed) {
  if (allowed == AllowedGears::both) return std::nullopt;
  const Real wanted = allowed == AllowedGears::forward ? 1 : -1;
  for (std::size_t i = 0; i < track.stretches.size(); ++i) {
    const Stretch& stretch = track.stretches[i];
    if (stretch.direction == wanted || !(stretch.length > 0)) continue;
    return Fault{text("the vehicle is driven %s, the allowed gears are: %s",
                      wanted > 0 ? "in reverse" : "forward", std::string(name_of(allowed)).c_str()),
                 Place{i, 0}};
  }
  return std::nullopt;
}

/// Fault of a stated goal that differs from the one at which the path ends.
std::optional<Fault> false_goal(const Goal& goal, const std::optional<ReachedGoal>& stated) {
  if (!stated) return std::nullopt;
  const Pose& is = goal.pose;
  const Pose& said = stated->pose;
  const double apart = std::hypot(is.x - said.x, is.y - said.y);
  const auto turn = static_cast<double>(
      std::abs(std::remainder(static_cast<Real>(is.heading) - said.heading, full_turn)));
  if (apart <= stated_tolerance && turn <= stated_tolerance) return std::nullopt;
  return Fault{
      text("the stated goal is %.3g m and %.3g rad away from where the path ends", apart, turn),
      {}};
}

/// Fault of a path whose last stretch is not as long and straight as the goal asks for.
std::optional<Fault> bent_end(const GoalRegion& region, const Goal& goal, const Place& end) {
  if (goal.lack_of_straight <= position_tolerance) return std::nullopt;
  return Fault{text("the last %.7g m before the goal are straight and in one gear, expected %.7g m",
                    region.straight - goal.lack_of_straight, region.straight),
               end};
}

/// Fault of a path that does not pass a via behind those before it.
std::optional<Fault> missed_via(const Task& task, const Track& track, const Passings& passed) {
  const std::size_t i = passed.places.size();
  if (i == task.via.size()) return std::nullopt;
  return Fault{text("the path does not pass via[%zu]%s", i,
                    i > 0 ? text(" behind via[%zu]", i - 1).c_str() : ""),
               end_of(track)};
}

/// Places of a track as somebody states them.
std::vector<PassedVia> stated_places(const Task& task, const Track& track,
                                     const std::vector<Place>& places) {
  std::vector<PassedVia> passed;
  for (const Place& place : places) {
    const PathPoint point = point_at(track, place);
    passed.push_back({point.s, to_scenario(*task.world, Local(point.pose))});
  }
  return passed;
}

/// The goal to which a path is compared: in the claimed region if it exists, else the nearest.
Goal goal_of(const Task& task, const Track& track, const Trailing* trailing,
             const PathClaims& claims) {
  std::optional<std::size_t> only;
  if (claims.goal && claims.goal->index < task.goal_set.size()) only = claims.goal->index;
  return nearest_goal(task, track, trailing, claims.steering == Steering::continuous, only);
}

/// The task with `goal` as its only goal.
Task with_goal(const Task& task, const Goal& goal) {
  Task to = task;
  to.goal = Local(goal.pose);
  to.curvatures.goal = goal.curvature;
  to.hitch_angles.goal = goal.hitch_angle;
  return to;
}

/// First fault of a path, and its least clearance [m]. `trailing` is null without a trailer.
std::optional<Fault> first_fault(const Task& task, const Track& track, const Trailing* trailing,
                                 const Passings& passed, const PathClaims& claims,
                                 std::optional<double>& least) {
  if (auto f = off_pose(track.stretches[0].start, task.start, "begins", {0, 0})) return f;
  if (auto f = too_tight(track, task.vehicle.min_turning_radius)) return f;
  if (auto f = false_steering(track, task, claims.steering, passed.stops)) return f;
  if (auto f = wrong_gear(track, claims.gears)) return f;
  if (auto f = out_of_bounds(track, task.world->local().bounds)) return f;
  if (auto f = begins_outside(track, trailing, task.world->local().inside)) return f;
  if (auto f = broken_rule(task.world->local().zones, task.vehicle, track, trailing)) return f;
  const std::shared_ptr<const Ground> ground = ground_of(*task.world);
  Bodies bodies{{track, *ground, outlines_of(task.vehicle)}};
  if (trailing != nullptr) {
    if (auto f = jackknife(*trailing, task.vehicle.max_hitch_angle)) return f;
    bodies.push_back({track, *ground, outlines_of(*task.vehicle.trailer), trailing});
  }
  least = std::numeric_limits<double>::infinity();
  if (auto f = first_collision(bodies, *least)) return f;
  if (*least < claims.clearance.margin) {
    if (auto f = too_near(track, bodies, claims.clearance)) return f;
  }
  if (auto f = off_pose(track.end, task.goal, "ends", end_of(track))) return f;
  if (trailing != nullptr) {
    const double wanted = task.hitch_angles.goal;
    if (auto f = off_hitch_angle(trailing->end_angle(), wanted, "ends", end_of(track))) return f;
  }
  if (auto f = missed_via(task, track, passed)) return f;
  if (auto f = false_passings(task, track, trailing, claims.via)) return Fault{*f, {}};
  Found found{.has_jerk_limit = task.vehicle.limits.max_jerk.has_value()};
  if (claims.cost && claims.cost->rule.measure == CostMeasure::time) {
    find_times(task, track, trailing, passed.stops, found);
  } else if (claims.cost) {
    find_surcharges(task, bodies, trailing, claims.cost->rule, found);
  }
  if (const auto reason = false_claim(track, trailing, found, claims)) return Fault{*reason, {}};
  return std::nullopt;
}

/// The path in the world's frame, where numbers are small.
Path local_path(const World& world, const Path& path) {
  return {to_local(world, path.start), path.segments};
}

/// Names of `HitKind`, in the order of the enumerators.
constexpr std::array<std::string_view, 7> names_of_kinds = {"obstacles", "kerbs", "map",  "bounds",
                                                            "inside",    "zones", "masks"};

PathClaims local_claims(const World& world, const PathClaims& claims) {
  PathClaims local = claims;
  if (local.goal) local.goal->pose = to_local(world, local.goal->pose);
  for (PassedVia& stated : local.via) stated.pose = to_local(world, stated.pose);
  for (StatedPose& stated : local.poses) stated.pose = to_local(world, stated.pose);
  return local;
}

}  // namespace

std::string_view name_of(HitKind kind) noexcept {
  return names_of_kinds[static_cast<std::size_t>(kind)];
}

std::optional<HitKind> hit_kind_named(std::string_view name) noexcept {
  const auto* const found = std::ranges::find(names_of_kinds, name);
  if (found == names_of_kinds.end()) return std::nullopt;
  return static_cast<HitKind>(found - names_of_kinds.begin());
}

bool has_index(HitKind kind) noexcept { return kind != HitKind::map && kind != HitKind::bounds; }

PathCheck check_path(const Problem& problem, const Path& path, const PathClaims& claims) {
  PathCheck check;
  check.reason = judge::door_fault(problem, claims.clearance.margin);
  if (check.reason.empty()) check.reason = judge::door_fault(problem, claims.clearance.margin_ramp);
  if (!check.reason.empty()) return check;
  if (const std::optional<Fault> fault = out_of_reason(path)) {
    check.reason = fault->reason;
    return check;
  }
  const World& world = *problem.world();
  const Track track = integrate(local_path(world, path));
  check.length = static_cast<double>(track.length);
  check.reverse_length = static_cast<double>(track.reverse_length);
  check.gear_changes = track.gear_changes;
  check.curvature_change = static_cast<double>(track.curvature_change);
  const Task* task = &problem.task();
  std::optional<Trailing> trailing;
  if (task->vehicle.trailer) {
    trailing.emplace(track, task->vehicle, task->hitch_angles.start);
    check.largest_hitch_angle = static_cast<double>(trailing->largest_angle());
  }
  const Trailing* const trailer = trailing ? &*trailing : nullptr;
  const PathClaims local = local_claims(world, claims);
  const Passings passed = passings(*task, track, trailer);
  std::optional<Fault> fault;
  if (task->goal_set.empty()) {
    fault = first_fault(*task, track, trailer, passed, local, check.clearance);
  } else {
    const Goal goal = goal_of(*task, track, trailer, local);
    fault = first_fault(with_goal(*task, goal), track, trailer, passed, local, check.clearance);
    if (!fault) fault = bent_end(task->goal_set[goal.index], goal, end_of(track));
    if (!fault) fault = false_goal(goal, local.goal);
    if (!fault) check.goal = ReachedGoal{goal.index, to_scenario(world, Local(goal.pose))};
  }
  check.valid = !fault;
  if (!fault) check.via = stated_places(*task, track, passed.places);
  if (!fault) return check;
  check.reason = fault->reason;
  check.hit = fault->hit;
  if (fault->place) {
    check.at = point_at(track, *fault->place);
    check.at->pose = to_scenario(world, Local(check.at->pose));
  }
  return check;
}

}  // namespace vandplan
