// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a scenario of CommonRoad say of its planning problem?

#include <string>
#include <vector>

#include "io/xml.h"
#include "vandplan/files.h"

namespace vandplan::io {

/// The planning problem with that id; with an empty id the only one. Throws InputError if there is
/// none or several.
[[nodiscard]] XmlNode planning_problem(const XmlFile& file, const std::string& id);

/// Time step at which the vehicle of a planning problem starts.
[[nodiscard]] double begin_of(const XmlFile& file, const XmlNode& problem);

/// Duration of a time step [s].
[[nodiscard]] double time_step_of(const XmlFile& file);

/// Elements with the places of all goals of a planning problem, in the order of `goal_set`.
[[nodiscard]] std::vector<XmlNode> goal_places(const XmlFile& file, const XmlNode& problem);

/// Exact value of an element such as `time`.
[[nodiscard]] double exact_from(const XmlFile& file, const XmlNode& node);

/// Interval of an element such as `time`, or its exact value.
[[nodiscard]] Interval interval_from(const XmlFile& file, const XmlNode& node);

}  // namespace vandplan::io
