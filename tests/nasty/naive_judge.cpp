// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "nasty/naive_judge.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace vandplan::nasty {
namespace {

using Real = long double;

constexpr Real pi = std::numbers::pi_v<Real>;

struct Vector {
  Real x = 0, y = 0;
};

struct Rectangle {
  Real x_min, x_max, y_min, y_max;
};

/// A convex body: what is to the left of all its sides, each moved outwards by a margin.
struct Body {
  struct Line {
    Vector outwards;  // unit vector
    Real offset;      // of the line from the origin, that way
    [[nodiscard]] Real beyond(const Vector& p) const {
      return outwards.x * p.x + outwards.y * p.y - offset;
    }
  };
  std::vector<Line> sides;
  std::vector<Vector> corners;  // where neighbouring sides meet
  Vector middle;
  Real reach = 0;
};

/// The corners in either order.
Body body_with(const Polygon& given, Real margin) {
  Body body;
  Real area = 0;
  for (std::size_t i = 0, j = given.size() - 1; i < given.size(); j = i++) {
    area += Real{given[j].x} * given[i].y - Real{given[j].y} * given[i].x;
    body.middle.x += Real{given[i].x} / given.size();
    body.middle.y += Real{given[i].y} / given.size();
  }
  for (std::size_t i = 0, j = given.size() - 1; i < given.size(); j = i++) {
    const Real dx = Real{given[i].x} - given[j].x;
    const Real dy = Real{given[i].y} - given[j].y;
    const Real length = area > 0 ? std::hypot(dx, dy) : -std::hypot(dx, dy);
    const Vector outwards{dy / length, -dx / length};
    body.sides.push_back({outwards, outwards.x * given[i].x + outwards.y * given[i].y + margin});
  }
  for (std::size_t i = 0, j = body.sides.size() - 1; i < body.sides.size(); j = i++) {
    const auto& [n, c] = body.sides[j];
    const auto& [m, d] = body.sides[i];
    const Real sine = n.x * m.y - n.y * m.x;
    body.corners.push_back({(c * m.y - d * n.y) / sine, (d * n.x - c * m.x) / sine});
  }
  for (const Vector& c : body.corners) body.reach = std::max(body.reach, std::hypot(c.x, c.y));
  return body;
}

Polygon rectangle(double rear, double front, double half_width) {
  return {{rear, -half_width}, {front, -half_width}, {front, half_width}, {rear, half_width}};
}

Body body_of(const Vehicle& v, Real margin) {
  if (!v.outline.empty()) return body_with(v.outline, margin);
  return body_with(rectangle(-v.rear_overhang, v.wheelbase + v.front_overhang, v.width / 2),
                   margin);
}

Body body_of(const Trailer& t, Real margin) {
  if (!t.outline.empty()) return body_with(t.outline, margin);
  return body_with(rectangle(-t.rear_overhang, t.wheelbase + t.front_overhang, t.width / 2),
                   margin);
}

Body wheels_of(const Vehicle& v, Real margin) {
  return body_with(rectangle(0, v.wheelbase, v.track_width.value_or(v.width) / 2), margin);
}

/// Where something is in a frame of somebody else: in the vehicle's or in the map's.
struct Frame {
  Vector origin;
  Real cosine, sine;

