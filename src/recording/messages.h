// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is the JSON of a message?
//
// The frame of each value is the one that the message names. Times are in nanoseconds.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/drive.h"
#include "vandplan/geometry.h"
#include "vandplan/problem.h"

namespace vandplan::recording {

struct Colour {
  double red, green, blue;  // components from 0 to 1
  double opacity = 1.0;     // 0: cannot be seen
};

/// A place above the ground [m].
struct Place {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

/// How the points of a line are joined. The numbers are those of Foxglove.
enum class Join : std::uint8_t { strip = 0, loop = 1, pairs = 2 };

struct Line {
  Join join = Join::strip;
  std::vector<Place> points;
  Colour colour;
  double thickness = 0.1;  ///< thickness [m]
  Pose pose = {};          ///< pose of the frame of the points
};

struct Triangles {
  std::vector<Place> points;
  std::vector<std::uint32_t> corners;  ///< indices in `points`, three for each triangle
  Colour colour;
  Pose pose = {};  ///< pose of the frame of the points
};

struct Label {
  std::string text;
  Place place;
  Colour colour;
};

/// A thing in a scene. It replaces an earlier one with the same id.
struct Entity {
  std::string id;
  std::string frame = {};
  /// Whether the thing moves with its frame from now on.
  bool moves_with_frame = false;
  std::vector<Line> lines = {};
  std::vector<Triangles> triangles = {};
  std::vector<Label> labels = {};
};

/// Things that appear or change, and ids of those that disappear.
struct SceneChange {
  std::vector<Entity> entities = {};
  std::vector<std::string> gone = {};
};

/// Importance of an event. The numbers are those of Foxglove.
enum class Level : std::uint8_t { info = 2, warning = 3, error = 4 };

/// Place of a frame in another one.
struct FramePose {
  std::string_view parent;
  std::string_view child;
  Pose pose = {};  ///< pose of `child` in `parent`
};

[[nodiscard]] std::string scene_message(std::uint64_t time, const SceneChange& change);
[[nodiscard]] std::string transform_message(std::uint64_t time, const FramePose& frame);
[[nodiscard]] std::string poses_message(std::uint64_t time, std::string_view frame,
                                        std::span<const Pose> poses);
[[nodiscard]] std::string log_message(std::uint64_t time, Level level, std::string_view text);
[[nodiscard]] std::string motion_message(std::uint64_t time, const DriveMoment& moment);
[[nodiscard]] std::string improvement_message(std::uint64_t time, const CostSample& sample);

/// The cells of a map, a byte each: 0 free, 50 unknown, 100 occupied. A map with more than `most`
/// cells along a side has blocks of cells instead, each as its worst cell.
[[nodiscard]] std::string grid_message(std::uint64_t time, std::string_view frame,
                                       const OccupancyGrid& grid, std::int32_t most);

}  // namespace vandplan::recording
