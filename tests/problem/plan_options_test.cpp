// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/plan_options.h"
#include "support/numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "vandplan/input_error.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

OptionValue whole(std::int64_t number) { return number; }

/// What an error says, or nothing.
template <typename Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string message_of_setting(const char* planner, const char* name, const char* value) {
  return message_of([&] {
    PlanOptions options;
    set_option(options, planner_named(planner), name, value);
  });
}

/// What is said when a run of that planner is asked for with these options.
std::string message_of_completing(const char* planner, const PlanOptions& options) {
  return message_of([&] { (void)complete(planner_named(planner), options); });
}

PlanOptions with(const char* name, OptionValue value) {
  PlanOptions options;
  options.planner.set(name, std::move(value));
  return options;
}

// ---- options of all planners ----

TEST(PlanOptions, EveryCommonOptionReadsBackWhatItWrites) {
  PlanOptions options;
  options.budget = {.time_limit = 0.1,
                    .max_iterations = 7,
                    .seed = 18446744073709551615U,
                    .threads = 3,
                    .target_gap = 0.02};
  options.cost = {.reverse_weight = 1.7,
                  .gear_change_cost = 0.1,
                  .curvature_change_cost = 3.3,
                  .clearance_weight = 0.7,
                  .clearance_distance = 2.1,
                  .initial_gear = InitialGear::reverse};
  options.clearance = {.margin = 0.2, .margin_ramp = 4};
  options.steering = Steering::continuous_between_stops;
  PlanOptions copy;
  for (const CommonOption& option : common_options()) {
    std::string value = option.get(options);
    if (value.front() == '"') value = value.substr(1, value.size() - 2);
    set_option(copy, planner_named("anytime"), option.name, value);
  }
  EXPECT_EQ(copy, options);
}

TEST(PlanOptions, NullTakesALimitAway) {
  PlanOptions options;
  set_option(options, default_planner(), "max_iterations", "3");
  EXPECT_EQ(options.budget.max_iterations, 3);
  set_option(options, default_planner(), "max_iterations", "null");
  EXPECT_EQ(options.budget.max_iterations, std::nullopt);
}

TEST(PlanOptions, ValidateSaysTheRule) {
  const auto message = [](const PlanOptions& options) {
    return message_of([&] { validate(options); });
  };
  EXPECT_EQ(message({.budget = {.time_limit = -1}}), "time_limit: -1 is not a number >= 0 [s]");
  EXPECT_EQ(message({.budget = {.max_iterations = -1}}),
            "max_iterations: -1 is not a whole number >= 0");
  EXPECT_EQ(message({.budget = {.threads = 0}}), "threads: 0 is not a whole number from 1 to 256");
  EXPECT_EQ(message({.budget = {.target_gap = 1001}}),
            "target_gap: 1001 is not a number from 0 to 1000");
  EXPECT_EQ(message({.cost = {.curvature_change_cost = -1}}),
            "curvature_change_cost: -1 is not a number from 0 to 10000 [m per 1/m]");
  EXPECT_EQ(message({.clearance = {.margin = -1}}),
            "margin: -1 is not a number from 0 to 1000 [m]");
}

TEST(PlanOptions, ValidateRejectsWhatIsOutOfRange) {
  const auto is_rejected = [](auto change) {
    PlanOptions options;
    change(options);
    return !message_of([&] { validate(options); }).empty();
  };
  EXPECT_FALSE(is_rejected([](PlanOptions&) {}));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.budget.time_limit = -0.1; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.budget.time_limit = infinity; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.budget.max_iterations = -1; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.budget.threads = 0; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.budget.threads = 257; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.budget.target_gap = -0.1; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.budget.target_gap = nan; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.cost.reverse_weight = 0.9; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.cost.reverse_weight = nan; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.cost.gear_change_cost = -1; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.cost.gear_change_cost = infinity; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.cost.curvature_change_cost = -1; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.cost.curvature_change_cost = nan; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.cost.clearance_weight = -0.1; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.cost.clearance_weight = nan; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.cost.clearance_distance = 0; }));
  EXPECT_TRUE(is_rejected([](PlanOptions& o) { o.cost.clearance_distance = nan; }));
}

// ---- the table ----

