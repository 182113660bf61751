// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which ground is known, and how do patches change it?

#include <cstdint>
#include <memory>
#include <vector>

#include "vandplan/problem.h"
#include "vandplan/replanner.h"

namespace vandplan::replanning {

/// Ground of a world, in the frame of the world, which patches change.
class KnownGround {
 public:
  /// `world` is the ground before all patches; it is copied, not changed. The origin of the copy's
  /// frame is 0: its frame is that of `world`.
  explicit KnownGround(const World& world);
  /// Ground in the scenario's frame before all patches; its world is as `World` makes it of both.
  KnownGround(Surroundings ground, const Point& near);

  /// Applies a patch. Throws InputError naming the part of `patch` that is wrong, without any
  /// change.
  void patch(const WorldPatch& patch);

  /// Current world. Patches change it in place, so checkers of it must not be used after a patch.
  [[nodiscard]] std::shared_ptr<const World> world() const noexcept { return world_; }
  /// Origin of the ground's frame, in the scenario's frame, which patches use [m].
  [[nodiscard]] const Point& origin() const noexcept { return origin_; }
  /// Number of patches that changed something.
  [[nodiscard]] std::int64_t version() const noexcept { return version_; }

 private:
  Point origin_;
  std::shared_ptr<std::vector<Cell>> cells_;  // cells of the world's map; null without a map
  // Percentages of each mask of the world; null for a mask without any.
  std::vector<std::shared_ptr<std::vector<std::uint8_t>>> percents_;
  std::shared_ptr<World> world_;     // current world; only this object changes it
  std::vector<std::int64_t> names_;  // names of the world's obstacles, in their order
  std::int64_t version_ = 0;
};

}  // namespace vandplan::replanning
