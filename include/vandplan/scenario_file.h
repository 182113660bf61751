// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do I read problems, ours or other people's?
//
// Formats: docs/formats.md. Every error is an InputError "file:line: what is wrong, what was
// expected".

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/planner.h"
#include "vandplan/problem.h"

namespace vandplan {

/// One goal of a row, with obstacles that exist for this goal only.
struct RowGoal {
  double distance = 0.0;  ///< how far this goal counts [m]
  Pose goal = {};
  std::vector<Polygon> obstacles = {};
  double curvature = 0.0;    ///< `EndCurvatures::goal` of this goal [1/m]
  double hitch_angle = 0.0;  ///< `EndHitchAngles::goal` of this goal [rad]
};

/// What a scenario file says: one problem (`goal:`), or a row of problems that differ in their
/// goals (`goals:`), of which the furthest one reached counts.
struct ScenarioFile {
  Scenario scenario = {};         ///< of a row what its problems share; its goal is the first one
  std::vector<RowGoal> row = {};  ///< empty for `goal:`
  /// What the file wants of every planner that honours it, `set_honoured`: no option of the budget.
  std::vector<Setting> options = {};
  /// What deserves a look though nothing is wrong, "file:line: key: what".
  std::vector<std::string> warnings = {};

  [[nodiscard]] bool is_row() const noexcept { return !row.empty(); }
  /// Number of problems.
  [[nodiscard]] std::size_t size() const noexcept { return is_row() ? row.size() : 1; }
};

/// A scenario file and the checked problems that it states.
struct ScenarioProblems {
  ScenarioFile file;
  std::vector<Problem> problems;  ///< those without obstacles of their own share one world
};

/// Problem number `i` of a file, with all of its obstacles. `i` < size().
[[nodiscard]] Scenario scenario_at(const ScenarioFile& file, std::size_t i);

/// The problems of a file. Throws InputError naming the key that is wrong
/// ("goals[3].obstacles[0]").
[[nodiscard]] std::vector<Problem> make_problems(const ScenarioFile& file);

/// Reads and checks a scenario file (YAML) with one goal. "-" is standard input.
[[nodiscard]] Scenario read_scenario(const std::string& file);

/// Reads and checks a scenario file (YAML) with one goal or a row of goals. "-" is standard input.
[[nodiscard]] ScenarioFile read_scenario_file(const std::string& file);

/// Reads a scenario file and makes its problems: everything is checked once.
[[nodiscard]] ScenarioProblems read_problems(const std::string& file);

/// Reads and checks the text of a scenario file; `where` stands for the file in errors, and the map
/// is looked for beside it unless it is here.
[[nodiscard]] ScenarioFile scenario_from_yaml(const std::string& text, const std::string& where,
                                              const std::optional<OccupancyGrid>& map = {});

/// A scenario file's text that `read_scenario_file` reads back exactly; the map stays in its own.
[[nodiscard]] std::string to_yaml(const ScenarioFile& file);
[[nodiscard]] std::string to_yaml(const Scenario& scenario);

/// Reads a map of ROS' map_server: its YAML file and the image that it names.
[[nodiscard]] OccupancyGrid read_map(const std::string& file);

/// Whether a YAML file is a map, that is, names an image; scenarios do not.
[[nodiscard]] bool is_map(const std::string& file);

/// A map as an image (PGM) and as the YAML file that names the image; `read_map` reads them back.
[[nodiscard]] std::string map_to_pgm(const OccupancyGrid& grid);
[[nodiscard]] std::string map_to_yaml(const OccupancyGrid& grid, const std::string& image);

/// A vehicle of the catalogue, "city-bus". Throws InputError if there is none of that name.
[[nodiscard]] Vehicle vehicle_named(std::string_view name);
[[nodiscard]] std::vector<std::string> vehicle_names();

/// Reads and checks a vehicle file (YAML): what stands below `vehicle:` of a scenario.
[[nodiscard]] Vehicle read_vehicle(const std::string& file);

/// The text of a vehicle file that `read_vehicle` reads back exactly, one line.
[[nodiscard]] std::string to_yaml(const Vehicle& vehicle);

/// The footprint of a robot of Nav2, and what it does not say.
struct FootprintFile {
  std::string file;                 ///< a list of corners, or parameters of Nav2 (YAML)
  double wheelbase = 0.0;           ///< rear axle to front axle [m]
  double min_turning_radius = 0.0;  ///< of the rear-axle midpoint [m]
  double rear_axle = 0.0;           ///< x of the rear axle in the frame of the footprint [m]
  bool rectangle = false;           ///< put a rectangle around any footprint
};

/// A vehicle with a convex footprint as its outline, or whose rectangle holds a footprint.
struct FootprintVehicle {
  Vehicle vehicle;
  double footprint_area = 0.0;  ///< [m^2]
  double added_area = 0.0;      ///< of the body beside the footprint [m^2]
  double added_width = 0.0;     ///< as the rectangle reaches equally far to both sides [m]
};

/// Reads the corners of a footprint, x ahead and y to the left, and makes a vehicle of them.
/// Throws InputError if there is none, there are several, or an axle is outside of it.
[[nodiscard]] FootprintVehicle read_footprint(const FootprintFile& footprint);

/// Where a path begins and ends, in the scenario's frame.
struct PosePair {
  Pose start;
  Pose goal;
};

/// Many starts and goals.
struct PosePairs {
  std::vector<PosePair> pairs;
  /// What deserves a look though nothing is wrong, "file:line: what".
  std::vector<std::string> warnings;
};

/// Reads a list of starts and goals (CSV). "-" is standard input.
[[nodiscard]] PosePairs read_pose_pairs(const std::string& file);

/// Reads a case of the Trajectory Planning Competition for Automated Parking 2022 (CSV).
[[nodiscard]] Scenario read_tpcap(const std::string& file);

/// One of the problems on a MovingAI map.
struct MovingAiProblem {
  std::string map;                    ///< file (.map)
  std::string problems;               ///< file (.scen)
  int number = 1;                     ///< of the problem in its file; >= 1
  double resolution = 1.0;            ///< side of a cell [m]; > 0
  std::string vehicle = "tpcap-car";  ///< of the catalogue
};

/// Reads a MovingAI problem; the scenario has a map, but `map_file` is still to be named.
[[nodiscard]] Scenario read_movingai(const MovingAiProblem& problem);

/// Reads a problem in the manner of dynobench (YAML): one car among boxes. Where its states have a
/// trailer and the vehicle has none, dynobench's own `car1_v0` drives.
[[nodiscard]] Scenario read_dynobench(const std::string& file, const std::string& vehicle);

}  // namespace vandplan
