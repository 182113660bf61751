// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The lengths of steering/reeds_shepp_formulas.h in vectors of double: the same operations in the
// same order, so the same bits. Where the scalar code branches, lanes are chosen.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>

#include "base/trigonometry_series.h"
#include "simd/pair_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "simd/kernels_highway_pairs.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace vandplan::simd::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
namespace series = base::series;
using D = hn::ScalableTag<double>;
using U = hn::RebindToUnsigned<D>;
using Doubles = hn::Vec<D>;
using Bits = hn::Vec<U>;
using Which = hn::Mask<D>;

constexpr double pi = std::numbers::pi;

Doubles set(double value) { return hn::Set(D(), value); }
Bits set(std::uint64_t value) { return hn::Set(U(), value); }

/// As std::max(value, 0.0), for -0 and NaN, too.
Doubles at_least_zero(Doubles value) {
  return hn::IfThenZeroElse(hn::Lt(value, hn::Zero(D())), value);
}

Doubles root(Doubles value) { return hn::Sqrt(at_least_zero(value)); }

/// a * b + c * d, each rounded.
Doubles sum_of_products(Doubles a, Doubles b, Doubles c, Doubles d) {
  return hn::Add(hn::Mul(a, b), hn::Mul(c, d));
}

/// a * b - c * d, each rounded.
Doubles difference_of_products(Doubles a, Doubles b, Doubles c, Doubles d) {
  return hn::Sub(hn::Mul(a, b), hn::Mul(c, d));
}

/// a + z * b.
Doubles plus(Doubles a, Doubles z, Doubles b) { return hn::Add(a, hn::Mul(z, b)); }

// ---- base::sin_cos for moderate angles, and base::atan_2 ----

struct SinCos {
  Doubles sin, cos;
};

Doubles with_sign_flipped(Doubles value, Bits bit_1) {
  return hn::BitCast(D(), hn::Xor(hn::BitCast(U(), value), hn::ShiftLeft<62>(bit_1)));
}

/// (s[0] + z (s[1] + z s[2])) + z^3 (s[3] + z (s[4] + z s[5])).
Doubles six_terms(const double (&s)[6], Doubles z, Doubles z3) {
  const Doubles low = plus(set(s[0]), z, plus(set(s[1]), z, set(s[2])));
  return plus(low, z3, plus(set(s[3]), z, plus(set(s[4]), z, set(s[5]))));
}

SinCos sin_cos(Doubles angle) {
  const Doubles shifted = hn::Add(hn::Mul(angle, set(series::per_quarter)), set(series::round));
  const Doubles n = hn::Sub(shifted, set(series::round));
  const Doubles coarse = hn::Sub(angle, hn::Mul(n, set(series::half_pi_1)));
  const Doubles fine = hn::Mul(n, set(series::half_pi_2));
  const Doubles difference = hn::Sub(coarse, fine);
  const Doubles back = hn::Sub(difference, coarse);
  const Doubles error = hn::Sub(hn::Sub(coarse, hn::Sub(difference, back)), hn::Add(fine, back));
  const Doubles first_rest = hn::Sub(error, hn::Mul(n, set(series::half_pi_3)));
  const Doubles r = hn::Add(difference, first_rest);
  const Doubles rest = hn::Sub(first_rest, hn::Sub(r, difference));

  const Doubles z = hn::Mul(r, r);
  const Doubles z3 = hn::Mul(hn::Mul(z, z), z);
  const Doubles s = six_terms(series::sine, z, z3);
  const Doubles c = six_terms(series::cosine, z, z3);
  const Doubles half_z = hn::Mul(set(0.5), z);
  const Doubles large = hn::Sub(set(1.0), half_z);
  const Doubles sine = hn::Add(r, hn::Add(hn::Mul(hn::Mul(r, z), s), hn::Mul(rest, large)));
  const Doubles small = hn::Sub(hn::Mul(hn::Mul(z, z), c), hn::Mul(r, rest));
  const Doubles cosine = hn::Add(large, hn::Add(hn::Sub(hn::Sub(set(1.0), large), half_z), small));

  const Bits quarters = hn::BitCast(U(), shifted);
  const Bits one = set(std::uint64_t{1});
  const Bits two = set(std::uint64_t{2});
  const Which odd = hn::RebindMask(D(), hn::Eq(hn::And(quarters, one), one));
  return {
      with_sign_flipped(hn::IfThenElse(odd, cosine, sine), hn::And(quarters, two)),
      with_sign_flipped(hn::IfThenElse(odd, sine, cosine), hn::And(hn::Add(quarters, one), two))};
}