TEST(Capabilities, HaveNamesThatAreRead) {
  std::set<std::string_view> names;
  for (const Capability capability : all_capabilities()) {
    EXPECT_FALSE(name_of(capability).empty());
    EXPECT_TRUE(names.insert(name_of(capability)).second) << name_of(capability);
    EXPECT_EQ(capability_named(name_of(capability)), capability);
  }
  EXPECT_EQ(name_of(all_capabilities().front()), "prices");
  EXPECT_EQ(all_capabilities().back(), Capability::site);
  EXPECT_EQ(message_of([] {
              (void)capability_named("price");
            }).substr(0, std::string("capabilities: \"price\" is unknown, did you mean ").size()),
            "capabilities: \"price\" is unknown, did you mean ");
}

TEST(Capabilities, AreASet) {
  constexpr Capabilities two = {Capability::prices, Capability::goal_sets};
  static_assert(two.has(Capability::goal_sets) && !two.has(Capability::time));
  for (const Capability capability : all_capabilities()) {
    Capabilities set;
    EXPECT_FALSE(set.has(capability));
    set.add(capability);
    EXPECT_EQ(set, Capabilities{capability});
    EXPECT_EQ(names_of(set), std::vector{name_of(capability)});
    set.remove(capability);
    EXPECT_EQ(set, Capabilities{});
  }
  EXPECT_EQ(names_of(two), (std::vector<std::string_view>{"prices", "goal_sets"}));
}

TEST(OptionTable, EveryRowIsComplete) {
  std::set<std::string_view> names;
  for (const CommonOption& option : style_and_common_options()) {
    SCOPED_TRACE(option.name);
    EXPECT_TRUE(names.insert(option.name).second);
    EXPECT_EQ(find_common_option(option.name), &option);
    EXPECT_TRUE(option.text().starts_with(option.summary));
    EXPECT_TRUE(option.text().ends_with("; " + option.range()));
    const auto all = all_capabilities();
    EXPECT_TRUE(!option.needs || std::find(all.begin(), all.end(), *option.needs) != all.end());
    EXPECT_EQ(option.is_optional, option.get({.cost = {}}) == "null");
  }
  EXPECT_EQ(find_common_option("style"), &style_and_common_options().front());
  EXPECT_EQ(find_common_option("seed"), &common_options().front());
  EXPECT_EQ(find_common_option("goal_bias"), nullptr);
}

TEST(OptionTable, SaysWhatMayBeSet) {
  const auto text = [](const char* name) { return find_common_option(name)->text(); };
  EXPECT_EQ(text("seed"), "random seed; 0 to 18446744073709551615");
  EXPECT_EQ(text("time_limit"), "time limit, wall clock [s]; >= 0 or null");
  EXPECT_EQ(text("threads"), "number of threads; 1 to 256");
  EXPECT_EQ(text("gear_change_cost"), "cost of one gear change [m]; 0 to 10000");
  EXPECT_EQ(text("clearance_distance"), "distance that counts as near [m]; 0.01 to 1000");
  EXPECT_EQ(text("gears"), "allowed gears; both, forward or reverse");
}

// A value that some planner cannot take is refused by a planner without that capability, and set
// by one that has nothing else.
TEST(OptionTable, AnOptionNeedsItsCapabilityAndNoOther) {
  for (const CommonOption& option : style_and_common_options()) {
    const std::string value = option.words.empty() ? "2" : std::string(option.words.back());
    Planner able{.name = "able", .summary = ""};
    if (option.needs) able.properties.capabilities = {*option.needs};
    PlanOptions options;
    set_option(options, able, option.name, value);
    EXPECT_TRUE(honours(able, option.name));
    EXPECT_FALSE(option.equal(options, {})) << option.name;
    if (!option.needs) continue;
    Planner unable{.name = "unable", .summary = ""};
    for (const Capability other : all_capabilities()) {
      if (other != *option.needs) unable.properties.capabilities.add(other);
    }
    EXPECT_FALSE(honours(unable, option.name));
    const std::string refusal = std::string(option.name) + ": is no option of unable, ";
    EXPECT_TRUE(message_of([&] { (void)complete(unable, options); }).starts_with(refusal));
    PlanOptions same;
    EXPECT_TRUE(
        message_of([&] { set_option(same, unable, option.name, value); }).starts_with(refusal));
    EXPECT_EQ(same, PlanOptions{});
  }
}

