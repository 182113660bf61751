// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "base/text.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/hash.h"

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
