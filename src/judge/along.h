// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How near does the vehicle come to things on its way, in the eyes of the judge?
//
// Method and proof: docs/algorithms/path_check.md.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "judge/clearance.h"
#include "judge/track.h"

namespace vandplan::judge {

/// Something that a body must not touch.
struct Thing {
  std::string hit;  ///< what has happened when it does
  Rectangle body;
  std::function<double(const Passage&, double most)> clearance;  ///< of the body (clearance.h)
};

struct Touch {
  std::size_t thing = 0;
  Place place;
};

struct Nearest {
  double clearance = 0.0;      ///< the least of all, to 1 mm [m]; infinity without things
  std::optional<Touch> touch;  ///< the first on the way; none if `clearance` is above 0
};

/// Looks wherever a point of a body has moved by a millimetre, except where nothing can be nearer
/// than what is known.
[[nodiscard]] Nearest nearest_along(const Track& track, const std::vector<Thing>& things);

}  // namespace vandplan::judge
