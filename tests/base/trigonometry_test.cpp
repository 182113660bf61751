// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "base/trigonometry.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "base/exponential.h"
#include "support/cases.h"
#include "support/numbers.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

/// In units of the last place of `expected`.
double error_of(double actual, long double expected) {
  const double size = std::abs(static_cast<double>(expected));
  return static_cast<double>(std::abs(actual - expected)) / (std::nextafter(size, infinity) - size);
}

void expect_right_sin_cos(double angle) {
  const auto [sin, cos] = base::sin_cos(angle);
  EXPECT_LT(error_of(sin, std::sin(static_cast<long double>(angle))), 1) << as_code(angle);
  EXPECT_LT(error_of(cos, std::cos(static_cast<long double>(angle))), 1) << as_code(angle);
}

TEST(SinCos, IsRightWithinOneTurn) {
  Rng rng(1);
  for (int i = 0; i < cases(1'000'000); ++i) expect_right_sin_cos(uniform(-7, 7, rng));
}

TEST(SinCos, IsRightForAnglesOfAnySize) {
  Rng rng(2);
  for (int i = 0; i < cases(1'000'000); ++i) {
    const double size = std::ldexp(uniform(1, 2, rng), static_cast<int>(rng() % 1000) - 40);
    expect_right_sin_cos(rng() % 2 == 0 ? size : -size);
  }
}

TEST(SinCos, IsRightNextToMultiplesOfQuarterTurns) {
  Rng rng(3);
  for (int i = 0; i < cases(1'000'000); ++i) {
    const double quarters = std::round(uniform(-1000, 1000, rng));
    const double offset = uniform(-1, 1, rng) * std::pow(10, uniform(-18, -1, rng));
    expect_right_sin_cos(quarters * (std::numbers::pi / 2) + offset);
  }
}

TEST(SinCos, IsRightForTheDoubleThatIsNearestToAMultipleOfQuarterTurns) {
  // 6381956970095103 * 2^797 (Muller 2016, table 11.1): 2^-60.9 from a multiple of pi/2.
  const double angle = std::ldexp(6381956970095103.0, 797);
  EXPECT_EQ(base::sin_cos(angle).cos, -4.6871659242546277e-19);
  EXPECT_EQ(base::sin_cos(angle).sin, 1);
}

TEST(SinCos, IsOddAndEvenBitForBit) {
  Rng rng(4);
  for (int i = 0; i < cases(100'000); ++i) {
    const double angle = std::ldexp(uniform(1, 2, rng), static_cast<int>(rng() % 100) - 50);
    EXPECT_EQ(base::sin_cos(-angle).sin, -base::sin_cos(angle).sin) << as_code(angle);
    EXPECT_EQ(base::sin_cos(-angle).cos, base::sin_cos(angle).cos) << as_code(angle);
  }
}

TEST(SinCos, KnowsTheSpecialArguments) {
  EXPECT_EQ(base::sin_cos(0).sin, 0);
  EXPECT_EQ(base::sin_cos(0).cos, 1);
  EXPECT_EQ(base::sin_cos(5e-324).sin, 5e-324);
  for (const double angle : {infinity, -infinity, nan}) {
    EXPECT_TRUE(std::isnan(base::sin_cos(angle).sin));
    EXPECT_TRUE(std::isnan(base::sin_cos(angle).cos));
  }
}

void expect_right_atan_2(double y, double x) {
  EXPECT_LT(error_of(base::atan_2(y, x), std::atan2(static_cast<long double>(y), x)), 2.5)
      << as_code(y) << ", " << as_code(x);
}

TEST(Atan2, IsRightInAllDirections) {
  Rng rng(5);
  for (int i = 0; i < cases(1'000'000); ++i) {
    expect_right_atan_2(uniform(-1, 1, rng), uniform(-1, 1, rng));
  }
}

TEST(Atan2, IsRightNextToTheAxesAndForVectorsOfAnySize) {
  Rng rng(6);
  const auto any = [&] {
    const double size = std::ldexp(uniform(1, 2, rng), static_cast<int>(rng() % 600) - 300);
    return rng() % 2 == 0 ? size : -size;
  };
  for (int i = 0; i < cases(1'000'000); ++i) {
    const double x = any();
    const double y = rng() % 2 == 0 ? any() : x * uniform(-3, 3, rng);
    expect_right_atan_2(y, x);
  }
}

TEST(Atan2, KnowsTheSpecialArguments) {
  const double values[] = {0.0,       -0.0,    1,        -1,     infinity,
                           -infinity, 1.7e308, -1.7e308, 5e-324, -5e-324};
  for (const double y : values) {
    for (const double x : values) {
      const double expected = std::atan2(y, x);
      EXPECT_DOUBLE_EQ(base::atan_2(y, x), expected) << y << ", " << x;
      EXPECT_EQ(std::signbit(base::atan_2(y, x)), std::signbit(expected)) << y << ", " << x;
    }
    EXPECT_TRUE(std::isnan(base::atan_2(y, nan)));
    EXPECT_TRUE(std::isnan(base::atan_2(nan, y)));
  }
}

TEST(Exponential, IsWithinTwoUnitsInTheLastPlace) {
  for_each_case(7, 1'000'000, [](Rng& rng) {
    const double size = std::pow(10, uniform(-9, 2.84, rng));
    const double x = rng() % 2 == 0 ? size : -size;
    EXPECT_LT(error_of(base::exponential(x), std::exp(static_cast<long double>(x))), 2)
        << as_code(x);
  });
}

TEST(Exponential, GoesToTheEndsOfDoubles) {
  EXPECT_EQ(base::exponential(0), 1);
  EXPECT_EQ(base::exponential(-701), 0);
  EXPECT_EQ(base::exponential(-infinity), 0);
  EXPECT_EQ(base::exponential(701), infinity);
  EXPECT_TRUE(std::isnan(base::exponential(nan)));
}

}  // namespace
}  // namespace vandplan
