// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "base/trigonometry.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/trigonometry_series.h"

namespace vandplan::base {
namespace {

/// An angle in [-pi/4, pi/4] as a sum, and the quarter turns that were taken from it.
struct Reduced {
  double angle;
  double rest;             ///< second part of the sum, far below the last bit of `angle`
  std::uint64_t quarters;  ///< quarter turns, modulo 4
};

/// The reduced angle, for |angle| <= `series::moderate` (Cody & Waite 1980).
Reduced reduced_moderate(double angle) {
  const double shifted = angle * series::per_quarter + series::round;
  const double n = shifted - series::round;
  const double coarse = angle - n * series::half_pi_1;
  const double fine = n * series::half_pi_2;
  const double difference = coarse - fine;
  const double back = difference - coarse;
  const double error = (coarse - (difference - back)) - (fine + back);
  const double rest = error - n * series::half_pi_3;
  const double sum = difference + rest;
  return {sum, rest - (sum - difference), std::bit_cast<std::uint64_t>(shifted) & 3};
}

__extension__ using Wide = unsigned __int128;

/// The reduced angle, for every other finite angle (Payne & Hanek 1983). Only those bits of
/// angle * 2 / pi are computed that are no multiples of four quarter turns. They come from a window
/// of 192 bits of 2 / pi.
Reduced reduced_large(double angle) {
  constexpr std::array<std::uint64_t, 21> two_over_pi = {
      0x0000000000000000, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041,
      0xfe5163abdebbc561, 0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e,
      0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4, 0x9c845f8bbdf9283b,
      0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,
      0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab,
      0xf0cfbc209af4361d};
  const auto bits = std::bit_cast<std::uint64_t>(angle);
  const std::uint64_t mantissa = (bits & 0xfffffffffffff) | 0x10000000000000;
  // angle = mantissa * 2^exponent; bit i of the table is worth 2^(63 - i).
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff) - 1075;
  const auto first = static_cast<std::size_t>(exponent + 62);
  const auto word = [&](std::size_t i) {
    const std::size_t at = first / 64 + i;
    const std::size_t shift = first % 64;
    return shift == 0 ? two_over_pi[at]
                      : two_over_pi[at] << shift | two_over_pi[at + 1] >> (64 - shift);
  };
  // The product modulo 2^192; its first two bits are the quarters, the others their fraction.
  const Wide low = Wide{mantissa} * word(2);
  const Wide middle = Wide{mantissa} * word(1) + (low >> 64);
  const Wide high = (Wide{mantissa * word(0)} << 64) + middle;
  std::uint64_t quarters = static_cast<std::uint64_t>(high >> 126);
  Wide fraction = high << 2 | static_cast<std::uint64_t>(low) >> 62;
  bool negative = angle < 0;
  if (fraction >> 127 != 0) {
    fraction = -fraction;
    ++quarters;
    if (angle < 0) quarters = -quarters;
    negative = !negative;
  } else if (angle < 0) {
    quarters = -quarters;
  }
  if (fraction == 0) return {0.0, 0.0, quarters & 3};
  // 64 bits of the fraction times 64 bits of pi/2.
  const auto top = static_cast<std::uint64_t>(fraction >> 64);
  const int zeros = top != 0 ? std::countl_zero(top)
                             : 64 + std::countl_zero(static_cast<std::uint64_t>(fraction));
  const auto leading = static_cast<std::uint64_t>(fraction << zeros >> 64);
  const auto product = static_cast<std::uint64_t>(Wide{leading} * 0xc90fdaa22168c235 >> 64);
  const double scale = std::ldexp(negative ? -1.0 : 1.0, -63 - zeros);
  return {static_cast<double>(product & ~std::uint64_t{0x7ff}) * scale,
          static_cast<double>(product & 0x7ff) * scale, quarters & 3};
}

/// `if_set` where the mask is all ones, `if_clear` where it is all zeros, without a branch.
double select(std::uint64_t mask, double if_set, double if_clear) {
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(if_set) & mask) |
                               (std::bit_cast<std::uint64_t>(if_clear) & ~mask));
}

double with_sign_flipped(double value, std::uint64_t sign_bit) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ sign_bit);
}

}  // namespace

SinCos sin_cos(double angle) noexcept {
  if (!std::isfinite(angle)) {
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  }
  const Reduced reduced =
      std::abs(angle) <= series::moderate ? reduced_moderate(angle) : reduced_large(angle);
  const double r = reduced.angle;
  const double z = r * r;
  const double z3 = z * z * z;

  constexpr auto& S = series::sine;
  constexpr auto& C = series::cosine;
  const double s = (S[0] + z * (S[1] + z * S[2])) + z3 * (S[3] + z * (S[4] + z * S[5]));
  const double c = (C[0] + z * (C[1] + z * C[2])) + z3 * (C[3] + z * (C[4] + z * C[5]));
  // Sine and cosine with the first-order effect of the rest; the large terms are added last.
  const double sine = r + (r * z * s + reduced.rest * (1 - 0.5 * z));
  const double large = 1 - 0.5 * z;
  const double cosine = large + (((1 - large) - 0.5 * z) + (z * z * c - r * reduced.rest));

  const std::uint64_t odd = -(reduced.quarters & 1);
  return {with_sign_flipped(select(odd, cosine, sine), reduced.quarters >> 1 << 63),
          with_sign_flipped(select(odd, sine, cosine), (reduced.quarters + 1) >> 1 << 63)};
}

double atan_2(double y, double x) noexcept {
  if (std::isnan(x) || std::isnan(y)) return x + y;
  double a = std::min(std::abs(x), std::abs(y));
  double b = std::max(std::abs(x), std::abs(y));
  if (!(b > 0 && b < 0x1p1020)) {
    if (b == 0) b = 1;  // two zeros: only the signs count
    if (std::isinf(a)) a = b = 1;
    if (std::isinf(b)) {
      a = 0;
      b = 1;
    }
    a *= 0x1p-4;
    b *= 0x1p-4;
  }
  // The angle from the nearer of 0 and 45 degrees: |q| <= tan(pi/8).
  const std::uint64_t middle = a > b * series::tan_eighth ? 1 : 0;
  const double q = (a - select(-middle, b, 0.0)) / (b + select(-middle, a, 0.0));
  const double z = q * q;
  const double z2 = z * z;
  const double z4 = z2 * z2;
  constexpr auto& A = series::arc_tangent;
  const double p0 = (A[0] + z * A[1]) + z2 * (A[2] + z * A[3]);
  const double p1 = (A[4] + z * A[5]) + z2 * (A[6] + z * A[7]);
  const double p2 = (A[8] + z * A[9]) + z2 * A[10];
  const double angle = q + q * (z * (p0 + z4 * (p1 + z4 * p2)));

  // The angle is mirrored at 45 degrees where y is larger, and at 90 degrees where x is negative.
  const std::uint64_t steep = std::abs(y) > std::abs(x) ? 1 : 0;
  const std::uint64_t back = std::bit_cast<std::uint64_t>(x) >> 63;
  std::uint64_t eighth = steep != 0 ? 2 - middle : middle;
  eighth = back != 0 ? 4 - eighth : eighth;
  const double turned = with_sign_flipped(angle, (steep ^ back) << 63);
  return std::copysign(series::eighths[eighth] + (series::rests[eighth] + turned), y);
}

}  // namespace vandplan::base
