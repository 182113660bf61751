// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does it look like?
//
// One drawing routine for all formats. The picture shows start, goal, path, all obstacles, kerbs
// and the map around them. Moving obstacles are fainter where they are later. A scene that is far
// larger than the path is cropped, and the picture says so. Bounds that lie far beyond are not
// shown. Axes count metres in the scenario's frame.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "vandplan/judge.h"
#include "vandplan/motion.h"
#include "vandplan/path.h"
#include "vandplan/problem.h"

namespace vandplan {

/// Content of a picture. Everything is in the scenario's frame.
struct Drawing {
  const Scenario* scenario = nullptr;  ///< the scenario; required
  const Path* path = nullptr;          ///< the path; or null
  const TreeSnapshot* tree = nullptr;  ///< the search tree; or null
  /// Poses of a vehicle that drove the path, shown as a line of its rear axle; or null.
  const std::vector<Pose>* driven = nullptr;
  /// Speeds along the path; or null. With them an SVG plays: the vehicle and all moving obstacles
  /// drive over the picture.
  const SpeedProfile* speeds = nullptr;
  /// Obstacle in the way of the start or the goal (`PlanResult::hit`), outlined in red.
  std::optional<Hit> hit = {};
  double margin = 0.0;       ///< width of a band around all that is swept [m]; >= 0
  std::string caption = {};  ///< one line above the picture, UTF-8
  /// Whether a strip below the picture of a path shows its curvature.
  bool curvature_strip = false;
  /// Whether an SVG shows what is under the mouse: the footprint of the vehicle at a place of the
  /// path, the number of an obstacle or kerb.
  bool footprints = false;
};

/// Several drawings of equal size side by side, row by row, without curvature strips.
struct ContactSheet {
  std::vector<Drawing> drawings = {};
  int columns = 3;           ///< number of columns; >= 1
  std::string caption = {};  ///< one line above all drawings, UTF-8
};

/// Format of a picture.
enum class PictureFormat { png, svg, pdf };

/// The format that the ending of a file name asks for: ".png", ".svg" or ".pdf". Throws InputError
/// naming the file for another ending.
[[nodiscard]] PictureFormat picture_format(const std::string& file);

/// The bytes of a picture. `width` is in pixels (PNG) or points (SVG, PDF), 50 to 10000; the height
/// follows. Throws InputError naming:
///
/// - "width", "columns" or "margin" if it is out of range,
/// - "caption" if it is not UTF-8,
/// - the key of a scenario that `check_scenario` refuses,
/// - a part of a path or tree whose numbers are not finite.
[[nodiscard]] std::string draw(const Drawing& drawing, PictureFormat format, int width);
/// The bytes of a picture of several drawings. Format, width and errors are those of one drawing.
[[nodiscard]] std::string draw(const ContactSheet& sheet, PictureFormat format, int width);

/// Image of a map's cells, as a background of other pictures.
struct MapImage {
  /// Bytes of the image: obstacles and unknown ground; free ground is transparent.
  std::string png;
  double width = 0.0;   ///< width along the columns [m]
  double height = 0.0;  ///< height along the rows [m]; the first line of pixels is row 0
};

/// An image of the map with a pixel for each cell, or for each block of cells, so that no side has
/// more than `most` pixels. A pixel shows the worst of its cells. `most` must be >= 1.
[[nodiscard]] MapImage map_image(const OccupancyGrid& map, int most);

}  // namespace vandplan
