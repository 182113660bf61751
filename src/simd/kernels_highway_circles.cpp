// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The words of steering/continuous/circle_word.h in vectors of double, where the curvature never
// jumps: the same operations in the same order, so the same bits. Where the scalar code branches,
// lanes are chosen.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "base/trigonometry_series.h"
#include "simd/circle_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "simd/kernels_highway_circles.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
#include "simd/kernels_highway_angles-inl.h"

// Clang takes minutes to put AddressSanitizer's checks into functions as large as these would be.
#if HWY_IS_ASAN
#define VANDPLAN_PART HWY_NOINLINE
#else
#define VANDPLAN_PART HWY_INLINE
#endif

HWY_BEFORE_NAMESPACE();
namespace vandplan::simd::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
// Most calls have few words of a formula: wider vectors would be empty.
using D = hn::CappedTag<double, 4>;
using V = hn::Vec<D>;
using Which = hn::Mask<D>;

HWY_INLINE V set(double value) { return hn::Set(D(), value); }

/// std::max(value, 0.0) in each lane, for -0 and NaN, too.
HWY_INLINE V at_least_zero(V value) {
  return hn::IfThenZeroElse(hn::Lt(value, hn::Zero(D())), value);
}
HWY_INLINE V root(V value) { return hn::Sqrt(at_least_zero(value)); }

/// Complex numbers whose arguments are angles.
struct Complex {
  V re, im;
};
HWY_INLINE Complex operator*(Complex a, Complex b) {
  return {hn::Sub(hn::Mul(a.re, b.re), hn::Mul(a.im, b.im)),
          hn::Add(hn::Mul(a.re, b.im), hn::Mul(a.im, b.re))};
}
HWY_INLINE Complex complex(double re, double im) { return {set(re), set(im)}; }
HWY_INLINE Complex opposite(Complex a) { return {a.re, hn::Neg(a.im)}; }
VANDPLAN_PART V angle(Complex a) { return Angles<V>::atan_2(a.im, a.re); }
HWY_INLINE V squared(Complex a) { return hn::Add(hn::Mul(a.re, a.re), hn::Mul(a.im, a.im)); }

/// Words by their circles.
struct Words {
  Complex first, last, inner;
  V line;
  Which exists;
};

/// Frames of words, and vectors from the centres of their first circles to those of their last.
struct Between {
  Complex a, v;
  V squared;
};

HWY_INLINE Between between(const CircleWords& words, std::size_t i, const CircleFormula& f,
                           const CircleTurns& t) {
  const D d;
  const Complex a{hn::LoadU(d, &words.cos[i]), hn::LoadU(d, &words.sin[i])};
  const double b0 = f.first_gear * t.ahead, b1 = f.last_gear * t.ahead;
  const double a0 = f.first_turn * t.aside, a1 = f.last_turn * t.aside;
  const V x = hn::LoadU(d, &words.x[i]), y = hn::LoadU(d, &words.y[i]);
  Complex v{hn::Sub(hn::Sub(x, hn::Mul(set(b0 + b1), a.re)), hn::Mul(set(a0 + a1), a.im)),
            hn::Add(hn::Add(y, hn::Mul(set(b0 - b1), a.im)), hn::Mul(set(a1 - a0), a.re))};
  const V square = squared(v);
  const Which none = hn::Lt(square, set(1e-60));
  v = {hn::IfThenElse(none, set(1e-30), v.re), hn::IfThenZeroElse(none, v.im)};
  return {a, v, square};
}

/// The inner turn and the heading at the change of gear, from the triangle of the centres.
struct Triangle {
  Complex inner, heading;
  Which exists;
};

HWY_INLINE Triangle triangle(const Between& b, const CircleTurns& t, double n) {
  const double p = n * t.aside, q = t.reach;
  const V d = hn::Mul(hn::Sqrt(b.squared), set(0.5));
  const V sides = set(2 * p * q);
  const V cos = hn::Div(hn::Sub(set(p * p + q * q), hn::Mul(d, d)), sides);
  const V product = hn::Mul(hn::Mul(hn::Sub(set(p + q), d), hn::Add(set(p + q), d)),
                            hn::Sub(hn::Add(d, set(q)), set(p)));
  const V sin = hn::Div(root(hn::Mul(product, hn::Add(hn::Sub(d, set(q)), set(p)))), sides);
  const Complex side{hn::Sub(set(p), hn::Mul(set(q), cos)), hn::Mul(set(q), sin)};
  return {{cos, sin}, complex(0, -1) * b.v * side, hn::Le(hn::Abs(cos), set(1))};
}