/// The multiple of pi/4 that the angle is counted from, of `series::eighths` or `series::rests`.
Doubles of_eighths(const double (&all)[5], Which middle, Which steep, Which back) {
  const Doubles ahead =
      hn::IfThenElse(middle, set(all[1]), hn::IfThenElse(steep, set(all[2]), set(all[0])));
  const Doubles behind =
      hn::IfThenElse(middle, set(all[3]), hn::IfThenElse(steep, set(all[2]), set(all[4])));
  return hn::IfThenElse(back, behind, ahead);
}

/// For numbers below 2^1020.
Doubles atan_2(Doubles y, Doubles x) {
  const Doubles abs_x = hn::Abs(x);
  const Doubles abs_y = hn::Abs(y);
  const Doubles a = hn::Min(abs_x, abs_y);
  Doubles b = hn::Max(abs_x, abs_y);
  b = hn::IfThenElse(hn::Eq(b, hn::Zero(D())), set(1.0), b);
  const Which middle = hn::Gt(a, hn::Mul(b, set(series::tan_eighth)));
  const Doubles q =
      hn::Div(hn::Sub(a, hn::IfThenElseZero(middle, b)), hn::Add(b, hn::IfThenElseZero(middle, a)));
  const Doubles z = hn::Mul(q, q);
  const Doubles z2 = hn::Mul(z, z);
  const Doubles z4 = hn::Mul(z2, z2);
  const auto& A = series::arc_tangent;
  const auto four_terms = [&](int i) {
    return plus(plus(set(A[i]), z, set(A[i + 1])), z2, plus(set(A[i + 2]), z, set(A[i + 3])));
  };
  const Doubles p2 = plus(plus(set(A[8]), z, set(A[9])), z2, set(A[10]));
  const Doubles p = plus(four_terms(0), z4, plus(four_terms(4), z4, p2));
  const Doubles angle = hn::Add(q, hn::Mul(q, hn::Mul(z, p)));

  const Which steep = hn::Gt(abs_y, abs_x);
  const Which back = hn::MaskFromVec(
      hn::BitCast(D(), hn::BroadcastSignBit(hn::BitCast(hn::RebindToSigned<D>(), x))));
  const Doubles turned = hn::IfThenElse(hn::Xor(steep, back), hn::Neg(angle), angle);
  const Doubles sum = hn::Add(of_eighths(series::eighths, middle, steep, back),
                              hn::Add(of_eighths(series::rests, middle, steep, back), turned));
  return hn::CopySign(sum, y);
}

// ---- the formulas ----

/// The pair in the mean frame, all signs positive; lengths in turning radii
/// (steering/mean_frame.h).
struct Circles {
  Doubles x, y, a, s, c, lr, rl;
};

/// Pairs of poses.
struct Pairs {
  Doubles dx, dy;    ///< in turning radii
  Doubles from, to;  ///< headings
};

