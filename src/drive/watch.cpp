// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "drive/watch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vandplan/path_check.h"

namespace vandplan::driving {
namespace {

/// What stands in a world, with bounds that nobody reaches: leaving them touches nothing.
struct Unbounded {
  std::shared_ptr<const World> world;
};

std::shared_ptr<const World> unbounded(const World& world) {
  const auto make = [&]() -> std::shared_ptr<const void> {
    constexpr double far = 1e6;  // worlds reach no further
    Surroundings things = world.local();
    things.bounds = {-far, far, -far, far};
    // A polygon that has shrunk to a point or a line has as many corners as one needs.
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

Watch::Watch(const Problem& problem)
    : world_(unbounded(*problem.world())),
      vehicle_(problem.vehicle()),
      bounds_(problem.world()->local().bounds) {
  // The judge is asked about the footprint alone: whatever the wheels do, it is not too sharp.
  vehicle_.min_turning_radius = 1e-3;
  checker_ = world_->checker(vehicle_);
  for (const Footprint& part : {footprint(vehicle_), wheel_footprint(vehicle_)}) {
    const double x = std::max(part.rear, part.front);
    reach_ = std::max(reach_, std::sqrt(x * x + part.half_width * part.half_width));
  }
}

void Watch::look_at(const Pose& pose) {
  constexpr double further = 2.0;  // than the least clearance so far [m]
  const double most = std::isinf(least_) ? 1e3 : least_ + further;
  const double clearance = checker_->clearance(pose, most);
  if (clearance < most) least_ = std::min(least_, clearance);
  free_ = clearance;
  nothing_ = std::isinf(least_) ? clearance : clearance - least_;
}

std::optional<std::string> Watch::look(const Pose& from, const Segment& arc, const Pose& to) {
  const double way = std::abs(arc.length);
  outside_ = std::max(outside_, distance_outside(bounds_, to));
  if (has_touched_) return std::nullopt;
  // No point of the vehicle moves further than this.
  const double moved = way * (1 + reach_ * std::abs(arc.curvature));
  const bool was_free = moved < free_ - CollisionChecker::tolerance;
  free_ -= moved;
  nothing_ -= moved;
  if (!was_free && !checker_->is_free(from, arc)) {
    std::string what = touched(from, arc);
    if (!what.empty()) {
      has_touched_ = true;
      least_ = 0.0;
      return what;
    }
  }
  if (!was_free || nothing_ <= 0.0) look_at(to);
  return std::nullopt;
}

/// The judge's word on one arc; empty if it finds nothing wrong.
std::string Watch::touched(const Pose& from, const Segment& arc) const {
  const Path path{from, {arc}};
  const Problem problem = make_problem(world_, vehicle_, from, end_pose(path));
  return check_path(problem, path).reason;
}

}  // namespace vandplan::driving
