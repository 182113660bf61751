// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is what a user hands in good, and which key is wrong if not?
//
// Each function throws InputError naming the key it was given.

#include <string>
#include <vector>

#include "vandplan/occupancy_grid.h"
#include "vandplan/problem.h"

namespace vandplan::problem {

/// A number between -limit and limit; not a NaN.
void require_within(double value, double limit, const std::string& where);

/// A pose in the scenario's frame; errors name `where` and the coordinate.
void check_pose(const Pose& pose, const std::string& where);

/// A curvature that the vehicle can drive [1/m]; errors name `where`.
void check_curvature(double curvature, const Vehicle& vehicle, const std::string& where);

/// Curvatures that the vehicle can drive; errors name "start.curvature" or "goal.curvature".
void check_curvatures(const EndCurvatures& curvatures, const Vehicle& vehicle);

/// A hitch angle at which a trailer may stand [rad], 0 without one; errors name `where`.
void check_hitch_angle(double angle, const Vehicle& vehicle, const std::string& where);

/// Hitch angles at which a trailer may stand; errors name "start.hitch_angles" or
/// "goal.hitch_angles".
void check_hitch_angles(const EndHitchAngles& angles, const Vehicle& vehicle);

/// The outline of a body, if it has one: convex, and around the midpoint of its axle; errors name
/// `where`.
void check_outline(const Polygon& outline, const std::string& where);

/// The trailer of a vehicle that has one and how it hangs on it; errors name
/// "vehicle.trailers[0].width" or another key.
void check_trailer(const Vehicle& vehicle);

/// A goal that is near enough to its start.
void check_distance(const Pose& start, const Pose& goal, const std::string& where);

/// How far a goal counts in a row of goals [m].
void check_row_distance(double distance, const std::string& where);

/// Bounds of the scenario's frame in the frame of `origin`, cut to the largest world that is
/// supported: 10^6 m from the origin along each axis. Errors name "bounds.x" or "bounds.y".
[[nodiscard]] Bounds local_bounds(const Bounds& bounds, const Point& origin);

/// A polygon of the scenario's frame in the frame of `origin`, cleaned, simple, and no further from
/// it than the largest world reaches.
[[nodiscard]] Polygon local_polygon(const Polygon& polygon, const Point& origin,
                                    const std::string& where);

/// Polygons of the scenario's frame in the frame of `origin`, cleaned, simple, and no further from
/// it than the largest world reaches; errors name `name[i]`.
[[nodiscard]] std::vector<Polygon> local_polygons(const std::vector<Polygon>& polygons,
                                                  const Point& origin, const std::string& name);

/// A map of the scenario's frame in the frame of `origin`, no further from it than the largest
/// world reaches; errors name "map.resolution", "map.origin" or "map".
[[nodiscard]] OccupancyGrid local_map(const OccupancyGrid& map, const Point& origin);

/// A point of the scenario's frame in the frame of `origin`, exact on the decimals that were
/// written.
[[nodiscard]] Point local_point(const Point& point, const Point& origin);
[[nodiscard]] LocalPose local_pose(const Pose& pose, const Point& origin);

/// `near`, rounded to whole metres.
[[nodiscard]] Point local_origin(const Point& near);

}  // namespace vandplan::problem
