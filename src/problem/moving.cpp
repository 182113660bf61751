// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "problem/moving.h"

#include <string>

#include "base/text.h"
#include "problem/checks.h"
#include "vandplan/input_error.h"

namespace vandplan::problem {
namespace {

constexpr double latest = 1e6;          // largest |time| of a row [s]
constexpr double widest_outline = 1e3;  // largest |coordinate| of an outline [m]
constexpr double fastest_growth = 10;   // growth of an outline on all sides [m/s]
constexpr double furthest_row = 1e6;    // largest |coordinate| of a row in the world's frame [m]

TimedPose local_row(const TimedPose& row, const Point& origin, const std::string& where) {
  require_within(row.t, latest, where);
  check_pose(row.pose, where);
  const TimedPose local{row.t, local_pose(row.pose, origin)};
  require_within(local.pose.x, furthest_row, where);
  require_within(local.pose.y, furthest_row, where);
  return local;
}

MovingObstacle local_one(const MovingObstacle& given, const Point& origin,
                         const std::string& where) {
  for (const Point& corner : given.outline) {
    require_within(corner.x, widest_outline, where + ".outline");
    require_within(corner.y, widest_outline, where + ".outline");
  }
  MovingObstacle local{.outline = local_polygon(given.outline, {}, where + ".outline"),
                       .trajectory = {},
                       .after = given.after,
                       .inflate = given.inflate};
  const std::string rows = where + ".trajectory";
  if (given.trajectory.empty()) throw InputError(rows, "is empty, expected at least one row");
  for (const TimedPose& row : given.trajectory) {
    const std::string place = rows + "[" + std::to_string(local.trajectory.size()) + "]";
    if (!local.trajectory.empty() && !(row.t > local.trajectory.back().t)) {
      throw InputError(place, "has the time " + base::shortest_text(row.t) +
                                  ", expected more than that of the row before, " +
                                  base::shortest_text(local.trajectory.back().t));
    }
    local.trajectory.push_back(local_row(row, origin, place));
  }
  if (!(given.inflate >= 0.0 && given.inflate <= fastest_growth)) {
    throw InputError(where + ".inflate", "is " + base::shortest_text(given.inflate) +
                                             ", expected 0 to " +
                                             base::shortest_text(fastest_growth) + " m/s");
  }
  return local;
}

}  // namespace

std::vector<MovingObstacle> local_moving(std::span<const MovingObstacle> moving,
                                         const Point& origin) {
  std::vector<MovingObstacle> local;
  local.reserve(moving.size());
  for (const MovingObstacle& given : moving) {
    local.push_back(local_one(given, origin, "moving[" + std::to_string(local.size()) + "]"));
  }
  return local;
}

}  // namespace vandplan::problem