Circles circles(const Pairs& pairs) {
  constexpr double two_pi = 2 * pi;
  const Doubles difference = hn::Sub(pairs.to, pairs.from);
  const Doubles turns = hn::Sub(hn::Add(hn::Mul(difference, set(1 / two_pi)), set(series::round)),
                                set(series::round));
  Doubles turn = hn::Sub(difference, hn::Mul(turns, set(two_pi)));
  const Doubles noise = hn::Mul(set(std::numeric_limits<double>::epsilon()),
                                hn::Add(hn::Abs(pairs.from), hn::Abs(pairs.to)));
  turn = hn::IfThenZeroElse(hn::AndNot(hn::Eq(turns, hn::Zero(D())), hn::Le(hn::Abs(turn), noise)),
                            turn);
  const SinCos mean = sin_cos(hn::Mul(set(0.5), hn::Add(pairs.to, pairs.from)));
  Circles f;
  f.x = hn::Abs(sum_of_products(pairs.dx, mean.cos, pairs.dy, mean.sin));
  f.y = hn::Abs(difference_of_products(pairs.dy, mean.cos, pairs.dx, mean.sin));
  f.a = hn::Abs(hn::Mul(set(0.5), turn));
  const SinCos half = sin_cos(f.a);
  f.s = half.sin;
  f.c = half.cos;
  const Doubles two_s = hn::Mul(set(2.0), f.s);
  const Doubles four_c = hn::Mul(set(4.0), f.c);
  const Doubles shared = hn::Mul(hn::Sub(f.x, two_s), hn::Add(f.x, two_s));
  f.lr = hn::Add(shared, hn::Mul(f.y, hn::Sub(f.y, four_c)));
  f.rl = hn::Add(shared, hn::Mul(f.y, hn::Add(f.y, four_c)));
  return f;
}

/// A word's length is line + 2 * angle; the angle is that of the vector (x, y) turned by the one of
/// (p, q).
struct Parts {
  Doubles line, x, y, p, q;

  void choose(Which which, const Parts& other) {
    line = hn::IfThenElse(which, other.line, line);
    x = hn::IfThenElse(which, other.x, x);
    y = hn::IfThenElse(which, other.y, y);
    p = hn::IfThenElse(which, other.p, p);
    q = hn::IfThenElse(which, other.q, q);
  }
  [[nodiscard]] Doubles angle() const {
    return atan_2(sum_of_products(y, p, x, q), difference_of_products(x, p, y, q));
  }
};

/// The conditions of the scalar code, of which the first one that holds counts, and what they
/// share.
struct Words {
  Which l_r_l, r_lsl, lsl, r_lsr_l, r_lsr, lsr;
  Doubles less, x, ahead, square;

  explicit Words(const Circles& f) {
    const Doubles zero = hn::Zero(D());
    const Doubles two_s = hn::Mul(set(2.0), f.s);
    less = hn::Sub(f.x, two_s);
    x = hn::Add(f.x, two_s);
    ahead = difference_of_products(less, f.c, f.y, f.s);
    square = sum_of_products(x, x, f.y, f.y);
    const Doubles beyond = hn::Sub(sum_of_products(x, f.c, f.y, f.s), set(2.0));
    const Doubles two_cc = hn::Mul(hn::Mul(set(2.0), f.c), f.c);
    const Doubles four_sc = hn::Mul(hn::Mul(set(4.0), f.s), f.c);
    l_r_l = hn::Le(f.rl, zero);
    r_lsl =
        hn::And(hn::Le(ahead, zero), hn::Ge(difference_of_products(f.x, f.s, f.y, f.c), two_cc));
    lsl = hn::And(hn::Ge(ahead, zero), hn::Ge(difference_of_products(less, f.s, f.y, f.c), zero));
    r_lsr_l = hn::And(hn::Ge(f.rl, set(16.0)), hn::Le(beyond, zero));
    r_lsr = hn::And(hn::And(hn::Ge(square, set(8.0)), hn::Ge(beyond, zero)),
                    hn::Le(hn::Add(ahead, four_sc), set(2.0)));
    lsr = hn::Ge(f.lr, zero);
  }
  [[nodiscard]] Which has_no_angle() const { return hn::Or(l_r_l, hn::Or(r_lsl, lsl)); }
  [[nodiscard]] Which is_of_arcs() const {
    return hn::Not(hn::Or(hn::Or(has_no_angle(), r_lsr_l), hn::Or(r_lsr, lsr)));
  }
};

