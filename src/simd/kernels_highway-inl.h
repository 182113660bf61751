// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What do all vector kernels share?
//
// foreach_target.h includes a kernel file, and so this file, once for each target. Therefore the
// guard of this file toggles.

#if defined(VANDPLAN_SIMD_KERNELS_HIGHWAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VANDPLAN_SIMD_KERNELS_HIGHWAY_INL_H
#undef VANDPLAN_SIMD_KERNELS_HIGHWAY_INL_H
#else
#define VANDPLAN_SIMD_KERNELS_HIGHWAY_INL_H
#endif

#include <cstddef>
#include <cstdint>
#include <numbers>

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace vandplan::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using F = hn::ScalableTag<float>;
using I = hn::ScalableTag<std::int32_t>;
using Floats = hn::Vec<F>;
using Ints = hn::Vec<I>;

constexpr float pi = std::numbers::pi_v<float>;

HWY_INLINE Floats set(float value) { return hn::Set(F(), value); }
HWY_INLINE Ints set(std::int32_t value) { return hn::Set(I(), value); }

/// The polynomial series[0] x^(n-1) + ... + series[n-1].
template <std::size_t n>
HWY_INLINE Floats horner(const float (&series)[n], Floats x) {
  Floats sum = set(series[0]);
  for (std::size_t i = 1; i < n; ++i) sum = hn::Add(set(series[i]), hn::Mul(x, sum));
  return sum;
}

}  // namespace vandplan::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
