// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "base/text.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/hash.h"
#include "base/nearest_word.h"

namespace vandplan {
namespace {

TEST(Text, NumbersAreAsShortAsReadsBackInTheirType) {
  EXPECT_EQ(base::shortest_text(0.1), "0.1");
  EXPECT_EQ(base::shortest_text(0.1F), "0.1");
  EXPECT_EQ(base::shortest_text(double{0.1F}), "0.10000000149011612");
  EXPECT_EQ(base::shortest_text(-1e300), "-1e+300");
  EXPECT_EQ(base::shortest_text(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
  EXPECT_EQ(base::shortest_text(-2.2250738585072014e-308), "-2.2250738585072014e-308");
}

TEST(Text, AnUnknownWordNamesTheNearestOne) {
  const std::vector<std::string_view> known = {"margin", "margin_ramp", "gear_change_cost", "x"};
  EXPECT_EQ(base::nearest_word("marign", known), "margin");
  EXPECT_EQ(base::nearest_word("MARGIN", known), "margin");
  EXPECT_EQ(base::nearest_word("gear-change-price", known), "gear_change_cost");
  EXPECT_EQ(base::nearest_word("margin_ram", known), "margin_ramp");
  EXPECT_EQ(base::nearest_word("y", known), "");
  EXPECT_EQ(base::nearest_word("", known), "");
  EXPECT_EQ(base::nearest_word("something else", known), "");
  EXPECT_EQ(base::nearest_word(std::string(100'000, 'm'), known), "");
  EXPECT_EQ(base::expected_one_of("mergin", known),
            "did you mean margin? Expected one of margin, margin_ramp, gear_change_cost, x");
  EXPECT_EQ(base::expected_one_of("z", known),
            "expected one of margin, margin_ramp, gear_change_cost, x");
}

TEST(Text, NamesHaveCommasBetweenThem) {
  struct Thing {
    std::string_view name;
  };
  EXPECT_EQ(base::joined(std::vector<Thing>{}, &Thing::name), "");
  EXPECT_EQ(base::joined(std::array{Thing{"a"}}, &Thing::name), "a");
  EXPECT_EQ(base::joined(std::array{Thing{"a"}, Thing{"b"}, Thing{"c"}}, &Thing::name), "a, b, c");
  EXPECT_EQ(base::joined(std::vector<std::string>{"x", "y"}), "x, y");
}

// The reference values of the authors of FNV.
TEST(Hash, IsFnv1a) {
  EXPECT_EQ(base::hash_of(""), 0xcbf29ce484222325U);
  EXPECT_EQ(base::hash_of("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(base::hash_of("foobar"), 0x85944171f73967e8U);
  EXPECT_EQ(base::hash_of("bar", base::hash_of("foo")), base::hash_of("foobar"));
}

}  // namespace
}  // namespace vandplan
