// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words of continuous steering may be the least, told by the word of Reeds and Shepp?
//
// All numbers are measured: docs/algorithms/continuous_steering.md, section 4.

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "steering/continuous_kinds.h"
#include "steering/word.h"

namespace vandplan::steering::shortlists {

using namespace families;
using enum Formula;

/// The longest ramp for which all this was measured.
inline constexpr double longest_ramp = 0.6;

/// A set of formulas, a bit for each.
using Formulas = std::uint16_t;

constexpr Formulas in(std::initializer_list<Formula> formulas) {
  unsigned bits = 0;
  for (const Formula formula : formulas) bits |= 1U << static_cast<unsigned>(formula);
  return static_cast<Formulas>(bits);
}
constexpr bool contains(Formulas set, Formula formula) {
  return (set >> static_cast<unsigned>(formula) & 1U) != 0;
}
inline constexpr Formulas nowhere = 0;

/// By how many ramps a first or last turn may be shorter than nothing, for the quick search to look
/// at its word.
struct Slack {
  double rolls, stands;  ///< there, at the start or the goal
  [[nodiscard]] double where(bool it_stands) const { return it_stands ? stands : rolls; }
};

/// An image of a word that may be the least where that of Reeds and Shepp is of some formulas.
struct Likely {
  std::size_t kind;
  Symmetry symmetry;
  Slack first, last;
  Formulas here;      ///< where it saves nothing
  Formulas saving{};  ///< where it drives a winding back
};

inline constexpr Slack half{0.5, 0.5};

/// Where the curvature never jumps.
inline constexpr std::array<Likely, 10> rolling = {{
    // clang-format off
    {0, none, {0.3, 0.3}, {0.3, 0.3},
     in({lsl, r_lsl}),
     in({lsl, r_lsl})},
    {1, none, {0.4, 0.4}, {0.4, 0.4},
     in({lsl, lsr, r_lsr, r_lsl, r_lsr_l}),
     in({lsl, lsr, r_lsr, r_lsl, r_lsr_l})},
    {6, none, {0.5, 0.5}, {0.5, 0.5},
     in({lsr, r_lsr, r_lsr_l}),
     in({r_lsr, r_lsr_l})},
    {7, none, {0.5, 0.5}, {0.5, 0.5},
     in({lsl, r_lsr, r_lsl}),
     in({lsl, r_lsr, r_lsl})},
    {2, none, {0.2, 0.2}, {0.2, 0.2},
     in({lsl, l_r_l, r_lsl}),
     in({lsl, lsr, l_r_l, r_lr, lr_lr, r_lsr, r_lsl})},
    {2, in_x, {1.0, 1.0}, {1.0, 1.0},
     in({lsl, lsr, l_r_l, r_lr, lr_lr, r_lsr, r_lsl}),
     in({lsl, lsr, l_r_l, r_lr, lr_lr, r_lsr, r_lsl})},
    {3, none, {0.7, 0.7}, {0.7, 0.7},
     in({lsl, lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l}),
     in({lsl, lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})},
    {4, none, {0.8, 0.8}, {0.8, 0.8},
     in({lsr, r_lr, lr_lr, r_lr_l}),
     in({r_lr, lr_lr, r_lr_l, r_lsr, r_lsl})},
    {5, none, {0.2, 0.2}, {0.2, 0.2},
     in({lsr, r_lr_l, r_lsr_l}),
     in({lr_lr, r_lr_l, r_lsr_l})},
    {8, none, {0.2, 0.2}, {0.2, 0.2},
     in({r_lsr_l}),
     in({r_lsr_l})},
    // clang-format on
}};

/// Where it jumps at both ends and inside.
inline constexpr std::array<Likely, 10> standing = {{
    // clang-format off
    {0, none, {0.02, 0.02}, {0.02, 0.02},
     in({lsl, r_lsl}), nowhere},
    {1, none, {0.02, 0.02}, {0.02, 0.02},
     in({lsl, lsr, r_lsr, r_lsl}), nowhere},
    {6, none, {0.02, 0.02}, {0.02, 0.02},
     in({r_lsr, r_lsl, r_lsr_l}), nowhere},
    {7, none, {0.02, 0.02}, {0.02, 0.02},
     in({r_lsr, r_lsl}), nowhere},
    {2, none, {0.0, 0.0}, {0.0, 0.0},
     in({lsl, l_r_l}), nowhere},
    {2, in_x, {0.0, 0.0}, {0.0, 0.0}, nowhere, nowhere},
    {3, none, {0.0, 0.0}, {0.6, 0.6},
     in({lsl, lsr, r_lr, lr_lr, r_lsr, r_lsl}), nowhere},
    {4, none, {0.6, 0.6}, {0.6, 0.6},
     in({r_lr, lr_lr}), nowhere},
    {5, none, {0.02, 0.02}, {0.02, 0.02},
     in({lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsr_l}), nowhere},
    {8, none, {0.02, 0.02}, {0.02, 0.02},
     in({r_lsr_l}), nowhere},
    // clang-format on
}};

/// An image that may be the least in the same places whether it saves or not.
constexpr Likely either(Likely likely) {
  likely.saving = likely.here;
  return likely;
}

/// Where it jumps inside, but not at both ends.
inline constexpr std::array<Likely, 16> legs = {{
    // clang-format off
    either({0, none, {0.02, 0.02}, {0.05, 0.02},
            in({lsl, r_lsl})}),
    either({1, none, {0.02, 0.02}, {0.02, 0.02},
            in({lsl, lsr, r_lsr, r_lsl, r_lsr_l})}),
    either({6, none, {0.25, 0.02}, {0.12, 0.1},
            in({lsr, r_lsr, r_lsl, r_lsr_l})}),
    either({7, none, {0.27, 0.02}, {0.02, 0.02},
            in({lsl, r_lsr, r_lsl})}),
    either({2, none, {0.27, 0.06}, {0.2, 0.06},
            in({lsl, lsr, l_r_l, r_lr, lr_lr, r_lsr, r_lsl})}),
    either({2, in_x, {0.3, 0.3}, {0.27, 0.2},
            in({l_r_l, r_lr, lr_lr, r_lsr, r_lsl})}),
    either({3, none, {0.3, 0.05}, {0.55, 0.55},
            in({lsl, lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})}),
    either({4, none, {0.6, 0.7}, {0.65, 0.5},
            in({lsr, r_lr, lr_lr, r_lr_l})}),
    either({5, none, {0.2, 0.06}, {0.22, 0.1},
            in({lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsr_l})}),
    either({8, none, {0.05, 0.1}, {0.12, 0.02},
            in({r_lsr, r_lsr_l})}),
    either({3, in_half_turn, {0.25, 0.3}, {0.0, 0.0},
            in({lsl, lsr, r_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})}),
    either({3, in_x, {0.0, 0.0}, {0.5, 0.0},
            in({r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})}),
    either({4, in_half_turn, {0.2, 0.5}, {0.0, 0.0},
            in({lsl, lsr, r_lr, lr_lr, r_lr_l})}),
    either({4, {false, true, true}, {0.15, 0.05}, {0.0, 0.0},
            in({lsl, lsr, r_lr, lr_lr, r_lsr, r_lsl})}),
    either({5, in_x, {0.0, 0.0}, {0.0, 0.0},
            in({lsl, lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})}),
    either({5, {true, true, false}, {0.0, 0.0}, {0.0, 0.0},
            in({lsl, lsr, r_lsl})}),
    // clang-format on
}};

/// Where one of these may be the least it drives a winding back.
inline constexpr std::array<Likely, 19> saving_images = {{
    // clang-format off
    {0, {true, true, true}, half, half, nowhere, in({lsl, r_lsl})},
    {1, in_x, half, half, nowhere, in({lsr, r_lsr, r_lsr_l})},
    {2, {true, false, true}, half, half, nowhere, in({r_lsr, r_lsl})},
    {2, {false, true, true}, half, half, nowhere, in({l_r_l, r_lr, r_lsr, r_lsl})},
    {2, {true, true, true}, half, half, nowhere, in({l_r_l, r_lr, r_lsr, r_lsl})},
    {3, in_x, half, half, nowhere, in({r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})},
    {3, in_half_turn, half, half, nowhere, in({lsl, lsr, r_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})},
    {3, {true, false, true}, half, half, nowhere, in({r_lr_l, r_lsr_l})},
    {3, {false, true, true}, half, half, nowhere, in({lsl, r_lsr, r_lsl})},
    {4, in_half_turn, half, half, nowhere, in({lsl, lsr, l_r_l, r_lr, lr_lr, r_lr_l})},
    {4, {false, true, true}, half, half, nowhere, in({lsl, lsr, l_r_l, r_lr, lr_lr, r_lsr, r_lsl})},
    {5, in_x, half, half, nowhere, in({lsl, lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})},
    {6, in_x, half, half, nowhere, in({r_lsr, r_lsl, r_lsr_l})},
    {6, in_half_turn, half, half, nowhere, in({r_lsr, r_lsr_l})},
    {6, {true, false, true}, half, half, nowhere, in({r_lsr, r_lsr_l})},
    {6, {false, true, true}, half, half, nowhere, in({r_lsr, r_lsl})},
    {7, {false, true, true}, half, half, nowhere, in({r_lsr})},
    {7, {true, true, true}, half, half, nowhere, in({r_lsr, r_lsl})},
    {8, in_x, half, half, nowhere, in({lsr, r_lsr, r_lsr_l})},
    // clang-format on
}};

/// Gear and side of a step in two bits, or no step.
using Way = unsigned;
inline constexpr Way no_way = 4;
constexpr Way way_of(double gear, double side) {
  return (gear < 0 ? 2U : 0U) + (side < 0 ? 1U : 0U);
}
/// What a symmetry changes of each.
constexpr Way flips_of(const Symmetry& symmetry) {
  return (symmetry.swaps_gears() ? 2U : 0U) + (symmetry.swaps_sides() ? 1U : 0U);
}

struct Ways {
  Way first, last;
};

/// In which ways a word of a kind begins and ends in a symmetry.
constexpr Ways ways_of(const Kind& kind, const Symmetry& symmetry) {
  const Steps& steps = all_steps[static_cast<std::size_t>(kind.formula)];
  const Step& begin = steps.list[symmetry.swaps_ends() ? steps.count - 1 : 0];
  const Step& end = steps.list[symmetry.swaps_ends() ? 0 : steps.count - 1];
  const Way flips = flips_of(symmetry);
  return {way_of(begin.gear, begin.turn) ^ flips, way_of(end.gear, end.turn) ^ flips};
}

/// A set of the rows of a list, a bit for each.
using Rows = std::uint64_t;

/// Images with all sets of them that a search asks for.
struct List {
  std::array<Likely, 35> rows{};
  Rows likely{};                    ///< those that may be the least where nothing is saved
  Rows arcs{};                      ///< those without a line
  std::array<Rows, 9> here{};       ///< by the formula of Reeds and Shepp
  std::array<Rows, 9> saving{};     ///< the same, of those that drive a winding back
  std::array<Rows, 5> first_way{};  ///< by the way in which a word begins
  std::array<Rows, 5> last_way{};   ///< and ends

