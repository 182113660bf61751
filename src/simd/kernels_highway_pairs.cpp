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
#include "simd/turn_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "simd/kernels_highway_pairs.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
#include "simd/kernels_highway_words-inl.h"

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

struct Math {
  using V = Doubles;
  static V atan_2(V y, V x) { return HWY_NAMESPACE::atan_2(y, x); }
  static V root(V value) { return hn::Sqrt(at_least_zero(value)); }
  static V less_four_plus_pi(V value) { return hn::Add(hn::Sub(value, set(4.0)), set(pi)); }
};
using Word = ShortestWord<Math>;
using Circles = Word::Circles;

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
  const Doubles x = hn::Abs(sum_of_products(pairs.dx, mean.cos, pairs.dy, mean.sin));
  const Doubles y = hn::Abs(difference_of_products(pairs.dy, mean.cos, pairs.dx, mean.sin));
  const Doubles a = hn::Abs(hn::Mul(set(0.5), turn));
  const auto [s, c] = sin_cos(a);
  const Doubles two_s = hn::Mul(set(2.0), s);
  const Doubles four_c = hn::Mul(set(4.0), c);
  const Doubles shared = hn::Mul(hn::Sub(x, two_s), hn::Add(x, two_s));
  const Doubles lr = hn::Add(shared, hn::Mul(y, hn::Sub(y, four_c)));
  const Doubles rl = hn::Add(shared, hn::Mul(y, hn::Add(y, four_c)));
  return {x, y, a, s, c, lr, rl};
}

// ---- poses ----

struct Poses {
  Doubles x, y, heading;
};

Poses one_pose(const double* pose) { return {set(pose[0]), set(pose[1]), set(pose[2])}; }

Poses next_poses(const double* poses) {
  Doubles x, y, heading;
  hn::LoadInterleaved3(D(), poses, x, y, heading);
  return {x, y, heading};
}

Doubles lengths_of(const Poses& from, const Poses& to, double radius) {
  const Doubles scale = set(radius);
  const Pairs pairs{hn::Div(hn::Sub(to.x, from.x), scale), hn::Div(hn::Sub(to.y, from.y), scale),
                    from.heading, to.heading};
  const Doubles length = hn::Mul(Word::shortest(circles(pairs)), scale);
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

/// Batches of eight fill vectors of any size.
void directions(const double* angles, double* sines, double* cosines, std::size_t count) {
  const hn::CappedTag<double, turns_of_batch> d;
  static_assert(turns_of_batch % hn::MaxLanes(d) == 0);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto [sin, cos] = sin_cos(hn::LoadU(d, angles + i));
    hn::StoreU(sin, d, sines + i);
    hn::StoreU(cos, d, cosines + i);
  }
}

}  // namespace
}  // namespace vandplan::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vandplan::simd {
namespace {

HWY_EXPORT(lengths);
HWY_EXPORT(directions);

}  // namespace

void exact_lengths(std::span<const double> from, std::span<const double> to, double radius,
                   std::span<double> out) noexcept {
  if (out.empty()) return;
  HWY_DYNAMIC_DISPATCH(lengths)
  (from.data(), from.size() == 3 ? 0 : 1, to.data(), to.size() == 3 ? 0 : 1, radius, out.data(),
   out.size());
}

void sines_and_cosines(std::span<const double> angles, std::span<double> sines,
                       std::span<double> cosines) noexcept {
  HWY_DYNAMIC_DISPATCH(directions)(angles.data(), sines.data(), cosines.data(), angles.size());
}

}  // namespace vandplan::simd
#endif  // HWY_ONCE
