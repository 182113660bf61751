// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do strokes become worth a gear change?

#include "search/route.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

/// A route whose strokes before and after gear changes have at least `least` [m], where there is
/// room. A shorter stroke is left out, or the gear changes later and another way leads back: the
/// cheapest free choice. `beside`: what is driven before and after the route. The result is priced.
[[nodiscard]] search::Route with_strokes(search::Connector& connector,
                                         const search::DrivenBeside& beside, search::Route route,
                                         double least);

/// A path as a route of short legs, each of which can be steered anew. The route ends at `goal`.
[[nodiscard]] search::Route legs_along(const Path& path, const LocalPose& goal);

}  // namespace vandplan::anytime
