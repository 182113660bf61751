// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which of the routes that were found takes the least time, and can it be made faster?

#include <cstdint>
#include <deque>
#include <optional>

#include "planners/anytime/shorten.h"
#include "search/route.h"

namespace vandplan::anytime {

class Fastest {
 public:
  /// `rule` has prices that are like time, by which routes are found and steered.
  Fastest(const Task& task, const CostRule& rule, std::uint64_t seed);

  /// Takes the route over if it takes less time than the one so far; if it does not take much more
  /// it may get faster yet.
  bool offer(Route route);

  /// One trial of making it faster, whatever the prices say. True when it got faster.
  bool step();

  [[nodiscard]] const std::optional<Route>& route() const { return route_; }
  /// That the route takes [s]; infinity while there is none.
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] std::int64_t solves() const;
  [[nodiscard]] std::int64_t checks() const;

 private:
  void begin();
  void begin_with(const Route& route);
  void challenge();

  const Task& task_;
  std::deque<Task> tasks_;            // whose wheels turn more slowly
  std::deque<Connector> connectors_;  // one for each of them
  std::uint64_t seed_;
  std::uint64_t beginnings_ = 0;
  std::optional<Route> route_;
  double time_;
  std::optional<Shortener> shortener_;
  std::vector<Route> challengers_;  // that may get faster than the route, the best one last
  bool is_challenger_ = false;      // whom the shortener has
  int trials_ = 0;                  // spent on it
};

}  // namespace vandplan::anytime