TEST(OptionTable, WhatEveryPlannerDoesMayBeSaid) {
  const Planner mine{.name = "mine", .summary = ""};
  PlanOptions options;
  for (const Setting& setting : std::vector<Setting>{{"threads", "1"},
                                                     {"target_gap", "null"},
                                                     {"style", "shortest"},
                                                     {"cost", "prices"},
                                                     {"reverse_weight", "1"},
                                                     {"initial_gear", "any"},
                                                     {"gears", "both"},
                                                     {"steering", "reeds-shepp"}}) {
    set_option(options, mine, setting.name, setting.value);
  }
  EXPECT_EQ(complete(mine, options), complete(mine));
}

// ---- options of one planner ----

TEST(PlannerOptions, ARangeWithoutBoundsIsAny) {
  constexpr double far = infinity;
  EXPECT_EQ((OptionInfo{"n", "", whole(1), -far, far}.range()), "any whole number");
  EXPECT_EQ((OptionInfo{"n", "", whole(1), 2, far}.range()), ">= 2");
  EXPECT_EQ((OptionInfo{"x", "", 0.5, -far, far}.range()), "any number");
  EXPECT_EQ((OptionInfo{"x", "", 0.5, -far, 1.5}.range()), "<= 1.5");
}

TEST(PlannerOptions, EveryOneReadsBackWhatItWrites) {
  for (const Planner& planner : planners()) {
    for (const OptionInfo& info : planner.options) {
      SCOPED_TRACE(planner.name + " " + info.name);
      std::string text = json_of(info.default_value);
      if (text.front() == '"') text = text.substr(1, text.size() - 2);
      EXPECT_EQ(parsed_value(info, text), info.default_value);
      EXPECT_EQ(fitting_value(info, info.default_value), info.default_value);
      EXPECT_FALSE(info.summary.empty());
      EXPECT_FALSE(info.range().empty());
    }
  }
}

TEST(PlannerOptions, ANumberReadsBackExactly) {
  PlanOptions options;
  set_option(options, planner_named("rrt-bsc-euc"), "goal_bias", "0.3333333333333333");
  EXPECT_EQ(options.planner.number("goal_bias"), 1.0 / 3);
}

TEST(PlannerOptions, CompleteFillsInTheDefaults) {
  const PlanOptions all = complete(planner_named("rrt-bsc-euc"), with("max_nodes", whole(77)));
  EXPECT_EQ(all.planner.integer("max_nodes"), 77);
  EXPECT_EQ(all.planner.number("goal_bias"), 0.05);
  EXPECT_EQ(all.planner.word("region"), "bounds");
  EXPECT_FALSE(all.planner.flag("try_goal"));
  EXPECT_TRUE(complete(planner_named("rrt-bsc-euc-goal"), {}).planner.flag("try_goal"));
}

TEST(PlannerOptions, AWholeNumberIsANumberToo) {
  const PlanOptions all = complete(planner_named("rrt-bsc-euc"), with("goal_bias", whole(1)));
  EXPECT_EQ(all.planner.number("goal_bias"), 1.0);
}

TEST(PlannerOptions, ARunWithoutALimitTakesTheDefaultTime) {
  EXPECT_EQ(complete(default_planner(), {}).budget.time_limit, default_time_limit);
  PlanOptions limited;
  limited.budget.max_iterations = 5;
  EXPECT_EQ(complete(default_planner(), limited).budget.time_limit, std::nullopt);
}

// ---- what is refused ----

TEST(PlannerOptions, AnUnknownNameListsTheKnownOnes) {
  const std::string expected =
      "gaol_bias: unknown option, did you mean goal_bias? Expected one of seed, time_limit, "
      "max_iterations, gears, margin, "
      "margin_ramp, steering, region, goal_bias, max_nodes, max_parents, try_goal, keep_tree, "
      "profile";
  EXPECT_EQ(message_of_setting("rrt-bsc-euc", "gaol_bias", "0.1"), expected);
  EXPECT_EQ(message_of_setting("anytime", "max_steering_angle", "0.6"),
            "max_steering_angle: is no option but a value of the vehicle, expected it there: "
            "\"vehicle\" of the scenario");
  EXPECT_EQ(message_of_completing("rrt-bsc-euc", with("gaol_bias", 0.1)), expected);
}

TEST(PlannerOptions, AnIgnoredOneNamesThePlannersThatHonourIt) {
  const std::string expected =
      "max_parents: is no option of anytime, expected one of the planners that honour it: rrt-... "
      "(28)";
  EXPECT_EQ(message_of_setting("anytime", "max_parents", "10"), expected);
  EXPECT_EQ(message_of_completing("anytime", with("max_parents", whole(10))), expected);
}

