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
#include "planners/pricing.h"
#include "vandplan/problem.h"

namespace vandplan::anytime {

/// How far a run is.
struct Progress {
  std::int64_t rounds = 0;             ///< rounds so far
  std::int64_t rounds_with_route = 0;  ///< rounds that began with a route
  std::int64_t iterations = 0;         ///< iterations so far
  bool has_route = false;              ///< whether there is a route
  bool is_settled = false;             ///< whether the best cost hardly falls any more
};

/// How much a worker does in the next round.
using Share = std::function<std::int64_t(const Progress&)>;

/// When in a round a worker works.
enum class Phase {
  before,    ///< alone, step by step, until the best cost is good enough
  together,  ///< beside the others
  after,     ///< alone, when what the others found is known
};

/// A worker in its place.
struct Slot {
  std::string_view name;
  std::unique_ptr<Worker> worker;
  Share share;        ///< iterations of the next round
  Share proofs = {};  ///< steps of proving beside them, which are no iterations
  Phase phase = Phase::together;
  bool is_relaxed = false;  ///< whether its routes are of the relaxed task: no answers, but offers
  std::vector<std::size_t> feeds = {};  ///< slots that hear of the routes that are given up here
};

/// All that a run needs. What it brings depends on nothing else.
struct Portfolio {
  std::unique_ptr<const planning::Pricing> pricing;
  std::unique_ptr<const Task>
      relaxed;  ///< the task of wheels that turn at once; null if none uses it
  CostBound bound;
  Finisher finisher;
  std::vector<Slot> slots;                 ///< in the order in which they are granted and merged
  std::vector<search::Route> routes = {};  ///< known before the first round
  std::optional<Drive> drive = {};         ///< known before the first round
  /// The run ends at a cost that is proven to be as near to the optimum, relative; never, if none.
  std::optional<double> gap = {};
  /// Whether routes are compared by the cost of the answer; otherwise drives alone are.
  bool routes_are_answers = true;
};

}  // namespace vandplan::anytime
