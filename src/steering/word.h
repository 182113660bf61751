// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do the arcs of a formula become the segments of a piece?

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "steering/mean_frame.h"
#include "steering/reeds_shepp_formulas.h"
#include "vandplan/path.h"

namespace vandplan::steering {

/// One turn or line of a word.
struct Step {
  double turn;       ///< 1 left, 0 straight, -1 right
  double gear;       ///< 1 forward, -1 reverse
  std::size_t part;  ///< member of `Arcs`: 0 first, 1 inner, 2 line, 3 last
};

struct Steps {
  std::array<Step, 5> list{};
  std::size_t count = 0;
  bool same_sense = false;  ///< the first and the last step turn the heading the same way
};

/// The steps of a word written as turns and gears, such as "L+R-L+".
constexpr Steps steps_from(std::string_view text) {
  Steps steps;
  steps.count = text.size() / 2;
  for (std::size_t i = 0; i < steps.count; ++i) {
    const double turn = text[2 * i] == 'L' ? 1 : text[2 * i] == 'R' ? -1 : 0;
    const std::size_t part = i == 0 ? 0 : i == steps.count - 1 ? 3 : turn == 0 ? 2 : 1;
    steps.list[i] = {turn, text[2 * i + 1] == '+' ? 1.0 : -1.0, part};
  }
  const Step& last = steps.list[steps.count - 1];
  steps.same_sense = steps.list[0].turn * steps.list[0].gear == last.turn * last.gear;
  return steps;
}

inline constexpr Steps all_steps[] = {
    steps_from("L+S+L+"),      // 8.1
    steps_from("L+S+R+"),      // 8.2
    steps_from("L+R-L+"),      // 8.3
    steps_from("R-L+R+"),      // 8.4
    steps_from("L-R-L+R+"),    // 8.7
    steps_from("R-L+R+L-"),    // 8.8
    steps_from("R-L+S+R+"),    // 8.9
    steps_from("R-L+S+L+"),    // 8.10
    steps_from("R-L+S+R+L-"),  // 8.11
    steps_from("L+R+L+"),      // Dubins
    steps_from("R-L+R+"),      // 8.4 with a wide inner arc
};

inline const Steps& steps_of(reeds_shepp_formulas::Formula formula) {
  return all_steps[static_cast<std::size_t>(formula)];
}

constexpr int gear_changes_of(const Steps& steps) {
  int changes = 0;
  for (std::size_t i = 1; i < steps.count; ++i) {
    changes += steps.list[i].gear != steps.list[i - 1].gear ? 1 : 0;
  }
  return changes;
}

/// Which signs of the mean frame change; each change maps paths onto paths.
struct Symmetry {
  bool x, y, half_turn;

  [[nodiscard]] Circles of(Circles p) const {
    if (x) p.x = -p.x;
    if (y) {
      p.y = -p.y;
      std::swap(p.lr, p.rl);
    }
    if (half_turn) {
      p.a = -p.a;
      p.s = -p.s;
    }
    return p;
  }
  [[nodiscard]] constexpr bool swaps_gears() const { return x; }
  [[nodiscard]] constexpr bool swaps_sides() const { return x != half_turn; }
  [[nodiscard]] constexpr bool swaps_ends() const { return (x != y) != half_turn; }
};

/// The symmetry that changes the signs of one of two symmetries, but not those of both.
constexpr Symmetry combined(const Symmetry& a, const Symmetry& b) {
  return {a.x != b.x, a.y != b.y, a.half_turn != b.half_turn};
}

inline constexpr Symmetry identity{false, false, false};
inline constexpr Symmetry in_x{true, false, false};
inline constexpr Symmetry in_y{false, true, false};
inline constexpr Symmetry in_half_turn{false, false, true};

/// How the words of a formula are made.
struct FormulaRow {
  reeds_shepp_formulas::Formula formula;
  reeds_shepp_formulas::Arcs (*arcs)(const Circles&);
  Symmetry own;  ///< symmetry that maps the word onto itself; `identity` if none does
};

/// All formulas, in the order of their enumerators.
inline constexpr auto formula_rows = [] {
  using namespace reeds_shepp_formulas;
  return std::array<FormulaRow, 11>{{
      {Formula::lsl, lsl, in_y},
      {Formula::lsr, lsr, in_half_turn},
      {Formula::l_r_l, l_r_l, in_y},
      {Formula::r_lr, r_lr, identity},
      {Formula::lr_lr, lr_lr, in_x},
      {Formula::r_lr_l, r_lr_l, in_half_turn},
      {Formula::r_lsr, r_lsr, identity},
      {Formula::r_lsl, r_lsl, identity},
      {Formula::r_lsr_l, r_lsr_l, in_half_turn},
      {Formula::lrl, lrl, in_y},
      {Formula::r_lr_wide, r_lr_wide, identity},
  }};
}();
inline constexpr std::size_t formula_count = formula_rows.size();

/// Lengths of the parts of the Reeds-Shepp word of a formula.
inline reeds_shepp_formulas::Arcs arcs_of(reeds_shepp_formulas::Formula formula,
                                          const Circles& circles) {
  return formula_rows[static_cast<std::size_t>(formula)].arcs(circles);
}

/// Calls `visit(symmetry)` for the symmetries under which a formula has different words: eight, or
/// four if one of them maps the word onto itself.
template <typename Visit>
void for_each_symmetry(reeds_shepp_formulas::Formula formula, Visit visit) {
  const Symmetry& own = formula_rows[static_cast<std::size_t>(formula)].own;
  for (unsigned i = 0; i < 8; ++i) {
    const Symmetry symmetry{(i & 4U) != 0, (i & 2U) != 0, (i & 1U) != 0};
    const auto& [x, y, half_turn] = symmetry;
    if ((x && own.x) || (y && own.y) || (half_turn && own.half_turn)) continue;
    visit(symmetry);
  }
}

/// The piece of a word under `symmetry`, at `radius` [m]. Parts of length 0 or less are left out.
inline Piece piece_of(reeds_shepp_formulas::Formula formula, const reeds_shepp_formulas::Arcs& arcs,
                      const Symmetry& symmetry, double radius) {
  const Steps& steps = steps_of(formula);
  const double parts[] = {arcs.first, arcs.inner, arcs.line, arcs.last};
  const double curvature = symmetry.swaps_sides() ? -1 / radius : 1 / radius;
  const double scale = symmetry.swaps_gears() ? -radius : radius;
  Piece piece;
  piece.length = arcs.length * radius;
  for (std::size_t i = 0; i < steps.count; ++i) {
    const Step& step = steps.list[symmetry.swaps_ends() ? steps.count - 1 - i : i];
    const double part = parts[step.part];
    if (part <= 0) continue;
    piece.segments[piece.count++] = {step.turn * curvature, step.gear * part * scale};
  }
  return piece;
}

/// The arcs without the small negative first or last arc that rounding leaves on the border between
/// two words. The change of heading stays the same.
inline reeds_shepp_formulas::Arcs without_noise(reeds_shepp_formulas::Formula formula,
                                                reeds_shepp_formulas::Arcs arcs) {
  double& lesser = arcs.first < arcs.last ? arcs.first : arcs.last;
  double& greater = arcs.first < arcs.last ? arcs.last : arcs.first;
  if (lesser < 0) {
    greater += steps_of(formula).same_sense ? lesser : -lesser;
    lesser = 0;
  }
  return arcs;
}

}  // namespace vandplan::steering