TEST(PlannerOptions, PricesAndThreadsAreRefusedByTheTrees) {
  const auto refusal = [](const std::string& name) {
    const bool is_price = name != "threads" && name != "target_gap";
    return name +
           ": is no option of rrt-opt-rs, expected one of the planners that honour it: anytime" +
           (is_price ? ", hybrid-a-star" : "");
  };
  EXPECT_EQ(message_of_setting("rrt-opt-rs", "reverse_weight", "2"), refusal("reverse_weight"));
  EXPECT_EQ(message_of_setting("rrt-opt-rs", "gear_change_cost", "2"), refusal("gear_change_cost"));
  EXPECT_EQ(message_of_setting("rrt-opt-rs", "initial_gear", "reverse"), refusal("initial_gear"));
  EXPECT_EQ(message_of_setting("rrt-opt-rs", "threads", "2"), refusal("threads"));
  EXPECT_EQ(message_of_setting("rrt-opt-rs", "target_gap", "0.1"), refusal("target_gap"));
  const auto completing = [](auto change) {
    PlanOptions options;
    change(options);
    return message_of_completing("rrt-opt-rs", options);
  };
  EXPECT_EQ(completing([](PlanOptions& o) { o.cost.reverse_weight = 3; }),
            refusal("reverse_weight"));
  EXPECT_EQ(completing([](PlanOptions& o) { o.cost.gear_change_cost = 2; }),
            refusal("gear_change_cost"));
  EXPECT_EQ(completing([](PlanOptions& o) { o.cost.initial_gear = InitialGear::reverse; }),
            refusal("initial_gear"));
  EXPECT_EQ(completing([](PlanOptions& o) { o.budget.threads = 2; }), refusal("threads"));
}

// ---- steering ----

TEST(SteeringOption, HasThreeNames) {
  for (const auto& [name, steering] :
       {std::pair{"reeds-shepp", Steering::reeds_shepp},
        {"continuous-between-stops", Steering::continuous_between_stops},
        {"continuous", Steering::continuous}}) {
    PlanOptions options;
    set_option(options, planner_named("anytime"), "steering", name);
    EXPECT_EQ(options.steering, steering);
    EXPECT_EQ(name_of(steering), name);
    EXPECT_EQ(steering_named(name), steering);
  }
  EXPECT_EQ(message_of_setting("anytime", "steering", "smooth"),
            "steering: \"smooth\" is not reeds-shepp, continuous-between-stops or continuous, "
            "expected: where curvature may jump; reeds-shepp, continuous-between-stops or "
            "continuous");
  EXPECT_THROW((void)steering_named("smooth"), InputError);
}

TEST(SteeringOption, IsHonouredByOurPlanners) {
  EXPECT_TRUE(honours(planner_named("anytime"), "steering"));
  EXPECT_TRUE(honours(planner_named("rrt-opt-rs"), "steering"));
  for (const Planner& planner : planners()) {
    if (!honours(planner, "steering")) continue;
    PlanOptions options;
    set_option(options, planner, "steering", "continuous");
    EXPECT_EQ(complete(planner, options).steering, Steering::continuous) << planner.name;
    options = {.cost = shortest_style};
    EXPECT_EQ(complete(planner, options).steering, Steering::reeds_shepp) << planner.name;
  }
}

// Who minds prices wants a path that can be driven.
TEST(SteeringOption, IsBetweenStopsWhereDrivingHasPrices) {
  const Planner& anytime = planner_named("anytime");
  EXPECT_EQ(complete(anytime, {}).steering, Steering::continuous_between_stops);
  EXPECT_EQ(complete(planner_named("rrt-bsc-euc"), {}).steering, Steering::reeds_shepp);
}

TEST(SteeringOption, IsRefusedForAPlannerThatDoesNotHonourIt) {
  const Planner mine{.name = "mine", .summary = ""};
  EXPECT_FALSE(honours(mine, "steering"));
  const auto refusal = [&](const std::string& message) {
    return message.starts_with(
        "steering: is no option of mine, expected one of the planners that honour it: anytime, ");
  };
  PlanOptions options;
  for (const char* const name : {"continuous-between-stops", "continuous"}) {
    EXPECT_TRUE(refusal(message_of([&] { set_option(options, mine, "steering", name); })));
    options.steering = steering_named(name);
    EXPECT_TRUE(refusal(message_of([&] { (void)complete(mine, options); })));
  }
  set_option(options, mine, "steering", "reeds-shepp");  // what it does may be said
  EXPECT_EQ(complete(mine, options).steering, Steering::reeds_shepp);
}

