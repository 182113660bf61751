// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do files become values, and values files?

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/graphs.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"
#include "vandplan/site_table.h"

namespace vandplan {

// ---- How are files read whole, and written whole or not at all? ----
//
// A file is written beside its place and then renamed. The old file stays until the new one is
// complete.

/// All bytes of a file; "-" is standard input. Throws InputError naming the file if it cannot be
/// read or holds more than `largest` bytes.
[[nodiscard]] std::string read_file(const std::string& file, std::size_t largest);

/// All bytes of a table file (tables.h), checked; "-" is standard input. Throws InputError
/// naming the file if it is foreign, truncated, altered, or longer than it says. No more is read
/// than its head promises.
[[nodiscard]] std::string read_table_file(const std::string& file);

/// The table of a site in a file (site_table.h), checked; "-" is standard input. The table looks
/// into the file as long as it lives, so that many processes share one copy in memory. Replace such
/// a file, as `write_file` does; do not write over it. Throws InputError naming the file if it is
/// foreign, truncated, altered, or of another version.
[[nodiscard]] SiteTable read_site_table(const std::string& file);

/// Throws InputError naming the file if `write_file` cannot write it, as far as can be told
/// beforehand.
void expect_writable(const std::string& file);

/// A file that is written piece by piece, and is whole or not at all. The old file stays until
/// `commit`, and for ever without it. "-" is standard output. Standard output and pipes get every
/// piece at once. All functions throw InputError naming the file if it cannot be written.
class FileWriter {
 public:
  /// Begins to write the file.
  explicit FileWriter(const std::string& file);
  ~FileWriter();
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  /// Writes a piece.
  void write(std::string_view content);
  /// Puts the written file in the place of the old one.
  void commit();

 private:
  struct Target;
  std::unique_ptr<Target> target_;
};

/// Writes all of `content` to a file; "-" is standard output. If that fails, the old file stays,
/// and InputError names the file.
void write_file(const std::string& file, std::string_view content);

// ---- Is a heading likely meant in degrees? ----

/// Doubt about a heading of more than a full turn [rad], which is likely meant in degrees. The text
/// is one line that says how many radians so many degrees are. It is empty if there is no doubt.
[[nodiscard]] std::string heading_doubt(double heading);

// ---- How do I read problems, ours or other people's? ----
//
// Formats: docs/formats.md. Every error is an InputError "file:line: what is wrong, what was
// expected".

/// One goal of a row, with obstacles that exist for this goal only.
struct RowGoal {
  double distance = 0.0;                ///< distance that this goal counts [m]
  Pose goal = {};                       ///< pose of the goal
  std::vector<Polygon> obstacles = {};  ///< obstacles for this goal only [m]
  double curvature = 0.0;               ///< `EndCurvatures::goal` of this goal [1/m]
  double hitch_angle = 0.0;             ///< `EndHitchAngles::goal` of this goal [rad]
};

/// A place on the ellipsoid WGS84 [degrees].
struct GeoPlace {
  double longitude = 0.0;
  double latitude = 0.0;
  bool operator==(const GeoPlace&) const = default;
};

/// Content of a scenario file: one problem (`goal:`), or a row of problems that differ in their
/// goals (`goals:`). The furthest goal of a row that is reached counts.
struct ScenarioFile {
  /// The scenario. For a row it is what its problems share, with the first goal as its goal.
  Scenario scenario = {};
  std::vector<RowGoal> row = {};  ///< goals of the row; empty for `goal:`
  /// Options that the file wants of every planner that honours them (`set_honoured`), none of the
  /// budget.
  std::vector<Setting> options = {};
  /// Place of each option in the file, for messages: "yard.yaml:12: options.margin".
  std::vector<std::string> option_places = {};
  /// Doubtful values that are not wrong: "file:line: key: what".
  std::vector<std::string> warnings = {};
  /// Place of the scenario's origin on Earth, with x to the east and y to the north. None: unknown.
  std::optional<GeoPlace> origin = {};

