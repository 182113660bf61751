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
#include "simd/kernels_highway_angles-inl.h"
#include "simd/kernels_highway_words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace vandplan::simd::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
namespace series = base::series;
using D = hn::ScalableTag<double>;
using Doubles = hn::Vec<D>;
using Which = hn::Mask<D>;

constexpr double pi = std::numbers::pi;

Doubles set(double value) { return hn::Set(D(), value); }

/// std::max(value, 0.0) in each lane, for -0 and NaN, too.
Doubles at_least_zero(Doubles value) {
  return hn::IfThenZeroElse(hn::Lt(value, hn::Zero(D())), value);
}

// ---- the formulas ----

struct Math {
  using V = Doubles;
  static V atan_2(V y, V x) { return Angles<V>::atan_2(y, x); }
  static V root(V value) { return hn::Sqrt(at_least_zero(value)); }
  static V less_four_plus_pi(V value) { return hn::Add(hn::Sub(value, set(4.0)), set(pi)); }
};
using Word = ShortestWord<Math>;
using Circles = Word::Circles;

/// Pairs of poses.
struct Pairs {
  Doubles dx, dy;    ///< offset from the first to the second pose [turning radii]
  Doubles from, to;  ///< headings of both poses [rad]
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
  const auto mean = Angles<Doubles>::sin_cos(hn::Mul(set(0.5), hn::Add(pairs.to, pairs.from)));
  const Doubles x = hn::Abs(sum_of_products(pairs.dx, mean.cos, pairs.dy, mean.sin));
  const Doubles y = hn::Abs(difference_of_products(pairs.dy, mean.cos, pairs.dx, mean.sin));
  const Doubles a = hn::Abs(hn::Mul(set(0.5), turn));
  const auto [s, c] = Angles<Doubles>::sin_cos(a);
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
  // Pairs that fill no whole vector, in lanes of their own.
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

/// Sines and cosines of angles, in batches of eight, which fill vectors of any size.
void directions(const double* angles, double* sines, double* cosines, std::size_t count) {
  const hn::CappedTag<double, turns_of_batch> d;
  using Batch = hn::Vec<decltype(d)>;
  static_assert(turns_of_batch % hn::MaxLanes(d) == 0);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto [sin, cos] = Angles<Batch>::sin_cos(hn::LoadU(d, angles + i));
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
