// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Can somebody drive that? A path of few segments, none of them a crumb, and strokes that are worth
// a gear change.

#include <vector>

#include "vandplan/search.h"

namespace vandplan::anytime {

/// "min_stroke": how long strokes before and after gear changes are at least, where there is room.
[[nodiscard]] OptionInfo min_stroke_option();

/// The segments of a path from `start`, tidied: it ends where it ended, is free if it was, and
/// costs at most a ten thousandth more, but for what strokes of `min_stroke` [m] need. Crumbs
/// are left out where the others can make up for them. Then a stroke before or after a gear change
/// that is shorter than `min_stroke` is left out or driven on, if there is room for it.
[[nodiscard]] std::vector<Segment> tidied(search::Connector& connector, const LocalPose& start,
                                          std::vector<Segment> segments, double min_stroke);

}  // namespace vandplan::anytime
