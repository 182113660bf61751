// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does a network compute and learn what it should, and what does it learn of a table?
#include "studies/learned.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/problems.h"
#include "support/sites.h"
#include "vandplan/graphs.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan::studies {
namespace {

std::vector<float> random_numbers(std::size_t count, Rng& rng) {
  std::vector<float> numbers(count);
  for (float& number : numbers) number = static_cast<float>(uniform(-1.0, 1.0, rng));
  return numbers;
}

/// Outputs of a layer whose weights begin at `at`, which is moved to the next layer.
std::vector<double> slow_layer(const std::vector<double>& in, std::size_t outputs,
                               const std::vector<float>& weights, std::size_t& at) {
  std::vector<double> out;
  for (std::size_t o = 0; o < outputs; ++o) {
    auto sum = static_cast<double>(weights[at + in.size() * outputs + o]);
    for (std::size_t i = 0; i < in.size(); ++i) {
      sum += in[i] * static_cast<double>(weights[at + i * outputs + o]);
    }
    out.push_back(sum);
  }
  at += (in.size() + 1) * outputs;
  return out;
}

/// Output of a network with those weights, layer by layer in double precision.
double slow_value(const std::vector<float>& weights, std::span<const float> input) {
  std::size_t at = 0;
  std::vector<double> units(input.begin(), input.end());
  for (int layer = 0; layer < 2; ++layer) {
    units = slow_layer(units, Network::width, weights, at);
    for (double& unit : units) unit = std::max(unit, 0.0);
  }
  const double output = slow_layer(units, 1, weights, at)[0];
  EXPECT_EQ(at, weights.size());
  return output;
}

TEST(Network, ComputesWhatItsWeightsSay) {
  Rng rng(1);
  for (const std::size_t inputs : {1U, 5U, 6U, 32U}) {
    const Network network(inputs, rng());
    for (int i = 0; i < 50; ++i) {
      const std::vector<float> input = random_numbers(inputs, rng);
      EXPECT_NEAR(network.value(input), slow_value(network.weights(), input), 1e-5);
    }
  }
}

// Adam's first step moves each weight by the rate, against the slope of the error.
TEST(Network, LearnsAgainstTheSlopeOfTheError) {
  Rng rng(2);
  Network network(3, 7);
  const std::vector<float> before = network.weights();
  const std::vector<float> input = random_numbers(3, rng);
  const float target = network.value(input) - 0.5F;
  constexpr float rate = 1e-3F;
  network.learn(input, std::vector<float>{target}, rate);
  int moved = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    constexpr float change = 1e-3F;
    std::vector<float> more = before, less = before;
    more[i] += change;
    less[i] -= change;
    const double slope = (slow_value(more, input) - slow_value(less, input)) / 2e-3;
    if (std::abs(slope) < 1e-3) continue;
    ++moved;
    EXPECT_NEAR(network.weights()[i] - before[i], slope > 0 ? -rate : rate, 1e-5) << i;
  }
  EXPECT_GT(moved, 100);
}

TEST(Network, LearnsAFunction) {
  Rng rng(3);
  const auto wanted = [](float x, float y) { return std::abs(x) - 0.5F * y; };
  Network network(2, 1);
  for (int step = 0; step < 2000; ++step) {
    const std::vector<float> inputs = random_numbers(32, rng);
    std::vector<float> targets;
    for (std::size_t i = 0; i < 32; i += 2) targets.push_back(wanted(inputs[i], inputs[i + 1]));
    network.learn(inputs, targets, 3e-3F);
  }
  for (int i = 0; i < 100; ++i) {
    const std::vector<float> input = random_numbers(2, rng);
    EXPECT_NEAR(network.value(input), wanted(input[0], input[1]), 0.1);
  }
}

// ---- costs ----

using namespace sites;

Problem around_a_wall() { return problem_of({20, 0, 0}, {0, 0, 0}, {box(9, -12, 11, 12)}, area); }

TEST(LearnedCosts, AreTheLengthsThatANetworkIsToldWithoutOne) {
  const Problem problem = around_a_wall();
  const SiteTable table = table_to(problem, length_options());
  const SiteTable blind = with_learned_costs(table, problem, Told::place, nullptr);
  const SiteTable told = with_learned_costs(table, problem, Told::map, nullptr);
  const auto way = search::make_goal_estimate("any-angle", problem.task());
  const double radius = problem.vehicle().min_turning_radius;
  for (const Pose& pose : {Pose{20, 1, 0}, Pose{-5, -7, 2}, Pose{25, -20, -3}}) {
    const double length = reeds_shepp_length(pose, problem.goal(), radius);
    EXPECT_NEAR(blind.cost(pose, 0), length, 1e-9);
    EXPECT_NEAR(told.cost(pose, 0), std::max(length, way.length(to_local(*problem.world(), pose))),
                1e-9);
  }
  EXPECT_GT(told.cost({20, 1, 0}, 0), blind.cost({20, 1, 0}, 0) + 1.0);
}

TEST(LearnedCosts, AreNearerToTheTableThanWhatTheNetworkIsTold) {
  const Problem problem = around_a_wall();
  const SiteTable table = table_to(problem, length_options());
  for (const Told told : {Told::place, Told::map}) {
    const auto network = trained_on(cost_samples(table, problem, told, 2000, 1), 3000, 1);
    EXPECT_EQ(network->weights(),
              trained_on(cost_samples(table, problem, told, 2000, 1), 3000, 1)->weights());
    const auto errors = [&](const auto& known) {
      return cost_errors(with_learned_costs(table, problem, told, known), table, 2);
    };
    const CostErrors learned = errors(network), untrained = errors(nullptr);
    EXPECT_LT(learned.mean, 0.5 * untrained.mean);
    EXPECT_LT(learned.mean, learned.percent_95);
    EXPECT_LT(learned.relative, 0.06);
  }
  EXPECT_EQ(cost_errors(table, table, 2).percent_95, 0.0);
}

}  // namespace
}  // namespace vandplan::studies
