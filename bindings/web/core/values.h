// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do JavaScript values become values of the library, and back?
//
// Input is checked as strictly as a file: a missing, unknown or mistyped key is an InputError that
// names it ("vehicle.width").

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

/// A JavaScript number. Throws InputError naming `where` for anything else.
[[nodiscard]] double number_from(const val& given, const std::string& where);

/// Number at a key of an object. If the key is missing, `standard`, or InputError without it.
[[nodiscard]] double number_at(const val& object, const char* key, const std::string& where);
[[nodiscard]] double number_at(const val& object, const char* key, const std::string& where,
                               double standard);

/// Throws InputError unless `object` is an object with no other keys than these.
void allow_only(const val& object, std::initializer_list<std::string_view> keys,
                const std::string& where);

/// Whether the value at a key is neither undefined nor null.
[[nodiscard]] bool has(const val& object, const char* key);

/// Name of a key of an object, for errors: "zones[1].cost".
[[nodiscard]] std::string key_of(const std::string& where, const std::string& key);

/// Length of a list. Throws InputError for anything else.
[[nodiscard]] std::size_t size_of(const val& list, const std::string& where);

/// Point from [x, y].
[[nodiscard]] Point point_from(const val& given, const std::string& where);

/// Start or goal of a path, with its curvature and hitch angle.
struct End {
  Pose pose = {};
  double curvature = 0.0;    ///< Curvature of the path [1/m].
  double hitch_angle = 0.0;  ///< Hitch angle [rad]; 0 without a trailer.
};

/// End from {x, y, heading, curvature, hitch_angles}, or from {trailer: {x, y, heading}, ...} for
/// the trailer's axle.
[[nodiscard]] End end_from(const val& given, const std::string& where, const Vehicle& vehicle);
/// A goal: one pose, or a set of goals.
struct Goal {
  End end = {};                      ///< Unused with a set.
  std::vector<GoalRegion> set = {};  ///< Empty for one pose.
};

/// Goal from an object with the keys of a scenario file.
[[nodiscard]] Goal goal_from(const val& given, const Vehicle& vehicle);
/// Entries of `via` of a scenario or query; none without the key.
[[nodiscard]] std::vector<Via> via_at(const val& given, const Vehicle& vehicle);
[[nodiscard]] Polygon polygon_from(const val& corners, const std::string& where);
/// Pose from {x, y, heading}; curvature and hitch_angles are ignored.
[[nodiscard]] Pose pose_from(const val& given, const std::string& where);
[[nodiscard]] Vehicle vehicle_from(const val& given);
/// Scenario from an object with the keys of a scenario file. Its map is {origin, resolution,
/// columns, rows, cells, unknown}.
[[nodiscard]] Scenario scenario_from(const val& given);
/// Path from {start, segments: [{curvature, length, curvature_rate}]}.
[[nodiscard]] Path path_from(const val& given);

[[nodiscard]] val object_of(const Pose& pose);
[[nodiscard]] val object_of(const Path& path);
/// Object {index, x, y, heading}, or null.
[[nodiscard]] val object_of(const std::optional<ReachedGoal>& goal);
/// List of {s, x, y, heading}.
[[nodiscard]] val list_of(const std::vector<PassedVia>& passed);
[[nodiscard]] val list_of(std::span<const Segment> segments);
[[nodiscard]] val object_of(const PathCheck& check);
[[nodiscard]] val object_of(const PlanResult& result);
/// Copy of the numbers in a typed array of JavaScript.
[[nodiscard]] val array_of(std::span<const double> numbers);
[[nodiscard]] val array_of(std::span<const float> numbers);
[[nodiscard]] val array_of(std::span<const std::int32_t> numbers);

}  // namespace vandplan::web
