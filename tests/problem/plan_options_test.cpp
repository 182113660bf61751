// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/plan_options.h"

#include <gtest/gtest.h>

#include <limits>

#include "vandplan/input_error.h"

namespace vandplan {
namespace {

std::string message_of_setting(const char* name, const char* value) {
  PlanOptions options;
  try {
    set_option(options, name, value);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PlanOptions, EveryOptionReadsBackWhatItWrites) {
  PlanOptions options;
  options.seed = 18446744073709551615U;
  options.time_limit = 0.1;
  options.max_nodes = 77;
  options.region = Region::scene;
  options.goal_bias = 1.0 / 3;
  options.reverse_weight = 1.7;
  options.gear_change_cost = 0.1;
  options.initial_gear = InitialGear::reverse;
  options.threads = 3;
  options.keep_tree = true;
  PlanOptions copy;
  for (const OptionInfo& info : option_table()) {
    std::string value = info.get(options);
    if (value.front() == '"') value = value.substr(1, value.size() - 2);
    set_option(copy, info.name, value);
  }
  for (const OptionInfo& info : option_table()) {
    EXPECT_EQ(info.get(copy), info.get(options)) << info.name;
  }
  EXPECT_EQ(copy.goal_bias, 1.0 / 3);
}

TEST(PlanOptions, NullTakesALimitAway) {
  PlanOptions options;
  set_option(options, "max_iterations", "3");
  EXPECT_EQ(options.max_iterations, 3);
  set_option(options, "max_iterations", "null");
  EXPECT_EQ(options.max_iterations, std::nullopt);
}

TEST(PlanOptions, UnknownNameListsTheKnownOnes) {
  const std::string message = message_of_setting("gaol_bias", "0.1");
  EXPECT_NE(message.find("gaol_bias: unknown option, expected one of seed, "), std::string::npos);
}

TEST(PlanOptions, BadValueNamesOptionValueAndRule) {
  EXPECT_EQ(message_of_setting("goal_bias", "0.1x"),
            "goal_bias: \"0.1x\" is not a number, expected: share of samples that are the goal; "
            "0 to 1");
  EXPECT_NE(message_of_setting("seed", "-1"), "");
  EXPECT_NE(message_of_setting("max_nodes", "99999999999999999999"), "");
  EXPECT_NE(message_of_setting("region", "everywhere"), "");
  EXPECT_NE(message_of_setting("keep_tree", "yes"), "");
}

TEST(PlanOptions, ValidateRejectsWhatIsOutOfRange) {
  const auto is_rejected = [](auto change) {
    PlanOptions options;
    change(options);
    try {
      validate(options);
    } catch (const InputError&) {
      return true;
    }
    return false;
  };
  EXPECT_FALSE(is_rejected([](PlanOptions&) {}));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.goal_bias = 1.01; }));
  EXPECT_TRUE(
      is_rejected([](PlanOptions& o) { o.goal_bias = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.time_limit = -0.1; }));
  EXPECT_TRUE(
      is_rejected([](PlanOptions& o) { o.time_limit = std::numeric_limits<double>::infinity(); }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.max_nodes = 0; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.max_parents = 0; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.max_iterations = -1; }));
}

}  // namespace
}  // namespace vandplan
