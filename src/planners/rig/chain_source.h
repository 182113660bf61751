// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where do drives of a rig come from that nobody has shortened yet?

#include <cstdint>

#include "planners/anytime/worker.h"
#include "planners/rig/setting.h"

namespace vandplan::rig {

/// A search for drives from the start to the goal, one after the other.
class ChainSource {
 public:
  virtual ~ChainSource() = default;

  /// Does at most `most` steps, fewer if a drive was found or the budget was interrupted. A step
  /// takes some ten microseconds. Gives back the number of steps, at least 1, and the commands of
  /// the drive that was found.
  [[nodiscard]] virtual anytime::Found work(std::int64_t most, const search::Budget& budget) = 0;
  /// Whether another step may find anything.
  [[nodiscard]] virtual bool has_work() const { return true; }

  /// Tells the source of the best drive of all workers, which has changed.
  virtual void hear(const anytime::Drive& /*best*/) {}
  [[nodiscard]] virtual anytime::Counts counts() const = 0;
};

}  // namespace vandplan::rig
