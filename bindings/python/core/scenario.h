// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is a scenario in Python?

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "vandplan/problem.h"
#include "vandplan/scenario_file.h"

namespace vandplan::python {

/// A scenario that was checked and does not change, with what its file wants of planners. Its world
/// is built when it is needed first, and shared with copies that differ in their poses; so are its
/// obstacles and its map, until one of these is asked for its own scenario.
class CheckedScenario {
 public:
  /// Throws InputError naming the key that is wrong.
  explicit CheckedScenario(Scenario scenario, std::vector<Setting> options = {});

  /// With Python's lock.
  [[nodiscard]] const Scenario& scenario() const;
  [[nodiscard]] const std::vector<Setting>& options() const noexcept { return options_; }

  /// The problem; with Python's lock, which it gives away while a world is built.
  [[nodiscard]] const Problem& problem() const;

  /// The one that differs in start and goal.
  [[nodiscard]] CheckedScenario with_poses(const Pose& start, const Pose& goal,
                                           const EndCurvatures& curvatures) const;

  /// The one that starts there, with a set of goals.
  [[nodiscard]] CheckedScenario with_goal_set(const Pose& start, const std::vector<GoalRegion>& set,
                                              double start_curvature) const;

  /// The one in which these move.
  [[nodiscard]] CheckedScenario with_moving(const std::vector<MovingObstacle>& moving) const;

  /// As files hold it.
  [[nodiscard]] ScenarioFile file() const { return {.scenario = scenario(), .options = options_}; }

 private:
  struct Ends {
    Pose start;
    Pose goal;
    EndCurvatures curvatures;
  };
  mutable std::shared_ptr<const Scenario> scenario_;
  mutable std::optional<Ends> ends_ = {};  // those of the scenario, where they differ
  std::vector<Setting> options_;
  mutable std::shared_ptr<const Problem> problem_;
};

/// A grid of an array, a resolution [m] and an origin. Throws InputError naming "grid" or a key of
/// it.
[[nodiscard]] OccupancyGrid grid_from(const pybind11::object& given, double resolution,
                                      const pybind11::object& origin, bool unknown_is_free);

/// A vehicle, the name of one, or a dict of its lengths.
[[nodiscard]] Vehicle vehicle_from(const pybind11::handle& given);

}  // namespace vandplan::python
