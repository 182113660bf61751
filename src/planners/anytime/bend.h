// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a route get cheaper whose words turn the wheels as far as they can?
//
// Method: docs/algorithms/anytime.md, "Bending".

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "planners/anytime/drive.h"
#include "planners/anytime/follow.h"
#include "planners/anytime/kinds.h"
#include "planners/commands/closer.h"
#include "planners/commands/shorten_drive.h"
#include "planners/commands/wheels.h"
#include "search/route.h"

namespace vandplan::anytime {

using namespace search;

/// Takes routes as drives by commands, whose curvatures may be any, and makes the cheapest of them
/// cheaper: it and another one in turns.
class Bender {
 public:
  using Measure = commands::DriveShortener::Measure;

  /// The vehicle has no trailer. The task and the rule outlive the bender. With a `measure` what is
  /// cheaper is so by it.
  Bender(const Task& task, const CostRule& rule, std::uint64_t seed, Measure measure = {});

  /// A route from the start of the task to its goal that may be worth it. One that is like a route
  /// offered before is left out unless it is much cheaper.
  void offer(const Route& route);
  /// The same of a path that need not be free, nor begin and end quite there.
  void offer(std::vector<Segment> segments);

  /// One trial. True when the cheapest drive got cheaper.
  bool step();
  /// Whether there is anything to try that many trials did not try in vain.
  [[nodiscard]] bool has_work() const {
    return is_following_ || !challengers_.empty() || !waiting_.empty() ||
           (best_ && !best_->is_stalled());
  }

  /// The cheapest drive so far; `step` was true once.
  [[nodiscard]] Drive best() const {
    return {.commands = best_->commands(), .segments = {}, .route = {}, .cost = best_->cost()};
  }
  [[nodiscard]] double cost() const { return best_->cost(); }
  [[nodiscard]] std::vector<Segment> segments() const { return best_->segments(); }
  [[nodiscard]] std::int64_t checks() const;

 private:
  /// A drive that may become cheaper than the best one yet.
  struct Challenger {
    std::unique_ptr<commands::DriveShortener> drive;
    std::int64_t trials = 0;  // spent on it
  };

  /// A route that was not tried yet.
  struct Waiting {
    std::vector<Segment> segments;
    double cost;  // as it is [m]
  };

  void wait(Waiting route);
  [[nodiscard]] bool drive_along(std::span<const Segment> segments);
  void add(std::span<const Segment> drive);
  bool begin();
  bool follow();
  bool challenge(std::size_t i);
  [[nodiscard]] double doubt(const Challenger& challenger, std::int64_t more = 0) const;
  [[nodiscard]] std::size_t next_challenger() const;
  void drop(std::size_t i);

  const Task& task_;
  const CostRule& rule_;
  commands::Wheels wheels_;
  commands::WheelEnds ends_;
  commands::Closer closer_;
  std::uint64_t seed_;
  Measure measure_;
  std::uint64_t drives_ = 0;      // so far; each has a seed
  Kinds kinds_;                   // that were offered
  std::vector<Waiting> waiting_;  // the cheapest one last, of those the newest
  std::unique_ptr<commands::DriveShortener> best_;
  std::vector<Challenger> challengers_;
  std::int64_t checks_ = 0;  // of drives that are gone
  Follower follower_;
  bool is_following_ = false;
  double followed_cost_ = 0.0;  // of that route, as it was
  bool is_turn_of_best_ = false;
};

}  // namespace vandplan::anytime
