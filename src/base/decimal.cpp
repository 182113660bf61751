// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "base/decimal.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

namespace vandplan::base {
namespace {

using Text = std::array<char, 40>;

/// The number digits * 10^exponent.
struct Decimal {
  std::int64_t digits;  // at most 17 decimal digits
  int exponent;
};

Decimal shortest_decimal(double value) noexcept {
  Text text;
  const char* const end = std::to_chars(text.data(), text.data() + text.size(), std::abs(value),
                                        std::chars_format::scientific)
                              .ptr;
  Decimal decimal{0, 0};
  const char* at = text.data();
  bool is_fraction = false;
  for (; *at != 'e'; ++at) {
    if (*at == '.') {
      is_fraction = true;
      continue;
    }
    decimal.digits = 10 * decimal.digits + (*at - '0');
    if (is_fraction) --decimal.exponent;
  }
  ++at;
  if (*at == '+') ++at;
  int power = 0;
  std::from_chars(at, end, power);
  decimal.exponent += power;
  if (std::signbit(value)) decimal.digits = -decimal.digits;
  return decimal;
}

double nearest_double(const Decimal& decimal) noexcept {
  const std::string text = std::to_string(decimal.digits) + "e" + std::to_string(decimal.exponent);
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

double moved(double value, double whole) noexcept {
  if (whole == 0.0 || !std::isfinite(value)) return value;
  Decimal decimal = shortest_decimal(value);
  // Beyond 18 decimals the plain sum is exact enough: the value is below 1, the sum is not.
  if (decimal.exponent >= 0 || decimal.exponent < -18) return value + whole;
  std::int64_t scale = 1;
  for (int i = decimal.exponent; i < 0; ++i) scale *= 10;
  constexpr double largest = 9e18;  // even with 17 digits added, the sum fits in 64 bits
  if (std::abs(whole) * static_cast<double>(scale) > largest) return value + whole;
  decimal.digits += static_cast<std::int64_t>(whole) * scale;
  return nearest_double(decimal);
}

}  // namespace vandplan::base
