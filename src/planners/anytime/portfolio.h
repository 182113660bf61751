// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Who works on a task, how much, and who hears of whom?

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "planners/anytime/cost_bound.h"
#include "planners/anytime/finish.h"
#include "planners/anytime/worker.h"
#include "planners/path_search.h"
#include "planners/pricing.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

/// State of a run, as far as shares depend on it.
struct Progress {
  std::int64_t rounds = 0;            ///< rounds so far
  std::int64_t rounds_with_path = 0;  ///< rounds that began with a path
  std::int64_t iterations = 0;        ///< iterations so far
  bool has_path = false;              ///< whether there is a route or a drive
  /// Whether the best cost has hardly fallen lately, so that proving deserves more of the work.
  bool is_settled = false;
};

/// Gives the iterations of a worker in the next round, or the steps of its proof.
using Share = std::function<std::int64_t(const Progress&)>;

/// When in a round a worker works. Routes that were given up are handed on in `together` alone.
enum class Phase {
  before,    ///< the worker works alone, first, again and again until the best cost is good enough
  together,  ///< the worker works beside others
  after,     ///< the worker works alone, last, once there is a route; its proofs are not asked for
};

/// A worker and its share of the work.
struct Slot {
  std::string_view name;
  std::unique_ptr<Worker> worker;
  Share share;        ///< iterations of the next round
  Share proofs = {};  ///< steps of proving in the next round, which are no iterations
  Phase phase = Phase::together;
  /// Whether the worker plans the relaxed task. Then its routes are no answers; other workers make
  /// drives of them.
  bool is_relaxed = false;
  std::vector<std::size_t> feeds = {};  ///< slots that hear of the routes given up here
};

/// All that a run needs beside its budget.
struct Portfolio {
  std::unique_ptr<const planning::Pricing> pricing;
  /// Task with wheels that turn at once; null if no worker uses it.
  std::unique_ptr<const Task> relaxed;
  CostBound bound;
  Finisher finisher;
  std::vector<Slot> slots;                 ///< workers, in the order of granting and merging
  std::vector<search::Route> routes = {};  ///< routes known before the first round
  std::optional<Drive> drive = {};         ///< drive known before the first round
  /// Largest proven gap at which the run ends [relative]; none: a gap does not end it.
  std::optional<double> gap = {};
  /// Whether the cost of a route is that of the answer. If not, only drives have the cost of the
  /// answer.
  bool routes_are_answers = true;
};

/// Lets the workers of a portfolio work in rounds. Workers hear of each other only between rounds,
/// and results are merged in a fixed order. So the outcome does not depend on the number of
/// threads. `budget` has begun; it was made from `options`.
[[nodiscard]] std::unique_ptr<planning::PathSearch> begin_run(Portfolio portfolio,
                                                              const search::Budget& budget,
                                                              const BudgetOptions& options);

}  // namespace vandplan::anytime
