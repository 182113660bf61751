// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "drive/watch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vandplan/judge.h"

namespace vandplan::driving {
namespace {

/// World with the same obstacles, without zones, and with bounds that no vehicle reaches: leaving
/// the bounds or breaking a rule is no contact.
struct Unbounded {
  std::shared_ptr<const World> world;
};

std::shared_ptr<const World> unbounded(const World& world) {
  const auto make = [&]() -> std::shared_ptr<const void> {
    constexpr double far = 1e6;  // half side of the bounds [m]; worlds reach no further
    Surroundings things = world.without_fences();
    things.bounds = {-far, far, -far, far};
    things.zones.clear();
    // A polygon that has shrunk to a point or a line gets its last corner repeated, up to three
    // corners.
    for (std::vector<Polygon>* polygons : {&things.obstacles, &things.kerbs}) {
      for (Polygon& polygon : *polygons) {
        while (polygon.size() < 3) polygon.push_back(polygon.back());
      }
    }
    return std::make_shared<const Unbounded>(
        Unbounded{std::make_shared<const World>(things, Point{})});
  };
  return std::static_pointer_cast<const Unbounded>(world.kept(typeid(Unbounded), make))->world;
}

double distance_outside(const Bounds& box, const Pose& pose) {
  const double dx = pose.x - std::clamp(pose.x, box.x_min, box.x_max);
  const double dy = pose.y - std::clamp(pose.y, box.y_min, box.y_max);
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

Watch::Watch(const Problem& problem, double spare)
    : world_(unbounded(*problem.world())),
      vehicle_(problem.vehicle()),
      bounds_(problem.world()->local().bounds) {
  // The judge shall check contacts alone. So any curvature is allowed, and the limit of the hitch
  // angle is checked here.
  vehicle_.min_turning_radius = 1e-3;
  most_hitch_angle_ = vehicle_.max_hitch_angle * (1 + spare);
  vehicle_.max_hitch_angle = 3.14;
  checker_ = world_->checker(vehicle_);
  for (const Footprint& part : {footprint(vehicle_), wheel_footprint(vehicle_)}) {
    const double x = std::max(part.rear, part.front);
    reach_ = std::max(reach_, std::sqrt(x * x + part.half_width * part.half_width));
  }
  if (!vehicle_.trailer) return;
  const double axle = vehicle_.trailer->wheelbase;
  for (const auto& [x, y] : body_outline(*vehicle_.trailer)) {
    trailer_reach_ = std::max(trailer_reach_, std::sqrt((x - axle) * (x - axle) + y * y));
  }
}

/// Upper bound of the motion of any point of vehicle and trailer on an arc [m].
double Watch::most_moved(const Segment& arc) const noexcept {
  const double way = std::abs(arc.length);
  const double bend = std::abs(arc.curvature);
  const double vehicle = way * (1 + reach_ * bend);
  if (!vehicle_.trailer) return vehicle;
  // The trailer turns around its hitch by at most the motion of the hitch over the wheelbase.
  const double hitch = way * (1 + std::abs(vehicle_.hitch) * bend);
  return std::max(vehicle, hitch * (1 + trailer_reach_ / vehicle_.trailer->wheelbase));
}

void Watch::look_at(const State& state) {
  constexpr double further = 2.0;  // distance beyond the least clearance that is searched [m]
  const double most = std::isinf(least_) ? 1e3 : least_ + further;
  const double clearance = checker_->clearance(Local(state), most);
  if (clearance < most) least_ = std::min(least_, clearance);
  free_ = clearance;
  nothing_ = std::isinf(least_) ? clearance : clearance - least_;
}

std::optional<std::string> Watch::look(const State& from, const Segment& arc, const State& to) {
  constexpr double rounding = 1e-6;  // rounding error of a hitch angle [rad]
  outside_ = std::max(outside_, distance_outside(bounds_, to.pose));
  if (has_touched_) return std::nullopt;
  if (std::abs(to.hitch_angle) > most_hitch_angle_ + rounding) {
    has_touched_ = true;
    least_ = 0.0;
    return "the rig folds up (jackknife)";
  }
  const double moved = most_moved(arc);
  const bool was_free = moved < free_ - CollisionChecker::tolerance;
  free_ -= moved;
  nothing_ -= moved;
  if (!was_free && !checker_->is_free(Local(from), arc)) {
    std::string what = touched(from, arc, to);
    if (!what.empty()) {
      has_touched_ = true;
      least_ = 0.0;
      return what;
    }
  }
  if (!was_free || nothing_ <= 0.0) look_at(to);
  return std::nullopt;
}

/// Reason why the judge rejects an arc; empty if it accepts it.
std::string Watch::touched(const State& from, const Segment& arc, const State& to) const {
  const Path path{from.pose, {arc}};
  const Problem problem = make_problem(world_, vehicle_, from.pose, end_pose(path), {},
                                       {from.hitch_angle, to.hitch_angle});
  return check_path(problem, path).reason;
}

}  // namespace vandplan::driving
