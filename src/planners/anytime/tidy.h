// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a path get rid of segments that nobody drives?

#include <vector>

#include "vandplan/search.h"

namespace vandplan::anytime {

/// Option "min_stroke": least length of strokes before and after gear changes, where there is room
/// [m].
[[nodiscard]] OptionInfo min_stroke_option();

/// The segments of a path from `start`, without crumbs where other segments can make up for them.
/// The path ends where it ended, is free if it was, and costs at most 1e-4 (relative) more.
[[nodiscard]] std::vector<Segment> tidied(search::Connector& connector, const LocalPose& start,
                                          std::vector<Segment> segments);

}  // namespace vandplan::anytime
