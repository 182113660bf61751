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
#include "simd/kernels_highway_words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace vandplan::simd::HWY_NAMESPACE {
namespace {

using Which = hn::Mask<F>;

Floats at_least_zero(Floats value) { return hn::Max(value, hn::Zero(F())); }

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

struct Math {
  using V = Floats;
  static V atan_2(V y, V x) { return HWY_NAMESPACE::atan_2(y, x); }
  static V root(V value) { return hn::Sqrt(at_least_zero(value)); }
  static V less_four_plus_pi(V value) { return hn::Add(value, set(pi - 4)); }
};
using Word = ShortestWord<Math>;
using Circles = Word::Circles;

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
    hn::StoreU(hn::Mul(Word::shortest(pair), set(radius)), d, length);
  };
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) step(x + i, y + i, heading + i, out + i);
  if (i == count) return;
  // Nodes that fill no whole vector, in lanes of their own.
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
