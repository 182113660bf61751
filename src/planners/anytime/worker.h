// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is a worker of the anytime planner?
//
// A worker uses one method, side by side with others. What it finds depends only on its seed and on
// what it is told.

#include <cstdint>
#include <optional>
#include <vector>

#include "planners/anytime/drive.h"
#include "planners/path_search.h"
#include "search/route.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

using planning::Proven;

/// What a worker found in one round.
struct Found {
  /// Iterations done in the round, at most those that were granted.
  std::int64_t iterations = 0;
  /// Improvements of the best cost that the worker knows. Iterations count from the begin of the
  /// round.
  std::vector<CostSample> improvements = {};
  /// Route of the last improvement: free, from the start to the goal, cheaper than the one told. Of
  /// the routes of a round the cheapest stays, and the others are dropped.
  std::optional<search::Route> route = {};
  /// Drive of the last improvement; the same drive may be found again. Without a trailer no other
  /// worker makes it cheaper: they may make more of a route in `given_up`.
  std::optional<Drive> drive = {};
  std::vector<search::Route> given_up = {};  ///< routes that other workers may make more of
};

/// What a worker is told at the beginning of a round.
struct Told {
  const search::Route* route = nullptr;  ///< best route of all workers; null while there is none
  const Drive* drive = nullptr;          ///< best drive of all workers; null while there is none
  double enough = 0.0;  ///< a route of at most this cost ends the worker's round [m]
};

/// Counters of the work so far.
struct Counts {
  std::int64_t solves = 0;  ///< calls of the steering function
  std::int64_t checks = 0;  ///< edge checks
  std::int64_t nodes = 0;   ///< nodes of the current search

  Counts& operator+=(const Counts& other) {
    solves += other.solves;
    checks += other.checks;
    nodes += other.nodes;
    return *this;
  }
};

[[nodiscard]] inline Counts counts_of(const search::Connector& connector) {
  return {connector.solves(), connector.checks()};
}

/// One method of the anytime planner. It searches in iterations, or proves in steps, or both.
class Worker {
 public:
  virtual ~Worker() = default;

  /// Whether another iteration may find anything, by what the worker heard in former rounds. A run
  /// ends once no worker has any work.
  [[nodiscard]] virtual bool has_work() const { return false; }
  /// Works for at most `iterations`; fewer if the budget is interrupted or nothing is left to do.
  /// Together with others it is called in every round, with 0 iterations too, so that the worker
  /// hears what it is told.
  [[nodiscard]] virtual Found work(std::int64_t /*iterations*/, const Told& /*told*/,
                                   const search::Budget& /*budget*/) {
    return {};
  }
  /// Tells the worker of a route that was given up.
  virtual void offer(const search::Route& /*route*/) {}
  /// Stage of the source that the worker takes routes from; 0 without one.
  [[nodiscard]] virtual std::int64_t stage() const { return 0; }

  /// Works on a proof, in at most `steps` steps. They are no iterations, so results of an iteration
  /// budget do not depend on them. Gives back the number of steps.
  virtual std::int64_t prove(std::int64_t /*steps*/, const search::Budget& /*budget*/) { return 0; }
  /// What is proven so far.
  [[nodiscard]] virtual Proven proven() const { return {}; }

  [[nodiscard]] virtual Counts counts() const { return {}; }
};

/// Steps of work between two looks at the clock.
inline constexpr std::int64_t steps_of_look = 4;

/// One round of a worker: calls `step` up to `iterations` times, until a cost is at most `enough`.
/// `has_work` says whether another step may find anything. `step` gives back the best cost that the
/// worker knows, if that fell.
template <class HasWork, class Step>
[[nodiscard]] Found work_in_steps(std::int64_t iterations, double enough,
                                  const search::Budget& budget, HasWork has_work, Step step) {
  Found found;
  while (found.iterations < iterations && has_work()) {
    if (found.iterations % steps_of_look == 0 && budget.is_interrupted()) break;
    ++found.iterations;
    const std::optional<double> cost = step();
    if (!cost) continue;
    found.improvements.push_back({budget.elapsed(), found.iterations, *cost});
    if (*cost <= enough) break;
  }
  return found;
}

}  // namespace vandplan::anytime
