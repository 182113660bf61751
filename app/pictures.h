// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a result become a picture file?

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "vandplan/result_file.h"
#include "vandplan/scenario_file.h"

namespace vandplan::app {

/// Which picture somebody wants.
struct PictureWish {
  std::string file;  ///< empty: none
  bool curvature_strip = false;
  bool plays = false;  ///< an SVG with one path: the vehicle drives along it
};

/// Adds --draw and --curvature-strip to a command.
void add_picture(CLI::App& command, PictureWish& wish);

/// Throws InputError if a picture can surely not be written to this file.
void expect_picture(const std::string& file);

/// Throws InputError if the results of a scenario are more than the picture is for.
void expect_one_path(const PictureWish& wish, const ScenarioFile& scenario);

/// Draws what was planned, a row of goals as a sheet of pictures; without records the scene alone.
void write_picture(const PictureWish& wish, const ScenarioFile& scenario,
                   const std::vector<ResultRecord>& records);

/// How a path was driven.
struct DrivenLine {
  const std::vector<Pose>& poses;  ///< of the rear axle
  std::string caption;
};

/// Draws a planned path and how it was driven.
void write_picture(const std::string& file, const Scenario& scenario, const ResultRecord& planned,
                   const DrivenLine& driven);

/// What was drawn of a file with results of many pairs.
struct DrawnPairs {
  std::size_t drawn = 0;
  bool is_all = true;  ///< there are no more
};

/// Draws results of many pairs as a sheet of pictures, as many as a sheet has room for, or the pair
/// of that number alone. Throws InputError when there is no such pair.
DrawnPairs write_picture(const PictureWish& wish, const ScenarioFile& scenario,
                         ResultReader& results, std::optional<std::size_t> pair);

}  // namespace vandplan::app
