// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/goal_poses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "base/trigonometry.h"
#include "problem/goal_set.h"
#include "vandplan/steering.h"
#include "vandplan/vehicle.h"

namespace vandplan::planning {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;
enum Axis : std::size_t { x, y, heading, hitch };

Bounds box_of(const GoalRegion& region) {
  if (!region.area.empty()) return bounding_box(region.area);
  return {region.x.least, region.x.most, region.y.least, region.y.most};
}

/// Lengths of the intervals of all axes [m, rad].
std::array<double, 4> widths_of(const GoalRegion& region) {
  const auto [x_min, x_max, y_min, y_max] = box_of(region);
  return {x_max - x_min, y_max - y_min, width(region.heading),
          region.hitch_angle.most - region.hitch_angle.least};
}

bool is_any(const GoalRegion& region) { return width(region.heading) >= full_turn; }

Point nearest_on_side(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double t = square > 0.0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0.0;
  const double inside = std::clamp(t, 0.0, 1.0);
  if (inside == 1.0) return b;
  return {a.x + inside * dx, a.y + inside * dy};
}

/// The place itself if it is in the area, otherwise the nearest place on its edge.
Point moved_into(const Polygon& area, const Point& p) {
  if (contains(area, p)) return p;
  Point nearest = area.front();
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Point there = nearest_on_side(p, area[i], area[(i + 1) % area.size()]);
    if (std::hypot(there.x - p.x, there.y - p.y) < std::hypot(nearest.x - p.x, nearest.y - p.y)) {
      nearest = there;
    }
  }
  return nearest;
}

double between(double least, double most, double at) {
  if (at >= 1.0) return most;
  return least + at * (most - least);
}

Point place_in_box(const GoalRegion& region, const GoalPoint& point) {
  const auto [x_min, x_max, y_min, y_max] = box_of(region);
  return {between(x_min, x_max, point.at[x]), between(y_min, y_max, point.at[y])};
}

/// Heading of the axle that a region refers to, at a point.
double heading_of(const GoalRegion& region, const GoalPoint& point) {
  const double turned = point.is_turned ? std::numbers::pi : 0.0;
  return wrap_angle(region.heading.from + point.at[heading] * width(region.heading) + turned);
}

/// State of the vehicle with the heading and the hitch angle of a point, at a place.
State state_at(const Vehicle& vehicle, const GoalRegion& region, const GoalPoint& point,
               const Point& place) {
  const Pose axle{place.x, place.y, heading_of(region, point)};
  const double angle = between(region.hitch_angle.least, region.hitch_angle.most, point.at[hitch]);
  return problem::state_at(vehicle, region, axle, angle);
}

}  // namespace

LocalState state_of(const Task& task, const GoalPoint& point) {
  const GoalRegion& region = task.goal_set[point.region];
  Point place = place_in_box(region, point);
  if (!region.area.empty()) place = moved_into(region.area, place);
  return Local(state_at(task.vehicle, region, point, place));
}

std::optional<GoalPoint> point_at(const Task& task, const LocalState& state) {
  const State& given = state;
  const auto share = [](double from, double width, double value) {
    return width > 0.0 ? std::clamp((value - from) / width, 0.0, 1.0) : 0.5;
  };
  for (std::size_t i = 0; i < task.goal_set.size(); ++i) {
    const GoalRegion& region = task.goal_set[i];
    const bool is_of_trailer = region.is_of_trailer && task.vehicle.trailer;
    const Pose axle = is_of_trailer ? trailer_pose(task.vehicle, given) : given.pose;
    const std::array<double, 4> widths = widths_of(region);
    const Bounds box = box_of(region);
    for (const bool is_turned : {false, true}) {
      if (is_turned && !region.either_way) continue;
      const double middle =
          region.heading.from + widths[heading] / 2 + (is_turned ? std::numbers::pi : 0.0);
      const double turn = wrap_angle(axle.heading - middle);
      GoalPoint point{.region = i, .is_turned = is_turned};
      point.at = {share(box.x_min, widths[x], axle.x), share(box.y_min, widths[y], axle.y),
                  share(-widths[heading] / 2, widths[heading], turn),
                  share(region.hitch_angle.least, widths[hitch], given.hitch_angle)};
      const LocalState there = state_of(task, point);
      const State& found = there;
      constexpr double off = 4e-6;  // larger than the judge's tolerance of all numbers together
      if (std::hypot(found.pose.x - given.pose.x, found.pose.y - given.pose.y) <= off &&
          std::abs(wrap_angle(found.pose.heading - given.pose.heading)) <= off &&
          std::abs(wrap_angle(found.hitch_angle - given.hitch_angle)) <= off) {
        return point;
      }
    }
  }
  return std::nullopt;
}

std::size_t goals_of_pose(const GoalRegion& region) {
  return (region.either_way ? 2U : 1U) * (region.straight > 0.0 ? 2U : 1U);
}

