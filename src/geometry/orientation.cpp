// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geometry/orientation.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace vandplan::geometry {
namespace {

int sign_of(double value) { return (value > 0) - (value < 0); }

/// A sum of doubles without rounding: parts from small to large that do not overlap.
class ExactSum {
 public:
  /// Adds a * b: the rounded product, and what rounding took away.
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  /// Sign of the sum: the largest part that is not 0 outweighs all others together.
  [[nodiscard]] int sign() const {
    for (std::size_t i = count_; i-- > 0;) {
      if (parts_[i] != 0) return sign_of(parts_[i]);
    }
    return 0;
  }

 private:
  void add(double value) {
    for (std::size_t i = 0; i < count_; ++i) {
      // Knuth's two-sum: `sum` is rounded, and `parts_[i]` becomes what that took away.
      const double sum = value + parts_[i];
      const double of_part = sum - value;
      parts_[i] = (value - (sum - of_part)) + (parts_[i] - of_part);
      value = sum;
    }
    parts_[count_++] = value;
  }

  std::array<double, 12> parts_ = {};  // two parts for each of six products
  std::size_t count_ = 0;
};

int exact_orientation(const Point& a, const Point& b, const Point& c) {
  ExactSum sum;
  sum.add_product(a.x, b.y);
  sum.add_product(-a.y, b.x);
  sum.add_product(b.x, c.y);
  sum.add_product(-b.y, c.x);
  sum.add_product(c.x, a.y);
  sum.add_product(-c.y, a.x);
  return sum.sign();
}

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c) {
  constexpr double rounding = 3.3306690738754716e-16;  // (3 + 16 e) e with e = 2^-53
  const double left = (b.x - a.x) * (c.y - a.y);
  const double right = (b.y - a.y) * (c.x - a.x);
  const double area = left - right;
  if (std::abs(area) > rounding * (std::abs(left) + std::abs(right))) return sign_of(area);
  return exact_orientation(a, b, c);
}

}  // namespace vandplan::geometry
