// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What of the ground is known, and how does it change?

#include <cstdint>
#include <memory>
#include <vector>

#include "vandplan/problem.h"
#include "vandplan/replanner.h"

namespace vandplan::replanning {

/// The ground of a world, in its frame, with patches.
class KnownGround {
 public:
  /// `world` has the whole of the ground, and stays as it is.
  explicit KnownGround(const World& world);

  /// Throws InputError naming what of the patch is wrong; nothing has changed then.
  void patch(const WorldPatch& patch);

  /// Changes with patches: whoever has a part of it, such as a checker, must not use it any more.
  [[nodiscard]] std::shared_ptr<const World> world() const noexcept { return world_; }
  /// Of its frame in the frame of patches.
  [[nodiscard]] const Point& origin() const noexcept { return origin_; }
  /// Grows with each patch that changes something.
  [[nodiscard]] std::int64_t version() const noexcept { return version_; }

 private:
  Point origin_;
  std::shared_ptr<std::vector<Cell>> cells_;  // of the map of the world, if there is one
  std::shared_ptr<World> world_;              // that nobody else changes
  std::vector<std::int64_t> names_;           // of its obstacles
  std::int64_t version_ = 0;
};

}  // namespace vandplan::replanning
