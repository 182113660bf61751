// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "studies/learned.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <ctime>
#include <span>
#include <utility>

#include "sites/estimate.h"
#include "studies/percentile.h"
#include "vandplan/graphs.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan::studies {
namespace {

constexpr std::size_t most_draws = 100;  // random poses that are tried for one that has a cost
constexpr float lengths_scale = 0.1F;
constexpr std::size_t batch = 32;
constexpr float first_rate = 3e-3F;
constexpr std::size_t poses_of_errors = 20'000;

/// What a network is told of a pose, and the largest of its lengths [turning radii].
struct Known {
  std::array<float, 7> inputs = {};
  double length = 0.0;
};

constexpr std::size_t inputs_of(Told told) { return told == Told::map ? 6 : 7; }

/// Costs to one goal.
class LearnedCosts {
 public:
  LearnedCosts(const Problem& problem, const Pose& goal, Told told)
      : problem_(with_poses(problem, problem.start(), goal)), told_(told) {
    if (told == Told::map) way_ = search::make_goal_estimate("any-angle", problem_.task());
  }
  LearnedCosts(const LearnedCosts&) = delete;
  LearnedCosts& operator=(const LearnedCosts&) = delete;

  [[nodiscard]] Known known(const Pose& pose) const {
    const double radius = problem_.vehicle().min_turning_radius;
    const auto scaled = [radius](double length) {
      return lengths_scale * static_cast<float>(length / radius);
    };
    const LocalPose place = to_local(*problem_.world(), pose);
    const auto [x, y, turn] = relative(problem_.goal(), pose);
    double length = reeds_shepp_length(pose, problem_.goal(), radius);
    Known known{.inputs = {scaled(x), scaled(y), static_cast<float>(std::cos(turn)),
                           static_cast<float>(std::sin(turn)), scaled(length)}};
    if (told_ == Told::map) {
      const double way = way_.length(place);
      known.inputs[5] = scaled(way);
      length = std::max(length, way);
    } else {
      known.inputs[5] = scaled(place.x);
      known.inputs[6] = scaled(place.y);
    }
    known.length = length / radius;
    return known;
  }

  /// Cost from a pose [m]. Without a network: the largest known length.
  [[nodiscard]] double from(const Pose& pose, const Network* network) const {
    const auto [inputs, length] = known(pose);
    const double radius = problem_.vehicle().min_turning_radius;
    if (network == nullptr || !std::isfinite(length)) return radius * length;
    const float more = network->value(std::span(inputs).first(inputs_of(told_)));
    return radius * (length + static_cast<double>(more));
  }

 private:
  Problem problem_;
  Told told_;
  search::GoalEstimate way_ = {};
};

/// Calls `use(pose, goal, cost)` with random poses that have a cost, for the goals in turn.
template <class Use>
void draw_costs(const SiteTable& table, std::size_t count, std::uint64_t seed, Use use) {
  Rng rng(seed);
  const std::size_t draws = most_draws * count;
  for (std::size_t found = 0, draw = 0; found < count && draw < draws; ++draw) {
    const std::size_t goal = found % table.goals().size();
    const Pose pose = uniform_pose(table.bounds(), rng);
    const double cost = table.cost(pose, goal);
    if (!std::isfinite(cost)) continue;
    use(pose, goal, cost);
    ++found;
  }
}

/// Costs to each goal of a table that is asked for, made when it is asked for first.
class LearnedTable {
 public:
  LearnedTable(const SiteTable& table, const Problem& problem, Told told)
      : problem_(problem), told_(told), goals_(table.goals()), costs_(goals_.size()) {}

  const LearnedCosts& to(std::size_t goal) {
    std::unique_ptr<LearnedCosts>& costs = costs_[goal];
    if (!costs) costs = std::make_unique<LearnedCosts>(problem_, goals_[goal], told_);
    return *costs;
  }

 private:
  Problem problem_;
  Told told_;
  std::vector<Pose> goals_;
  std::vector<std::unique_ptr<LearnedCosts>> costs_;
};

}  // namespace

CostSamples cost_samples(const SiteTable& table, const Problem& problem, Told told,
                         std::size_t count, std::uint64_t seed) {
  CostSamples samples;
  LearnedTable costs(table, problem, told);
  const double radius = problem.vehicle().min_turning_radius;
  draw_costs(table, count, seed, [&](const Pose& pose, std::size_t goal, double cost) {
    const auto [inputs, length] = costs.to(goal).known(pose);
    if (!std::isfinite(length)) return;
    samples.inputs.insert(samples.inputs.end(), inputs.begin(),
                          inputs.begin() + static_cast<std::ptrdiff_t>(inputs_of(told)));
    samples.targets.push_back(static_cast<float>(cost / radius - length));
  });
  return samples;
}

std::shared_ptr<const Network> trained_on(const CostSamples& samples, int steps,
                                          std::uint64_t seed) {
  Rng rng(seed);
  const std::size_t size = samples.inputs.size() / samples.targets.size();
  auto network = std::make_shared<Network>(size, rng());
  std::vector<float> inputs(batch * size), targets(batch);
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < batch; ++i) {
      const std::size_t sample = rng() % samples.targets.size();
      std::copy_n(samples.inputs.data() + sample * size, size, inputs.data() + i * size);
      targets[i] = samples.targets[sample];
    }
    const float left = 1.0F - static_cast<float>(step) / static_cast<float>(steps);
    network->learn(inputs, targets, first_rate * left);
  }
  return network;
}

SiteTable with_learned_costs(const SiteTable& table, const Problem& problem, Told told,
                             std::shared_ptr<const Network> network) {
  return sites::with_costs(table,
                           [costs = std::make_shared<LearnedTable>(table, problem, told),
                            network = std::move(network)](const Pose& pose, std::size_t goal) {
                             return costs->to(goal).from(pose, network.get());
                           });
}

CostErrors cost_errors(const SiteTable& costs, const SiteTable& table, std::uint64_t seed) {
  std::vector<std::pair<Pose, std::size_t>> queries;
  std::vector<double> errors;
  double all_errors = 0.0, all_costs = 0.0;
  draw_costs(table, poses_of_errors, seed, [&](const Pose& pose, std::size_t goal, double cost) {
    const double estimate = costs.cost(pose, goal);
    if (!std::isfinite(estimate)) return;
    queries.emplace_back(pose, goal);
    errors.push_back(std::abs(estimate - cost));
    all_errors += errors.back();
    all_costs += cost;
  });
  if (errors.empty()) return {};
  const std::clock_t begin = std::clock();
  double sum = 0.0;
  for (const auto& [pose, goal] : queries) sum += costs.cost(pose, goal);
  const auto ticks = static_cast<double>(std::clock() - begin);
  const auto count = static_cast<double>(errors.size());
  assert(sum >= 0.0);
  return {.mean = all_errors / count,
          .percent_95 = percentile(errors, 95.0),
          .relative = all_errors / all_costs,
          .nanoseconds = 1e9 * ticks / CLOCKS_PER_SEC / count};
}

}  // namespace vandplan::studies
