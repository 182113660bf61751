// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Python see a scenario?

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "vandplan/files.h"
#include "vandplan/problem.h"

namespace vandplan::python {

/// Checked, immutable scenario with the planner options of its file. The world is built at first
/// use and shared with copies that differ in their poses. Obstacles and map are shared too, until a
/// copy's own `scenario()` is called.
class CheckedScenario {
 public:
  /// Throws InputError naming the key that is wrong.
  explicit CheckedScenario(Scenario scenario, std::vector<Setting> options = {});

  /// Scenario; requires Python's lock.
  [[nodiscard]] const Scenario& scenario() const;
  [[nodiscard]] const std::vector<Setting>& options() const noexcept { return options_; }

  /// Problem; requires Python's lock, and releases it while a world is built.
  [[nodiscard]] const Problem& problem() const;

  /// Copy with another start and goal.
  [[nodiscard]] CheckedScenario with_poses(const Pose& start, const Pose& goal,
                                           const EndCurvatures& curvatures) const;

  /// Copy with another start and a set of goals.
  [[nodiscard]] CheckedScenario with_goal_set(const Pose& start, const std::vector<GoalRegion>& set,
                                              double start_curvature) const;

  /// Copy with other moving obstacles.
  [[nodiscard]] CheckedScenario with_moving(const std::vector<MovingObstacle>& moving) const;

  /// Copy with other vias.
  [[nodiscard]] CheckedScenario with_via(const std::vector<Via>& via) const;

  /// Content of a scenario file.
  [[nodiscard]] ScenarioFile file() const { return {.scenario = scenario(), .options = options_}; }

 private:
  struct Ends {
    Pose start;
    Pose goal;
    EndCurvatures curvatures;
  };
  /// Copy with this problem, of this scenario.
  [[nodiscard]] CheckedScenario with(Problem problem, Scenario scenario) const;

  mutable std::shared_ptr<const Scenario> scenario_;
  /// Ends of the scenario where they differ from `scenario_`.
  mutable std::optional<Ends> ends_ = {};
  std::vector<Setting> options_;
  mutable std::shared_ptr<const Problem> problem_;
};

/// State of a scenario for pickle, and the scenario of a state.
[[nodiscard]] pybind11::tuple state_of_scenario(const CheckedScenario& self);
[[nodiscard]] CheckedScenario scenario_from_state(const pybind11::tuple& state);

/// State of a mask for pickle, and the mask of a state.
[[nodiscard]] pybind11::tuple state_of_mask(const Mask& self);
[[nodiscard]] Mask mask_from_state(const pybind11::tuple& state);

/// Map from an array, a resolution [m] and an origin. Throws InputError naming "map" or one of its
/// keys.
[[nodiscard]] OccupancyGrid grid_from(const pybind11::object& given, double resolution,
                                      const pybind11::object& origin, bool unknown_is_free);

/// Vehicle from a `Vehicle`, a name, or a dict of lengths. None gives the default vehicle.
[[nodiscard]] Vehicle vehicle_from(const pybind11::handle& given);

}  // namespace vandplan::python
