// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The lengths of length_kernels_scalar.cpp in vectors: the same operations in the same order, so
// the same bits. Where the scalar code branches, lanes are chosen.

#include <algorithm>
#include <cstddef>
#include <span>

#include "simd/length_kernels.h"
#include "simd/series.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "simd/kernels_highway_lengths.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
#include "simd/kernels_highway-inl.h"

HWY_BEFORE_NAMESPACE();
namespace vandplan::simd::HWY_NAMESPACE {
namespace {

using Which = hn::Mask<F>;

Floats at_least_zero(Floats value) { return hn::Max(value, hn::Zero(F())); }

Floats root(Floats value) { return hn::Sqrt(at_least_zero(value)); }

/// a * b + c * d, each rounded.
Floats sum_of_products(Floats a, Floats b, Floats c, Floats d) {
  return hn::Add(hn::Mul(a, b), hn::Mul(c, d));
}

/// a * b - c * d, each rounded.
Floats difference_of_products(Floats a, Floats b, Floats c, Floats d) {
  return hn::Sub(hn::Mul(a, b), hn::Mul(c, d));
}

struct Direction {
  Floats sin, cos;
};

Direction direction(Floats angle) {
  const Floats z = hn::Mul(angle, angle);
  const Floats sin = hn::Add(angle, hn::Mul(hn::Mul(angle, z), horner(sine_rest, z)));
  const Floats cos = hn::Add(hn::Sub(set(1.0F), hn::Mul(set(0.5F), z)),
                             hn::Mul(hn::Mul(z, z), horner(cosine_rest, z)));
  return {sin, cos};
}

Floats atan_2(Floats y, Floats x) {
  const Floats abs_x = hn::Abs(x);
  const Floats abs_y = hn::Abs(y);
  const Which steep = hn::Lt(abs_x, abs_y);
  const Floats a = hn::Min(abs_x, abs_y);
  const Floats b = hn::Max(abs_x, abs_y);
  const Which middle = hn::Gt(a, hn::Mul(b, set(tan_eighth)));
  const Floats q =
      hn::Div(hn::Sub(a, hn::IfThenElseZero(middle, b)), hn::Add(b, hn::IfThenElseZero(middle, a)));
  const Floats z = hn::Mul(q, q);
  Floats angle = hn::Add(q, hn::Mul(hn::Mul(q, z), horner(arc_tangent_rest, z)));
  angle = hn::Add(angle, hn::IfThenElseZero(middle, set(pi / 4)));
  angle = hn::IfThenElse(steep, hn::Sub(set(pi / 2), angle), angle);
  angle = hn::IfThenElse(hn::Lt(x, hn::Zero(F())), hn::Sub(set(pi), angle), angle);
  return hn::IfThenElse(hn::Lt(y, hn::Zero(F())), hn::Neg(angle), angle);
}

struct Circles {
  Floats x, y, a, s, c, lr, rl;
};

Circles circles(Floats dx, Floats dy, Floats node, Floats sample, float radius) {
  const Floats mean = hn::Mul(set(0.5F), hn::Add(node, sample));
  const Floats turns = hn::Round(hn::Mul(mean, set(1 / pi)));
  const Floats reduced = hn::Sub(mean, hn::Mul(turns, set(pi)));
  const auto [sin, cos] = direction(hn::Sub(reduced, hn::Mul(turns, set(rest_of_pi))));
  const Floats scale = set(1.0F / radius);
  const Floats x = hn::Mul(hn::Abs(sum_of_products(dx, cos, dy, sin)), scale);
  const Floats y = hn::Mul(hn::Abs(difference_of_products(dy, cos, dx, sin)), scale);
  const Floats difference = hn::Abs(hn::Sub(node, sample));
  const Floats other_way = hn::Add(hn::Sub(set(2 * pi), difference), set(2 * rest_of_pi));
  const Floats a = hn::Mul(set(0.5F), at_least_zero(hn::Min(difference, other_way)));
  const auto [s, c] = direction(a);
  const Floats two_s = hn::Mul(set(2.0F), s);
  const Floats four_c = hn::Mul(set(4.0F), c);
  const Floats shared = hn::Mul(hn::Sub(x, two_s), hn::Add(x, two_s));
  const Floats lr = hn::Add(shared, hn::Mul(y, hn::Sub(y, four_c)));
  const Floats rl = hn::Add(shared, hn::Mul(y, hn::Add(y, four_c)));
  return {x, y, a, s, c, lr, rl};
}

/// A word's length is line + 2 * angle; the angle is that of the vector (x, y) turned by the one of
/// (p, q).
struct Parts {
  Floats line, x, y, p, q;

