// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "support/place_of_error.h"
#include "vandplan/planner.h"

namespace vandplan::ros {
namespace {

using Values = Parameters::Values;

std::string refused(const Values& values) {
  return place_of_error([&] { Parameters().set(values); });
}

TEST(RosParameters, EachIsDescribedOnce) {
  std::set<std::string> names;
  for (const Parameter& parameter : parameters()) {
    EXPECT_TRUE(names.insert(parameter.info.name).second) << parameter.info.name;
    EXPECT_FALSE(parameter.info.summary.empty()) << parameter.info.name;
    EXPECT_NE(parameter.description().find(parameter.info.range()), std::string::npos);
    EXPECT_EQ(find_parameter(parameter.info.name), &parameter);
  }
  for (const CommonOption& option : style_and_common_options()) {
    EXPECT_TRUE(names.count(std::string(option.name))) << option.name;
  }
  for (const OptionInfo& option : default_planner().options) EXPECT_TRUE(names.count(option.name));
  EXPECT_EQ(find_parameter("speed_of_light"), nullptr);
  EXPECT_EQ(find_parameter("gear_change_cost")->description(),
            "cost of one gear change [m]; 0 to 10000");
}

TEST(RosParameters, DefaultsAreThoseOfPlanning) {
  const Parameters parameters;
  const PlanOptions all = complete(default_planner(), parameters.options());
  const PlanOptions usual = complete(default_planner());
  EXPECT_EQ(all, usual);
  EXPECT_EQ(parameters.cost_rule(), CostRule{});
  EXPECT_EQ(parameters.goal_heading(), GoalHeading::given);
  EXPECT_EQ(parameters.tolerance(), 0.0);
  EXPECT_EQ(parameters.chassis().min_turning_radius, 0.4);
  EXPECT_EQ(parameters.chassis().rear_axle, 0.0);
  EXPECT_FALSE(parameters.chassis().wheelbase);
  EXPECT_EQ(parameters.chassis().limits, DrivingLimits{});
  EXPECT_EQ(parameters.find("style"), nullptr) << "not set";
  EXPECT_EQ(*parameters.find("margin"), OptionValue(0.0));
}

TEST(RosParameters, ValuesReachWhatTheyAreFor) {
  Parameters parameters;
  parameters.set({{"allow_unknown", false},
                  {"lethal_cost", std::int64_t{253}},
                  {"cost_penalty", 0.5},
                  {"goal_heading_mode", std::string("BIDIRECTIONAL")},
                  {"tolerance", 0.25},
                  {"minimum_turning_radius", 1.5},
                  {"wheelbase", 0.8},
                  {"rear_axle", -0.3},
                  {"max_steering_rate", 0.7},
                  {"max_curvature_rate", 2.0},
                  {"margin", 0.1},
                  {"gears", std::string("forward")},
                  {"style", std::string("shortest")},
                  {"gear_change_cost", 3.0},
                  {"time_limit", 0.5},
                  {"seed", std::int64_t{9}}});
  EXPECT_EQ(parameters.cost_rule(), (CostRule{253, false, 0.5}));
  EXPECT_EQ(parameters.goal_heading(), GoalHeading::either_way);
  EXPECT_EQ(parameters.tolerance(), 0.25);
  const Chassis chassis = parameters.chassis();
  EXPECT_EQ(chassis.min_turning_radius, 1.5);
  EXPECT_EQ(chassis.wheelbase, 0.8);
  EXPECT_EQ(chassis.rear_axle, -0.3);
  EXPECT_EQ(chassis.limits.max_steering_rate, 0.7);
  EXPECT_EQ(chassis.limits.max_curvature_rate, 2.0);
  const PlanOptions options = complete(default_planner(), parameters.options());
  EXPECT_EQ(options.clearance.margin, 0.1);
  EXPECT_EQ(options.cost.gears, AllowedGears::forward);
  EXPECT_EQ(options.cost.reverse_weight, 1.0) << "of the style";
  EXPECT_EQ(options.cost.gear_change_cost, 3.0) << "beside the style";
  EXPECT_EQ(options.budget.time_limit, 0.5);
  EXPECT_EQ(options.budget.seed, 9U);
  parameters.set({{"goal_heading_mode", std::string("ALL_DIRECTION")}, {"rear_axle", 0.0}});
  EXPECT_EQ(parameters.goal_heading(), GoalHeading::any);
}

TEST(RosParameters, EveryBoundIsAcceptedAndNothingBeyond) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (const auto& [info, has_default] : parameters()) {
    SCOPED_TRACE(info.name);
    const auto& name = info.name;
    if (std::holds_alternative<double>(info.default_value)) {
      EXPECT_EQ(refused({{name, info.least}}), "nothing");
      EXPECT_EQ(refused({{name, std::min(info.most, 1e9)}}), "nothing");
      EXPECT_EQ(refused({{name, std::nextafter(info.least, -inf)}}), name);
      EXPECT_EQ(refused({{name, std::nan("")}}), name);
      EXPECT_EQ(refused({{name, inf}}), name);
      EXPECT_EQ(refused({{name, std::string("1")}}), name);
    } else if (std::holds_alternative<std::int64_t>(info.default_value)) {
      EXPECT_EQ(refused({{name, static_cast<std::int64_t>(info.least)}}), "nothing");
      EXPECT_EQ(refused({{name, static_cast<std::int64_t>(info.least) - 1}}), name);
      if (info.most < 1e15) {
        EXPECT_EQ(refused({{name, static_cast<std::int64_t>(info.most) + 1}}), name);
      }
      EXPECT_EQ(refused({{name, 1.5}}), name);
      EXPECT_EQ(refused({{name, true}}), name);
    } else if (std::holds_alternative<std::string>(info.default_value)) {
      for (const std::string& word : info.words)
        EXPECT_EQ(refused({{name, word}}), "nothing") << word;
      EXPECT_EQ(refused({{name, std::string("no such word")}}), name);
      EXPECT_EQ(refused({{name, 1.0}}), name);
    } else {
      EXPECT_EQ(refused({{name, true}}), "nothing");
      EXPECT_EQ(refused({{name, std::string("true")}}), name);
    }
    EXPECT_TRUE(!has_default || refused({{name, info.default_value}}) == "nothing");
  }
}

TEST(RosParameters, ValuesThatDoNotFitTogetherChangeNothing) {
  Parameters parameters;
  parameters.set({{"margin", 0.2}});
  const auto refused_by = [&](const Values& values) {
    return place_of_error([&] { parameters.set(values); });
  };
  EXPECT_EQ(refused_by({{"margin", 0.3}, {"no_such", 1.0}}), "no_such");
  EXPECT_EQ(refused_by({{"margin", 0.3}, {"tolerance", -1.0}}), "tolerance");
  EXPECT_NE(refused_by({{"margin", 0.3}, {"cost", std::string("time")}, {"reverse_weight", 2.0}}),
            "nothing");
  EXPECT_EQ(refused_by({{"margin", 0.3},
                        {"rear_axle", 0.1},
                        {"goal_heading_mode", std::string("ALL_DIRECTION")}}),
            "goal_heading_mode");
  EXPECT_EQ(*parameters.find("margin"), OptionValue(0.2));
  EXPECT_EQ(parameters.options().clearance.margin, 0.2);
  EXPECT_EQ(parameters.chassis().rear_axle, 0.0);
}

}  // namespace
}  // namespace vandplan::ros