double last_stretch(const Task& task, const GoalPoint& point) {
  const double straight = task.goal_set[point.region].straight;
  return point.is_backed_into ? -straight : straight;
}

std::size_t number_of_intervals(const Task& task, std::size_t region) {
  const std::array<double, 4> widths = widths_of(task.goal_set[region]);
  const auto count =
      std::count_if(widths.begin(), widths.end(), [](double width) { return width > 0.0; });
  return static_cast<std::size_t>(count);
}

bool is_in_region(const Task& task, const GoalPoint& point) {
  const GoalRegion& region = task.goal_set[point.region];
  return region.area.empty() || contains(region.area, place_in_box(region, point));
}

// The additive recurrence with the inverse powers of the root of z^(d+1) = z + 1 (Roberts 2018).
// Point 0 of the sequence is the middle of the region. The sequence covers each interval and a
// tenth more at both ends, and is cut off to the interval: the best goal is often at an end.
GoalPoint point_of_sequence(const Task& task, std::size_t region, std::size_t i) {
  const GoalRegion& of = task.goal_set[region];
  const std::array<double, 4> widths = widths_of(of);
  GoalPoint point{.region = region, .at = {}};
  const std::size_t turns_of_pose = of.either_way ? 2 : 1;
  const std::size_t kind = i % goals_of_pose(of);
  point.is_turned = kind % turns_of_pose == 1;
  point.is_backed_into = kind >= turns_of_pose;
  const std::size_t number = i / goals_of_pose(of);
  constexpr std::array roots = {2.0, 1.618033988749895, 1.324717957244746, 1.2207440846057594,
                                1.1673039782614187};
  const double root = roots[number_of_intervals(task, region)];
  double step = 1.0;
  for (std::size_t axis = 0; axis < widths.size(); ++axis) {
    if (widths[axis] == 0.0) continue;
    step /= root;
    const double turns = 0.5 + step * static_cast<double>(number);
    double at = turns - std::floor(turns);
    const bool is_round = axis == heading && is_any(of);
    constexpr double beyond = 0.1;
    if (!is_round) at = std::clamp((1 + 2 * beyond) * at - beyond, 0.0, 1.0);
    point.at[axis] = at;
  }
  return point;
}

namespace {

/// Moves of a point by a share of its intervals, in numbers of the point. Places move along the
/// heading and across it: in a narrow place nothing else is free.
std::vector<std::array<double, 4>> moves_of(const GoalRegion& region, const GoalPoint& point,
                                            double share) {
  const std::array<double, 4> widths = widths_of(region);
  std::vector<std::array<double, 4>> moves;
  if (widths[x] > 0.0 && widths[y] > 0.0) {
    const auto [sin, cos] = base::sin_cos(heading_of(region, point));
    const double way = share * std::max(widths[x], widths[y]);
    moves.push_back({way * cos / widths[x], way * sin / widths[y]});
    moves.push_back({-way * sin / widths[x], way * cos / widths[y]});
  }
  for (std::size_t axis = moves.empty() ? x : heading; axis < widths.size(); ++axis) {
    if (widths[axis] > 0.0) moves.emplace_back()[axis] = share;
  }
  return moves;
}

}  // namespace

std::vector<GoalPoint> beside(const Task& task, const GoalPoint& point, double share) {
  const GoalRegion& region = task.goal_set[point.region];
  std::vector<GoalPoint> points;
  for (const std::array<double, 4>& move : moves_of(region, point, share)) {
    for (const double sign : {1.0, -1.0}) {
      GoalPoint other = point;
      for (std::size_t axis = 0; axis < move.size(); ++axis) {
        double& at = other.at[axis];
        at += sign * move[axis];
        at = axis == heading && is_any(region) ? at - std::floor(at) : std::clamp(at, 0.0, 1.0);
      }
      if (!(other == point)) points.push_back(other);
    }
  }
  return points;
}

