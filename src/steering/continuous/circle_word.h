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
#include "steering/continuous/turn.h"
#include "steering/mean_frame.h"
#include "steering/word.h"

namespace vandplan::steering::continuous {

using reeds_shepp_formulas::Arcs, reeds_shepp_formulas::Formula, reeds_shepp_formulas::root;

/// Mean frame of a word (`MeanFrame`): x, y, half turn a, s = sin a, c = cos a.
struct WordFrame {
  double x, y, a, s, c;
};

inline WordFrame word_frame(const MeanFrame& f) noexcept {
  const auto [sin, cos] = base::sin_cos(f.half_turn);
  return {f.x, f.y, f.half_turn, sin, cos};
}

/// A complex number whose argument is an angle.
struct Complex {
  double re = 1, im = 0;

  friend Complex operator*(Complex a, Complex b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  [[nodiscard]] Complex opposite() const { return {re, -im}; }  // conjugate: the negative angle
  [[nodiscard]] double angle() const { return base::atan_2(im, re); }
  [[nodiscard]] double squared() const { return re * re + im * im; }
};

inline constexpr double full_turn = 2 * std::numbers::pi;

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

/// A word by its circles. Turns are directions, which suffice for many tests without arc tangents.
struct CircleWord {
  Complex first, last;
  Complex inner;         ///< direction whose angle less `skew` is that of each inner turn
  double skew = 0;       ///< angle to subtract from that of `inner` [rad]
  bool is_wide = false;  ///< whether inner turns may exceed half a turn
  double quarter = 0;    ///< angle of inner turns in place of `inner`, if not 0 [rad]
  double line = 0;       ///< length of the line; negative: the circles are too close by as much
  bool exists = true;    ///< whether the circles meet, so that there is a word

  /// Angles of the turns and length of the line; first and last angle are in [-pi, pi].
  [[nodiscard]] Arcs arcs() const noexcept {
    double turn = quarter;
    if (turn == 0 && (inner.re != 1 || inner.im != 0)) {
      turn = inner.angle();
      if (is_wide && turn < 0) turn += 2 * std::numbers::pi;
      turn -= skew;
    }
    return {0, first.angle(), turn, line, last.angle()};
  }
};

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
  Complex v;
  double squared;
};

/// Inner turn and heading at the gear change, from a triangle of centres. One side spans `n` gear
/// changes, one a joint with straight wheels between turns to either side.
struct Triangle {
  Triangle(const Between& between, const Joints& j, double n, bool wide) noexcept {
    const double p = n * j.stop, q = j.reach;  // halves of two sides of the triangle
    const double d = std::sqrt(between.squared) / 2;
    const double cos = (p * p + q * q - d * d) / (2 * p * q);
    exists = std::abs(cos) <= 1;
    // The product of the sides keeps all digits where the triangle is flat.
    const double sin = root((p + q - d) * (p + q + d) * (d + q - p) * (d - q + p)) / (2 * p * q);
    inner = {cos, wide ? -sin : sin};
    const Complex side{p - q * inner.re, q * inner.im};
    heading = Complex{0, -1} * between.v * side;
  }
  Complex inner, heading;
  bool exists;
};

/// The word of a formula with a line.
inline CircleWord circle_word_with_line(Formula formula, const WordFrame& f,
                                        const Joints& j) noexcept {
  constexpr double quarter = std::numbers::pi / 2;
  constexpr Complex left{0, 1};
  const Between b(f, j, steps_of(formula));
  const Complex v = b.v;
  const Complex a{f.c, f.s};
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
      const Complex h = v * Complex{root(gap), across};
      word.first = h * a;
      word.last = h * a.opposite();
      word.line = root(gap) - 2 * j.ahead;
      word.exists = gap >= 0;
      break;
    }
    case Formula::r_lsr:
    case Formula::r_lsr_l: {
      const double gap = b.squared - across * across;
      const Complex h = v * Complex{across, -root(gap)};
      const bool ends_left = formula == Formula::r_lsr_l;
      word.first = h * a;
      word.last = ends_left ? h * a.opposite() : left * h * a.opposite();
      word.quarter = quarter;
      word.line = root(gap) - (ends_left ? 4 : 2) * j.stop - 2 * j.ahead;
      word.exists = gap >= 0;
      break;
    }
    case Formula::r_lsl: {
      const Complex h = left.opposite() * v;
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
inline CircleWord circle_word_l_r_l(const Between& b, const Complex& a, const Joints& j) noexcept {
  CircleWord word;
  const double rest = 16 * j.stop * j.stop - b.squared;
  const Complex half{root(rest), std::sqrt(b.squared)};
  const Complex middle{-b.v.re, -b.v.im};
  word.first = middle * half.opposite() * a;
  word.last = (middle * half).opposite() * a;
  word.inner = half * half;
  word.is_wide = true;
  word.exists = rest >= 0;
  return word;
}

/// The word of a formula without a line.
inline CircleWord circle_word_of_arcs(Formula formula, const WordFrame& f,
                                      const Joints& j) noexcept {
  constexpr Complex left{0, 1};
  const Between b(f, j, steps_of(formula));
  const Complex v = b.v;
  const Complex a{f.c, f.s};
  CircleWord word;
  switch (formula) {
    case Formula::l_r_l:
      return circle_word_l_r_l(b, a, j);
    case Formula::r_lr:
    case Formula::r_lr_wide: {
      const Triangle t(b, j, 1, formula == Formula::r_lr_wide);
      word.first = t.heading * a;
      word.last = t.heading * a.opposite() * t.inner * Complex{j.aside, -j.ahead};
      word.inner = t.inner;
      word.is_wide = formula == Formula::r_lr_wide;
      word.skew = j.skew;
      word.exists = t.exists;
      break;
    }
    case Formula::lr_lr: {
      const double cos = (2 * j.stop + std::sqrt(b.squared)) / (4 * j.reach);
      word.inner = {cos, root(1 - cos * cos)};
      word.skew = j.skew;
      const Complex u = word.inner * Complex{j.aside, -j.ahead};
      const Complex h = left * v;
      word.first = u * (a * h).opposite();
      word.last = u * a.opposite() * h;
      word.exists = cos <= 1;
      break;
    }
    case Formula::r_lr_l: {
      const Triangle t(b, j, 2, false);
      word.first = t.heading * a;
      word.last = t.heading * a.opposite();
      word.inner = t.inner;
      word.skew = j.skew;
      word.exists = t.exists;
      break;
    }
    case Formula::lrl: {  // a guess for Newton's method, as if the circles met
      const double d = std::min(1.0, std::sqrt(b.squared) / (4 * j.reach));
      const Complex half{-root(1 - d * d), d};  // a quarter to a half turn
      word.first = a * v * half;
      word.last = a * v.opposite() * half;
      word.inner = half * half;
      word.is_wide = true;
      word.exists = false;
      break;
    }
    default:
      break;
  }
  return word;
}

inline CircleWord circle_word_of(Formula formula, const WordFrame& f, const Joints& j) noexcept {
  const bool has_line = formula == Formula::lsl || formula == Formula::lsr ||
                        formula == Formula::r_lsr || formula == Formula::r_lsl ||
                        formula == Formula::r_lsr_l;
  return has_line ? circle_word_with_line(formula, f, j) : circle_word_of_arcs(formula, f, j);
}

}  // namespace vandplan::steering::continuous
