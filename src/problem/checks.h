// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Are the inputs of a user valid, and which key is wrong if not?
//
// The checks throw InputError naming the wrong key: `where`, or a key below it.

#include <string>
#include <vector>

#include "vandplan/geometry.h"
#include "vandplan/problem.h"

namespace vandplan::problem {

/// Throws unless -limit <= value <= limit; NaN throws, too.
void require_within(double value, double limit, const std::string& where);

/// Checks a pose in the scenario's frame: coordinates up to 10^12 m, headings up to 10^6 rad.
/// Errors name `where` with ".x", ".y" or ".heading".
void check_pose(const Pose& pose, const std::string& where);

/// Throws unless both headings are at most 10^6 rad and span at most a full turn.
void check_headings(const HeadingRange& range, const std::string& where);

/// Throws unless the vehicle can drive the curvature [1/m].
void check_curvature(double curvature, const Vehicle& vehicle, const std::string& where);

/// Throws unless the vehicle can drive both curvatures. Errors name "start.curvature" or
/// "goal.curvature".
void check_curvatures(const EndCurvatures& curvatures, const Vehicle& vehicle);

/// Throws unless the trailer may stand at the hitch angle [rad]. Without a trailer the angle must
/// be 0.
void check_hitch_angle(double angle, const Vehicle& vehicle, const std::string& where);

/// Throws unless the trailer may stand at both hitch angles. Errors name "start.hitch_angles" or
/// "goal.hitch_angles".
void check_hitch_angles(const EndHitchAngles& angles, const Vehicle& vehicle);

/// Checks the outline of a body: convex, and around the midpoint of the body's axle. An empty
/// outline is valid.
void check_outline(const Polygon& outline, const std::string& where);

/// Checks trailer, hitch and hitch limit of a vehicle with a trailer. Errors name
/// "vehicle.trailers[0].width" or another key.
void check_trailer(const Vehicle& vehicle);

/// Throws unless the goal is at most 100 km from the start.
void check_distance(const Pose& start, const Pose& goal, const std::string& where);

/// Checks the distance that a goal of a row counts [m]: 0 to 10^12.
void check_row_distance(double distance, const std::string& where);

/// Bounds moved from the scenario's frame into the frame of `origin`. They are cut to the largest
/// supported world, 10^6 m from the origin along each axis. Errors name "bounds.x" or "bounds.y".
[[nodiscard]] Bounds local_bounds(const Bounds& bounds, const Point& origin);

/// A polygon moved from the scenario's frame into the frame of `origin`, and cleaned. Throws unless
/// it is simple and within 10^6 m of the origin along each axis.
[[nodiscard]] Polygon local_polygon(const Polygon& polygon, const Point& origin,
                                    const std::string& where);

/// Polygons moved from the scenario's frame into the frame of `origin`, each as by `local_polygon`.
/// Errors name `name[i]`.
[[nodiscard]] std::vector<Polygon> local_polygons(const std::vector<Polygon>& polygons,
                                                  const Point& origin, const std::string& name);

/// A map moved from the scenario's frame into the frame of `origin`. Throws unless it is valid and
/// within 10^6 m of the origin along each axis. Errors name "map.resolution", "map.origin" or
/// "map".
[[nodiscard]] OccupancyGrid local_map(const OccupancyGrid& map, const Point& origin);

/// A point moved from the scenario's frame into the frame of `origin`. The subtraction is exact on
/// the decimal text of the coordinates.
[[nodiscard]] Point local_point(const Point& point, const Point& origin);
/// A pose moved from the scenario's frame into the frame of `origin`; heading in [-pi, pi).
[[nodiscard]] LocalPose local_pose(const Pose& pose, const Point& origin);

/// Origin of a world around `near`: `near` rounded to whole metres.
[[nodiscard]] Point local_origin(const Point& near);

}  // namespace vandplan::problem
