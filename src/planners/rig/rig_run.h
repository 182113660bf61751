// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a tractor with a trailer get to its goal, in one run with one kind of wheels?
//
// Method: docs/algorithms/trailers.md.

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "planners/commands/shorten_drive.h"
#include "planners/pricing.h"
#include "planners/rig/rig_search.h"
#include "search/enclosure.h"
#include "vandplan/planner.h"
#include "vandplan/search.h"

namespace vandplan::rig {

/// One run: its searches, and its best drive so far.
class Run {
 public:
  /// Task, options and pricing outlive the run.
  Run(const Task& task, const PlanOptions& options, const planning::Pricing& pricing);

  /// If the goal is far away, follows a path of the tractor first.
  void begin();
  /// One round of searches, following and shortening. False when the run is over.
  bool search();
  /// Whether it is proven that the tractor or the trailer cannot get from the start to the goal.
  [[nodiscard]] bool is_walled_in() const { return tractor_.is_proven() || trailer_.is_proven(); }
  [[nodiscard]] PlannerAnswer answer();
  [[nodiscard]] bool is_over() { return budget_.exhausted() || is_walled_in() || is_good_enough(); }
  [[nodiscard]] bool has_drive() const { return best_.has_value(); }
  [[nodiscard]] std::int64_t iterations() const { return budget_.iterations(); }
  /// Time until the limit [s]; 0 without one.
  [[nodiscard]] double time_left() const;
  /// Takes over the work of a run for a stricter task, and its best drive if that is cheaper.
  void take_from(const Run& stricter, std::int64_t iterations);

 private:
  static constexpr int first_share = 128, most_share = 1 << 14;
  static constexpr std::size_t searches = 7;
  /// Slot of one kind of search.
  struct Search {
    std::optional<RigSearch> now;
    int rounds = 0;
    std::size_t task = 0;       // index of the task whose wheels the search has
    bool is_of_prices = false;  // whether the search has the prices in force
    bool is_bare = false;       // whether the search ignores the margin
  };

  void look_for_walls();
  void begin(Search& search);
  void end(Search& search);
  [[nodiscard]] double cutoff() const;
  void turn(Search& search, int expansions);
  void follow_tractor(std::int64_t work);
  void polish();
  void shorten(commands::DriveShortener& drive, std::size_t task);
  void take(std::vector<Segment> commands, std::size_t with);
  void widen(const std::vector<Segment>& commands);
  void keep(const commands::DriveShortener& drive, std::size_t task);
  void note_cost();
  [[nodiscard]] commands::DriveShortener::Measure measure() const;
  [[nodiscard]] bool is_good_enough() const;

  const Task& task_;
  const std::deque<Task> tasks_;  // the task, and copies with slower wheels if time counts
  const PlanOptions& options_;
  const planning::Pricing& pricing_;
  double min_stroke_;  // least stroke that is asked for [m]
  search::Budget budget_;
  /// Prices of searches: in force, a driver's, in force, and with hardly any reverse.
  std::array<search::CostRule, 4> rules_;
  double unit_;               // unit of the steps of a search [m]
  std::optional<Task> bare_;  // the task without its margin
  Guides guides_;
  std::array<Search, searches> searches_;
  int share_ = first_share;  // expansions of a search in a round, which grow
  int follows_ = 0;          // paths of the tractor that were followed
  Task towed_;
  search::Enclosure tractor_{task_}, trailer_{towed_};
  double bound_;                              // lower bound of the cost [m or s]
  double least_;                              // lower bound of the cost with exact ends [m or s]
  std::optional<std::vector<Segment>> best_;  // segments of the best drive
  std::vector<Segment> best_commands_;        // commands of the best drive
  std::size_t best_with_ = 0;      // index of the task whose wheels obey the best commands
  std::vector<Segment> roomiest_;  // drive without the margin, while there is none with it
  double lack_ = 0.0;              // cost of `roomiest_` by `rule_of_room`
  double best_cost_ = 0.0;         // cost of the best drive
  double best_wanted_ = 0.0;       // cost of the best drive with a price for short strokes
  std::vector<CostSample> trace_;
  std::int64_t nodes_ = 0, checks_ = 0, closings_ = 0, bridges_ = 0, trials_ = 0;
  std::uint64_t shortened_ = 0;  // drives shortened so far; numbers their seeds
};

}  // namespace vandplan::rig
