// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a task mirrored, so that words of one formula are enough for all its symmetries?

#include <cmath>
#include <cstddef>

#include "steering/continuous/word_task.h"
#include "steering/mean_frame.h"
#include "steering/word.h"

namespace vandplan::steering::continuous {

inline WordFrame mirrored(WordFrame f, const Symmetry& s) {
  static constexpr double sign[] = {1, -1};  // a table: branches would be mispredicted
  f.x *= sign[s.x];
  f.y *= sign[s.y];
  f.a *= sign[s.half_turn];
  f.s *= sign[s.half_turn];
  return f;
}

/// Stops in the order of a word that the symmetry maps onto their task.
inline Stops mirrored(const Stops& stops, const Symmetry& s) {
  const bool ends[] = {stops.start, stops.goal};  // a table: branches would be mispredicted
  const std::size_t first = s.swaps_ends() ? 1 : 0;
  return {ends[first], stops.inside, ends[1 - first]};
}

/// The mean frame mirrored so that no number is negative.
inline MeanFrame folded(const MeanFrame& f) {
  return {std::abs(f.x), std::abs(f.y), std::abs(f.half_turn)};
}

/// The symmetry that undoes `folded`. For the frame from the other end all three of its signs
/// differ, zeros included.
inline Symmetry unfolding(const MeanFrame& f) {
  const bool backwards = f.x != 0 ? f.x < 0 : f.y != 0 ? f.y < 0 : f.half_turn < 0;
  const auto is_negative = [&](double v) { return v != 0 ? v < 0 : backwards; };
  return {backwards, is_negative(f.y), is_negative(f.half_turn)};
}

/// Whether the goal is straight ahead except for rounding, and too far for turns to be shorter.
inline bool is_straight_ahead(const MeanFrame& f) {
  constexpr double noise = 1e-13;
  const bool is_exact = f.y == 0 && f.half_turn == 0;
  return is_exact || (f.x > 1e-3 && f.y <= noise * (1 + f.x) && f.half_turn <= noise);
}

/// Calls `visit(formula, symmetry)` for the nine formulas that may be shortest, under all
/// symmetries except the identity and the formula's own.
template <typename Visit>
void for_each_mirrored_formula(Visit visit) {
  for (std::size_t i = 0; i < 9; ++i) {
    const Symmetry& own = formula_rows[i].own;
    for (unsigned bits = 1; bits < 8; ++bits) {
      const Symmetry symmetry{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
      const bool is_own =
          (symmetry.x && own.x) || (symmetry.y && own.y) || (symmetry.half_turn && own.half_turn);
      if (!is_own) visit(formula_rows[i].formula, symmetry);
    }
  }
}

inline constexpr int any_gear_changes = -1;

/// Calls `visit(formula, frame, onto_task)` for the words of all formulas with `gear_changes` gear
/// changes: the mirrored frame in which the formula holds, and the symmetry that maps its word onto
/// the task.
template <typename Visit>
void for_each_candidate(const WordTask& task, int gear_changes, Visit visit) {
  const Symmetry undo = unfolding(task.frame);
  for (const FormulaRow& row : formula_rows) {
    if (gear_changes != any_gear_changes &&
        gear_changes_of(steps_of(row.formula)) != gear_changes) {
      continue;
    }
    for_each_symmetry(row.formula, [&](const Symmetry& symmetry) {
      visit(row.formula, mirrored(task.folded, symmetry), combined(undo, symmetry));
    });
  }
}

}  // namespace vandplan::steering::continuous
