// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a path get cheaper without leaving its surroundings?

#include <functional>
#include <optional>
#include <vector>

#include "search/route.h"
#include "vandplan/random.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

using namespace search;

/// Relative excess of a route or drive over the best one, times its trials, above which it is
/// hopeless: what trials gain falls about as one over their number (docs/algorithms/anytime.md).
inline constexpr double hopeless = 8.0;
/// A route may cost so many times the best one, as shortening helps.
inline constexpr double worth_shortening = 1.1;
/// Where a measure compares routes, prices are only a guide: one that costs so many times as much
/// may still be better.
inline constexpr double guide_leeway = 1.3;

/// Improves one route by random trials; a trial is kept only if it is free and cheaper. Of a long
/// route trials change some legs, the window, and then the next ones. So a trial costs as much
/// however long the route is.
class Shortener {
 public:
  /// `beside`: what is driven before and after the route, if it is a part of another one. With a
  /// `measure` routes are compared by it, and the prices of the connector are only a guide. The
  /// window is the whole route then, and the cost of the route is that of the measure.
  Shortener(Connector& connector, Route route, std::uint64_t seed,
            std::function<double(const Route&)> measure = {},
            std::optional<DrivenBeside> beside = {});

  /// One trial. True when the route got cheaper.
  bool step();

  [[nodiscard]] Route route() const;
  [[nodiscard]] double cost() const { return route_.cost; }
  /// Number of trials that bring about as much as one trial on a short route.
  [[nodiscard]] double trials_for_one() const;
  /// Whether many trials in a row brought nothing.
  [[nodiscard]] bool is_stalled() const;

 private:
  /// Place on the route: `s` metres into a leg.
  struct Place {
    std::size_t leg;
    double s;
  };

  /// Legs [first, last) of the route, the gears around them, and the cost that a trial must
  /// undercut.
  struct Stretch {
    std::size_t first;
    std::size_t last;
    DrivenBeside beside;
    double cost;
  };

  /// Number of legs that trials may change.
  [[nodiscard]] std::size_t legs_in_window() const { return last_ - first_; }
  [[nodiscard]] bool is_whole() const { return legs_in_window() == route_.legs.size(); }
  void move_window();
  void next_window();
  [[nodiscard]] std::size_t random_via();
  [[nodiscard]] Place random_place();
  [[nodiscard]] LocalPose pose_at(const Place& place) const;
  [[nodiscard]] LocalPose perturbed(const LocalPose& pose);
  bool shortcut();
  bool drop_via();
  bool move_via();
  bool move_place();
  [[nodiscard]] double cost_of_legs(std::span<const Leg> legs, const DrivenBeside& beside) const;
  [[nodiscard]] Stretch stretch(std::size_t first, std::size_t last) const;
  bool replace_by_way_of(const LocalPose& via, const Stretch& old, GearSign cusp);
  [[nodiscard]] bool stays_cheaper(LocalPose from, double gain);
  bool replace(const Stretch& old, std::span<const Leg> fresh);

  Connector& connector_;
  std::function<double(const Route&)> measure_;
  Route route_;
  DrivenBeside beside_;  // driven before and after the route
  /// Trials may change the legs [first_, last_), the window.
  std::size_t first_ = 0, last_;
  bool goes_back_ = false;  // whether windows move from the goal to the start
  int idle_visit_ = 0;      // trials in this window since the last gain
  Rng rng_;
  std::vector<Leg> trial_;  // legs of the trial
  int idle_ = 0;            // trials since the last gain
};

}  // namespace vandplan::anytime
