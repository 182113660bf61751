// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are the start and the goal of a scenario read and written?

#include <string>
#include <vector>

#include "io/document.h"
#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan::io {

/// Start or goal of one pose.
struct End {
  Pose pose = {};
  double curvature = 0.0;    ///< Curvature of the path at the pose, from the turned wheels [1/m].
  double hitch_angle = 0.0;  ///< Hitch angle of the trailer [rad].
};

[[nodiscard]] End end_from(const Document& file, const Node& node, const Vehicle& vehicle);

/// Goal of one pose, given for the vehicle or for its trailer.
[[nodiscard]] End goal_from(const Document& file, const Node& node, const Vehicle& vehicle);

/// Whether a goal has more than one pose.
[[nodiscard]] bool is_goal_set(const Document& file, const Node& node);

/// Regions of a goal.
[[nodiscard]] std::vector<GoalRegion> goal_set_from(const Document& file, const Node& node,
                                                    const Vehicle& vehicle);

/// Headings from a number, from [first, last], or from `any`.
[[nodiscard]] HeadingRange headings_from(const Document& file, const Node& node);
/// Directions from [first, last].
[[nodiscard]] HeadingRange directions_from(const Document& file, const Node& node);

/// Entries of `via`: sets of goals, each with `stop`.
[[nodiscard]] std::vector<Via> via_from(const Document& file, const Node& node,
                                        const Vehicle& vehicle);

/// Adds a warning for each heading of a start or goal that looks like degrees.
void warn_of_degrees(const Document& file, const Node& node, std::vector<std::string>& warnings);

[[nodiscard]] std::string yaml_of(const HeadingRange& range);
[[nodiscard]] std::string yaml_of(const End& end);
[[nodiscard]] std::string yaml_of(const std::vector<GoalRegion>& set);
[[nodiscard]] std::string yaml_of(const std::vector<Via>& via);

}  // namespace vandplan::io
