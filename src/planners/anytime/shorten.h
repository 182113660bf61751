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

/// What of a route is looked at at a time.
enum class Scope {
  all,      ///< the whole route
  windows,  ///< some legs, then the next ones: a trial costs as much however long the route is
};

/// Improves one route by random trials; a trial is kept only if it is free and cheaper.
class Shortener {
 public:
  /// `beside` is what is driven before the route and after it, if that is known: of a part of a
  /// route. With a `measure` a route is cheaper when that says so; the prices of the connector are
  /// a guide only, the scope is all, and the route comes with the cost that the measure gives it.
  Shortener(Connector& connector, Route route, std::uint64_t seed, Scope scope = Scope::all,
            std::function<double(const Route&)> measure = {}, std::optional<Gears> beside = {});

  /// One trial. True when the route got cheaper.
  bool step();

  [[nodiscard]] Route route() const;
  [[nodiscard]] double cost() const { return is_whole() ? route_.cost : cost_; }
  /// How many trials bring about as much as one on a short route.
  [[nodiscard]] double trials_for_one() const;
  /// Whether many trials in a row brought next to nothing.
  [[nodiscard]] bool is_stalled() const;

 private:
  // A place on the route: `s` metres into a leg.
  struct Place {
    std::size_t leg;
    double s;
  };

  // Legs of the route, the gears around them, and what they cost.
  struct Stretch {
    std::size_t first;
    std::size_t last;  // the one after them
    Gears gears;
    double cost;
  };

  [[nodiscard]] bool is_whole() const { return passed_.empty() && ahead_.empty(); }
  [[nodiscard]] std::size_t count_of_legs() const {
    return passed_.size() + route_.legs.size() + ahead_.size();
  }
  [[nodiscard]] Gears gears_beside(std::size_t first, std::size_t last) const;
  void move_window();
  void next_window();
  [[nodiscard]] Place random_place();
  [[nodiscard]] LocalPose pose_at(const Place& place) const;
  [[nodiscard]] LocalPose perturbed(const LocalPose& pose);
  bool shortcut();
  bool drop_via();
  bool move_via();
  bool move_place();
  [[nodiscard]] double cost_of_legs(std::span<const Leg> legs, const Gears& gears) const;
  [[nodiscard]] Stretch stretch(std::size_t first, std::size_t last) const;
  bool replace_by_way_of(const LocalPose& via, const Stretch& old, GearSign cusp);
  [[nodiscard]] bool stays_cheaper(LocalPose from, double gain);
  bool replace(const Stretch& old, std::span<const Leg> fresh);
  /// Puts the trial in the place of the stretch.
  void exchange(Route& route, const Stretch& old) const;

  Connector& connector_;
  std::function<double(const Route&)> measure_;
  Route route_;      // or the window of it
  LocalPose start_;  // of the whole route
  Gears beside_;     // what is driven before and after it
  // The legs before the window, and those after it, the last one first.
  std::vector<Leg> passed_;
  std::vector<Leg> ahead_;
  bool goes_back_ = false;  // from window to window
  double cost_;             // of the whole route
  double visit_cost_;       // of it when a trial in this window last brought something
  int visit_ = 0;           // trials in this window,
  int idle_visit_ = 0;      // and since one last brought something
  Rng rng_;
  std::vector<Leg> trial_;  // buffer
  int idle_ = 0;            // trials since the last progress worth the name
  double progress_cost_;    // what the route cost then
};

}  // namespace vandplan::anytime
