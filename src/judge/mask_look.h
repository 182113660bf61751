// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do the cells of a mask say along a track, in the eyes of the judge? docs/lab/zones.md.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "judge/track.h"
#include "judge/zone_prices.h"
#include "vandplan/problem.h"

namespace vandplan::judge {

/// Whether a mask limits speeds or has prices.
[[nodiscard]] bool is_graded(const Mask& mask);

/// A mask along a track. Of cells less than a micrometre away, the dearest or slowest one counts,
/// or the cheapest and fastest one.
class MaskLook {
 public:
  /// Mask and track must outlive the object.
  MaskLook(const Mask& mask, const Track& track, AtEdge at_edge);

  /// Adds the places of a stretch where the mask says something else.
  void add_changes(std::size_t stretch, Real begin, Real end, std::vector<Real>& places) const;
  /// Applies what the mask says at a place.
  void apply_to(PricedPart& part, const Place& place) const;

 private:
  /// Least and largest value of cells.
  struct Values {
    Real least, most;
  };

  [[nodiscard]] Real value_of(std::int64_t column, std::int64_t row) const;
  [[nodiscard]] Values around(const Place& place, Real distance) const;
  [[nodiscard]] Real at(const Place& place) const;

  const Mask& mask_;
  const Track& track_;
  AtEdge at_edge_;
  Real last_part_;  // Part of which only the ends are looked at [m].
};

}  // namespace vandplan::judge