// ---- styles ----

TEST(Styles, AreSetsOfPrices) {
  const Planner planner = planner_named("anytime");
  PlanOptions options;
  EXPECT_EQ(complete(planner, options).cost, driver_style);
  EXPECT_FALSE(is_length(driver_style));
  options.cost.initial_gear = InitialGear::reverse;
  set_option(options, planner, "style", "shortest");
  EXPECT_TRUE(is_length(complete(planner, options).cost));
  EXPECT_EQ(options.cost.initial_gear, InitialGear::reverse);
  EXPECT_EQ(
      message_of_setting("anytime", "style", "fast"),
      "style: \"fast\" is not shortest or driver, expected: prices and steering where none is "
      "set, the length's or a driver's; shortest or driver");
  for (const Style style : {Style::shortest, Style::driver}) {
    EXPECT_EQ(style_named(name_of(style)), style);
    EXPECT_EQ(prices_of(style, {}), style == Style::driver ? driver_style : shortest_style);
  }
}

TEST(Styles, ShrinkWithASmallVehicle) {
  const auto prices = [](double radius) {
    return prices_of(Style::driver, {.min_turning_radius = radius});
  };
  const CostOptions half = {.forward_weight = 1.0,
                            .reverse_weight = 2.0,
                            .gear_change_cost = 2.5,
                            .curvature_change_cost = 1.25,
                            .clearance_weight = 2.0,
                            .clearance_distance = 0.5};
  EXPECT_EQ(prices(3.5), half);
  for (const double radius : {7.0, 8.0, 1e4}) EXPECT_EQ(prices(radius), driver_style) << radius;
  EXPECT_EQ(prices_of(Style::shortest, {.min_turning_radius = 1.0}), shortest_style);
}

TEST(Styles, AreInRangeForEveryVehicle) {
  for (const double radius : {-7.0, 0.0, 1e-3, 0.07, 1.0, 1e300, std::nan("")}) {
    const CostOptions prices = prices_of(Style::driver, {.min_turning_radius = radius});
    EXPECT_EQ(message_of([&] { validate({.cost = prices}); }), "") << radius;
  }
}

TEST(Styles, SayHowTheVehicleSteers) {
  const Planner planner = planner_named("anytime");
  for (const char* const name : {"driver", "shortest"}) {
    PlanOptions options{.steering = Steering::continuous};
    set_option(options, planner, "style", name);
    EXPECT_EQ(complete(planner, options).steering, name == std::string("driver")
                                                       ? Steering::continuous_between_stops
                                                       : Steering::reeds_shepp);
    set_option(options, planner, "reverse_weight", "3");  // says nothing about steering
    EXPECT_EQ(complete(planner, options).steering, name == std::string("driver")
                                                       ? Steering::continuous_between_stops
                                                       : Steering::reeds_shepp);
    set_honoured(options, planner,
                 std::vector<Setting>{{"steering", "continuous"}, {"style", name}});
    EXPECT_EQ(complete(planner, options).steering, Steering::continuous);  // given beside it
  }
}

// ---- what is not set ----

TEST(UnsetOptions, ArePricesOfTheStyleThatThePlannerNames) {
  for (const Planner& planner : planners()) {
    const bool is_default = planner.name == default_planner().name;
    EXPECT_EQ(complete(planner).cost, is_default ? driver_style : shortest_style) << planner.name;
  }
  Planner mine{.name = "mine", .summary = "", .properties = {.capabilities = {Capability::prices}}};
  EXPECT_EQ(complete(mine).cost, shortest_style);
  mine.properties.style = Style::driver;
  EXPECT_EQ(complete(mine).cost, driver_style);
  mine.properties.capabilities.remove(Capability::prices);
  EXPECT_EQ(complete(mine).cost, shortest_style);
}

