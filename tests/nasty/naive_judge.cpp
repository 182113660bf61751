// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "nasty/naive_judge.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "nasty/naive_geometry.h"
#include "nasty/naive_zones.h"

namespace vandplan::nasty {
namespace {

/// A scenario as the naive judge sees it.
class Look {
 public:
  Look(const Scenario& scenario, double margin)
      : scenario_(scenario),
        body_(body_of(scenario.vehicle, margin)),
        wheels_(wheels_of(scenario.vehicle, margin)),
        reach_(std::max(body_.reach, wheels_.reach)) {
    if (scenario.vehicle.trailer) trailer_ = body_of(*scenario.vehicle.trailer, margin);
    add(scenario.obstacles, "obstacle", obstacles_);
    add(scenario.kerbs, "kerb", kerbs_);
    add(scenario.inside, "inside", areas_);
    if (scenario.map) maps_.push_back({*scenario.map, "map", frame_of(*scenario.map)});
    for (const Mask& mask : scenario.masks) {
      if (mask.use != MaskUse::obstacles) continue;
      OccupancyGrid occupied = mask.map;
      occupied.unknown_is_free = true;
      maps_.push_back({occupied, "mask", frame_of(occupied)});
    }
  }

  /// What the vehicle hits at a place that counts from the start; empty if nothing.
  [[nodiscard]] std::string hit(const Vector& place, Real heading) const {
    const Frame vehicle = frame_at(place, heading);
    for (const Thing& thing : kerbs_) {
      if (is_near(thing, place, reach_) && hits(thing, wheels_, vehicle)) return thing.name;
    }
    return hit(body_, vehicle);
  }

  /// The same of the trailer, whose wheels have no length to be made smaller: kerbs are overlooked.
  [[nodiscard]] std::string hit_by_trailer(const Vector& place, Real heading, Real angle) const {
    const Vehicle& vehicle = scenario_.vehicle;
    const Vector hitch = frame_at(place, heading).placed({vehicle.hitch, 0});
    const Real behind = vehicle.trailer->wheelbase;
    const Vector axle = frame_at(hitch, heading - angle).placed({-behind, 0});
    const std::string thing = hit(trailer_, frame_at(axle, heading - angle));
    return thing.empty() ? "" : thing + " with the trailer";
  }

  [[nodiscard]] bool leaves_bounds(const Vector& place) const {
    const Bounds& b = scenario_.bounds;
    const Real x = scenario_.start.x + place.x;
    const Real y = scenario_.start.y + place.y;
    return x < b.x_min - allowed_miss || x > b.x_max + allowed_miss || y < b.y_min - allowed_miss ||
           y > b.y_max + allowed_miss;
  }

  [[nodiscard]] Real reach() const { return reach_; }

 private:
  struct Map {
    OccupancyGrid grid;
    std::string name;
    Frame frame;
  };

  [[nodiscard]] Frame frame_of(const OccupancyGrid& grid) const {
    return frame_at(
        {Real{grid.origin.x} - scenario_.start.x, Real{grid.origin.y} - scenario_.start.y},
        grid.origin.heading);
  }

  void add(const std::vector<Polygon>& polygons, const std::string& name,
           std::vector<Thing>& things) const {
    for (const Polygon& polygon : polygons) {
      const std::string number = "[" + std::to_string(things.size()) + "]";
      things.push_back(thing_of(name + number, polygon, scenario_.start));
    }
  }

  [[nodiscard]] std::string hit(const Body& body, const Frame& vehicle) const {
    for (const Thing& thing : obstacles_) {
      if (is_near(thing, vehicle.origin, body.reach) && hits(thing, body, vehicle)) {
        return thing.name;
      }
    }
    if (!areas_.empty() && !is_in_an_area(body, vehicle)) return "the edge";
    for (const Map& map : maps_) {
      if (hits_map(map, body, vehicle)) return map.name;
    }
    return "";
  }