  [[nodiscard]] Vector seen(const Vector& p) const {
    const Real x = p.x - origin.x;
    const Real y = p.y - origin.y;
    return {cosine * x + sine * y, cosine * y - sine * x};
  }
  [[nodiscard]] Vector placed(const Vector& p) const {
    return {origin.x + cosine * p.x - sine * p.y, origin.y + sine * p.x + cosine * p.y};
  }
};

Frame frame_at(const Vector& origin, Real heading) {
  return {origin, std::cos(heading), std::sin(heading)};
}

/// Whether a part of the side lies inside the open body (Cyrus and Beck 1978).
bool runs_through(const Vector& a, const Vector& b, const Body& body) {
  Real begin = 0;
  Real end = 1;
  for (const Body::Line& side : body.sides) {
    const Real first = side.beyond(a);
    const Real last = side.beyond(b);
    if (first >= 0 && last >= 0) return false;
    if (first < 0 && last < 0) continue;
    const Real crossing = first / (first - last);
    (first > 0 ? begin : end) = first > 0 ? std::max(begin, crossing) : std::min(end, crossing);
  }
  if (begin > end) return false;
  const Real middle = (begin + end) / 2;
  const Vector p{a.x + middle * (b.x - a.x), a.y + middle * (b.y - a.y)};
  return std::ranges::all_of(body.sides, [&](const auto& side) { return side.beyond(p) < 0; });
}

bool holds(const std::vector<Vector>& polygon, const Vector& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector& a = polygon[j];
    const Vector& b = polygon[i];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

/// A polygon whose corners count from the start, and a box around it.
struct Thing {
  std::string name;
  std::vector<Vector> corners;
  Rectangle box;
};

Thing thing_of(const std::string& name, const Polygon& polygon, const Pose& start) {
  constexpr Real far = 1e300;
  Thing thing{name, {}, {far, -far, far, -far}};
  for (const Point& p : polygon) {
    const Vector corner{Real{p.x} - start.x, Real{p.y} - start.y};
    thing.corners.push_back(corner);
    thing.box = {std::min(thing.box.x_min, corner.x), std::max(thing.box.x_max, corner.x),
                 std::min(thing.box.y_min, corner.y), std::max(thing.box.y_max, corner.y)};
  }
  return thing;
}

bool hits(const Thing& thing, const Body& body, const Frame& vehicle) {
  std::vector<Vector> seen;
  for (const Vector& corner : thing.corners) seen.push_back(vehicle.seen(corner));
  for (std::size_t i = 0, j = seen.size() - 1; i < seen.size(); j = i++) {
    if (runs_through(seen[j], seen[i], body)) return true;
  }
  return holds(seen, body.middle);
}

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
    if (!scenario.map) return;
    const Pose& origin = scenario.map->origin;
    map_ = frame_at({Real{origin.x} - scenario.start.x, Real{origin.y} - scenario.start.y},
                    origin.heading);
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
    return scenario_.map && hits_map(body, vehicle) ? "map" : "";
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
  [[nodiscard]] bool hits_map(const Body& body, const Frame& vehicle) const {
    const OccupancyGrid& grid = *scenario_.map;
    const Real side = grid.resolution;
    Rectangle near{1e300L, -1e300L, 1e300L, -1e300L};
    for (const Vector& corner : body.corners) {
      const Vector p = map_.seen(vehicle.placed(corner));
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
        if (is_blocked(grid, column, row) && hits_cell(body, vehicle, column, row)) return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool hits_cell(const Body& body, const Frame& vehicle, std::int32_t column,
                               std::int32_t row) const {
    const Real side = scenario_.map->resolution;
    Thing cell;
    for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      cell.corners.push_back(map_.placed({side * (column + right), side * (row + up)}));
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
  Frame map_{};
};

/// A vehicle on its way, its place counted from the start.
struct Drive {
  Vector place;
  Real heading;
  Real angle;  ///< at the hitch, if there is a trailer

  /// A step so short that three Gauss nodes are exact to the last digits.
  void step(Real curvature, Real rate, Real signed_step) {
    const Real gear = signed_step < 0 ? -1 : 1;
    const Real driven = std::abs(signed_step);
    const auto heading_at = [&](Real t) { return heading + gear * t * (curvature + rate * t / 2); };
    const Real node = std::sqrt(Real{3} / 5);
    for (const auto& [at, weight] : {std::pair<Real, Real>{-node, 5}, {0, 8}, {node, 5}}) {
      const Real there = heading_at(driven / 2 * (1 + at));
      place.x += signed_step * weight / 18 * std::cos(there);
      place.y += signed_step * weight / 18 * std::sin(there);
    }
    heading = heading_at(driven);
  }

  /// What that does to the hitch angle, by small steps of Runge and Kutta.
  void fold(const Vehicle& vehicle, Real curvature, Real rate, Real signed_step) {
    const Real gear = signed_step < 0 ? -1 : 1;
    const Real driven = std::abs(signed_step);
    const Real hitch = vehicle.hitch, wheelbase = vehicle.trailer->wheelbase;
    const auto slope = [&](Real t, Real a) {
      const Real k = curvature + rate * t;
      return gear * (k - (std::sin(a) + hitch * k * std::cos(a)) / wheelbase);
    };
    const Real steepest = std::max(std::abs(curvature), std::abs(curvature + rate * driven));
    const Real pace = (1 + std::abs(hitch) * steepest) / wheelbase + steepest;
    const auto steps = 1 + static_cast<long>(std::min<Real>(256 * driven * pace, 1e6L));
    const Real h = driven / steps;
    for (long i = 0; i < steps; ++i) {
      const Real t = h * i;
      const Real first = slope(t, angle);
      const Real second = slope(t + h / 2, angle + h / 2 * first);
      const Real third = slope(t + h / 2, angle + h / 2 * second);
      angle += h / 6 * (first + 2 * second + 2 * third + slope(t + h, angle + h * third));
    }
  }
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

Real from_segment(const Vector& p, const Vector& a, const Vector& b) {
  const Vector along{b.x - a.x, b.y - a.y};
  const Real square = along.x * along.x + along.y * along.y;
  Real t = square > 0 ? ((p.x - a.x) * along.x + (p.y - a.y) * along.y) / square : 0;
  t = std::min(std::max(t, Real{0}), Real{1});
  return std::hypot(p.x - a.x - t * along.x, p.y - a.y - t * along.y);
}

/// How far a place is from an area: by the angles under which it sees the sides whether it is in
/// it.
Real from_area(const Polygon& area, const Pose& origin, const Vector& p) {
  Real turns = 0;
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Point& from = area[i];
    const Point& to = area[(i + 1) % area.size()];
    const Vector a{Real{from.x} - origin.x, Real{from.y} - origin.y};
    const Vector b{Real{to.x} - origin.x, Real{to.y} - origin.y};
    least = std::min(least, from_segment(p, a, b));
    turns +=
        std::remainder(std::atan2(b.y - p.y, b.x - p.x) - std::atan2(a.y - p.y, a.x - p.x), 2 * pi);
  }
  return std::abs(turns) > pi ? 0 : least;
}

Real beyond(Real value, Real least, Real most) {
  return std::max({least - value, value - most, Real{0}});
}

/// How far a heading is beyond all of a range, counter-clockwise from the first to the last.
Real beyond_headings(Real heading, const HeadingRange& range) {
  Real width = Real{range.to} - range.from;
  while (width < 0) width += 2 * pi;
  Real after = std::fmod(heading - range.from, 2 * pi);
  if (after < 0) after += 2 * pi;
  return after <= width ? 0 : std::min(after - width, 2 * pi - after);
}

bool is_of_region(const Scenario& scenario, const GoalRegion& region, const Drive& at) {
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
      !(beyond(fold, region.hitch_angle.least, region.hitch_angle.most) <= allowed_miss);
  return off <= allowed_miss && turn <= allowed_miss && !is_folded;
}

std::string flaw_of_end(const Scenario& scenario, const Drive& at) {
  for (const GoalRegion& region : scenario.goal_set) {
    if (is_of_region(scenario, region, at)) return "";
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
  if (!scenario.goal_set.empty()) return flaw_of_end(scenario, at);
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