// Formulas in the order of reeds_shepp_formulas::Formula.
enum : std::size_t { lsl, lsr, l_r_l, r_lr, lr_lr, r_lr_l, r_lsr, r_lsl, r_lsr_l };

constexpr bool has_line(std::size_t formula) { return formula < l_r_l || formula > r_lr_l; }

template <std::size_t formula>
VANDPLAN_PART Words with_line(const Between& b, const CircleTurns& t) {
  const Complex &a = b.a, &v = b.v;
  const Complex left = complex(0, 1);
  const V across = set(2 * t.aside);
  const V gap = hn::Sub(b.squared, hn::Mul(across, across));
  const V clothoids = set(2 * t.ahead);
  const Which always = hn::Eq(across, across);
  if constexpr (formula == lsl) {
    return {v * a, opposite(v) * a, complex(1, 0), hn::Sub(hn::Sqrt(b.squared), clothoids), always};
  } else if constexpr (formula == lsr) {
    const Complex h = v * Complex{root(gap), across};
    return {h * a, h * opposite(a), complex(1, 0), hn::Sub(root(gap), clothoids),
            hn::Ge(gap, hn::Zero(D()))};
  } else if constexpr (formula == r_lsl) {
    const Complex h = complex(0, -1) * v;
    const V line = hn::Sub(hn::Sub(hn::Sqrt(b.squared), across), clothoids);
    return {h * a, opposite(left * h) * a, complex(1, 0), line, always};
  } else {
    constexpr bool ends_left = formula == r_lsr_l;
    const Complex h = v * Complex{across, hn::Neg(root(gap))};
    const V stops = set((ends_left ? 4 : 2) * t.aside);
    const V line = hn::Sub(hn::Sub(root(gap), stops), clothoids);
    return {h * a, (ends_left ? h : left * h) * opposite(a), complex(1, 0), line,
            hn::Ge(gap, hn::Zero(D()))};
  }
}

template <std::size_t formula>
VANDPLAN_PART Words of_arcs(const Between& b, const CircleTurns& t) {
  const Complex &a = b.a, &v = b.v;
  const V no_line = hn::Zero(D());
  const Complex skew = complex(t.aside, -t.ahead);
  if constexpr (formula == l_r_l) {
    const V rest = hn::Sub(set(16 * t.aside * t.aside), b.squared);
    const Complex half{root(rest), hn::Sqrt(b.squared)};
    const Complex middle{hn::Neg(v.re), hn::Neg(v.im)};
    return {middle * opposite(half) * a, opposite(middle * half) * a, half * half, no_line,
            hn::Ge(rest, hn::Zero(D()))};
  } else if constexpr (formula == lr_lr) {
    const V cos = hn::Div(hn::Add(set(2 * t.aside), hn::Sqrt(b.squared)), set(4 * t.reach));
    const Complex inner{cos, root(hn::Sub(set(1), hn::Mul(cos, cos)))};
    const Complex u = inner * skew;
    const Complex h = complex(0, 1) * v;
    return {u * opposite(a * h), u * opposite(a) * h, inner, no_line, hn::Le(cos, set(1))};
  } else {
    const Triangle tri = triangle(b, t, formula == r_lr_l ? 2 : 1);
    Complex last = tri.heading * opposite(a);
    if constexpr (formula == r_lr) last = last * tri.inner * skew;
    return {tri.heading * a, last, tri.inner, no_line, tri.exists};
  }
}

