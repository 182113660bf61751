// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/out_of_reach.h"

#include <cstddef>

#include "planners/goal_poses.h"
#include "search/zone_bound.h"

namespace vandplan::planning {

bool is_out_of_reach(const Task& task, const std::vector<GoalRegion>& regions,
                     search::GearSign only, const search::Budget& budget) {
  constexpr int most_steps = 20'000;
  std::vector<Bounds> places;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    for (const RegionPart& part : whole(regions[i], i)) {
      places.push_back(placed(task.vehicle, regions[i], part).box);
    }
  }
  search::ZoneBound flood(task, only, {}, places);
  for (int i = 0; i < most_steps && !budget.is_interrupted() && flood.step(); ++i) {
  }
  return flood.is_proven();
}

}  // namespace vandplan::planning
