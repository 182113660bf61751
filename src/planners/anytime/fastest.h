// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which of the routes that were found is the cheapest by a measure of the whole drive, such as its
// time, and can it be made cheaper?

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include "planners/anytime/bend.h"
#include "planners/anytime/shorten.h"
#include "search/route.h"

namespace vandplan::anytime {

class Fastest {
 public:
  using Measure = std::function<double(const Route&)>;

  /// `rule` has prices that are like the measure, by which routes are found and steered.
  /// With a measure of drives routes are bent, too.
  Fastest(const Task& task, const CostRule& rule, std::uint64_t seed, Measure measure,
          const Bender::Measure& measure_of_drive = {});

  /// Takes the route over if it costs less than the one so far; if it does not cost much more it
  /// may get cheaper yet.
  bool offer(Route route);

  /// One trial of making it cheaper, whatever the prices say. True when it got cheaper.
  bool step();

  [[nodiscard]] const std::optional<Route>& route() const { return route_; }
  /// What is driven along the route, or along one that was bent if that is cheaper.
  [[nodiscard]] std::vector<Segment> segments() const;
  /// Of that, by the measure; infinity while there is no route.
  [[nodiscard]] double cost() const { return std::min(cost_, bent_cost_); }
  [[nodiscard]] std::int64_t solves() const;
  [[nodiscard]] std::int64_t checks() const;

 private:
  void begin();
  void begin_with(const Route& route);
  void challenge();
  bool bend();

  Measure measure_;
  std::deque<Task> tasks_;            // whose wheels turn more slowly
  std::deque<Connector> connectors_;  // one for each of them
  std::deque<Bender> benders_;        // the same
  std::uint64_t seed_;
  std::uint64_t beginnings_ = 0;
  std::optional<Route> route_;
  double cost_;                  // of it
  std::size_t bends_ = 0;        // trials of bending so far
  std::size_t best_bender_ = 0;  // whose drive is the cheapest one,
  double bent_cost_;             // and what that costs
  int steps_ = 0;
  std::optional<Shortener> shortener_;
  std::vector<Route> challengers_;  // that may get cheaper than the route, the best one last
  bool is_challenger_ = false;      // whom the shortener has
  int trials_ = 0;                  // spent on it
};

}  // namespace vandplan::anytime