  /// Whether an area holds a body: it holds a place of it, and no side runs through it.
  [[nodiscard]] bool is_in_an_area(const Body& body, const Frame& vehicle) const {
    return std::any_of(areas_.begin(), areas_.end(), [&](const Thing& area) {
      std::vector<Vector> seen;
      for (const Vector& corner : area.corners) seen.push_back(vehicle.seen(corner));
      for (std::size_t i = 0, j = seen.size() - 1; i < seen.size(); j = i++) {
        if (runs_through(seen[j], seen[i], body)) return false;
      }
      return holds(seen, body.middle);
    });
  }

  [[nodiscard]] static bool is_near(const Thing& thing, const Vector& place, Real reach) {
    return thing.box.x_min - place.x <= reach && place.x - thing.box.x_max <= reach &&
           thing.box.y_min - place.y <= reach && place.y - thing.box.y_max <= reach;
  }

  /// Blocked cells near the body one by one; and the ground outside if that is blocked.
  [[nodiscard]] static bool hits_map(const Map& map, const Body& body, const Frame& vehicle) {
    const OccupancyGrid& grid = map.grid;
    const Real side = grid.resolution;
    Rectangle near{1e300L, -1e300L, 1e300L, -1e300L};
    for (const Vector& corner : body.corners) {
      const Vector p = map.frame.seen(vehicle.placed(corner));
      near = {std::min(near.x_min, p.x), std::max(near.x_max, p.x), std::min(near.y_min, p.y),
              std::max(near.y_max, p.y)};
    }
    const bool is_outside = near.x_min < 0 || near.y_min < 0 || near.x_max > side * grid.columns ||
                            near.y_max > side * grid.rows;
    if (is_outside && !grid.unknown_is_free) return true;
    const auto clamped = [&](Real value, std::int32_t count) {
      return static_cast<std::int32_t>(std::clamp<Real>(std::floor(value / side), 0, count - 1));
    };
    for (std::int32_t row = clamped(near.y_min, grid.rows); row <= clamped(near.y_max, grid.rows);
         ++row) {
      for (std::int32_t column = clamped(near.x_min, grid.columns);
           column <= clamped(near.x_max, grid.columns); ++column) {
        if (is_blocked(grid, column, row) && hits_cell(map, body, vehicle, column, row))
          return true;
      }
    }
    return false;
  }

  [[nodiscard]] static bool hits_cell(const Map& map, const Body& body, const Frame& vehicle,
                                      std::int32_t column, std::int32_t row) {
    const Real side = map.grid.resolution;
    Thing cell;
    for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      cell.corners.push_back(map.frame.placed({side * (column + right), side * (row + up)}));
    }
    return hits(cell, body, vehicle);
  }