  void choose(Which which, const Parts& other) {
    line = hn::IfThenElse(which, other.line, line);
    x = hn::IfThenElse(which, other.x, x);
    y = hn::IfThenElse(which, other.y, y);
    p = hn::IfThenElse(which, other.p, p);
    q = hn::IfThenElse(which, other.q, q);
  }
  [[nodiscard]] Floats angle() const {
    return atan_2(sum_of_products(y, p, x, q), difference_of_products(x, p, y, q));
  }
};

/// The conditions of the scalar code, each for the lanes in which none before it holds, and what
/// they share.
struct Words {
  Which l_r_l, r_lsl, lsl, r_lsr_l, r_lsr, lsr;
  Floats less, x, ahead, square;

  explicit Words(const Circles& f) {
    const Floats zero = hn::Zero(F());
    const Floats two_s = hn::Mul(set(2.0F), f.s);
    less = hn::Sub(f.x, two_s);
    x = hn::Add(f.x, two_s);
    ahead = difference_of_products(less, f.c, f.y, f.s);
    square = sum_of_products(x, x, f.y, f.y);
    const Floats beyond = hn::Sub(sum_of_products(x, f.c, f.y, f.s), set(2.0F));
    const Floats two_cc = hn::Mul(hn::Mul(set(2.0F), f.c), f.c);
    const Floats four_sc = hn::Mul(hn::Mul(set(4.0F), f.s), f.c);
    l_r_l = hn::Le(f.rl, zero);
    r_lsl =
        hn::And(hn::Le(ahead, zero), hn::Ge(difference_of_products(f.x, f.s, f.y, f.c), two_cc));
    lsl = hn::And(hn::Ge(ahead, zero), hn::Ge(difference_of_products(less, f.s, f.y, f.c), zero));
    r_lsr_l = hn::And(hn::Ge(f.rl, set(16.0F)), hn::Le(beyond, zero));
    r_lsr = hn::And(hn::And(hn::Ge(square, set(8.0F)), hn::Ge(beyond, zero)),
                    hn::Le(hn::Add(ahead, four_sc), set(2.0F)));
    lsr = hn::Ge(f.lr, zero);
  }
  [[nodiscard]] Which has_no_angle() const { return hn::Or(l_r_l, hn::Or(r_lsl, lsl)); }
  [[nodiscard]] Which is_of_arcs() const {
    return hn::Not(hn::Or(hn::Or(has_no_angle(), r_lsr_l), hn::Or(r_lsr, lsr)));
  }
};

/// The words with a line; of those before 8.11 the line only.
Parts with_line(const Circles& f, const Words& is) {
  Floats square = hn::IfThenElse(is.r_lsr, hn::Sub(is.square, set(4.0F)), f.lr);         // 8.9, 8.2
  square = hn::IfThenElse(is.r_lsr_l, f.rl, square);                                     // 8.11
  square = hn::IfThenElse(is.lsl, sum_of_products(is.less, is.less, f.y, f.y), square);  // 8.1
  square = hn::IfThenElse(is.r_lsl, hn::Add(set(4.0F), f.rl), square);                   // 8.10
  const Floats d = root(square);
  const Floats two = set(2.0F);
  const Floats two_c = hn::Mul(two, f.c);
  const Floats less_two = hn::Sub(d, two);
  Parts parts{d, f.x, hn::Sub(f.y, two_c), d, two};       // 8.2
  parts.choose(is.r_lsr, {less_two, is.x, f.y, d, two});  // 8.9
  const Floats less_arcs = hn::Add(d, set(pi - 4));
  parts.choose(is.r_lsr_l, {less_arcs, hn::Add(f.y, two_c), hn::Neg(f.x), d, two});  // 8.11
  parts.line = hn::IfThenElse(is.lsl, d, parts.line);
  parts.line = hn::IfThenElse(is.r_lsl, less_two, parts.line);
  parts.line = hn::IfThenZeroElse(is.l_r_l, parts.line);
  return parts;
}

/// 8.8 where `is_r_lr_l`, else 8.4.
Parts of_arcs(const Circles& f, const Words& is, Which is_r_lr_l) {
  const Floats one = set(1.0F);
  const Floats two = set(2.0F);
  const Floats sixteenth = set(0.0625F);
  const Floats cos = hn::Sub(one, hn::Mul(f.rl, sixteenth));
  const Floats sin = hn::Mul(root(hn::Mul(f.rl, hn::Sub(set(32.0F), f.rl))), sixteenth);
  Parts parts{hn::Zero(F()), is.x, f.y, root(hn::Sub(one, hn::Mul(is.square, sixteenth))),
              hn::Mul(root(is.square), set(0.25F))};
  parts.choose(is_r_lr_l, {hn::Zero(F()), hn::Add(f.y, hn::Mul(two, f.c)), hn::Neg(f.x),
                           hn::Sub(hn::Mul(two, cos), one), hn::Mul(two, sin)});
  return parts;
}

/// 8.7; `between` the left and the right circle.
Floats lr_lr(const Circles& f, Floats between) {
  const Floats eight = set(8.0F);
  const Floats sin_squared = hn::Div(hn::Neg(f.lr), hn::Mul(eight, hn::Add(set(2.0F), between)));
  const Floats quarter = atan_2(root(sin_squared), root(hn::Sub(set(1.0F), sin_squared)));
  return hn::Sub(hn::Mul(eight, quarter), hn::Mul(set(2.0F), f.a));
}

Floats shortest(const Circles& f) {
  const Floats zero = hn::Zero(F());
  const Floats two = set(2.0F);
  const Words is(f);
  Parts parts = with_line(f, is);
  const Which arcs = is.is_of_arcs();
  const bool any_arcs = !hn::AllFalse(F(), arcs);
  Which is_r_lr_l = arcs;
  if (any_arcs) {
    const Floats eight_s = hn::Mul(set(8.0F), f.s);
    is_r_lr_l = hn::And(arcs, hn::Le(hn::Add(f.lr, hn::Mul(eight_s, is.x)), zero));
    parts.choose(arcs, of_arcs(f, is, is_r_lr_l));
  }
  const Floats angle = hn::IfThenElse(is.has_no_angle(), f.a, parts.angle());
  const Floats length = hn::Add(parts.line, hn::Mul(two, angle));
  if (!any_arcs) return length;

  const Floats across = hn::Sub(hn::Mul(two, f.c), f.y);
  const Floats between = root(sum_of_products(f.x, f.x, across, across));
  const Floats rise =
      sum_of_products(f.lr, hn::Add(between, set(4.0F)), hn::Mul(set(4.0F), hn::Add(between, two)),
                      sum_of_products(f.s, is.x, f.y, f.c));
  const Floats end = hn::Add(is.ahead, hn::Mul(hn::Mul(two, f.y), f.s));
  const Which is_lr_lr = hn::And(arcs, hn::And(hn::Le(rise, zero), hn::Le(end, zero)));
  if (hn::AllFalse(F(), is_lr_lr)) return length;
  const Floats other = lr_lr(f, between);
  const Which better = hn::Or(hn::Not(is_r_lr_l), hn::Lt(other, length));
  return hn::IfThenElse(hn::And(is_lr_lr, better), other, length);
}

void lengths(const float* x, const float* y, const float* heading, const LengthSample& sample,
             float radius, float* out, std::size_t count) {
  const F d;
  const std::size_t lanes = hn::Lanes(d);
  const auto step = [&](const float* node_x, const float* node_y, const float* node_heading,
                        float* length) {
    const Floats dx = hn::Sub(hn::LoadU(d, node_x), set(sample.x));
    const Floats dy = hn::Sub(hn::LoadU(d, node_y), set(sample.y));
    const Floats node = hn::LoadU(d, node_heading);
    const Circles pair = circles(dx, dy, node, set(sample.heading), radius);
    hn::StoreU(hn::Mul(shortest(pair), set(radius)), d, length);
  };
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) step(x + i, y + i, heading + i, out + i);
  if (i == count) return;
  // The rest, in lanes of its own.
  HWY_ALIGN float rest[4][HWY_MAX_BYTES / sizeof(float)] = {};
  std::copy(x + i, x + count, rest[0]);
  std::copy(y + i, y + count, rest[1]);
  std::copy(heading + i, heading + count, rest[2]);
  step(rest[0], rest[1], rest[2], rest[3]);
  std::copy(rest[3], rest[3] + (count - i), out + i);
}

}  // namespace
}  // namespace vandplan::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vandplan::simd {
namespace {

HWY_EXPORT(lengths);

}  // namespace

void reeds_shepp_lengths(std::span<const float> x, std::span<const float> y,
                         std::span<const float> heading, const LengthSample& sample, float radius,
                         std::span<float> out) noexcept {
  HWY_DYNAMIC_DISPATCH(lengths)
  (x.data(), y.data(), heading.data(), sample, radius, out.data(), out.size());
}

}  // namespace vandplan::simd
#endif  // HWY_ONCE
