// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where does the ground of a site differ from what it was?

#include <cstdint>
#include <optional>
#include <vector>

#include "vandplan/problem.h"

namespace vandplan::sites {

/// A place where the ground has changed, in the frame of the world.
struct GroundChange {
  Bounds box = {};     ///< box around it [m]
  bool frees = false;  ///< whether something may be free or cheaper now that was not
};

/// What stood when it was last looked at. It copies what a world may change in place.
class SeenGround {
 public:
  explicit SeenGround(const World& world);

  /// Looks at a world, and says where it differs from what was seen before. None: it differs in
  /// what concerns all places, such as bounds, origin, or the size of the map; what was seen before
  /// stays.
  [[nodiscard]] std::optional<std::vector<GroundChange>> look(const World& world);

  /// Origin of the world's frame [m].
  [[nodiscard]] const Point& origin() const noexcept { return origin_; }

 private:
  Point origin_;
  Surroundings ground_;                              // without numbers of map and masks
  std::vector<Cell> cells_;                          // of the map
  std::vector<std::vector<std::uint8_t>> percents_;  // of each mask
};

}  // namespace vandplan::sites
