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

/// The ground of a world, in its frame, with patches. Worlds that were given out stay as they are.
class KnownGround {
 public:
  /// `world` has the whole of the ground; `origin` is that of its frame in the frame of patches.
  KnownGround(std::shared_ptr<const World> world);

  /// Throws InputError naming what of the patch is wrong; nothing has changed then.
  void patch(const WorldPatch& patch);

  [[nodiscard]] const std::shared_ptr<const World>& world() const noexcept { return world_; }
  [[nodiscard]] const Point& origin() const noexcept { return origin_; }
  /// Grows with each patch that changes something.
  [[nodiscard]] std::int64_t version() const noexcept { return version_; }

 private:
  Point origin_;
  Surroundings ground_;              // with the obstacles that are there
  std::vector<std::int64_t> names_;  // of these
  std::shared_ptr<const World> world_;
  std::int64_t version_ = 0;
};

}  // namespace vandplan::replanning
