// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words lead from one pose to another: all, the shortest, or those of least price?

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "steering/continuous/word_task.h"

namespace vandplan::steering::continuous {

/// Every word, at most one of each formula and symmetry.
[[nodiscard]] std::vector<FoundWord> all_words(const WordSolver& solver, const WordTask& task);

/// The shortest word of several tasks.
struct ShortestWord {
  std::size_t task = 0;  ///< index of its task
  FoundWord found;
  double length = 0.0;  ///< length of both windings and the word, less what the word saves
};

/// Words that the search for the shortest one considers: likely ones, or many more. Many are needed
/// where poses are so near to each other that the Reeds-Shepp word tells little.
enum class SearchBreadth { likely, many };

/// The shortest word below `cutoff`, if there is one, for at most four tasks with the same stops.
[[nodiscard]] std::optional<ShortestWord> shortest_word(const WordSolver& solver,
                                                        std::span<const WordTask> tasks,
                                                        double cutoff, SearchBreadth breadth);

/// Prices of driving a word.
struct GearPrices {
  double forward = 1.0;      ///< price of a radius driven forward; > 0
  double reverse = 1.0;      ///< price of a radius driven in reverse; > 0
  double gear_change = 0.0;  ///< price of a gear change [turning radii]; >= 0
};

/// A task for words under prices.
struct PricedTask {
  WordTask task;
  int first_gear = 0, last_gear = 0;  ///< gears in which the word begins and ends; 0: any
  int before = 0, after = 0;          ///< gears driven before and after the word; 0: any
};

/// Receives a word and the index of its task; returns the cost that later words have to undercut.
using TakeWord = std::function<double(std::size_t task, const FoundWord&)>;

/// Calls `take` with words of the formulas that have `gear_changes` gear changes (0 to 2). Words
/// come in the order of a bound of their cost, and have to undercut `cutoff` and all that `take`
/// returned. If all turns reach full lock, the word has a closed form and the bound is exact.
/// Otherwise Newton's method finds the word, and the bound is the cost of the Reeds-Shepp word of
/// the same letters.
void for_priced_words(const WordSolver& solver, std::span<const PricedTask> tasks,
                      const GearPrices& prices, int gear_changes, double cutoff,
                      const TakeWord& take);

}  // namespace vandplan::steering::continuous
