// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a path become one that somebody can drive?
//
// Such a path has few segments, no crumbs, and strokes that are worth a gear change.

#include <vector>

#include "vandplan/search.h"

namespace vandplan::anytime {

/// Option "min_stroke": least length of strokes before and after gear changes, where there is room
/// [m].
[[nodiscard]] OptionInfo min_stroke_option();

/// The segments of a path from `start`, tidied. The path ends where it ended, is free if it was,
/// and costs at most 1e-4 (relative) more, except for lengthened strokes. Crumbs are left out where
/// other segments can make up for them. Then a stroke shorter than `min_stroke` [m], before or
/// after a gear change, is left out or driven on, if there is room for it.
[[nodiscard]] std::vector<Segment> tidied(search::Connector& connector, const LocalPose& start,
                                          std::vector<Segment> segments, double min_stroke);

}  // namespace vandplan::anytime
