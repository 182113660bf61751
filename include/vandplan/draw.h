// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does it look like?
//
// One drawing routine for all formats. The picture shows start, goal and path with all obstacles,
// kerbs and the map around them, and what moves, fainter where it is later; a scene that is far
// larger than the path is cropped, and the picture says so. Bounds that lie far beyond are not
// shown. Axes count metres in the scenario's frame.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "vandplan/outcome.h"
#include "vandplan/path.h"
#include "vandplan/path_check.h"
#include "vandplan/problem.h"
#include "vandplan/speed.h"

namespace vandplan {

/// What to draw; everything in the scenario's frame.
struct Drawing {
  const Scenario* scenario = nullptr;
  const Path* path = nullptr;          ///< or none
  const TreeSnapshot* tree = nullptr;  ///< or none
  /// Where the rear axle of a vehicle was that drove the path, as a line over it; or none.
  const std::vector<Pose>* driven = nullptr;
  /// When the vehicle is where on the path: an SVG plays then, the vehicle drives over the picture
  /// and all that moves does; or none.
  const SpeedProfile* speeds = nullptr;
  /// What stands in the way of the start or the goal (`PlanResult::hit`): outlined in red.
  std::optional<Hit> hit = {};
  double margin = 0.0;       ///< a band so wide is drawn around all that is swept [m]
  std::string caption = {};  ///< one line above the picture, UTF-8
  /// Below the picture of a path: how far the wheels are turned along it.
  bool curvature_strip = false;
};

/// Several drawings side by side, row by row, all of the same size; without curvature strips.
struct ContactSheet {
  std::vector<Drawing> drawings = {};
  int columns = 3;           ///< >= 1
  std::string caption = {};  ///< one line above all of them, UTF-8
};

enum class PictureFormat { png, svg, pdf };

/// From the ending of a file name. Throws InputError for any other ending.
[[nodiscard]] PictureFormat picture_format(const std::string& file);

/// The bytes of a picture. `width` in pixels (PNG) or points (SVG, PDF), 50 to 10000; the height
/// follows. Throws InputError for another width, a scenario that `check_scenario` refuses, a
/// caption that is not UTF-8, and paths and trees with
/// numbers that are not finite.
[[nodiscard]] std::string draw(const Drawing& drawing, PictureFormat format, int width);
[[nodiscard]] std::string draw(const ContactSheet& sheet, PictureFormat format, int width);

/// The cells of a map, for other pictures to lie on.
struct MapImage {
  std::string png;      ///< obstacles and unknown ground; what is free is transparent
  double width = 0.0;   ///< along the columns [m]
  double height = 0.0;  ///< along the rows, the first line of pixels being row 0 [m]
};

/// A pixel for each cell, or for a block of cells, so that no side has more than `most` pixels; it
/// shows the worst of them. `most` >= 1.
[[nodiscard]] MapImage map_image(const OccupancyGrid& map, int most);

}  // namespace vandplan
