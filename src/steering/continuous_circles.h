// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long are the parts of a word whose turns all reach full lock?
//
// Each such turn follows a circle of radius 1. The vector between the centres of neighbouring
// circles is known in the frame of the pose between them: docs/algorithms/continuous_steering.md.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/trigonometry.h"
#include "steering/continuous_turn.h"
#include "steering/mean_frame.h"
#include "steering/word.h"

namespace vandplan::steering {

/// Mean frame of a word (`MeanFrame`): x, y, half turn a, s = sin a, c = cos a.
struct WordFrame {
  double x, y, a, s, c;
};

inline WordFrame word_frame(const MeanFrame& f) noexcept {
  const auto [sin, cos] = base::sin_cos(f.half_turn);
  return {f.x, f.y, f.half_turn, sin, cos};
}

/// A complex number whose argument is an angle.
struct Arrow {
  double re = 1, im = 0;

  friend Arrow operator*(Arrow a, Arrow b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  [[nodiscard]] Arrow opposite() const { return {re, -im}; }  // conjugate: the negative angle
  [[nodiscard]] double angle() const { return base::atan_2(im, re); }
  [[nodiscard]] double squared() const { return re * re + im * im; }
};

/// A word by its circles. Turns are directions, which suffice for many tests without arc tangents.
struct CircleWord {
  Arrow first, last;
  Arrow inner;         ///< direction whose angle less `unwound` is that of each inner turn
  double unwound = 0;  ///< angle to subtract from that of `inner` [rad]
  bool wide = false;   ///< whether inner turns may exceed half a turn
  double quarter = 0;  ///< angle of inner turns in place of `inner`, if not 0 [rad]
  double line = 0;     ///< length of the line; negative: the circles are too close by as much
  bool exact = true;   ///< whether the circles meet, so that the word exists