TEST(UnsetOptions, AreFilledBesideThoseThatAreSet) {
  const PlanOptions by_length{.cost = {.reverse_weight = 3.0}};
  CostOptions expected = shortest_style;
  expected.reverse_weight = 3.0;
  EXPECT_EQ(complete(planner_named("hybrid-a-star"), by_length).cost, expected);
  expected = driver_style;
  expected.reverse_weight = 3.0;
  EXPECT_EQ(complete(planner_named("anytime"), by_length).cost, expected);
}

TEST(UnsetOptions, FitTheVehicle) {
  const Vehicle robot{.min_turning_radius = 1.4};
  const PlanOptions options{.cost = {.gear_change_cost = 5.0}};
  const CostOptions cost = complete(planner_named("anytime"), options, robot).cost;
  EXPECT_EQ(cost.gear_change_cost, 5.0) << "it is set";
  EXPECT_DOUBLE_EQ(*cost.curvature_change_cost, 0.2);
  EXPECT_DOUBLE_EQ(*cost.clearance_distance, 0.2);
}

// The default of a price is no value that may be set in vain.
TEST(UnsetOptions, AreToldFromTheirDefaults) {
  for (const double weight : {1.0, 2.0, 2.1}) {
    const PlanOptions options{.cost = {.reverse_weight = weight}};
    const std::string message =
        message_of([&] { (void)complete(planner_named("rrt-star"), options); });
    EXPECT_EQ(message.starts_with("reverse_weight: is no option of rrt-star"), weight != 1.0)
        << weight;
    PlanOptions in_time = options;
    in_time.cost.measure = CostMeasure::time;
    EXPECT_EQ(message_of([&] { (void)complete(planner_named("anytime"), in_time); }),
              weight == 1.0 ? "" : "reverse_weight: is a price, expected none beside cost=time")
        << weight;
  }
  const PlanOptions driver{.style = Style::driver};
  EXPECT_NE(message_of([&] { (void)complete(planner_named("rrt-star"), driver); }), "");
}

// Somebody who asks for the time does not ask for the prices that held before.
TEST(SetOption, TheMeasureTakesPricesBack) {
  PlanOptions options;
  const Planner planner = planner_named("anytime");
  set_honoured(options, planner, std::vector<Setting>{{"reverse_weight", "3"}, {"margin", "0.2"}});
  set_option(options, planner, "cost", "prices");
  EXPECT_EQ(options.cost.reverse_weight, 3.0);
  set_option(options, planner, "cost", "time");
  EXPECT_EQ(options.cost, CostOptions{.measure = CostMeasure::time});
  EXPECT_EQ(options.clearance.margin, 0.2);
  PlanOptions both;  // a price beside it is a mistake, whichever comes first
  set_honoured(both, planner, std::vector<Setting>{{"reverse_weight", "3"}, {"cost", "time"}});
  EXPECT_NE(message_of([&] { (void)complete(planner, both); }), "");
}

// A style is what holds where nothing else is set, whichever stands first.
TEST(SetOption, TimeBesideAStyleIsTheFastestDriveInEitherOrder) {
  const Planner planner = planner_named("anytime");
  const std::vector<Setting> given = {{"cost", "time"}, {"style", "shortest"}};
  const std::vector<Setting> turned = {given[1], given[0]};
  PlanOptions options;
  PlanOptions others;
  set_honoured(options, planner, given);
  set_honoured(others, planner, turned);
  EXPECT_EQ(options, others);
  const PlanOptions all = complete(planner, options);
  EXPECT_EQ(all.cost.measure, CostMeasure::time);
  EXPECT_EQ(all.steering, Steering::reeds_shepp);
  set_option(options, planner, "style", "shortest");  // said later, by itself
  EXPECT_TRUE(is_length(complete(planner, options).cost));
  EXPECT_LT(setting_order("style"), setting_order("cost"));
  EXPECT_LT(setting_order("cost"), setting_order("seed"));
  EXPECT_EQ(setting_order("goal_bias"), setting_order("seed"));
}

// Gears are no price: neither a style nor the time takes them back.
TEST(SetOption, GearsHoldBesideStyleAndMeasure) {
  PlanOptions options;
  const Planner planner = planner_named("anytime");
  set_option(options, planner, "gears", "forward");
  set_option(options, planner, "style", "shortest");
  set_option(options, planner, "cost", "time");
  EXPECT_EQ(options.cost.gears, AllowedGears::forward);
  EXPECT_EQ(complete(planner, options).cost.gears, AllowedGears::forward);
  EXPECT_NE(message_of([&] {
              set_option(options, planner, "gears", "first");
            }).find("\"first\" is not both, forward or reverse"),
            std::string::npos);
}

