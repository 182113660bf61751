// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "problem/zones.h"

#include <cmath>
#include <cstddef>
#include <string>

#include "base/text.h"
#include "problem/checks.h"
#include "problem/stops.h"
#include "vandplan/input_error.h"
#include "vandplan/problem.h"
#include "vandplan/vehicle.h"

namespace vandplan::problem {
namespace {

constexpr double most_cost = 1000.0;

void check_zone(const Zone& zone, const std::string& where) {
  if (zone.direction) check_headings(*zone.direction, where + ".direction");
  if (!(zone.cost >= 1.0 && zone.cost <= most_cost)) {
    throw InputError(where + ".cost",
                     "is " + base::shortest_text(zone.cost) + ", expected 1 to 1000");
  }
  if (zone.max_speed && !(*zone.max_speed > 0.0)) {
    throw InputError(where + ".max_speed",
                     "is " + base::shortest_text(*zone.max_speed) + ", expected more than 0 m/s");
  }
  const bool has_rule = zone.closed || zone.direction || zone.gears != AllowedGears::both;
  if (has_rule || zone.cost != 1.0 || zone.max_speed) return;
  throw InputError(where, "has no rule, expected closed, gears, direction, cost or max_speed");
}

}  // namespace

std::vector<Zone> local_zones(const std::vector<Zone>& zones, const Point& origin) {
  std::vector<Zone> local = zones;
  for (std::size_t i = 0; i < local.size(); ++i) {
    const std::string where = "zones[" + std::to_string(i) + "]";
    check_zone(local[i], where);
    local[i].area = local_polygon(local[i].area, origin, where + ".area");
  }
  return local;
}

}  // namespace vandplan::problem

namespace vandplan {

std::vector<SpeedLimit> speed_limits(const Task& task, const LocalState& from,
                                     std::span<const Segment> segments) {
  std::vector<SpeedLimit> limits;
  for (const double s : problem::stops_at_vias(task, from, segments)) limits.push_back({s, s, 0.0});
  if (!task.checker->has_speed_limits()) return limits;
  LocalState state = from;
  double s = 0.0;
  for (const Segment& segment : segments) {
    for (const GroundPart& part : task.checker->ground_along(state, segment)) {
      if (std::isinf(part.max_speed)) continue;
      limits.push_back({s + part.begin, s + part.end, part.max_speed});
    }
    s += std::abs(segment.length);
    state = advance(task.vehicle, state, segment);
  }
  return limits;
}

SpeedOptions speed_options(const Problem& problem, const Path& path) {
  const Task& task = problem.task();
  const State start{path.start, task.hitch_angles.start};
  return {.start_curvature = task.curvatures.start,
          .limits = speed_limits(task, to_local(*problem.world(), start), path.segments)};
}

SpeedOptions speed_options(const Scenario& scenario, const Path& path) {
  if (scenario.zones.empty() && scenario.masks.empty() && scenario.via.empty()) {
    return {.start_curvature = scenario.curvatures.start};
  }
  return speed_options(make_problem(scenario), path);
}

}  // namespace vandplan