  const Scenario& scenario_;
  Body body_;
  Body wheels_;
  Body trailer_ = {};
  Real reach_;  ///< of the vehicle
  std::vector<Thing> obstacles_;
  std::vector<Thing> kerbs_;
  std::vector<Thing> areas_;  ///< that the body stays in
  std::vector<Map> maps_;
};

/// How many steps a segment is driven in.
long steps_of(const Segment& segment, Real steepest, Real reach) {
  const Real length = std::abs(Real{segment.length});
  const Real for_looks = std::min<Real>(length / std::max<Real>(0.005L, reach / 100), 20000);
  return 1 + static_cast<long>(std::max(for_looks, 32 * length * steepest));
}

std::string flaw_at(const std::string& what, const Vector& place) {
  return what + ", " + std::to_string(static_cast<double>(place.x)) + " and " +
         std::to_string(static_cast<double>(place.y)) + " m from the start";
}

/// What is wrong with the trailer there, or empty.
std::string flaw_of_trailer(const Look& look, const Vehicle& vehicle, const Drive& at) {
  if (!(std::abs(at.angle) <= vehicle.max_hitch_angle + allowed_miss)) {
    return flaw_at("folds up", at.place);
  }
  const std::string hit = look.hit_by_trailer(at.place, at.heading, at.angle);
  return hit.empty() ? "" : flaw_at("hits " + hit, at.place);
}

/// Drives a segment and looks; what is wrong, or empty.
std::string drive(const Look& look, const Vehicle& vehicle, const Segment& segment, Drive& at) {
  const Real length = std::abs(Real{segment.length});
  const Real last = segment.curvature + segment.curvature_rate * length;
  const Real steepest = std::max(std::abs(Real{segment.curvature}), std::abs(last));
  if (!(steepest * vehicle.min_turning_radius <= 1 + 1e-9L)) return flaw_at("bent", at.place);
  if (!(length < 1e9L)) return flaw_at("too long", at.place);
  const long steps = steps_of(segment, steepest, look.reach());
  const Real part = Real{segment.length} / steps;
  for (long i = 0; i < steps; ++i) {
    const Real driven = std::abs(part) * i;
    const Real curvature = segment.curvature + segment.curvature_rate * driven;
    if (vehicle.trailer) at.fold(vehicle, curvature, segment.curvature_rate, part);
    at.step(curvature, segment.curvature_rate, part);
    if (look.leaves_bounds(at.place)) return flaw_at("outside the bounds", at.place);
    const std::string hit = look.hit(at.place, at.heading);
    if (!hit.empty()) return flaw_at("hits " + hit, at.place);
    if (!vehicle.trailer) continue;
    const std::string flaw = flaw_of_trailer(look, vehicle, at);
    if (!flaw.empty()) return flaw;
  }
  return "";
}

// ---- Sets of goals ----

bool is_of_region(const Scenario& scenario, const GoalRegion& region, const Drive& at,
                  Real slack = allowed_miss, Real turn_slack = allowed_miss) {
  Vector place = at.place;
  Real heading = at.heading;
  if (region.is_of_trailer) {
    const Vehicle& v = scenario.vehicle;
    heading = at.heading - at.angle;
    place = {place.x + v.hitch * std::cos(at.heading) - v.trailer->wheelbase * std::cos(heading),
             place.y + v.hitch * std::sin(at.heading) - v.trailer->wheelbase * std::sin(heading)};
  }
  const Pose& origin = scenario.start;
  const Real off =
      region.area.empty()
          ? std::hypot(
                beyond(place.x, Real{region.x.least} - origin.x, Real{region.x.most} - origin.x),
                beyond(place.y, Real{region.y.least} - origin.y, Real{region.y.most} - origin.y))
          : from_area(region.area, origin, place);
  Real turn = beyond_headings(heading, region.heading);
  if (region.either_way) turn = std::min(turn, beyond_headings(heading + pi, region.heading));
  const Real fold = std::remainder(at.angle, 2 * pi);
  const bool is_folded =
      scenario.vehicle.trailer &&
      !(beyond(fold, region.hitch_angle.least, region.hitch_angle.most) <= turn_slack);
  return off <= slack && turn <= turn_slack && !is_folded;
}

/// Passes the vias that come next, as far as steps of `part` metres show.
void pass(const Scenario& scenario, const Drive& at, Real part, Real steepest, std::size_t& next) {
  const Vehicle& vehicle = scenario.vehicle;
  Real pace = steepest;
  if (vehicle.trailer) {
    pace += (1 + std::abs(Real{vehicle.hitch}) * steepest) / vehicle.trailer->wheelbase;
  }
  const auto is_passed = [&](const GoalRegion& region) {
    return is_of_region(scenario, region, at, part * 2 + allowed_miss, part * pace + allowed_miss);
  };
  while (next < scenario.via.size() && std::any_of(scenario.via[next].any_of.begin(),
                                                   scenario.via[next].any_of.end(), is_passed)) {
    ++next;
  }
}

/// The first via that a path does not pass, or empty: looks every millimetre.
std::string flaw_of_vias(const Scenario& scenario, const Path& path) {
  Drive at{{}, scenario.start.heading, scenario.hitch_angles.start};
  std::size_t next = 0;
  pass(scenario, at, 0, 0, next);
  for (const Segment& segment : path.segments) {
    const Real length = std::abs(Real{segment.length});
    const Real last = segment.curvature + segment.curvature_rate * length;
    const Real steepest = std::max(std::abs(Real{segment.curvature}), std::abs(last));
    const auto steps = 1 + static_cast<long>(std::min<Real>(length / 1e-3L, 100'000));
    const Real part = Real{segment.length} / steps;
    for (long i = 0; i < steps && next < scenario.via.size(); ++i) {
      const Real curvature = segment.curvature + segment.curvature_rate * std::abs(part) * i;
      if (scenario.vehicle.trailer) {
        at.fold(scenario.vehicle, curvature, segment.curvature_rate, part);
      }
      at.step(curvature, segment.curvature_rate, part);
      pass(scenario, at, std::abs(part), steepest, next);
    }
  }
  return next == scenario.via.size() ? "" : "does not pass via " + std::to_string(next);
}

/// Length of the straight line in one gear at the end of a path, which may turn by a microradian.
Real straight_end(const Path& path) {
  Real turn = 0, end = 0;
  for (std::size_t i = path.segments.size(); i > 0; --i) {
    const Segment& segment = path.segments[i - 1];
    if (end * segment.length < 0) break;
    const Real length = std::abs(Real{segment.length});
    const Real far = segment.curvature + Real{segment.curvature_rate} * length;
    turn += std::max(std::abs(Real{segment.curvature}), std::abs(far)) * length;
    if (turn > allowed_miss) break;
    end += segment.length;
  }
  return std::abs(end);
}

std::string flaw_of_end(const Scenario& scenario, const Path& path, const Drive& at) {
  const Real straight = straight_end(path) + allowed_miss;
  for (const GoalRegion& region : scenario.goal_set) {
    if (straight >= region.straight && is_of_region(scenario, region, at)) return "";
  }
  return flaw_at("ends at none of the goals", at.place);
}

}  // namespace

std::string naive_flaw(const Scenario& scenario, const Path& path) {
  if (path.start != scenario.start) return "begins elsewhere";
  const Look look(scenario, -allowed_depth);
  Drive at{{}, scenario.start.heading, scenario.hitch_angles.start};
  if (look.leaves_bounds(at.place)) return "starts outside the bounds";
  const std::string hit = look.hit(at.place, at.heading);
  if (!hit.empty()) return "hits " + hit + " at the start";
  if (scenario.vehicle.trailer) {
    std::string flaw = flaw_of_trailer(look, scenario.vehicle, at);
    if (!flaw.empty()) return flaw;
  }
  for (const Segment& segment : path.segments) {
    std::string flaw = drive(look, scenario.vehicle, segment, at);
    if (!flaw.empty()) return flaw;
  }
  if (std::string flaw = naive_look_at_zones(scenario, path).flaw; !flaw.empty()) return flaw;
  if (std::string flaw = flaw_of_vias(scenario, path); !flaw.empty()) return flaw;
  if (!scenario.goal_set.empty()) return flaw_of_end(scenario, path, at);
  const Pose& goal = scenario.goal;
  const Real dx = at.place.x - (Real{goal.x} - scenario.start.x);
  const Real dy = at.place.y - (Real{goal.y} - scenario.start.y);
  if (!(std::hypot(dx, dy) <= allowed_miss)) return flaw_at("ends beside the goal", {dx, dy});
  const Real turn = std::remainder(at.heading - goal.heading, 2 * pi);
  if (!(std::abs(turn) <= allowed_miss)) return flaw_at("ends turned", at.place);
  const Real fold = std::remainder(at.angle - scenario.hitch_angles.goal, 2 * pi);
  const bool is_folded = scenario.vehicle.trailer && !(std::abs(fold) <= allowed_miss);
  return is_folded ? flaw_at("ends folded", at.place) : "";
}

std::string naive_hit(const Scenario& scenario, const Pose& pose, double margin) {
  const Look look(scenario, margin);
  const Vector place{Real{pose.x} - scenario.start.x, Real{pose.y} - scenario.start.y};
  if (look.leaves_bounds(place)) return "bounds";
  return look.hit(place, pose.heading);
}

}  // namespace vandplan::nasty