/// The angle of an inner turn.
template <std::size_t formula>
HWY_INLINE V inner_angle(const Words& words, const CircleTurns& t) {
  if constexpr (formula == lsl || formula == lsr) return hn::Zero(D());
  if constexpr (has_line(formula)) return set(std::numbers::pi / 2);
  V turn = angle(words.inner);
  if constexpr (formula == l_r_l) {
    turn =
        hn::IfThenElse(hn::Lt(turn, hn::Zero(D())), hn::Add(turn, set(2 * std::numbers::pi)), turn);
  } else {
    turn = hn::Sub(turn, set(t.skew));
  }
  const Which none = hn::And(hn::Eq(words.inner.re, set(1)), hn::Eq(words.inner.im, hn::Zero(D())));
  return hn::IfThenZeroElse(none, turn);
}

/// Angles of [-pi, pi], with a whole turn added to those below -1/2 [rad].
HWY_INLINE V in_one_turn(V angle) {
  return hn::IfThenElse(hn::Lt(angle, set(-0.5)), hn::Add(angle, set(2 * std::numbers::pi)), angle);
}

/// Lanes in which the angle of a direction is below -slack or too far beyond a quarter turn.
template <std::size_t formula>
VANDPLAN_PART Which unlikely(const Complex& direction, V slack, const CircleTurns& t) {
  const V zero = hn::Zero(D());
  const V square = squared(direction);
  const V least = hn::Add(hn::Mul(slack, slack), set(1e-24));
  const Which behind = hn::Lt(direction.re, zero);
  const Which below = hn::Gt(hn::Mul(direction.im, direction.im), hn::Mul(least, square));
  const Which too_low = hn::And(hn::Lt(direction.im, zero), hn::Or(behind, below));
  if constexpr (formula == l_r_l) return too_low;
  const V most = hn::Mul(set(t.high * t.high), square);
  return hn::Or(too_low, hn::And(behind, hn::Gt(hn::Mul(direction.re, direction.re), most)));
}

/// By how much turns are shorter than angle + ramp [ramps]: `continuous::SmallTurn::lacks`.
VANDPLAN_PART V lacking(V angle, const SmallTurn& turn, const CircleTurns& t) {
  const V u = hn::Sub(set(1), hn::Mul(angle, set(1 / t.ramp)));
  const V square = hn::Mul(u, u);
  const V growth = hn::Mul(hn::Mul(set(turn.growth), square), square);
  const V lack = hn::Mul(square, hn::Add(set(turn.lack), growth));
  return hn::IfThenZeroElse(hn::Le(u, hn::Zero(D())), hn::Min(lack, set(turn.max_lack)));
}

/// Angles of the turns of words.
struct Turns {
  V first, inner, last;
};

/// Estimated lengths of words: `continuous::estimated_length`.
template <std::size_t formula>
HWY_INLINE V length_of(const Turns& turns, V line, const CircleFormula& f, const CircleTurns& t) {
  V length = hn::Add(hn::Add(turns.first, turns.last), set(2 * t.ramp));
  const V inner_way = hn::Add(turns.inner, set(t.ramp));
  constexpr bool begins_with_line = formula == lsl || formula == lsr;
  if constexpr (!begins_with_line) length = hn::Add(length, inner_way);
  if constexpr (has_line(formula)) length = hn::Add(length, line);
  if constexpr (formula == lr_lr || formula == r_lr_l || formula == r_lsr_l) {
    length = hn::Add(length, inner_way);
  }
  const V first = lacking(turns.first, f.first, t);
  const V inner = lacking(turns.inner, f.inner, t);
  const V last = lacking(turns.last, f.last, t);
  const V together =
      hn::Add(hn::Mul(hn::Mul(set(5), inner), hn::Add(first, last)), hn::Mul(first, last));
  const V all = hn::Add(hn::Add(hn::Add(first, inner), last), together);
  return hn::Sub(length, hn::Mul(set(t.ramp), all));
}

