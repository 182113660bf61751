// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do I read scenarios and results, and write results?
//
// Formats: docs/formats.md. Files of users are read here and nowhere else; every error is an
// InputError "file:line: what is wrong, what was expected". A file that is written is whole or
// untouched: it is written beside its place and renamed.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/path_check.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"

namespace vandplan {

/// Reads and checks a scenario file (YAML). "-" is standard input.
[[nodiscard]] Scenario read_scenario(const std::string& file);

/// The same for the text of a scenario file; `where` stands for the file in errors, and the map is
/// looked for beside it unless it is here.
[[nodiscard]] Scenario scenario_from_yaml(const std::string& text, const std::string& where,
                                          const std::optional<OccupancyGrid>& map = {});

/// A scenario as YAML that `read_scenario` reads back exactly.
[[nodiscard]] std::string scenario_to_yaml(const Scenario& scenario);

/// Reads a map of ROS' map_server: its YAML file and the image that it names.
[[nodiscard]] OccupancyGrid read_map(const std::string& file);

/// Whether a YAML file is a map, that is, names an image; scenarios do not.
[[nodiscard]] bool is_map(const std::string& file);

/// A vehicle of the catalogue, "city-bus". Throws InputError if there is none of that name.
[[nodiscard]] Vehicle vehicle_named(std::string_view name);
[[nodiscard]] std::vector<std::string> vehicle_names();

/// Where a path begins and ends, in the scenario's frame.
struct PosePair {
  Pose start;
  Pose goal;
};

/// Reads a list of starts and goals (CSV). "-" is standard input.
[[nodiscard]] std::vector<PosePair> read_pose_pairs(const std::string& file);

/// Reads a case of the Trajectory Planning Competition for Automated Parking 2022 (CSV).
[[nodiscard]] Scenario read_tpcap(const std::string& file);

/// The furthest goal of a row that somebody says was reached.
struct StatedFurthest {
  std::optional<double> distance;  ///< [m]; none: no goal was
};

/// One of the problems on a MovingAI map.
struct MovingAiProblem {
  std::string map;                    ///< file (.map)
  std::string problems;               ///< file (.scen)
  int number = 1;                     ///< of the problem in its file; >= 1
  double resolution = 1.0;            ///< side of a cell [m]; > 0
  std::string vehicle = "tpcap-car";  ///< of the catalogue
};

/// Reads it; the scenario has a map, but `map_file` is still to be named.
[[nodiscard]] Scenario read_movingai(const MovingAiProblem& problem);

/// Reads a problem in the manner of dynobench (YAML): one car among boxes.
[[nodiscard]] Scenario read_dynobench(const std::string& file, const std::string& vehicle);

/// A map as an image (PGM) and as the YAML file that names the image; `read_map` reads them back.
[[nodiscard]] std::string map_to_pgm(const OccupancyGrid& grid);
[[nodiscard]] std::string map_to_yaml(const OccupancyGrid& grid, const std::string& image);

/// One planning run with what is needed to write, judge and draw it.
struct ResultRecord {
  std::string scenario;  ///< name of the scenario
  std::string planner;
  PlanOptions options;
  std::optional<double> distance;  ///< of the goal in a row of goals [m]
  PlanResult result;               ///< path and tree in the scenario's frame
  PathClaims claims;               ///< what a file that was read says about its path
  /// What that file says about the row that the record belongs to.
  std::optional<StatedFurthest> furthest;
};

/// A record whose result is as the planner gave it, in the frame of its world, as files have it.
[[nodiscard]] ResultRecord in_scenario(const World& world, ResultRecord record);

/// The largest distance among the goals of a row that have a path [m].
[[nodiscard]] std::optional<double> furthest_reached(const std::vector<ResultRecord>& records);

/// Result file as JSON text: one record for `goal:`, a row of records for `goals:`.
[[nodiscard]] std::string results_to_json(const Scenario& scenario,
                                          const std::vector<ResultRecord>& records);

/// One of many results, for the pair of poses with that number, as one line of JSON.
[[nodiscard]] std::string result_to_json_line(std::size_t pair, const Scenario& scenario,
                                              const ResultRecord& record);

/// Reads a result file written by us or by others. As many records as the scenario has goals.
[[nodiscard]] std::vector<ResultRecord> read_results(const std::string& file,
                                                     const Scenario& scenario);

/// All bytes of a table file (table_file.h), checked: what is foreign, truncated, altered or longer
/// than it says is refused before more is read than it promises. "-" is standard input.
[[nodiscard]] std::string read_table_file(const std::string& file);

/// All bytes of a file, "-" is standard input. Throws InputError if it cannot be read or holds more
/// than `largest` bytes.
[[nodiscard]] std::string read_file(const std::string& file, std::size_t largest);

/// Throws InputError if `write_file` cannot write this file, as far as can be told beforehand.
void expect_writable(const std::string& file);

/// A file that is written piece by piece, and is whole or not at all: what was there stays until
/// `commit`, and for ever without it. "-" is standard output; that, and pipes, get every piece at
/// once. All throw InputError if the file cannot be written.
class FileWriter {
 public:
  explicit FileWriter(const std::string& file);
  ~FileWriter();
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  void write(std::string_view content);
  void commit();

 private:
  struct Target;
  std::unique_ptr<Target> target_;
};

/// Writes all of `content`, "-" is standard output, or, if that fails, leaves what was there and
/// throws InputError.
void write_file(const std::string& file, std::string_view content);

}  // namespace vandplan
