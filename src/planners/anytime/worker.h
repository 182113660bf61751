// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the anytime planner do side by side? Each worker does one line of work. What a worker
// finds depends on its seed and on what it is told, on nothing else.

#include <cstdint>
#include <optional>
#include <vector>

#include "planners/anytime/drive.h"
#include "search/route.h"
#include "vandplan/outcome.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

/// What a worker found in one round.
struct Found {
  std::int64_t iterations = 0;
  /// Costs below all that the worker knew of. Iterations count from the beginning of the round.
  std::vector<CostSample> improvements;
  std::optional<search::Route> route;   ///< route of the last improvement
  std::optional<Drive> drive;           ///< drive of the last improvement
  std::vector<search::Route> given_up;  ///< routes of which another worker may make more
};

/// What a worker is told at the beginning of a round.
struct Told {
  const search::Route* best = nullptr;  ///< best route of all workers; null while there is none
  double enough = 0.0;                  ///< a route that costs no more ends the round [m]
};

/// What a worker has proven.
struct Proven {
  double shortest = 0.0;       ///< no path is shorter, even one that ends beside the goal [m]
  double shortest_turn = 0.0;  ///< no path is shorter that ends just at the goal [m]
  bool is_walled_in = false;   ///< there is no path
};

/// Work so far.
struct Counts {
  std::int64_t solves = 0;  ///< exact steerings
  std::int64_t checks = 0;  ///< edge checks
  std::int64_t nodes = 0;   ///< nodes of the search that is under way
};

class Worker {
 public:
  virtual ~Worker() = default;

  /// Whether another iteration may bring anything.
  [[nodiscard]] virtual bool has_work() const = 0;
  /// At most `iterations` of work; less if the budget is interrupted or nothing is left to do.
  [[nodiscard]] virtual Found work(std::int64_t iterations, const Told& told,
                                   const search::Budget& budget) = 0;
  /// A route that another worker gave up.
  virtual void offer(const search::Route& /*route*/) {}

  /// Proves more, in at most so many steps, which are no iterations. Number of steps made.
  virtual std::int64_t prove(std::int64_t /*steps*/, const search::Budget& /*budget*/) { return 0; }
  [[nodiscard]] virtual Proven proven() const { return {}; }

  [[nodiscard]] virtual Counts counts() const = 0;
};

/// Steps of work between two looks at the clock.
inline constexpr std::int64_t steps_of_look = 4;

/// One round of a worker: calls `step` as often as it may. `has_work` says whether another step may
/// bring anything; `step` returns the best cost that the worker knows of, if it fell.
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
