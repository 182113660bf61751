// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Are strokes of continuous curvature worth a gear change?

#include "search/route.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

/// A route whose curvature is continuous, with strokes before and after gear changes of at least
/// `least` [m] where there is room for it: one that is shorter is left out, or the gear changes
/// later and another way leads back, whatever is free and cheapest. `beside` is what is driven
/// before and after the route. The result is priced.
[[nodiscard]] search::Route with_strokes(search::Connector& connector, const search::Gears& beside,
                                         search::Route route, double least);

/// The path as a route of short legs, which can be steered anew one by one; it ends at `goal`.
[[nodiscard]] search::Route legs_along(const Path& path, const LocalPose& goal);

}  // namespace vandplan::anytime
