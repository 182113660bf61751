// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do values of JavaScript become ours, and ours theirs?
//
// Whatever comes in is checked as strictly as a file: a key that is missing, unknown or of another
// type is an InputError that names it ("vehicle.width").

#include <emscripten/val.h>

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"

namespace vandplan::web {

using emscripten::val;

/// A number of JavaScript. Throws InputError naming `where` for anything else.
[[nodiscard]] double number_from(const val& given, const std::string& where);

/// The number below that key of an object; `standard` where the key is not there.
[[nodiscard]] double number_at(const val& object, const char* key, const std::string& where);
[[nodiscard]] double number_at(const val& object, const char* key, const std::string& where,
                               double standard);

/// Throws InputError unless `object` is an object that has none but these keys.
void allow_only(const val& object, std::initializer_list<std::string_view> keys,
                const std::string& where);

/// Whether there is a value, neither undefined nor null, below that key.
[[nodiscard]] bool has(const val& object, const char* key);

/// Where a path begins or ends, and how wheels and trailer stand there.
struct End {
  Pose pose = {};
  double curvature = 0.0;    ///< [1/m]
  double hitch_angle = 0.0;  ///< [rad]; 0 without a trailer
};

/// {x, y, heading, curvature, hitch_angles}, or {trailer: {x, y, heading}, ...}: the trailer's
/// axle.
[[nodiscard]] End end_from(const val& given, const std::string& where, const Vehicle& vehicle);
/// A goal: a pose, or a set of goals.
struct Goal {
  End end = {};                      ///< of no account with a set
  std::vector<GoalRegion> set = {};  ///< empty for a pose
};

/// With the keys of a scenario file.
[[nodiscard]] Goal goal_from(const val& given, const Vehicle& vehicle);
[[nodiscard]] Polygon polygon_from(const val& corners, const std::string& where);
/// {x, y, heading} of it, passing over the rest.
[[nodiscard]] Pose pose_from(const val& given, const std::string& where);
[[nodiscard]] Vehicle vehicle_from(const val& given);
/// A scenario with the keys of a scenario file; its map is {origin, resolution, columns, rows,
/// cells, unknown}.
[[nodiscard]] Scenario scenario_from(const val& given);
/// {start, segments: [{curvature, length, curvature_rate}]}.
[[nodiscard]] Path path_from(const val& given);

[[nodiscard]] val object_of(const Pose& pose);
[[nodiscard]] val object_of(const Path& path);
/// {index, x, y, heading}, or null.
[[nodiscard]] val object_of(const std::optional<ReachedGoal>& goal);
[[nodiscard]] val list_of(std::span<const Segment> segments);
[[nodiscard]] val object_of(const PathCheck& check);
[[nodiscard]] val object_of(const PlanResult& result);
/// A copy of the numbers that belongs to JavaScript.
[[nodiscard]] val array_of(std::span<const double> numbers);
[[nodiscard]] val array_of(std::span<const float> numbers);
[[nodiscard]] val array_of(std::span<const std::int32_t> numbers);

}  // namespace vandplan::web