  /// Angles of the turns and length of the line; first and last angle are in [-pi, pi].
  [[nodiscard]] reeds_shepp_formulas::Arcs arcs() const noexcept {
    double turn = quarter;
    if (turn == 0 && (inner.re != 1 || inner.im != 0)) {
      turn = inner.angle();
      if (wide && turn < 0) turn += 2 * std::numbers::pi;
      turn -= unwound;
    }
    return {0, first.angle(), turn, line, last.angle()};
  }
};

namespace circles {

using reeds_shepp_formulas::Formula, reeds_shepp_formulas::root;

/// Vector `v` from the centre of the first circle to that of the last, and its square.
struct Between {
  Between(const WordFrame& f, const Joints& j, const Steps& steps) noexcept {
    const Step& first = steps.list[0];
    const Step& last = steps.list[steps.count - 1];
    const double b0 = first.gear * j.start.ahead, b1 = last.gear * j.goal.ahead;
    const double a0 = first.turn * j.start.aside, a1 = last.turn * j.goal.aside;
    v.re = f.x - (b0 + b1) * f.c - (a0 + a1) * f.s;
    v.im = f.y + (b0 - b1) * f.s + (a1 - a0) * f.c;
    squared = v.squared();
    if (squared < 1e-60) v = {1e-30, 0};  // equal centres: any direction will do
  }
  Arrow v;
  double squared;
};

/// Inner turn and heading at the gear change, from a triangle of centres. One side spans `n` gear
/// changes, one a joint with straight wheels between turns to either side.
struct Triangle {
  Triangle(const Between& between, const Joints& j, double n, bool wide) noexcept {
    const double p = n * j.stop, q = j.reach;  // halves of two sides of the triangle
    const double d = std::sqrt(between.squared) / 2;
    const double cos = (p * p + q * q - d * d) / (2 * p * q);
    exact = std::abs(cos) <= 1;
    // The product of the sides keeps all digits where the triangle is flat.
    const double sin = root((p + q - d) * (p + q + d) * (d + q - p) * (d - q + p)) / (2 * p * q);
    inner = {cos, wide ? -sin : sin};
    const Arrow side{p - q * inner.re, q * inner.im};
    heading = Arrow{0, -1} * between.v * side;
  }
  Arrow inner, heading;
  bool exact;
};

/// The word of a formula with a line.
inline CircleWord lined_word(Formula formula, const WordFrame& f, const Joints& j) noexcept {
  constexpr double quarter = std::numbers::pi / 2;
  constexpr Arrow left{0, 1};
  const Between b(f, j, steps_of(formula));
  const Arrow v = b.v;
  const Arrow a{f.c, f.s};
  const double across = 2 * j.aside;
  CircleWord word;
  switch (formula) {
    case Formula::lsl:
      word.first = v * a;
      word.last = v.opposite() * a;
      word.line = std::sqrt(b.squared) - 2 * j.ahead;
      break;
    case Formula::lsr: {
      const double gap = b.squared - across * across;
      const Arrow h = v * Arrow{root(gap), across};
      word.first = h * a;
      word.last = h * a.opposite();
      word.line = root(gap) - 2 * j.ahead;
      word.exact = gap >= 0;
      break;
    }
    case Formula::r_lsr:
    case Formula::r_lsr_l: {
      const double gap = b.squared - across * across;
      const Arrow h = v * Arrow{across, -root(gap)};
      const bool ends_left = formula == Formula::r_lsr_l;
      word.first = h * a;
      word.last = ends_left ? h * a.opposite() : left * h * a.opposite();
      word.quarter = quarter;
      word.line = root(gap) - (ends_left ? 4 : 2) * j.stop - 2 * j.ahead;
      word.exact = gap >= 0;
      break;
    }
    case Formula::r_lsl: {
      const Arrow h = left.opposite() * v;
      word.first = h * a;
      word.last = (left * h).opposite() * a;
      word.quarter = quarter;
      word.line = std::sqrt(b.squared) - 2 * j.stop - 2 * j.ahead;
      break;
    }
    default:
      break;
  }
  return word;
}

/// The word of three arcs with a gear change at both joints (8.3).
inline CircleWord l_r_l_word(const Between& b, const Arrow& a, const Joints& j) noexcept {
  CircleWord word;
  const double rest = 16 * j.stop * j.stop - b.squared;
  const Arrow half{root(rest), std::sqrt(b.squared)};
  const Arrow middle{-b.v.re, -b.v.im};
  word.first = middle * half.opposite() * a;
  word.last = (middle * half).opposite() * a;
  word.inner = half * half;
  word.wide = true;
  word.exact = rest >= 0;
  return word;
}

/// The word of a formula without a line.
inline CircleWord arcs_word(Formula formula, const WordFrame& f, const Joints& j) noexcept {
  constexpr Arrow left{0, 1};
  const Between b(f, j, steps_of(formula));
  const Arrow v = b.v;
  const Arrow a{f.c, f.s};
  CircleWord word;
  switch (formula) {
    case Formula::l_r_l:
      return l_r_l_word(b, a, j);
    case Formula::r_lr:
    case Formula::r_lr_wide: {
      const Triangle t(b, j, 1, formula == Formula::r_lr_wide);
      word.first = t.heading * a;
      word.last = t.heading * a.opposite() * t.inner * Arrow{j.aside, -j.ahead};
      word.inner = t.inner;
      word.wide = formula == Formula::r_lr_wide;
      word.unwound = j.skew;
      word.exact = t.exact;
      break;
    }
    case Formula::lr_lr: {
      const double cos = (2 * j.stop + std::sqrt(b.squared)) / (4 * j.reach);
      word.inner = {cos, root(1 - cos * cos)};
      word.unwound = j.skew;
      const Arrow u = word.inner * Arrow{j.aside, -j.ahead};
      const Arrow h = left * v;
      word.first = u * (a * h).opposite();
      word.last = u * a.opposite() * h;
      word.exact = cos <= 1;
      break;
    }
    case Formula::r_lr_l: {
      const Triangle t(b, j, 2, false);
      word.first = t.heading * a;
      word.last = t.heading * a.opposite();
      word.inner = t.inner;
      word.unwound = j.skew;
      word.exact = t.exact;
      break;
    }
    case Formula::lrl: {  // a guess for Newton's method, as if the circles met
      const double d = std::min(1.0, std::sqrt(b.squared) / (4 * j.reach));
      const Arrow half{-root(1 - d * d), d};  // a quarter to a half turn
      word.first = a * v * half;
      word.last = a * v.opposite() * half;
      word.inner = half * half;
      word.wide = true;
      word.exact = false;
      break;
    }
    default:
      break;
  }
  return word;
}

inline CircleWord word_of(Formula formula, const WordFrame& f, const Joints& j) noexcept {
  const bool has_line = formula == Formula::lsl || formula == Formula::lsr ||
                        formula == Formula::r_lsr || formula == Formula::r_lsl ||
                        formula == Formula::r_lsr_l;
  return has_line ? lined_word(formula, f, j) : arcs_word(formula, f, j);
}

}  // namespace circles
}  // namespace vandplan::steering
