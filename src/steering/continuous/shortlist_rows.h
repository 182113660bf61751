// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which formula under which symmetry may give the shortest word, by the formula of the Reeds-Shepp
// word?
//
// All numbers are measured: docs/algorithms/continuous_steering.md, section 4.

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "steering/reeds_shepp_formulas.h"
#include "steering/word.h"

namespace vandplan::steering::continuous::shortlists {

using reeds_shepp_formulas::Formula;
using enum Formula;

/// Longest ramp for which the lists were measured [turning radii].
inline constexpr double longest_ramp = 0.6;

/// A set of formulas, a bit for each.
using FormulaSet = std::uint16_t;

constexpr FormulaSet in(std::initializer_list<Formula> formulas) {
  unsigned bits = 0;
  for (const Formula formula : formulas) bits |= 1U << static_cast<unsigned>(formula);
  return static_cast<FormulaSet>(bits);
}
inline constexpr FormulaSet no_formula = 0;

/// How far below 0 the angle of a first or last turn may be [ramps], so that the quick search tries
/// its word.
struct Slack {
  double rolls, stands;  ///< limits for a vehicle that rolls or stands at that end
  [[nodiscard]] double at(bool it_stands) const { return it_stands ? stands : rolls; }
};

/// A formula under a symmetry, and the formulas of the Reeds-Shepp word for which its word may be
/// the shortest.
struct Row {
  Formula formula;
  Symmetry symmetry;
  Slack first, last;
  FormulaSet plain;     ///< formulas for which it may be shortest without driving a winding back
  FormulaSet saving{};  ///< formulas for which it may be shortest if it drives a winding back
};

/// Words where the curvature never jumps. `beside_windings` has their formulas beside windings.
inline constexpr std::array<Row, 10> rolling_rows = {{
    // clang-format off
    {lsl, identity, {0.3, 0.3}, {0.3, 0.3},
     in({lsl, r_lsl})},
    {lsr, identity, {0.4, 0.4}, {0.4, 0.4},
     in({lsl, lsr, r_lsr, r_lsl, r_lsr_l})},
    {r_lsr, identity, {0.5, 0.5}, {0.5, 0.5},
     in({lsr, r_lsr, r_lsr_l})},
    {r_lsl, identity, {0.5, 0.5}, {0.5, 0.5},
     in({lsl, r_lsr, r_lsl})},
    {l_r_l, identity, {0.2, 0.2}, {0.2, 0.2},
     in({lsl, l_r_l, r_lsl})},
    {l_r_l, in_x, {1.0, 1.0}, {1.0, 1.0},
     in({lsl, lsr, l_r_l, r_lr, lr_lr, r_lsr, r_lsl})},
    {r_lr, identity, {0.7, 0.7}, {0.7, 0.7},
     in({lsl, lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})},
    {lr_lr, identity, {0.8, 0.8}, {0.8, 0.8},
     in({lsr, r_lr, lr_lr, r_lr_l})},
    {r_lr_l, identity, {0.2, 0.2}, {0.2, 0.2},
     in({lsr, r_lr_l, r_lsr_l})},
    {r_lsr_l, identity, {0.2, 0.2}, {0.2, 0.2},
     in({r_lsr_l})},
    // clang-format on
}};

/// Words where the curvature may jump at both ends and inside.
inline constexpr std::array<Row, 10> standing_rows = {{
    // clang-format off
    {lsl, identity, {0.02, 0.02}, {0.02, 0.02},
     in({lsl, r_lsl})},
    {lsr, identity, {0.02, 0.02}, {0.02, 0.02},
     in({lsl, lsr, r_lsr, r_lsl})},
    {r_lsr, identity, {0.02, 0.02}, {0.02, 0.02},
     in({r_lsr, r_lsl, r_lsr_l})},
    {r_lsl, identity, {0.02, 0.02}, {0.02, 0.02},
     in({r_lsr, r_lsl})},
    {l_r_l, identity, {0.0, 0.0}, {0.0, 0.0},
     in({lsl, l_r_l})},
    {l_r_l, in_x, {0.0, 0.0}, {0.0, 0.0}, no_formula},
    {r_lr, identity, {0.0, 0.0}, {0.6, 0.6},
     in({lsl, lsr, r_lr, lr_lr, r_lsr, r_lsl})},
    {lr_lr, identity, {0.6, 0.6}, {0.6, 0.6},
     in({r_lr, lr_lr})},
    {r_lr_l, identity, {0.02, 0.02}, {0.02, 0.02},
     in({lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsr_l})},
    {r_lsr_l, identity, {0.02, 0.02}, {0.02, 0.02},
     in({r_lsr_l})},
    // clang-format on
}};

/// A row that may be shortest for the same formulas, whether it drives a winding back or not.
constexpr Row saving_or_not(Row row) {
  row.saving = row.plain;
  return row;
}

/// Words where the curvature may jump inside, but not at both ends.
inline constexpr std::array<Row, 16> leg_rows = {{
    // clang-format off
    saving_or_not({lsl, identity, {0.02, 0.02}, {0.05, 0.02},
                   in({lsl, r_lsl})}),
    saving_or_not({lsr, identity, {0.02, 0.02}, {0.02, 0.02},
                   in({lsl, lsr, r_lsr, r_lsl, r_lsr_l})}),
    saving_or_not({r_lsr, identity, {0.25, 0.02}, {0.12, 0.1},
                   in({lsr, r_lsr, r_lsl, r_lsr_l})}),
    saving_or_not({r_lsl, identity, {0.27, 0.02}, {0.02, 0.02},
                   in({lsl, r_lsr, r_lsl})}),
    saving_or_not({l_r_l, identity, {0.27, 0.06}, {0.2, 0.06},
                   in({lsl, lsr, l_r_l, r_lr, lr_lr, r_lsr, r_lsl})}),
    saving_or_not({l_r_l, in_x, {0.3, 0.3}, {0.27, 0.2},
                   in({l_r_l, r_lr, lr_lr, r_lsr, r_lsl})}),
    saving_or_not({r_lr, identity, {0.3, 0.05}, {0.55, 0.55},
                   in({lsl, lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})}),
    saving_or_not({lr_lr, identity, {0.6, 0.7}, {0.65, 0.5},
                   in({lsr, r_lr, lr_lr, r_lr_l})}),
    saving_or_not({r_lr_l, identity, {0.2, 0.06}, {0.22, 0.1},
                   in({lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsr_l})}),
    saving_or_not({r_lsr_l, identity, {0.05, 0.1}, {0.12, 0.02},
                   in({r_lsr, r_lsr_l})}),
    saving_or_not({r_lr, in_half_turn, {0.25, 0.3}, {0.0, 0.0},
                   in({lsl, lsr, r_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})}),
    saving_or_not({r_lr, in_x, {0.0, 0.0}, {0.5, 0.0},
                   in({r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})}),
    saving_or_not({lr_lr, in_half_turn, {0.2, 0.5}, {0.0, 0.0},
                   in({lsl, lsr, r_lr, lr_lr, r_lr_l})}),
    saving_or_not({lr_lr, {false, true, true}, {0.15, 0.05}, {0.0, 0.0},
                   in({lsl, lsr, r_lr, lr_lr, r_lsr, r_lsl})}),
    saving_or_not({r_lr_l, in_x, {0.0, 0.0}, {0.0, 0.0},
                   in({lsl, lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})}),
    saving_or_not({r_lr_l, {true, true, false}, {0.0, 0.0}, {0.0, 0.0},
                   in({lsl, lsr, r_lsl})}),
    // clang-format on
}};

/// A row that may be shortest only if it drives a winding back.
constexpr Row only_saving(Formula formula, const Symmetry& symmetry, FormulaSet saving) {
  constexpr Slack half_ramp{0.5, 0.5};
  return {formula, symmetry, half_ramp, half_ramp, no_formula, saving};
}

/// Words that may be shortest only if they drive a winding back.
inline constexpr std::array<Row, 19> saving_rows = {{
    // clang-format off
    only_saving(lsl, {true, true, true}, in({lsl, r_lsl})),
    only_saving(lsr, in_x, in({lsr, r_lsr, r_lsr_l})),
    only_saving(l_r_l, {true, false, true}, in({r_lsr, r_lsl})),
    only_saving(l_r_l, {false, true, true}, in({l_r_l, r_lr, r_lsr, r_lsl})),
    only_saving(l_r_l, {true, true, true}, in({l_r_l, r_lr, r_lsr, r_lsl})),
    only_saving(r_lr, in_x, in({r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})),
    only_saving(r_lr, in_half_turn, in({lsl, lsr, r_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})),
    only_saving(r_lr, {true, false, true}, in({r_lr_l, r_lsr_l})),
    only_saving(r_lr, {false, true, true}, in({lsl, r_lsr, r_lsl})),
    only_saving(lr_lr, in_half_turn, in({lsl, lsr, l_r_l, r_lr, lr_lr, r_lr_l})),
    only_saving(lr_lr, {false, true, true}, in({lsl, lsr, l_r_l, r_lr, lr_lr, r_lsr, r_lsl})),
    only_saving(r_lr_l, in_x, in({lsl, lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})),
    only_saving(r_lsr, in_x, in({r_lsr, r_lsl, r_lsr_l})),
    only_saving(r_lsr, in_half_turn, in({r_lsr, r_lsr_l})),
    only_saving(r_lsr, {true, false, true}, in({r_lsr, r_lsr_l})),
    only_saving(r_lsr, {false, true, true}, in({r_lsr, r_lsl})),
    only_saving(r_lsl, {false, true, true}, in({r_lsr})),
    only_saving(r_lsl, {true, true, true}, in({r_lsr, r_lsl})),
    only_saving(r_lsr_l, in_x, in({lsr, r_lsr, r_lsr_l})),
    // clang-format on
}};

/// Pairs of first and last letter with which a word may be shortest beside windings, for each
/// formula of the Reeds-Shepp word. Bit 5 * first + last stands for one pair (see `beside`).
using BesideWindings = std::array<std::uint32_t, 9>;

/// Pairs beside windings for each row of `rolling_rows`, then of `saving_rows`.
inline constexpr std::array<BesideWindings, 29> beside_windings = {{
    // clang-format off
    {{0xbd83ff, 0, 0, 0, 0, 0, 0, 0xbd837f, 0}},
    {{0xbd8b7f, 0xbd877b, 0, 0, 0, 0, 0xb0837b, 0x98833b, 0x300273}},
    {{0, 0, 0, 0, 0, 0, 0xbd833b, 0, 0x398233}},
    {{0xb48403, 0, 0, 0, 0, 0, 0xbc807b, 0xbd877b, 0}},
    {{0x108425, 0x108021, 0x10843f, 0x10843f, 0x10803b, 0, 0x108021, 0x10ce3b, 0}},
    {{0xffffbf, 0xffc7b3, 0xfdefff, 0xfdefff, 0xffffff, 0, 0xbd833b, 0xfcc379, 0}},
    {{0xbde23b, 0xbdec3f, 0, 0xbdef7b, 0xbdef3b, 0xbdec3b, 0xbd83bb, 0xfe8279, 0x39803b}},
    {{0, 0, 0, 0, 0xbd807b, 0xbd801b, 0x000001, 0x108001, 0}},
    {{0, 0, 0, 0, 0x108019, 0xbd801b, 0, 0, 0x188019}},
    {{0, 0, 0, 0, 0, 0, 0, 0, 0xbd803b}},
    {{0x100033, 0, 0x000001, 0, 0, 0, 0, 0x10823b, 0}},
    {{0, 0x000001, 0, 0, 0, 0, 0x108011, 0, 0x100033}},
    {{0, 0, 0x000013, 0, 0, 0, 0, 0x000019, 0}},
    {{0x000001, 0, 0x10003b, 0, 0, 0, 0x108001, 0x108021, 0}},
    {{0, 0, 0x108028, 0, 0, 0, 0x000019, 0x800106, 0}},
    {{0, 0, 0, 0x108021, 0x108021, 0x100031, 0x108039, 0x108021, 0x100039}},
    {{0x00001f, 0x10001f, 0, 0x10001f, 0, 0x10803f, 0x10001b, 0x000019, 0x10003b}},
    {{0, 0, 0, 0, 0, 0x000001, 0, 0, 0x000001}},
    {{0x108621, 0x100401, 0, 0x000001, 0, 0, 0x000019, 0x10863b, 0}},
    {{0, 0, 0x000001, 0x000010, 0x000001, 0x10003b, 0, 0, 0}},
    {{0x108401, 0x008000, 0x000001, 0x108421, 0x108421, 0, 0x108421, 0xb08439, 0}},
    {{0x100001, 0x100001, 0, 0x108401, 0x108019, 0x108019, 0x100000, 0, 0x100011}},
    {{0, 0, 0, 0, 0, 0, 0x108039, 0x108001, 0x100039}},
    {{0, 0x000010, 0, 0, 0, 0, 0x000010, 0, 0x10003b}},
    {{0, 0, 0, 0, 0, 0, 0, 0, 0x100011}},
    {{0, 0, 0, 0, 0, 0, 0x000018, 0x000019, 0}},
    {{0, 0, 0, 0, 0, 0, 0x000019, 0, 0}},
    {{0, 0, 0, 0, 0, 0, 0x008001, 0x008009, 0}},
    {{0, 0, 0, 0, 0, 0, 0, 0, 0x108019}},
    // clang-format on
}};

}  // namespace vandplan::steering::continuous::shortlists
