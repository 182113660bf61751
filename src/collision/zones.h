// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which segments break the rule of a zone, and what do zones say along a segment?
//
// Rules: a zone turns into an obstacle on the part of a segment that they forbid: on all of it if
// the zone is closed or the gear is wrong, and where the direction of travel is outside of the
// range. Collision checks then find out, without steps, whether the vehicle is in the area there.
// docs/lab/zones.md.

#include <span>
#include <vector>

#include "collision/mask_cells.h"
#include "vandplan/collision.h"
#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan::collision {

/// Whether a zone forbids something, and does not only have a price or a speed.
[[nodiscard]] bool has_rules(const Zone& zone) noexcept;

/// Zones of one vehicle, and the masks that limit speeds or have prices.
class Zones {
 public:
  Zones(const Vehicle& vehicle, std::span<const Zone> zones, std::span<const Mask> masks);
  ~Zones();
  Zones(const Zones&) = delete;
  Zones& operator=(const Zones&) = delete;

  /// Whether a zone or mask has a price, and whether one has a largest speed.
  [[nodiscard]] bool have_prices() const noexcept;
  [[nodiscard]] bool have_speed_limits() const noexcept;

  /// Whether the segments, one after the other, break no rule.
  [[nodiscard]] bool allow(const LocalState& from, std::span<const Segment> segments,
                           InTime in_time) const noexcept;

  /// What zones and masks say along a segment.
  [[nodiscard]] std::vector<GroundPart> along(const LocalState& from, const Segment& segment,
                                              GroundRules which) const;

 private:
  struct Checked;
  /// A zone and the box around all places of the rear axle where it can hold.
  struct Boxed {
    Bounds box;
    const Checked* zone;
  };

  [[nodiscard]] static bool is_far_from(std::span<const Boxed> zones, const Pose& place,
                                        double length) noexcept;

  Vehicle vehicle_;
  std::vector<Checked> all_;
  std::vector<Boxed> ruling_;     // Zones that forbid something.
  std::vector<Boxed> telling_;    // Zones with a price, and then those with a speed alone.
  std::vector<MaskCells> masks_;  // Masks of prices, and then those of speeds.
  std::size_t price_zones_ = 0, price_masks_ = 0;  // Number of those with a price.
};

}  // namespace vandplan::collision
