// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which rule of which zone does a path break, in the eyes of the judge?
//
// Method: docs/lab/zones.md.

#include <optional>
#include <span>
#include <vector>

#include "judge/body.h"
#include "judge/fault.h"
#include "judge/ground.h"
#include "judge/track.h"
#include "judge/trailing.h"
#include "vandplan/judge.h"
#include "vandplan/problem.h"
#include "vandplan/vehicle.h"

namespace vandplan::judge {

/// The bodies whose being in the area of a zone counts: the axle, or vehicle and trailer. Nothing
/// but the area stands on their ground.
class ZoneBodies {
 public:
  /// `trailing` is null without a trailer. References must outlive the object.
  ZoneBodies(const Zone& zone, const Vehicle& vehicle, const Track& track,
             const Trailing* trailing);
  ZoneBodies(const ZoneBodies&) = delete;
  ZoneBodies& operator=(const ZoneBodies&) = delete;

  [[nodiscard]] std::span<const Body> all() const { return bodies_; }

 private:
  Surroundings surroundings_;
  Ground ground_;
  std::vector<Body> bodies_;
};

/// First rule that a path breaks, in the order of the zones. `trailing` is null without a trailer.
/// The judge looks wherever what the rule is about has moved by a tenth of a millimetre, unless it
/// is proven to be outside of the area. A direction of travel may be off by 1e-6 rad.
[[nodiscard]] std::optional<Fault> broken_rule(const std::vector<Zone>& zones,
                                               const Vehicle& vehicle, const Track& track,
                                               const Trailing* trailing);

}  // namespace vandplan::judge