TEST(SetOption, BothGearsAreWhatEveryPlannerDrives) {
  for (const Planner& planner : planners()) {
    PlanOptions options;
    set_option(options, planner, "gears", "both");
    EXPECT_EQ(honours(planner, "gears"), planner.can(Capability::gears)) << planner.name;
  }
}

TEST(SettingsOf, SayWhatIsSet) {
  PlanOptions options;
  options.budget.time_limit = 2.0;
  options.cost.reverse_weight = 3.0;
  options.steering = Steering::continuous;
  options.planner.set("min_stroke", 0.5);
  PlanOptions again;
  const Planner planner = planner_named("anytime");
  set_honoured(again, planner, settings_of(options));
  EXPECT_EQ(again, options);
}

TEST(UnsetOptions, AreCompletedOnce) {
  for (const Planner& planner : planners()) {
    PlanOptions options;
    if (honours(planner, "style")) options.style = Style::driver;
    const PlanOptions once = complete(planner, options);
    EXPECT_EQ(complete(planner, once), once) << planner.name;
    EXPECT_FALSE(once.style) << planner.name;
  }
}

TEST(Styles, GiveWayToWhatIsSetBesideThem) {
  PlanOptions options;
  const Planner planner = planner_named("anytime");
  set_honoured(options, planner,
               std::vector<Setting>{{"gear_change_cost", "7"}, {"style", "shortest"}});
  EXPECT_EQ(complete(planner, options).cost.gear_change_cost, 7);
  EXPECT_EQ(complete(planner, options).cost.reverse_weight, 1);
}

TEST(Styles, OfThoseWhoKnowNoPricesAreTheShortest) {
  const Planner planner = planner_named("rrt-opt-rs");
  PlanOptions options;
  set_option(options, planner, "style", "shortest");
  EXPECT_EQ(complete(planner, options).cost, shortest_style);
  EXPECT_EQ(complete(planner, PlanOptions{}).cost, shortest_style);
  EXPECT_EQ(message_of_setting("rrt-opt-rs", "style", "driver"),
            "style: is no option of rrt-opt-rs, expected one of the planners that honour it: "
            "anytime, hybrid-a-star");
}

TEST(PlannerOptions, ABadTextNamesOptionValueAndRule) {
  EXPECT_EQ(message_of_setting("rrt-bsc-euc", "goal_bias", "0.1x"),
            "goal_bias: \"0.1x\" is not a number, expected: share of samples that are the goal; "
            "0 to 1");
  EXPECT_NE(message_of_setting("rrt-bsc-euc", "seed", "-1"), "");
  EXPECT_NE(message_of_setting("rrt-bsc-euc", "max_nodes", "99999999999999999999"), "");
  EXPECT_NE(message_of_setting("rrt-bsc-euc", "max_nodes", "0"), "");
  EXPECT_NE(message_of_setting("rrt-bsc-euc", "region", "everywhere"), "");
  EXPECT_NE(message_of_setting("rrt-bsc-euc", "keep_tree", "yes"), "");
}

TEST(PlannerOptions, AValueOfAnotherTypeOrOutOfRangeIsRefused) {
  EXPECT_EQ(message_of_completing("rrt-bsc-euc", with("goal_bias", 1.01)),
            "goal_bias: 1.01 is not 0 to 1");
  EXPECT_EQ(message_of_completing("rrt-bsc-euc", with("goal_bias", std::string("0.1"))),
            "goal_bias: \"0.1\" is not 0 to 1");
  EXPECT_EQ(message_of_completing("rrt-bsc-euc", with("region", std::string("yard"))),
            "region: \"yard\" is not bounds or scene");
  EXPECT_EQ(message_of_completing("rrt-bsc-euc", with("keep_tree", whole(1))),
            "keep_tree: 1 is not true or false");
  EXPECT_NE(message_of_completing("rrt-bsc-euc", with("goal_bias", nan)), "");
  EXPECT_NE(message_of_completing("rrt-bsc-euc", with("max_nodes", whole(0))), "");
  EXPECT_NE(message_of_completing("rrt-bsc-euc", with("max_nodes", 5.5)), "");
  EXPECT_NE(message_of_completing("rrt-bsc-euc", with("max_parents", whole(0))), "");
}

}  // namespace
}  // namespace vandplan
