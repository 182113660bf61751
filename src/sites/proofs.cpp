// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "sites/proofs.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"
#include "search/enclosure.h"
#include "search/zone_bound.h"
#include "sites/site.h"
#include "vandplan/search.h"

namespace vandplan::sites {
namespace {

/// Steps of all proofs from one start, and of one flood; some ten microseconds each.
constexpr int steps_of_start = 1000;
constexpr int steps_of_flood = 100;

/// Proofs from one start. Goals are tried together, since one flood tells of all that nothing leads
/// to any of these goals. If it tells nothing, halves of the goals are tried.
class ProofsFrom {
 public:
  ProofsFrom(const Task& task, const PlanOptions& options, const std::vector<LocalPose>& goals)
      : task_(task), only_(search::cost_rule(options.cost, task).only_gear()), goals_(goals) {}

  void prove(std::span<const std::size_t> goals) {
    if (left_ <= 0) return;
    if (are_parted(goals)) {
      unreachable.insert(unreachable.end(), goals.begin(), goals.end());
    } else if (goals.size() > 1) {
      prove(goals.first(goals.size() / 2));
      prove(goals.last(goals.size() - goals.size() / 2));
    }
  }

  std::vector<std::size_t> unreachable = {};

 private:
  /// Whether it is proven that no path leads to any of some goals.
  [[nodiscard]] bool are_parted(std::span<const std::size_t> goals) {
    std::vector<LocalPose> ends;
    std::vector<Bounds> places;
    for (const std::size_t goal : goals) {
      const LocalPose& end = ends.emplace_back(goals_[goal]);
      places.push_back({end.x, end.x, end.y, end.y});
    }
    return is_proven(search::ZoneBound(task_, only_, {}, places)) ||
           is_proven(search::Enclosure(task_, ends));
  }

  template <typename Flood>
  [[nodiscard]] bool is_proven(Flood flood) {
    for (int i = 0; i < steps_of_flood && left_ > 0 && flood.step(); ++i) --left_;
    return flood.is_proven();
  }

  const Task& task_;
  search::GearSign only_;
  const std::vector<LocalPose>& goals_;
  int left_ = steps_of_start;
};

/// Starts and goals by the ground that ways join, wherever they lead: each has the number of the
/// first one there, starts before goals. Where streets lead one way, each is alone.
class Grounds {
 public:
  Grounds(const Problem& problem, std::size_t starts, std::size_t goals,
          std::span<const SiteCost> costs)
      : starts_(starts), first_(starts + goals), first_goal_(starts + goals, goals) {
    std::iota(first_.begin(), first_.end(), std::size_t{0});
    const std::vector<Zone>& zones = problem.world()->local().zones;
    const bool is_one_way =
        std::ranges::any_of(zones, [](const Zone& zone) { return zone.direction.has_value(); });
    for (std::size_t i = 0; i < costs.size() && !is_one_way; ++i) {
      if (costs[i].outcome == SiteOutcome::way) join(i / goals, starts + i % goals);
    }
    for (std::size_t j = goals; j-- > 0;) first_goal_[of(starts + j)] = j;
  }

  [[nodiscard]] std::size_t of_start(std::size_t i) { return of(i); }
  /// First goal on the ground of a goal.
  [[nodiscard]] std::size_t first_goal(std::size_t j) { return first_goal_[of(starts_ + j)]; }

 private:
  [[nodiscard]] std::size_t of(std::size_t i) {
    while (first_[i] != i) i = first_[i] = first_[first_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = of(a);
    b = of(b);
    first_[std::max(a, b)] = std::min(a, b);
  }

  std::size_t starts_;
  std::vector<std::size_t> first_;       // a pose of the same ground with a lower number, or itself
  std::vector<std::size_t> first_goal_;  // by the ground's number; of one without goals none
};

}  // namespace

std::vector<std::size_t> unreachable_goals(const Problem& problem, const Pose& start,
                                           const std::vector<Pose>& goals,
                                           const PlanOptions& options) {
  if (goals.empty()) return {};
  const Problem pair = between(problem, start, goals.front(), "starts");
  const Task task = task_of(pair, options.clearance, Steering::reeds_shepp);
  std::vector<LocalPose> ends;
  ends.reserve(goals.size());
  for (const Pose& goal : goals) ends.push_back(to_local(*task.world, goal));
  std::vector<std::size_t> all(goals.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  ProofsFrom proofs(task, options, ends);
  proofs.prove(all);
  return proofs.unreachable;
}

// What is proven for one start and goal holds for all on the same grounds, as a way that led from
// one ground to the other would join them.
void prove_empty_entries(const Problem& problem, std::span<const Pose> starts,
                         const std::vector<Pose>& goals, const PlanOptions& options, int threads,
                         std::span<SiteCost> costs) {
  const auto is_open = [](const SiteCost& cost) {
    return cost.outcome == SiteOutcome::no_way || cost.outcome == SiteOutcome::outside;
  };
  Grounds grounds(problem, starts.size(), goals.size(), costs);
  std::vector<std::vector<std::size_t>> open(starts.size());  // goals that a proof is tried for
  std::vector<std::vector<bool>> is_proven(starts.size());
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const std::size_t start = i / goals.size(), goal = i % goals.size();
    const bool is_first = grounds.of_start(start) == start && grounds.first_goal(goal) == goal;
    if (is_first && is_open(costs[i])) open[start].push_back(goal);
  }
  parallel_for(starts.size(), threads, [&](std::size_t i) {
    std::vector<Pose> to;
    for (const std::size_t goal : open[i]) to.push_back(goals[goal]);
    is_proven[i].resize(goals.size());
    for (const std::size_t number : unreachable_goals(problem, starts[i], to, options)) {
      is_proven[i][open[i][number]] = true;
    }
  });
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const std::size_t goal = grounds.first_goal(i % goals.size());
    if (!is_open(costs[i]) || !is_proven[grounds.of_start(i / goals.size())][goal]) continue;
    costs[i].outcome = SiteOutcome::no_path;
  }
}

}  // namespace vandplan::sites
