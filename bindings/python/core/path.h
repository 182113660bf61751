// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do other parts of the module need for paths?

#include <pybind11/pybind11.h>

#include <string_view>

#include "vandplan/path.h"
#include "vandplan/steering.h"

namespace vandplan::python {

/// "between-stops" or "throughout". Throws InputError for another word.
[[nodiscard]] Continuity continuity_named(std::string_view name);

/// Path of one piece from a pose.
[[nodiscard]] Path path_of(const Pose& start, const Piece& piece);

/// Segments from rows [curvature, length] or [curvature, length, curvature_rate].
[[nodiscard]] std::vector<Segment> segments_from(const pybind11::handle& given);

}  // namespace vandplan::python
