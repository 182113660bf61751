// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How does a tractor back its trailer up to a dock, and how far does the rig fold up?

#include <vandplan/planner.h>
#include <vandplan/vehicle.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

int main() {
  const double degrees = 180 / 3.141592653589793;
  vandplan::Scenario dock;
  dock.vehicle = {.wheelbase = 3.6,
                  .front_overhang = 1.4,
                  .rear_overhang = 0.9,
                  .width = 2.55,
                  .min_turning_radius = vandplan::turning_radius(3.6, 0.55),
                  .hitch = 0.6,  // hitch ahead of the rear axle [m]
                  .max_hitch_angle = 1.2,
                  .trailer = vandplan::Trailer{.wheelbase = 7.7, .front_overhang = 1.6}};
  dock.bounds = {-45, 45, -20, 40};
  dock.start = {-30, 25, 0};
  // The goal is a pose of the trailer's axle, with the tractor straight ahead of the trailer.
  const vandplan::Pose berth{0, -5, 3.141592653589793 / 2};
  dock.goal = vandplan::tractor_pose(dock.vehicle, berth, 0.0);
  dock.obstacles = {{{-45, -12}, {45, -12}, {45, -10.2}, {-45, -10.2}},  // the building
                    {{-6.3, -10}, {-3.7, -10}, {-3.7, 4}, {-6.3, 4}},    // trailers to either side
                    {{3.7, -10}, {6.3, -10}, {6.3, 4}, {3.7, 4}}};

  vandplan::PlanOptions options;
  options.budget.max_iterations = 5000;
  options.clearance.margin = 0.3;
  const vandplan::PlanResult result = vandplan::plan(dock, options);
  if (!result.path) return 1;
  const vandplan::PathCheck& check = *result.check;
  std::printf("%.2f m, %.2f m of it in reverse, gear changes: %d, %.2f m from everything\n",
              check.length, check.reverse_length, check.gear_changes, check.clearance.value_or(0));

  // The hitch angle with index i belongs to the point with index i.
  const auto points = vandplan::sampled(*result.path, 0.1);
  const auto angles = vandplan::sampled_hitch_angles(dock.vehicle, *result.path, 0.0, 0.1);
  const auto [least, largest] = std::minmax_element(angles.begin(), angles.end());
  std::printf("hitch angle: %.1f to %.1f degrees, at most %.1f are allowed\n", degrees * *least,
              degrees * *largest, degrees * dock.vehicle.max_hitch_angle);

  const vandplan::Pose end =
      vandplan::trailer_pose(dock.vehicle, {points.back().pose, angles.back()});
  const double off = std::hypot(end.x - berth.x, end.y - berth.y);
  std::printf("the trailer ends %.1f mm beside its berth, at %.1f degrees\n", 1e3 * off,
              degrees * end.heading);
  const double largest_angle = std::max(-*least, *largest);
  return off < 1e-5 && points.back().gear == vandplan::Gear::reverse && largest_angle > 0 &&
                 largest_angle <= dock.vehicle.max_hitch_angle
             ? 0
             : 1;
}
