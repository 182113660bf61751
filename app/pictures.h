// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a result become a picture file?

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "vandplan/files.h"
#include "vandplan/result_file.h"

namespace vandplan::app {

/// Picture that the command line asks for.
struct PictureWish {
  std::string file;              ///< file of the picture; empty: no picture
  bool curvature_strip = false;  ///< whether the curvature is plotted below
  bool plays = false;            ///< whether the vehicle drives along the path (SVG, one path)
};

/// Adds --draw and --curvature-strip to a command.
void add_picture(CLI::App& command, PictureWish& wish);

/// Throws InputError if the ending of the file is no picture format, or the file cannot be written.
void expect_picture(const std::string& file);

/// Throws InputError if the picture is for one path and the scenario has a row of goals, or if an
/// animation is no SVG.
void expect_one_path(const PictureWish& wish, const ScenarioFile& scenario);

/// Draws results of a scenario; a row of goals becomes a sheet of pictures. Without records it
/// draws the scene alone.
void write_picture(const PictureWish& wish, const ScenarioFile& scenario,
                   const std::vector<ResultRecord>& records);

/// Line that a vehicle drove.
struct DrivenLine {
  const std::vector<Pose>& poses;  ///< poses of the rear axle
  std::string caption;
};

/// Draws a planned path and the line that a vehicle drove.
void write_picture(const std::string& file, const Scenario& scenario, const ResultRecord& planned,
                   const DrivenLine& driven);

/// Pairs that were drawn of a file with many results.
struct DrawnPairs {
  std::size_t drawn = 0;  ///< number of drawn pairs
  bool is_all = true;     ///< whether all pairs were drawn
};

/// Draws results of many pairs as a sheet of pictures, as many as a sheet has room for. With `pair`
/// it draws the pair with that number alone. Throws InputError when there is no such pair.
DrawnPairs write_picture(const PictureWish& wish, const ScenarioFile& scenario,
                         ResultReader& results, std::optional<std::size_t> pair);

}  // namespace vandplan::app
