// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous/word_task.h"

#include <cmath>

#include "steering/continuous/mirrored_task.h"
#include "steering/word.h"

namespace vandplan::steering::continuous {
namespace {

/// Whether a word under `symmetry` with the first (or last) step `step`, if that is long enough,
/// drives a winding back.
bool may_drive_back(const Step& step, const Symmetry& symmetry, const Winding& winding) {
  static constexpr double sign[] = {1, -1};
  const bool same_side = sign[symmetry.swaps_sides()] * step.turn == winding.side;
  const bool same_gear = sign[symmetry.swaps_gears()] * step.gear == winding.gear;
  return (winding.length > 0) & same_side & same_gear;
}

}  // namespace

WordTask::WordTask(const MeanFrame& between, const Windings& around, const Stops& at) noexcept
    : WordTask(between, around, at, base::sin_cos(std::abs(between.half_turn))) {}

WordTask::WordTask(const MeanFrame& between, const Windings& around, const Stops& at,
                   const base::SinCos& half) noexcept
    : frame(between), windings(around), stops(at) {
  const MeanFrame positive = continuous::folded(between);
  folded = {positive.x, positive.y, positive.half_turn, half.sin, half.cos};
  const auto& [x, y, a, s, c] = folded;
  reeds_shepp = reeds_shepp_formulas::shortest(Circles({x, y, a}, {s, c}));
}

double saved_length(const WordSolver& solver, const FoundWord& found,
                    const Windings& windings) noexcept {
  constexpr double rounding = 1e-12;
  const auto saves = [&](bool at_start, const Winding& winding) {
    if (winding.length <= 0) return 0.0;
    const Steps& steps = steps_of(found.word.formula);
    const bool from_end = at_start == found.symmetry.swaps_ends();
    for (std::size_t i = 0; i < steps.count; ++i) {
      const std::size_t step = from_end ? steps.count - 1 - i : i;
      const double length = solver.step_length(found.word, step);
      if (length == 0) continue;
      // The step must be longer than the winding: without a rest the curvature would jump there
      // while the vehicle rolls.
      return may_drive_back(steps.list[step], found.symmetry, winding) &&
                     length > winding.length * (1 + rounding) + rounding / 10 &&
                     solver.ramp_of(found.word, step) * (1 + rounding) >= winding.length
                 ? 2 * winding.length
                 : 0.0;
    }
    return 0.0;
  };
  return saves(true, windings.start) + saves(false, windings.goal);
}

}  // namespace vandplan::steering::continuous