  constexpr void add(std::size_t i, const Likely& row) {
    const Steps& steps = all_steps[static_cast<std::size_t>(kinds[row.kind].formula)];
    const Rows bit = Rows{1} << i;
    rows[i] = row;
    if (steps.list[1].turn != 0 && steps.list[2].turn != 0) arcs |= bit;
    for (std::size_t formula = 0; formula < 9; ++formula) {
      if ((row.here >> formula & 1U) != 0) here[formula] |= bit;
      if ((row.saving >> formula & 1U) != 0) saving[formula] |= bit;
    }
    const Ways ways = ways_of(kinds[row.kind], row.symmetry);
    first_way[ways.first] |= bit;
    last_way[ways.last] |= bit;
  }
};

template <std::size_t n>
constexpr List list_of(const std::array<Likely, n>& likely) {
  List list;
  for (std::size_t i = 0; i < n; ++i) list.add(i, likely[i]);
  for (std::size_t i = 0; i < saving_images.size(); ++i) list.add(n + i, saving_images[i]);
  list.likely = (Rows{1} << n) - 1;
  return list;
}

inline constexpr List rolling_list = list_of(rolling);
inline constexpr List standing_list = list_of(standing);
inline constexpr List leg_list = list_of(legs);

}  // namespace vandplan::steering::shortlists
