// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// About how long does a drive wait for what moves?
//
// Searches compare many paths, and looking for the best speeds among moving obstacles takes as long
// as pricing a hundred paths. So they price a path by its fastest drive: how long it meets
// somebody.

#include "moving/encounters.h"
#include "vandplan/motion.h"
#include "vandplan/path.h"
#include "vandplan/problem.h"

namespace vandplan::planning {

class Delay {
 public:
  /// The task outlives the object.
  explicit Delay(const Task& task);

  /// Estimate of the time that `drive`, the fastest one along a path from the start, loses by
  /// letting moving obstacles pass [s]; 0 if no look finds it too near to one before the goal.
  [[nodiscard]] double of(const Path& path, const SpeedProfile& drive) const;

 private:
  [[nodiscard]] bool meets_anybody(const State& state, double t) const;

  const Task& task_;
  moving::Encounters movers_;  // asked for distances, not for places on its path
};

}  // namespace vandplan::planning