  /// Whether the file states a row of goals.
  [[nodiscard]] bool is_row() const noexcept { return !row.empty(); }
  /// Number of problems.
  [[nodiscard]] std::size_t size() const noexcept { return is_row() ? row.size() : 1; }
};

/// A scenario file and the checked problems that it states.
struct ScenarioProblems {
  ScenarioFile file;
  std::vector<Problem> problems;  ///< the problems; those without own obstacles share one world
};

/// Problem number `i` of a file, with all of its obstacles. Throws InputError naming "goals" unless
/// i < size().
[[nodiscard]] Scenario scenario_at(const ScenarioFile& file, std::size_t i);

/// The problems of a file. Throws InputError naming the key that is wrong
/// ("goals[3].obstacles[0]").
[[nodiscard]] std::vector<Problem> make_problems(const ScenarioFile& file);

/// Reads and checks a scenario file (YAML) with one goal. "-" is standard input. Throws InputError
/// "file:line: what is wrong", also for a row of goals.
[[nodiscard]] Scenario read_scenario(const std::string& file);

/// Reads and checks a scenario file (YAML) with one goal or a row of goals. "-" is standard input.
/// Throws InputError "file:line: what is wrong".
[[nodiscard]] ScenarioFile read_scenario_file(const std::string& file);

/// Reads a scenario file and makes its problems; everything is checked once. "-" is standard input.
/// Throws InputError "file:line: what is wrong".
[[nodiscard]] ScenarioProblems read_problems(const std::string& file);

/// Reads and checks the text of a scenario file. `where` stands for the file in errors. The map is
/// read from beside that file unless `map` is given.
[[nodiscard]] ScenarioFile scenario_from_yaml(const std::string& text, const std::string& where,
                                              const std::optional<OccupancyGrid>& map = {});

/// Text of a scenario file that `read_scenario_file` reads back exactly. The map stays in its own
/// file.
[[nodiscard]] std::string to_yaml(const ScenarioFile& file);
/// Text of a scenario file with one goal that `read_scenario` reads back exactly.
[[nodiscard]] std::string to_yaml(const Scenario& scenario);

/// Reads a map of ROS' map_server: its YAML file and the image that it names. Throws InputError
/// "file:line: what is wrong".
[[nodiscard]] OccupancyGrid read_map(const std::string& file);

/// Whether a YAML file is a map, that is, names an image; scenarios do not. Throws InputError
/// "file:line: what is wrong" for other text than YAML.
[[nodiscard]] bool is_map(const std::string& file);

/// A map as the bytes of an image (PGM). Throws InputError naming "map" or another key if
/// `check_map` refuses the map.
[[nodiscard]] std::string map_to_pgm(const OccupancyGrid& grid);
/// A map as the YAML text that names the image file `image`. `read_map` reads text and image back.
[[nodiscard]] std::string map_to_yaml(const OccupancyGrid& grid, const std::string& image);

/// `map_to_pgm` and `map_to_yaml` of a mask: with its percentages, if it has them, as a map of mode
/// raw.
[[nodiscard]] std::string mask_to_pgm(const Mask& mask);
[[nodiscard]] std::string mask_to_yaml(const Mask& mask, const std::string& image);

/// The vehicle of the catalogue with that name, such as "city-bus". Throws InputError naming
/// "vehicle" if there is none.
[[nodiscard]] Vehicle vehicle_named(std::string_view name);
/// Names of all vehicles of the catalogue.
[[nodiscard]] std::vector<std::string> vehicle_names();

/// Reads and checks a vehicle file (YAML), which holds the keys below `vehicle:` of a scenario. "-"
/// is standard input. Throws InputError "file:line: what is wrong".
[[nodiscard]] Vehicle read_vehicle(const std::string& file);

/// Text of a vehicle file that `read_vehicle` reads back exactly, one line.
[[nodiscard]] std::string to_yaml(const Vehicle& vehicle);

/// The footprint of a robot of Nav2, and what its file does not say.
struct FootprintFile {
  std::string file;        ///< file with a list of corners, or with parameters of Nav2 (YAML)
  double wheelbase = 0.0;  ///< rear axle to front axle [m]
  double min_turning_radius = 0.0;  ///< turning radius of the rear-axle midpoint [m]
  double rear_axle = 0.0;           ///< x of the rear axle in the frame of the footprint [m]
  bool rectangle = false;           ///< whether any footprint gets a rectangle around it
};

/// A vehicle whose outline is a convex footprint, or whose rectangle holds a footprint.
struct FootprintVehicle {
  Vehicle vehicle;
  double footprint_area = 0.0;  ///< area of the footprint [m^2]
  double added_area = 0.0;      ///< area of the body beyond the footprint [m^2]
  /// Width that is added because the rectangle reaches equally far to both sides [m].
  double added_width = 0.0;
};

/// Reads the corners of a footprint, x ahead and y to the left, and makes a vehicle of them. Throws
/// InputError naming the file if there is no footprint, there are several, or an axle is outside of
/// it.
[[nodiscard]] FootprintVehicle read_footprint(const FootprintFile& footprint);

/// Start and goal of a path, in the scenario's frame.
struct PosePair {
  Pose start;
  Pose goal;
};

/// Many starts and goals.
struct PosePairs {
  std::vector<PosePair> pairs;
  std::vector<int> lines;  ///< line of each pair in the file, counted from 1
  /// Doubtful values that are not wrong: "file:line: what".
  std::vector<std::string> warnings;
};

/// Reads a list of starts and goals (CSV). "-" is standard input. Throws InputError "file:line:
/// what is wrong".
[[nodiscard]] PosePairs read_pose_pairs(const std::string& file);

/// Many poses, in the scenario's frame.
struct Poses {
  std::vector<Pose> poses;
  std::vector<int> lines;  ///< line of each pose in the file, counted from 1
  /// Doubtful values that are not wrong: "file:line: what".
  std::vector<std::string> warnings;
};

/// Reads a list of poses (CSV): x, y, heading. "-" is standard input. Throws InputError "file:line:
/// what is wrong".
[[nodiscard]] Poses read_poses(const std::string& file);

/// Reads a case of the Trajectory Planning Competition for Automated Parking 2022 (CSV). Throws
/// InputError "file:line: what is wrong".
[[nodiscard]] Scenario read_tpcap(const std::string& file);

/// One of the problems on a MovingAI map.
struct MovingAiProblem {
  std::string map;                    ///< name of the map's file (.map)
  std::string problems;               ///< name of the file of problems (.scen)
  int number = 1;                     ///< number of the problem in its file; >= 1
  double resolution = 1.0;            ///< side of a cell [m]; > 0
  std::string vehicle = "tpcap-car";  ///< vehicle of the catalogue
};

/// Reads a MovingAI problem. The scenario has a map, but its `map_file` is empty. Throws InputError
/// "file:line: what is wrong", or naming "resolution", "number" or "vehicle".
[[nodiscard]] Scenario read_movingai(const MovingAiProblem& problem);

/// Reads a problem in the manner of dynobench (YAML): one car among boxes. `vehicle` is one of the
/// catalogue. If the file's states have a trailer and the vehicle has none, dynobench's own
/// `car1_v0` drives. Throws InputError "file:line: what is wrong", or naming "vehicle".
[[nodiscard]] Scenario read_dynobench(const std::string& file, const std::string& vehicle);

// ---- How does a site that somebody drew on a map become a scenario? ----
//
// Which features become what: docs/formats.md. Every error is an InputError "file:line: what is
// wrong, what was expected".

/// A site file, and what it does not say.
struct GeoJsonSite {
  std::string file = {};      ///< file name; "-" is standard input
  Vehicle vehicle = {};       ///< vehicle that drives there
  bool is_in_metres = false;  ///< whether coordinates are metres, whatever the file says
  /// Start that replaces the one of the file: x and y in its coordinates, heading [rad].
  std::optional<Pose> start = {};
  /// Goal that replaces the one of the file: x and y in its coordinates, heading [rad].
  std::optional<Pose> goal = {};
  /// Width of lines and points that do not state theirs [m]; 0.001 to 1000.
  double default_width = 0.2;
};

/// The scenario of a site.
struct GeoJsonScenario {
  Scenario scenario = {};
  /// Place of the scenario's origin on Earth, with x to the east and y to the north. None: the
  /// coordinates of the file are metres and were used as they are.
  std::optional<GeoPlace> origin = {};
  /// Features that were left out or changed: "left out: highway 3".
  std::vector<std::string> notes = {};
  /// Doubtful values that are not wrong: "file:line: key: what".
  std::vector<std::string> warnings = {};
};

/// Whether longitudes and latitudes can be read: the library was built with GeographicLib.
[[nodiscard]] bool reads_longitudes() noexcept;

/// Reads and checks a site (GeoJSON). Longitudes and latitudes become metres in a plane that
/// touches the Earth at the start. Throws InputError "file:line: what is wrong", or naming "width"
/// if `default_width` is out of range.
[[nodiscard]] GeoJsonScenario read_geojson(const GeoJsonSite& site);

// ---- How do maps of roads, and CommonRoad's scenarios, become scenarios? ----
//
// What becomes what: docs/formats.md. Every error is an InputError "file:line: what is wrong, what
// was expected".

/// How the lanes of a map bind a vehicle.
struct RoadRules {
  bool both_ways = false;   ///< whether one-way lanes may be driven in both directions
  bool open_edges = false;  ///< whether the body may leave the lanes and areas
};

/// A map of roads, and what its file does not say.
struct RoadMap {
  std::string file = {};  ///< file name; "-" is standard input
  Vehicle vehicle = {};   ///< vehicle that drives there
  /// Start and goal: x and y in the coordinates of the file, longitude and latitude if it has no
  /// metres; heading [rad].
  Pose start = {};
  Pose goal = {};
  RoadRules rules = {};
};

/// The scenario of a map of roads.
struct RoadScenario {
  ScenarioFile file = {};               ///< the scenario, and the place of its origin if known
  std::vector<std::string> notes = {};  ///< numbers of lanes; what was left out
};

/// Reads and checks a map of Lanelet2 (OSM XML). Longitudes and latitudes become metres in a plane
/// that touches the Earth at the start. Throws InputError "file:line: what is wrong", or naming
/// "--start" or "--goal".
[[nodiscard]] RoadScenario read_lanelet2(const RoadMap& map);

/// Reads and checks a map of OpenDRIVE (.xodr). Throws InputError as `read_lanelet2` does.
[[nodiscard]] RoadScenario read_opendrive(const RoadMap& map);

/// One planning problem of a scenario of CommonRoad.
struct CommonRoadCase {
  std::string file = {};     ///< file name (XML); "-" is standard input
  std::string problem = {};  ///< id of the planning problem; empty: the only one
  /// Vehicle that drives. None: vehicle 2 of CommonRoad, a BMW 320i.
  std::optional<Vehicle> vehicle = {};
  RoadRules rules = {};
};

/// Reads and checks a scenario of CommonRoad (XML, 2018b or 2020a). Throws InputError "file:line:
/// what is wrong".
[[nodiscard]] RoadScenario read_commonroad(const CommonRoadCase& one);

/// A solution in CommonRoad's format.
struct CommonRoadSolution {
  std::string text = {};                   ///< the file (XML)
  std::vector<std::string> warnings = {};  ///< why CommonRoad may not accept it: "file:line: what"
};

/// The drive along the path of a result as a solution of model KS, vehicle 2, cost function SM1.
/// The drive keeps the speeds of the result, else it is the fastest. Throws InputError naming
/// "result" without a path, "vehicle" if the case has one, or as `read_commonroad` does.
[[nodiscard]] CommonRoadSolution commonroad_solution(const CommonRoadCase& one,
                                                     const PlanResult& result);

// ---- How do the primitives of other programs become ours? ----
//
// Their files hold sampled poses. Exact segments that pass by those poses are read from them:
// docs/algorithms/lattice.md, "Files of others".

/// Reads the primitives of Nav2 (".json", of its lattice_primitives) or of SBPL (".mprim"). Those
/// of Nav2 are taken in reverse as well. Throws InputError "file:line: what is wrong, what was
/// expected".
[[nodiscard]] std::shared_ptr<const search::Primitives> read_primitives(const std::string& file);

}  // namespace vandplan
