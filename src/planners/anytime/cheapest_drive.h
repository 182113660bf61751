// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which route is the cheapest by a measure of the whole drive, such as its time?

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include "planners/anytime/bend.h"
#include "planners/anytime/shorten.h"
#include "planners/anytime/worker.h"
#include "search/route.h"

namespace vandplan::anytime {

/// Keeps the cheapest route by a measure of the whole drive, and makes it cheaper by random trials.
class CheapestDrive final : public Worker {
 public:
  using Measure = std::function<double(const Route&)>;

  /// `rule`: prices like the measure, by which routes are found and steered. With a
  /// `measure_of_drive` routes are bent, too.
  CheapestDrive(const Task& task, const CostRule& rule, std::uint64_t seed, Measure measure,
                const Bender::Measure& measure_of_drive = {});

  [[nodiscard]] bool has_work() const override { return true; }
  [[nodiscard]] Found work(std::int64_t iterations, const Told& told,
                           const Budget& budget) override;
  /// Keeps a route for the next round, where it comes after the best route.
  void offer(const Route& route) override { offers_.push_back(route); }
  [[nodiscard]] Counts counts() const override;

  /// Takes a route over if it is cheaper than the one so far. A route that is a little dearer is
  /// kept and shortened later. True if the cheapest drive got cheaper.
  bool take(Route route);

  /// One trial to make the drive cheaper by the measure. True if the cheapest drive got cheaper.
  bool step();

  /// Segments of the cheapest drive: along the route, or bent if that is cheaper.
  [[nodiscard]] std::vector<Segment> segments() const;
  /// Cost of the cheapest drive by the measure; infinity while there is no route.
  [[nodiscard]] double cost() const { return std::min(cost_, bent_cost_); }

 private:
  void begin();
  void begin_with(const Route& route);
  void challenge();
  bool bend();

  Measure measure_;
  std::deque<Task> tasks_;            // copies of the task with different curvature rates
  std::deque<Connector> connectors_;  // one connector for each of `tasks_`
  std::deque<Bender> benders_;        // one bender for each of `tasks_`, if drives are bent
  std::uint64_t seed_;
  std::uint64_t beginnings_ = 0;  // shortened routes so far; numbers their seeds
  std::optional<Route> route_;    // cheapest route
  double cost_;                   // cost of the cheapest route
  std::size_t bends_ = 0;         // trials of bending so far
  std::size_t best_bender_ = 0;   // index of the bender with the cheapest bent drive
  double bent_cost_;              // cost of the cheapest bent drive
  int steps_ = 0;                 // trials so far
  std::vector<Route> offers_;     // routes for the next round
  std::optional<Shortener> shortener_;
  std::vector<Route> challengers_;  // dearer routes that may become the cheapest, the newest last
  bool is_challenger_ = false;      // whether the shortener works on a challenger
  int trials_ = 0;                  // trials spent on the challenger
};

}  // namespace vandplan::anytime
