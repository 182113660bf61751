// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the anytime planner do side by side? Islands: lines of work that share nothing but the
// best route, which they are told between rounds.

#include <optional>
#include <vector>

#include "planners/anytime/adapt.h"
#include "planners/anytime/bend.h"
#include "planners/anytime/detours.h"
#include "planners/anytime/shorten.h"
#include "planners/anytime/sources.h"
#include "planners/anytime/survey.h"
#include "search/geodesic.h"
#include "search/pose_flood.h"

namespace vandplan::anytime {

/// What an island does.
enum class Work {
  refine,             ///< shorten the best route
  search_from_start,  ///< lattice searches
  search_from_goal,
  random_trees,
  bound,    ///< prove how short no path can be
  detours,  ///< look for other ways between two places of the best route
  bend,     ///< make routes cheaper by turning the wheels less
  survey,   ///< look everywhere for other kinds of way
  adapt,    ///< drive routes of wheels that turn at once
};

/// What an island did in one round.
struct Slice {
  std::int64_t iterations = 0;
  std::vector<CostSample> improvements;  // iterations count from the beginning of the slice
  std::optional<Route> route;            // the one of the last improvement,
  std::optional<BentDrive> drive;        // or what became of one
  std::vector<Route> losers;             // routes that were given up
};

/// One line of work. What it does depends on its seed and on what it is told, on nothing else.
class Island {
 public:
  Island(Work work, const Task& task, const CostRule& rule, const Bounds& region,
         std::uint64_t seed, bool keeps_losers = false);
  Island(const Island&) = delete;
  Island& operator=(const Island&) = delete;

  /// At most `iterations` of work; less if the budget is interrupted, nothing is left to do, or a
  /// route costs no more than `enough`. `best` is the best route of all islands, null while there
  /// is none.
  [[nodiscard]] Slice run(std::int64_t iterations, const Route* best, const Budget& budget,
                          double enough);

  /// Whether there is anything left to try.
  [[nodiscard]] bool has_work() const;

  /// A route that may be worth bending or, of the relaxed task, adapting: what this island does.
  void offer(const Route& route) {
    if (!is_prepared_) prepare();
    if (bender_) bender_->offer(route);
    if (adapter_) adapter_->offer(route);
  }
  /// What bending goes on from before the first round: a path that need not be free, nor begin and
  /// end quite where it should. Nothing if it cannot be driven.
  [[nodiscard]] std::optional<BentDrive> begin_with(const Path& known);

  /// What no path is shorter than, as far as it has been proven here [m].
  [[nodiscard]] double shortest() const { return geodesic_ ? geodesic_->bound() : 0.0; }
  /// The same of paths that begin and end just where they should.
  [[nodiscard]] double shortest_turning() const { return flood_ ? flood_->bound() : 0.0; }

  /// Raises the bound for vehicles, which have to turn. At most so many steps, which are no
  /// iterations.
  void raise(std::int64_t steps, const Budget& budget);
  /// Whether that may bring anything.
  [[nodiscard]] bool may_raise() const { return flood_ && !flood_is_final_; }

  /// Of a survey: whether it looks for its first way,
  [[nodiscard]] bool is_glance() const { return !survey_ || survey_->is_glance(); }
  /// or around for the first time.
  [[nodiscard]] bool is_first_look() const { return survey_ && survey_->is_first_look(); }

  [[nodiscard]] std::int64_t solves() const;
  [[nodiscard]] std::int64_t checks() const;
  /// Nodes of the search that is under way.
  [[nodiscard]] std::size_t nodes() const;

 private:
  void prepare();
  void take_over(const Route& best);
  bool step();
  std::optional<Route> search();
  [[nodiscard]] bool is_hopeless() const;
  [[nodiscard]] bool is_known(const Route& route) const;
  void give_up();

  const Task& task_;
  Bounds region_;
  Work work_;
  std::uint64_t seed_;
  bool keeps_losers_;  // for those who look at routes in another way
  Scope scope_;        // of shortening
  Connector connector_;
  double best_cost_;  // of the routes it knows of
  std::optional<Ladder> ladder_;
  std::optional<Attempts> attempts_;
  std::optional<Detours> detours_;
  std::optional<Survey> survey_;
  std::optional<Bender> bender_;
  std::optional<Adapter> adapter_;
  std::optional<Geodesic> geodesic_;
  std::optional<PoseFlood> flood_;
  bool is_prepared_ = false;
  bool bound_is_final_ = false;  // of the geodesic
  bool flood_is_final_ = false;
  std::optional<Shortener> candidate_;  // a route that may win yet
  Route raw_;                           // the candidate as it was found
  std::vector<Route> losers_;           // given up in this slice
  std::vector<Route> given_up_;         // the last ones, as they were found
  std::optional<Route> offer_;          // a route that has won
  std::int64_t trials_ = 0;             // spent on the candidate
  double handed_on_cost_;               // of the route that detours lead off or that is bent
  std::uint64_t candidates_ = 0;        // so far; each has a seed
};

}  // namespace vandplan::anytime
