// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long are the parts of each Reeds-Shepp word, and which word is shortest?
//
// Reeds & Shepp 1990, formulas 8.1 to 8.11, in the mean frame and at unit radius. There one word
// per formula is enough for x, y, half_turn >= 0, and straight lines and circles divide the plane
// between the nine: docs/algorithms/steering.md has both, docs/proofs/steering.md the proof.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/trigonometry.h"
#include "steering/mean_frame.h"

namespace vandplan::steering::reeds_shepp_formulas {

using base::atan_2;

/// The nine formulas and two more, named by their words: l and r are arcs, s is a line, `_` a
/// change of gear. The last two have an inner arc of more than half a turn. They are never
/// shortest, but may need the fewest changes of gear.
enum class Formula { lsl, lsr, l_r_l, r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l, lrl, r_lr_wide };

/// Lengths of the parts of a word. Where a word is not shortest, `first` and `last` may need whole
/// turns to be added; `length` is right where they do not.
struct Arcs {
  double length;
  double first;
  double inner;  ///< length of each turn except the first and the last
  double line;
  double last;
};

inline double root(double value) { return std::sqrt(std::max(value, 0.0)); }

// Each function below begins with the vector between the centres of the first and last circle.

inline Arcs lsl(const Circles& p) {  // 8.1
  const double x = p.x - 2 * p.s, y = p.y;
  const double d = root(x * x + y * y);
  const double h = atan_2(y, x);
  return {d + 2 * p.a, p.a + h, 0, d, p.a - h};
}

inline Arcs lsr(const Circles& p) {  // 8.2
  const double x = p.x, y = p.y - 2 * p.c;
  const double d = root(p.lr);
  const double h = atan_2(y * d + 2 * x, x * d - 2 * y);
  return {d + 2 * h, h + p.a, 0, d, h - p.a};
}

inline Arcs l_r_l(const Circles& p) {  // 8.3
  const double x = 2 * p.s - p.x, y = p.y;
  const double d_squared = x * x + y * y;
  const double h = atan_2(y, x);
  const double half = atan_2(root(d_squared), root(16 - d_squared));
  return {2 * p.a, p.a - half - h, 2 * half, 0, p.a - half + h};
}

inline Arcs r_lr(const Circles& p) {  // 8.4
  const double x = p.x + 2 * p.s, y = p.y;
  const double d_squared = x * x + y * y;
  const double sin = root(d_squared) / 4;
  const double cos = root(1 - d_squared / 16);
  const double half = atan_2(sin, cos);
  const double sum = atan_2(y * cos + x * sin, x * cos - y * sin);
  return {2 * sum, sum + p.a - 2 * half, 2 * half, 0, sum - p.a};
}

inline Arcs lr_lr(const Circles& p) {  // 8.7
  const double x = p.x, y = 2 * p.c - p.y;
  const double d = root(x * x + y * y);  // 4 + lr would cancel
  const double sin_squared = -p.lr / (8 * (2 + d));
  const double u = 2 * atan_2(root(sin_squared), root(1 - sin_squared));
  const double h = atan_2(x, y);
  return {4 * u - 2 * p.a, u - p.a - h, u, 0, u - p.a + h};
}

inline Arcs r_lr_l(const Circles& p) {  // 8.8
  const double x = p.x, y = p.y + 2 * p.c;
  const double cos = 1 - p.rl / 16;
  const double sin = root(p.rl * (32 - p.rl)) / 16;
  const double u = atan_2(sin, cos);
  const double sum = atan_2(2 * sin * y - (2 * cos - 1) * x, (2 * cos - 1) * y + 2 * sin * x);
  return {2 * sum, sum - u + p.a, u, 0, sum - u - p.a};
}

inline Arcs r_lsr(const Circles& p) {  // 8.9
  constexpr double quarter = std::numbers::pi / 2;
  const double x = p.x + 2 * p.s, y = p.y;
  const double d = root(x * x + y * y - 4);
  const double h = atan_2(y * d + 2 * x, x * d - 2 * y);
  return {d - 2 + 2 * h, h + p.a - quarter, quarter, d - 2, h - p.a};
}

inline Arcs r_lsl(const Circles& p) {  // 8.10
  constexpr double quarter = std::numbers::pi / 2;
  const double x = p.x, y = p.y + 2 * p.c;
  const double d = root(4 + p.rl);
  const double h = atan_2(x, y);
  return {d - 2 + 2 * p.a, p.a - h, quarter, d - 2, p.a + h - quarter};
}

inline Arcs r_lsr_l(const Circles& p) {  // 8.11
  constexpr double quarter = std::numbers::pi / 2;
  const double x = p.x, y = p.y + 2 * p.c;
  const double d = root(p.rl);
  const double h = atan_2(2 * y - d * x, d * y + 2 * x);
  return {d - 4 + 2 * quarter + 2 * h, h + p.a, quarter, d - 4, h - p.a};
}

inline Arcs lrl(const Circles& p) {  // Dubins
  const double x = p.x - 2 * p.s, y = p.y;
  const double d_squared = x * x + y * y;
  const double h = atan_2(y, x);
  const double half = std::numbers::pi - atan_2(root(d_squared), root(16 - d_squared));
  return {2 * p.a + 4 * half, p.a + half + h, 2 * half, 0, p.a + half - h};
}

inline Arcs r_lr_wide(const Circles& p) {  // 8.4 with the other inner circle
  const double x = p.x + 2 * p.s, y = p.y;
  const double d_squared = x * x + y * y;
  const double h = atan_2(y, x);
  const double half = std::numbers::pi - atan_2(root(d_squared), root(16 - d_squared));
  return {2 * (h + half), h + p.a - half, 2 * half, 0, h - p.a + half};
}

/// The shortest word and its arcs.
struct Solution {
  Formula formula;
  Arcs arcs;
};

/// The shortest word for x, y, half_turn >= 0. Neighbouring words are equally long on the line or
/// circle between them, so that rounding may take either there.
inline Solution shortest(const Circles& p) {
  if (p.rl <= 0) return {Formula::l_r_l, l_r_l(p)};

  const double ahead = (p.x - 2 * p.s) * p.c - p.y * p.s;
  if (ahead <= 0 && p.x * p.s - p.y * p.c >= 2 * p.c * p.c) return {Formula::r_lsl, r_lsl(p)};
  if (ahead >= 0 && (p.x - 2 * p.s) * p.s - p.y * p.c >= 0) return {Formula::lsl, lsl(p)};

  const double x = p.x + 2 * p.s;
  const double beyond = x * p.c + p.y * p.s - 2;
  if (p.rl >= 16 && beyond <= 0) return {Formula::r_lsr_l, r_lsr_l(p)};
  if (x * x + p.y * p.y >= 8 && beyond >= 0 && ahead + 4 * p.s * p.c <= 2) {
    return {Formula::r_lsr, r_lsr(p)};
  }
  if (p.lr >= 0) return {Formula::lsr, lsr(p)};

  const bool is_r_lr_l = p.lr + 8 * p.s * x <= 0;
  const double across = 2 * p.c - p.y;
  const double d = root(p.x * p.x + across * across);
  const bool is_lr_lr =
      p.lr * (d + 4) + 4 * (d + 2) * (p.s * x + p.y * p.c) <= 0 && ahead + 2 * p.y * p.s <= 0;
  if (is_r_lr_l && is_lr_lr) {  // only the regions of these two overlap
    const Arcs r = r_lr_l(p);
    const Arcs l = lr_lr(p);
    return r.length <= l.length ? Solution{Formula::r_lr_l, r} : Solution{Formula::lr_lr, l};
  }
  if (is_r_lr_l) return {Formula::r_lr_l, r_lr_l(p)};
  if (is_lr_lr) return {Formula::lr_lr, lr_lr(p)};
  return {Formula::r_lr, r_lr(p)};
}

}  // namespace vandplan::steering::reeds_shepp_formulas
