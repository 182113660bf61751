// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which formulas and symmetries do the words of continuous steering have?

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "steering/continuous_families.h"
#include "steering/continuous_word.h"
#include "steering/mean_frame.h"
#include "steering/word.h"

namespace vandplan::steering::families {

using namespace reeds_shepp_formulas;

inline constexpr double full_turn = 2 * std::numbers::pi;

/// A formula, with what is needed to make its words.
struct Kind {
  Formula formula;
  Arcs (*arcs)(const Circles&);
  Symmetry own;  ///< symmetry that maps the word onto itself; `none` for a word with eight images
};

inline constexpr Symmetry none{false, false, false};
inline constexpr Symmetry in_x{true, false, false};
inline constexpr Symmetry in_y{false, true, false};
inline constexpr Symmetry in_half_turn{false, false, true};

inline constexpr std::array<Kind, 11> kinds = {{
    {Formula::lsl, lsl, in_y},
    {Formula::lsr, lsr, in_half_turn},
    {Formula::l_r_l, l_r_l, in_y},
    {Formula::r_lr, r_lr, none},
    {Formula::lr_lr, lr_lr, in_x},
    {Formula::r_lr_l, r_lr_l, in_half_turn},
    {Formula::r_lsr, r_lsr, none},
    {Formula::r_lsl, r_lsl, none},
    {Formula::r_lsr_l, r_lsr_l, in_half_turn},
    {Formula::lrl, lrl, in_y},
    {Formula::r_lr_wide, r_lr_wide, none},
}};

/// The arc plus whole turns, in [-slack, 2 pi - slack). A slightly negative arc is a bad guess of a
/// small turn, not of a whole turn.
inline double in_one_turn(double arc) {
  constexpr double slack = 0.5;
  if (arc >= -slack && arc < full_turn - slack) return arc;
  return arc - full_turn * std::floor((arc + slack) / full_turn);
}

inline Arcs in_one_turn(Arcs arcs) {
  arcs.first = in_one_turn(arcs.first);
  arcs.last = in_one_turn(arcs.last);
  return arcs;
}

inline WordFrame image_of(WordFrame f, const Symmetry& s) {
  static constexpr double sign[] = {1, -1};  // a table: branches would be mispredicted
  f.x *= sign[s.x];
  f.y *= sign[s.y];
  f.a *= sign[s.half_turn];
  f.s *= sign[s.half_turn];
  return f;
}

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

inline Symmetry both(const Symmetry& a, const Symmetry& b) {
  return {a.x != b.x, a.y != b.y, a.half_turn != b.half_turn};
}

/// Whether the curvature may jump inside, but not at both ends: on a leg of a longer way.
inline bool is_leg(const Stops& stops) { return stops.inside && !(stops.start && stops.goal); }

/// The stops of a task, in the order of a word that the symmetry `made` maps onto the task.
inline Stops seen_by(const Symmetry& made, const Stops& stops) {
  const bool ends[] = {stops.start, stops.goal};  // a table: branches would be mispredicted
  const std::size_t first = made.swaps_ends() ? 1 : 0;
  return {ends[first], stops.inside, ends[1 - first]};
}

/// Whether a word with the first (or last) step `step`, if that is long enough, drives a winding
/// back.
inline bool may_drive_back(const Step& step, const Symmetry& symmetry, const Winding& winding) {
  static constexpr double sign[] = {1, -1};
  const bool same_side = sign[symmetry.swaps_sides()] * step.turn == winding.side;
  const bool same_gear = sign[symmetry.swaps_gears()] * step.gear == winding.gear;
  return (winding.length > 0) & same_side & same_gear;
}

/// Whether the goal is straight ahead except for rounding, and too far for turns to be shorter.
inline bool is_line(const MeanFrame& f) {
  constexpr double noise = 1e-13;
  const bool is_exact = f.y == 0 && f.half_turn == 0;
  return is_exact || (f.x > 1e-3 && f.y <= noise * (1 + f.x) && f.half_turn <= noise);
}

/// Length of a word with these arcs; negative ones count as 0.
inline double driven_length(const Steps& steps, const Arcs& arcs) {
  const double parts[] = {arcs.first, arcs.inner, arcs.line, arcs.last};
  double sum = 0;
  for (std::size_t i = 0; i < steps.count; ++i) sum += std::max(0.0, parts[steps.list[i].part]);
  return sum;
}

inline int gear_changes_of(const Steps& steps) {
  int changes = 0;
  for (std::size_t i = 1; i < steps.count; ++i) {
    changes += steps.list[i].gear != steps.list[i - 1].gear ? 1 : 0;
  }
  return changes;
}

/// Calls `visit(kind, symmetry)` for the nine formulas that may be shortest, under all symmetries
/// except the identity and the formula's own.
template <typename Visit>
void for_each_symmetry(Visit visit) {
  for (std::size_t i = 0; i < 9; ++i) {
    const Symmetry& own = kinds[i].own;
    for (unsigned bits = 1; bits < 8; ++bits) {
      const Symmetry symmetry{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
      const bool is_own =
          (symmetry.x && own.x) || (symmetry.y && own.y) || (symmetry.half_turn && own.half_turn);
      if (!is_own) visit(kinds[i], symmetry);
    }
  }
}

inline constexpr int any_gear_changes = -1;

/// Calls `visit(kind, frame, symmetry)` for all images of kinds with `gear_changes` gear changes.
template <typename Visit>
void for_each_image(const WordTask& task, int gear_changes, Visit visit) {
  const Symmetry undo = unfolding(task.frame);
  for (const Kind& kind : kinds) {
    if (gear_changes != any_gear_changes &&
        gear_changes_of(steps_of(kind.formula)) != gear_changes) {
      continue;
    }
    for (unsigned i = 0; i < 8; ++i) {
      const Symmetry symmetry{(i & 4U) != 0, (i & 2U) != 0, (i & 1U) != 0};
      const auto& [x, y, half_turn] = symmetry;
      if ((x && kind.own.x) || (y && kind.own.y) || (half_turn && kind.own.half_turn)) continue;
      visit(kind, image_of(task.folded, symmetry), both(undo, symmetry));
    }
  }
}

}  // namespace vandplan::steering::families
