// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "base/decimal.h"
#include "base/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/cases.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

TEST(Moved, KeepsTheDecimalsThatWereWritten) {
  EXPECT_EQ(base::moved(4484378811.24645, -4484378811), 0.24645);
  EXPECT_EQ(base::moved(4484378788.261, -4484378811), -22.739);
  EXPECT_EQ(base::moved(-354286007.239762, 354286007), -0.239762);
  EXPECT_EQ(base::moved(0.1, 1), 1.1);
  EXPECT_EQ(base::moved(-0.3, 1), 0.7);
}

TEST(Moved, AddsWhatIsTooFineForItsDecimals) {
  EXPECT_EQ(base::moved(1e-30, 7), 7);
  EXPECT_EQ(base::moved(3.1234567890123456, 4484378811), 3.1234567890123456 + 4484378811);
  EXPECT_EQ(base::moved(1e300, 7), 1e300);
  EXPECT_EQ(base::moved(12, -5), 7);
}

TEST(Moved, LeavesWhatIsNotFiniteAlone) {
  EXPECT_EQ(base::moved(std::numeric_limits<double>::infinity(), 1),
            std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(base::moved(std::numeric_limits<double>::quiet_NaN(), 1)));
}

TEST(Moved, ComesBackExactlyFromTheOriginNextToIt) {
  for_each_case(1, 200'000, [](Rng& rng) {
    const double size = std::pow(10.0, uniform(-3, 12, rng));
    const double value = uniform(-size, size, rng);
    const double origin = std::round(value);
    const double local = base::moved(value, -origin);
    ASSERT_LE(std::abs(local), 0.5 + std::abs(value) * 1e-15) << as_code(value);
    ASSERT_EQ(base::moved(local, origin), value) << as_code(value);
  });
}

TEST(Moved, IsTheSumToHalfASpacing) {
  for_each_case(2, 100'000, [](Rng& rng) {
    const double value = uniform(-1e3, 1e3, rng) * std::pow(10.0, uniform(-9, 8, rng));
    const double whole = std::round(uniform(-1e10, 1e10, rng));
    const double sum = base::moved(value, whole);
    // The text of `value` is within half its spacing, the plain sum within half of its own.
    const double slack = (std::nextafter(std::abs(value), 1e300) - std::abs(value)) / 2 +
                         std::nextafter(std::abs(sum), 1e300) - std::abs(sum);
    ASSERT_LE(std::abs(sum - (value + whole)), slack) << as_code(value) << ' ' << as_code(whole);
  });
}

TEST(ShortestText, ReadsBackAndIsShort) {
  EXPECT_EQ(base::shortest_text(0.1), "0.1");
  EXPECT_EQ(base::shortest_text(-2.5), "-2.5");
  EXPECT_EQ(base::shortest_text(200), "200");
  EXPECT_EQ(base::shortest_text(1e300), "1e+300");
}

}  // namespace
}  // namespace vandplan