/// Lanes in which a turn is so far below 0 that there is no word.
HWY_INLINE Which is_gone(const Turns& turns, const CircleFormula& f, const CircleTurns& t) {
  const V drop = hn::Mul(set(0.2), at_least_zero(hn::Sub(turns.inner, set(1.5))));
  const V ramp = set(t.ramp);
  const Which no_first = hn::Lt(turns.first, hn::Mul(hn::Sub(set(f.first.min_angle), drop), ramp));
  const Which no_last = hn::Lt(turns.last, hn::Mul(hn::Sub(set(f.last.min_angle), drop), ramp));
  return hn::Or(hn::Or(no_first, no_last), hn::Lt(turns.inner, set(f.inner.min_angle * t.ramp)));
}

template <std::size_t formula>
HWY_INLINE void work_out(CircleWords& all, std::size_t i, const CircleFormula& f,
                         const CircleTurns& t) {
  const D d;
  const Between b = between(all, i, f, t);
  Words words;
  if constexpr (has_line(formula)) {
    words = with_line<formula>(b, t);
  } else {
    words = of_arcs<formula>(b, t);
  }
  V slack_first = hn::LoadU(d, &all.slack_first[i]), slack_last = hn::LoadU(d, &all.slack_last[i]);
  Which out = hn::Lt(words.line, set(-1.05 * t.ramp));
  if constexpr (has_line(formula)) {
    const Which is_long = hn::Gt(words.line, set(3 * t.ramp));
    const V low = set(0.01 * t.ramp);
    slack_first = hn::IfThenElse(is_long, hn::Min(slack_first, low), slack_first);
    slack_last = hn::IfThenElse(is_long, hn::Min(slack_last, low), slack_last);
  }
  out = hn::Or(out, hn::Or(unlikely<formula>(words.first, slack_first, t),
                           unlikely<formula>(words.last, slack_last, t)));
  const Turns turns{in_one_turn(angle(words.first)), inner_angle<formula>(words, t),
                    in_one_turn(angle(words.last))};
  out = hn::Or(hn::Or(out, hn::Not(words.exists)), is_gone(turns, f, t));
  const V length = length_of<formula>(turns, words.line, f, t);
  hn::StoreU(turns.first, d, &all.first[i]);
  hn::StoreU(turns.inner, d, &all.inner[i]);
  hn::StoreU(words.line, d, &all.line[i]);
  hn::StoreU(turns.last, d, &all.last[i]);
  const V none = set(std::numeric_limits<double>::infinity());
  hn::StoreU(hn::IfThenElse(out, none, length), d, &all.length[i]);
}

/// Repeats the last word to the end of its vector, and works out all vectors.
template <std::size_t formula>
void work_out_all(CircleWords& all, const CircleFormula& f, const CircleTurns& t) {
  const std::size_t lanes = hn::Lanes(D());
  static_assert(CircleWords::padded >= CircleWords::capacity + hn::MaxLanes(D()));
  if (all.count == 0) return;
  for (auto* numbers : {&all.x, &all.y, &all.sin, &all.cos, &all.slack_first, &all.slack_last}) {
    const V last = set((*numbers)[all.count - 1]);
    hn::StoreU(last, D(), &(*numbers)[all.count]);
  }
  for (std::size_t i = 0; i < all.count; i += lanes) work_out<formula>(all, i, f, t);
}

template <std::size_t... formula>
void work_out_formulas(std::array<CircleWords, circle_formulas>& words,
                       const std::array<CircleFormula, circle_formulas>& formulas,
                       const CircleTurns& turns, std::index_sequence<formula...> /*all*/) {
  (work_out_all<formula>(words[formula], formulas[formula], turns), ...);
}

void words_by_circles(std::array<CircleWords, circle_formulas>& words,
                      const std::array<CircleFormula, circle_formulas>& formulas,
                      const CircleTurns& turns) {
  work_out_formulas(words, formulas, turns, std::make_index_sequence<circle_formulas>());
}

}  // namespace
}  // namespace vandplan::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vandplan::simd {
namespace {

HWY_EXPORT(words_by_circles);

}  // namespace

bool circle_words(std::array<CircleWords, circle_formulas>& words,
                  const std::array<CircleFormula, circle_formulas>& formulas,
                  const CircleTurns& turns) noexcept {
  HWY_DYNAMIC_DISPATCH(words_by_circles)(words, formulas, turns);
  return true;
}

}  // namespace vandplan::simd
#endif  // HWY_ONCE
