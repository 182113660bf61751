// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which image of a word may be the shortest, by the formula of the Reeds-Shepp word?
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

/// Longest ramp for which the lists were measured [turning radii].
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

/// How far below 0 the angle of a first or last turn may be [ramps], for the quick search to look
/// at its word.
struct Slack {
  double rolls, stands;  ///< limits for a vehicle that rolls or stands at that end
  [[nodiscard]] double where(bool it_stands) const { return it_stands ? stands : rolls; }
};

/// An image of a word, and the formulas of the Reeds-Shepp word for which it may be the shortest.
struct Likely {
  std::size_t kind;  ///< index in `kinds`
  Symmetry symmetry;
  Slack first, last;
  Formulas here;      ///< formulas for which it may be shortest without driving a winding back
  Formulas saving{};  ///< formulas for which it may be shortest if it drives a winding back
};

inline constexpr Slack half{0.5, 0.5};

/// Images where the curvature never jumps. `beside_windings` has their formulas beside windings.
inline constexpr std::array<Likely, 10> rolling = {{
    // clang-format off
    {0, none, {0.3, 0.3}, {0.3, 0.3},
     in({lsl, r_lsl})},
    {1, none, {0.4, 0.4}, {0.4, 0.4},
     in({lsl, lsr, r_lsr, r_lsl, r_lsr_l})},
    {6, none, {0.5, 0.5}, {0.5, 0.5},
     in({lsr, r_lsr, r_lsr_l})},
    {7, none, {0.5, 0.5}, {0.5, 0.5},
     in({lsl, r_lsr, r_lsl})},
    {2, none, {0.2, 0.2}, {0.2, 0.2},
     in({lsl, l_r_l, r_lsl})},
    {2, in_x, {1.0, 1.0}, {1.0, 1.0},
     in({lsl, lsr, l_r_l, r_lr, lr_lr, r_lsr, r_lsl})},
    {3, none, {0.7, 0.7}, {0.7, 0.7},
     in({lsl, lsr, r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l})},
    {4, none, {0.8, 0.8}, {0.8, 0.8},
     in({lsr, r_lr, lr_lr, r_lr_l})},
    {5, none, {0.2, 0.2}, {0.2, 0.2},
     in({lsr, r_lr_l, r_lsr_l})},
    {8, none, {0.2, 0.2}, {0.2, 0.2},
     in({r_lsr_l})},
    // clang-format on
}};

/// Images where the curvature may jump at both ends and inside.
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

/// An image that may be shortest for the same formulas, whether it drives a winding back or not.
constexpr Likely either(Likely likely) {
  likely.saving = likely.here;
  return likely;
}

/// Images where the curvature may jump inside, but not at both ends.
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

/// Images that may be shortest only if they drive a winding back.
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

/// Ways to begin and end in which an image may be shortest beside windings, for each formula of the
/// Reeds-Shepp word. Bit 5 * first + last stands for one pair of ways (see `beside`).
using BesideWindings = std::array<std::uint32_t, 9>;

/// Ways beside windings for each image of `rolling`, then of `saving_images`.
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

}  // namespace vandplan::steering::shortlists
