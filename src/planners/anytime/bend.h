// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a route get cheaper whose words turn the wheels as far as they can?
//
// Method: docs/algorithms/anytime.md, "Bending".

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "planners/anytime/drive.h"
#include "planners/anytime/follow.h"
#include "planners/anytime/kinds.h"
#include "planners/anytime/shorten.h"
#include "planners/anytime/worker.h"
#include "planners/commands/closer.h"
#include "planners/commands/shorten_drive.h"
#include "planners/commands/wheels.h"
#include "search/route.h"

namespace vandplan::anytime {

using namespace search;

/// Makes drives of routes, with commands of any curvature, and makes the cheapest drive cheaper.
/// Trials alternate between that drive and its challengers.
class Bender final : public Worker {
 public:
  using Measure = commands::DriveShortener::Measure;

  /// The vehicle has no trailer. The task and the rule outlive the bender. With a `measure` drives
  /// are compared by it.
  Bender(const Task& task, const CostRule& rule, std::uint64_t seed, Measure measure = {});

  /// Offers a route from the start of the task to its goal. A route that is like one offered before
  /// is ignored unless it is much cheaper.
  void offer(const Route& route) override;
  /// Offers a path that need not be free, and whose ends need not be exact. Only one whose cost is
  /// known is followed where the wheels cannot turn as it says.
  void offer_path(std::vector<Segment> segments,
                  double cost = std::numeric_limits<double>::infinity());
  /// Begins with a known path. Gives back the drive along it; none if none was found.
  [[nodiscard]] std::optional<Drive> begin_with(const Path& known);

  /// Whether more trials may bring anything: routes wait or may come, or a drive is not stalled.
  [[nodiscard]] bool has_work() const override {
    return !has_begun_ || is_following_ || !challengers_.empty() || !waiting_.empty() ||
           (best_ && !best_->is_stalled());
  }
  [[nodiscard]] Found work(std::int64_t iterations, const Told& told,
                           const Budget& budget) override;
  [[nodiscard]] Counts counts() const override { return {0, checks()}; }

  /// One trial. True when the cheapest drive got cheaper.
  bool step();

  /// The cheapest drive so far. Requires that `step` was true once.
  [[nodiscard]] Drive best() const {
    return {.commands = best_->commands(), .cost = best_->cost()};
  }
  [[nodiscard]] double cost() const { return best_->cost(); }
  /// Segments of the best drive, without crumbs that other commands can make up for.
  [[nodiscard]] std::vector<Segment> segments() const;
  [[nodiscard]] std::int64_t checks() const;

 private:
  void wait(Drive route);
  [[nodiscard]] bool drive_along(std::span<const Segment> segments);
  void add(std::span<const commands::Command> drive);
  bool begin();
  bool follow();
  bool challenge(std::size_t i);
  [[nodiscard]] double doubt(const commands::DriveShortener& challenger) const;
  [[nodiscard]] std::size_t next_challenger() const;
  void drop(std::size_t i);

  const Task& task_;
  const CostRule& rule_;
  commands::Wheels wheels_;
  DrivenBeside ends_;
  commands::Closer closer_;
  std::uint64_t seed_;
  Measure measure_;
  std::uint64_t drives_ = 0;  // drives so far; numbers their seeds
  Kinds kinds_;               // kinds of the routes that were offered
  /// Routes by falling cost; of equal ones the newest last. The cost of a known path is infinite.
  std::vector<Drive> waiting_;
  std::unique_ptr<commands::DriveShortener> best_;
  /// Drives that may become cheaper than the best drive.
  std::vector<std::unique_ptr<commands::DriveShortener>> challengers_;
  std::int64_t checks_ = 0;  // checks of drives that were dropped
  Follower follower_;
  bool is_following_ = false;
  double followed_cost_ = 0.0;  // cost of the route that is being followed [m]
  bool is_turn_of_best_ = false;
  bool has_begun_ = false;  // whether there was an offer or an iteration
  double known_cost_;       // least cost of all routes and drives that the worker knows
  double told_cost_;        // cost of the best route that the worker was told
};

}  // namespace vandplan::anytime
