// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is a polygon simple, and do line segments meet?

#include <string>

#include "vandplan/geometry.h"

namespace vandplan::geometry {

/// Neighbouring equal corners made one; the last and the first are neighbours. Corners that are all
/// equal become a triangle of micrometres around the point: obstacles like that occur in recorded
/// data.
[[nodiscard]] Polygon cleaned(const Polygon& polygon);

/// What keeps a cleaned polygon of finite corners from being simple, as half a sentence; empty if
/// nothing does. Simple: an area, and no two sides that share more than the corner between them.
/// `origin` is that of the polygon's frame in the frame of whoever reads the sentence.
[[nodiscard]] std::string flaw_of(const Polygon& polygon, const Point& origin);

/// Whether two closed line segments have a point in common, decided exactly.
[[nodiscard]] bool meet(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace vandplan::geometry