/// The words with a line; of those before 8.11 the line only.
Parts with_line(const Circles& f, const Words& is) {
  Doubles square = hn::IfThenElse(is.r_lsr, hn::Sub(is.square, set(4.0)), f.lr);         // 8.9, 8.2
  square = hn::IfThenElse(is.r_lsr_l, f.rl, square);                                     // 8.11
  square = hn::IfThenElse(is.lsl, sum_of_products(is.less, is.less, f.y, f.y), square);  // 8.1
  square = hn::IfThenElse(is.r_lsl, hn::Add(set(4.0), f.rl), square);                    // 8.10
  const Doubles d = root(square);
  const Doubles two = set(2.0);
  const Doubles two_c = hn::Mul(two, f.c);
  const Doubles less_two = hn::Sub(d, two);
  Parts parts{d, f.x, hn::Sub(f.y, two_c), d, two};       // 8.2
  parts.choose(is.r_lsr, {less_two, is.x, f.y, d, two});  // 8.9
  const Doubles less_arcs = hn::Add(hn::Sub(d, set(4.0)), set(pi));
  parts.choose(is.r_lsr_l, {less_arcs, hn::Add(f.y, two_c), hn::Neg(f.x), d, two});  // 8.11
  parts.line = hn::IfThenElse(is.lsl, d, parts.line);
  parts.line = hn::IfThenElse(is.r_lsl, less_two, parts.line);
  parts.line = hn::IfThenZeroElse(is.l_r_l, parts.line);
  return parts;
}

/// 8.8 where `is_r_lr_l`, else 8.4.
Parts of_arcs(const Circles& f, const Words& is, Which is_r_lr_l) {
  const Doubles one = set(1.0);
  const Doubles two = set(2.0);
  const Doubles sixteenth = set(0.0625);
  const Doubles cos = hn::Sub(one, hn::Mul(f.rl, sixteenth));
  const Doubles sin = hn::Mul(root(hn::Mul(f.rl, hn::Sub(set(32.0), f.rl))), sixteenth);
  Parts parts{hn::Zero(D()), is.x, f.y, root(hn::Sub(one, hn::Mul(is.square, sixteenth))),
              hn::Mul(root(is.square), set(0.25))};
  parts.choose(is_r_lr_l, {hn::Zero(D()), hn::Add(f.y, hn::Mul(two, f.c)), hn::Neg(f.x),
                           hn::Sub(hn::Mul(two, cos), one), hn::Mul(two, sin)});
  return parts;
}

/// 8.7; `between` the left and the right circle.
Doubles lr_lr(const Circles& f, Doubles between) {
  const Doubles two = set(2.0);
  const Doubles sin_squared = hn::Div(hn::Neg(f.lr), hn::Mul(set(8.0), hn::Add(two, between)));
  const Doubles u = hn::Mul(two, atan_2(root(sin_squared), root(hn::Sub(set(1.0), sin_squared))));
  return hn::Sub(hn::Mul(set(4.0), u), hn::Mul(two, f.a));
}

