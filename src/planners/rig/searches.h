// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which searches look for drives of a rig?
//
// Method: docs/algorithms/trailers.md.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "planners/rig/chain_source.h"

namespace vandplan::rig {

/// Settings of a line of searches, for ways that are open, narrow or full of turns.
struct LineSettings {
  double step;              ///< step of the first search [units of a search]
  double weight;            ///< weight of the cost-to-go in the first search
  int levels;               ///< levels of finer steps where there is little room
  std::int64_t share;       ///< expansions in a turn
  std::size_t first_price;  ///< index of the prices until one of the lines has found a drive
  std::size_t first_turn;   ///< index of the first prices and wheels after that
  bool is_forward = false;  ///< whether the searches drive forward alone, if both gears are allowed
};

/// Lines of searches that take turns. In each line, one search follows another with smaller steps,
/// other prices and, if time counts, other wheels.
class Searches final : public ChainSource {
 public:
  /// `tasks`: tasks that the searches of a line have in turn, with the wheels 0, 1, ...
  Searches(std::shared_ptr<const Setting> setting, std::span<const LineSettings> kinds,
           std::vector<const Task*> tasks);

  [[nodiscard]] anytime::Found work(std::int64_t most, const search::Budget& budget) override;
  void hear(const anytime::Drive& best) override;
  [[nodiscard]] anytime::Counts counts() const override;

 private:
  /// One line: its search at hand, and how many there have been.
  struct Line {
    LineSettings kind;
    std::optional<RigSearch> search = {};
    std::size_t round = 0;
    std::size_t task = 0;              // index of the task that the search has
    bool has_prices_in_force = false;  // whether the search has the prices in force
  };

  void begin(Line& line);
  void end(Line& line);

  std::shared_ptr<const Setting> setting_;
  std::array<search::CostRule, 2> rules_;          // prices in force, helpful ones
  std::array<search::CostRule, 2> forward_rules_;  // the same, driving forward alone
  std::vector<const Task*> tasks_;
  std::vector<Line> lines_;
  std::size_t turn_ = 0;    // index of the line whose turn it is
  std::int64_t done_ = 0;   // expansions in this turn
  bool has_found_ = false;  // whether one of the lines has found a drive
  double cutoff_ = std::numeric_limits<double>::infinity();
  anytime::Counts former_;  // counts of searches that have ended
};

/// [2] Searches that ignore the margin, before there is a drive. Each drive that they find is moved
/// away from obstacles, until it keeps the margin.
class BareSearches final : public ChainSource {
 public:
  /// The setting has a margin.
  BareSearches(std::shared_ptr<const Setting> setting, std::uint64_t seed);

  [[nodiscard]] anytime::Found work(std::int64_t most, const search::Budget& budget) override;
  void hear(const anytime::Drive&) override { has_drive_ = true; }
  [[nodiscard]] bool has_work() const override { return !has_drive_; }
  [[nodiscard]] anytime::Counts counts() const override;

 private:
  void begin(std::span<const Command> commands);
  [[nodiscard]] std::optional<anytime::Drive> widen();

  std::shared_ptr<const Setting> setting_;
  Searches searches_;
  search::CostRule rule_;  // cost: how far a drive is nearer to obstacles than the margin
  std::uint64_t seed_;
  std::uint64_t begun_ = 0;
  std::optional<commands::DriveShortener> widened_;  // the drive that is moved away
  std::vector<Command> roomiest_;                    // drive that came nearest to the margin
  double lack_ = 0.0;                                // cost of `roomiest_`
  std::int64_t searched_ = 0;                        // expansions since a drive was moved last
  bool has_drive_ = false;
  std::int64_t checks_ = 0;
};

}  // namespace vandplan::rig
