// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which segments break the rule of a zone?
//
// A zone turns into an obstacle on the part of a segment that its rules forbid: on all of it if the
// zone is closed or the gear is wrong, and where the direction of travel is outside of the range.
// Collision checks then find out, without steps, whether the vehicle is in the area on that part.
// docs/algorithms/collision.md, "Zones".

#include <memory>
#include <span>
#include <vector>

#include "vandplan/collision.h"
#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan::collision {

/// Zones that restrict where and how one vehicle drives.
class Zones {
 public:
  /// Zones without such rules are left out.
  Zones(const Vehicle& vehicle, std::span<const Zone> zones);
  ~Zones();
  Zones(const Zones&) = delete;
  Zones& operator=(const Zones&) = delete;

  [[nodiscard]] bool is_empty() const noexcept;

  /// Whether the segments, one after the other, break no rule. At least one is given.
  [[nodiscard]] bool allow(const LocalState& from, std::span<const Segment> segments,
                           InTime in_time) const noexcept;

 private:
  struct Checked;

  Vehicle vehicle_;
  std::vector<Checked> all_;
};

}  // namespace vandplan::collision