/// In turning radii.
Doubles shortest(const Circles& f) {
  const Doubles zero = hn::Zero(D());
  const Doubles two = set(2.0);
  const Words is(f);
  Parts parts = with_line(f, is);
  const Which arcs = is.is_of_arcs();
  const bool any_arcs = !hn::AllFalse(D(), arcs);
  Which is_r_lr_l = arcs;
  if (any_arcs) {
    const Doubles eight_s = hn::Mul(set(8.0), f.s);
    is_r_lr_l = hn::And(arcs, hn::Le(hn::Add(f.lr, hn::Mul(eight_s, is.x)), zero));
    parts.choose(arcs, of_arcs(f, is, is_r_lr_l));
  }
  const Doubles angle = hn::IfThenElse(is.has_no_angle(), f.a, parts.angle());
  const Doubles length = hn::Add(parts.line, hn::Mul(two, angle));
  if (!any_arcs) return length;

  const Doubles across = hn::Sub(hn::Mul(two, f.c), f.y);
  const Doubles between = root(sum_of_products(f.x, f.x, across, across));
  const Doubles rise =
      sum_of_products(f.lr, hn::Add(between, set(4.0)), hn::Mul(set(4.0), hn::Add(between, two)),
                      sum_of_products(f.s, is.x, f.y, f.c));
  const Doubles end = hn::Add(is.ahead, hn::Mul(hn::Mul(two, f.y), f.s));
  const Which is_lr_lr = hn::And(arcs, hn::And(hn::Le(rise, zero), hn::Le(end, zero)));
  if (hn::AllFalse(D(), is_lr_lr)) return length;
  const Doubles other = lr_lr(f, between);
  const Which better = hn::Or(hn::Not(is_r_lr_l), hn::Lt(other, length));
  return hn::IfThenElse(hn::And(is_lr_lr, better), other, length);
}

// ---- poses ----

struct Poses {
  Doubles x, y, heading;
};

Poses one_pose(const double* pose) { return {set(pose[0]), set(pose[1]), set(pose[2])}; }

Poses next_poses(const double* poses) {
  Poses p;
  hn::LoadInterleaved3(D(), poses, p.x, p.y, p.heading);
  return p;
}

Doubles lengths_of(const Poses& from, const Poses& to, double radius) {
  const Doubles scale = set(radius);
  const Pairs pairs{hn::Div(hn::Sub(to.x, from.x), scale), hn::Div(hn::Sub(to.y, from.y), scale),
                    from.heading, to.heading};
  const Doubles length = hn::Mul(shortest(circles(pairs)), scale);
  const Doubles most = set(2 * series::moderate);
  const Which is_moderate =
      hn::And(hn::Le(hn::Add(hn::Abs(from.heading), hn::Abs(to.heading)), most),
              hn::And(hn::Le(hn::Abs(pairs.dx), set(most_radii)),
                      hn::Le(hn::Abs(pairs.dy), set(most_radii))));
  return hn::IfThenElse(is_moderate, length, set(std::numeric_limits<double>::quiet_NaN()));
}

void lengths(const double* from, std::size_t from_step, const double* to, std::size_t to_step,
             double radius, double* out, std::size_t count) {
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  const Poses first_from = one_pose(from);
  const Poses first_to = one_pose(to);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const Poses a = from_step == 0 ? first_from : next_poses(from + 3 * i);
    const Poses b = to_step == 0 ? first_to : next_poses(to + 3 * i);
    hn::StoreU(lengths_of(a, b, radius), d, out + i);
  }
  if (i == count) return;
  // The rest, in lanes of its own.
  constexpr std::size_t most = HWY_MAX_BYTES / sizeof(double);
  HWY_ALIGN double rest[2][3 * most] = {};
  HWY_ALIGN double answers[most];
  if (from_step != 0) std::copy(from + 3 * i, from + 3 * count, rest[0]);
  if (to_step != 0) std::copy(to + 3 * i, to + 3 * count, rest[1]);
  const Poses a = from_step == 0 ? first_from : next_poses(rest[0]);
  const Poses b = to_step == 0 ? first_to : next_poses(rest[1]);
  hn::Store(lengths_of(a, b, radius), d, answers);
  std::copy(answers, answers + (count - i), out + i);
}

}  // namespace
}  // namespace vandplan::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vandplan::simd {
namespace {

HWY_EXPORT(lengths);

}  // namespace

void exact_lengths(std::span<const double> from, std::span<const double> to, double radius,
                   std::span<double> out) noexcept {
  if (out.empty()) return;
  HWY_DYNAMIC_DISPATCH(lengths)
  (from.data(), from.size() == 3 ? 0 : 1, to.data(), to.size() == 3 ? 0 : 1, radius, out.data(),
   out.size());
}

}  // namespace vandplan::simd
#endif  // HWY_ONCE