namespace {

/// Part of a region with the length of paths to it.
struct PartAhead {
  RegionPart part;
  double least = 0.0;  // lower bound of the length of paths to the part [m]
  bool operator<(const PartAhead& other) const { return least > other.least; }
};

/// Largest distance of the vehicle from its pose in the middle of a part, in place and heading, if
/// it may be off itself.
steering::Closing spread_of(const Vehicle& vehicle, const GoalRegion& region,
                            const RegionPart& part, const steering::Closing& off) {
  const std::array<double, 4> widths = widths_of(region);
  const auto half = [&](Axis axis) { return part.half[axis] * widths[axis]; };
  steering::Closing spread{std::hypot(half(x), half(y)) + off.position,
                           half(heading) + off.heading};
  if (!region.is_of_trailer) return spread;
  spread.position += vehicle.trailer->wheelbase * spread.heading +
                     std::abs(vehicle.hitch) * (spread.heading + half(hitch));
  spread.heading += half(hitch);
  return spread;
}

Pose middle_of(const Vehicle& vehicle, const GoalRegion& region, const GoalPoint& middle) {
  return state_at(vehicle, region, middle, place_in_box(region, middle)).pose;
}

/// Lower bound of the length of paths to a part. The Reeds-Shepp length is a distance. So it
/// changes by at most the length of the move, which is made ahead, sideways and on the spot.
double length_lower_bound(const Task& task, const RegionPart& part) {
  const double radius = task.vehicle.min_turning_radius;
  const GoalRegion& region = task.goal_set[part.middle.region];
  // Both ends of a path may be off as far as the judge allows.
  const auto [place, turn] = spread_of(
      task.vehicle, region, part, {2 * steering::judged.position, 2 * steering::judged.heading});
  const Pose pose = middle_of(task.vehicle, region, part.middle);
  const double sideways = place > 0.0 ? reeds_shepp_length({}, {0, place, 0}, radius) : 0.0;
  const double move = place + sideways + radius * turn;
  const double apart = std::hypot(pose.x - task.start.x, pose.y - task.start.y) - place;
  return std::max({reeds_shepp_length(task.start, pose, radius) - move, apart, 0.0});
}

}  // namespace

std::vector<RegionPart> whole(const GoalRegion& region, std::size_t index) {
  std::vector<RegionPart> parts;
  parts.reserve(2);
  for (const bool is_turned : region.either_way ? std::vector{false, true} : std::vector{false}) {
    parts.push_back({{index, {0.5, 0.5, 0.5, 0.5}, is_turned}, {0.5, 0.5, 0.5, 0.5}});
  }
  return parts;
}

namespace {

/// Both halves of a part, cut along the interval for whose half `way_of` is largest.
template <class WayOf>
std::array<RegionPart, 2> cut(const GoalRegion& region, const RegionPart& part, WayOf way_of) {
  const std::array<double, 4> widths = widths_of(region);
  std::size_t axis = 0;
  double most = -1.0;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const double way = way_of(i == x || i == y, part.half[i] * widths[i]);
    if (way <= most) continue;
    most = way;
    axis = i;
  }
  std::array<RegionPart, 2> parts = {part, part};
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    RegionPart& half = parts[side];
    half.half[axis] /= 2;
    half.middle.at[axis] += (side == 0 ? -1 : 1) * half.half[axis];
  }
  return parts;
}

}  // namespace

std::array<RegionPart, 2> halves(const GoalRegion& region, double radius, const RegionPart& part) {
  return cut(region, part, [radius](bool is_place, double half) {
    return is_place ? half + 2 * std::sqrt(radius * half) : radius * half;
  });
}

std::array<RegionPart, 2> halves_in_space(const GoalRegion& region, double reach,
                                          const RegionPart& part) {
  return cut(region, part,
             [reach](bool is_place, double half) { return is_place ? half : reach * half; });
}

PlacedPart placed(const Vehicle& vehicle, const GoalRegion& region, const RegionPart& part) {
  const std::array<double, 4> widths = widths_of(region);
  const double half_x = part.half[x] * widths[x], half_y = part.half[y] * widths[y];
  const steering::Closing off = spread_of(vehicle, region, part, steering::judged);
  const Pose pose = middle_of(vehicle, region, part.middle);
  const double swing = off.position - std::hypot(half_x, half_y);
  const double reach = std::max(swing, 0.0) + steering::judged.position;
  return {pose,
          off,
          {pose.x - half_x - reach, pose.x + half_x + reach, pose.y - half_y - reach,
           pose.y + half_y + reach}};
}

// Halves the part with the least bound, until that hardly raises the bound.
double length_lower_bound_to(const Task& task, std::size_t region, std::size_t halvings,
                             const search::Budget& budget) {
  constexpr std::size_t max_halvings = 2000;
  constexpr std::size_t halvings_at_once = 16;  // between two looks at the budget
  constexpr double fine = 1e-4;                 // finest size of a part, relative to the bound
  const GoalRegion& of = task.goal_set[region];
  std::priority_queue<PartAhead> parts;
  for (const RegionPart& part : whole(of, region)) {
    parts.push({part, length_lower_bound(task, part)});
  }
  for (std::size_t i = 0; i < std::min(halvings, max_halvings); ++i) {
    if (i % halvings_at_once == 0 && budget.is_interrupted()) break;
    const auto [part, least] = parts.top();
    const auto [place, turn] = spread_of(
        task.vehicle, of, part, {2 * steering::judged.position, 2 * steering::judged.heading});
    if (place + turn <= fine * least) break;
    parts.pop();
    for (const RegionPart& half : halves(of, task.vehicle.min_turning_radius, part)) {
      parts.push({half, std::max(least, length_lower_bound(task, half))});
    }
  }
  return parts.top().least;
}

}  // namespace vandplan::planning
