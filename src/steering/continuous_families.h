// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words of continuous steering lead from one pose to another?

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "steering/continuous_word.h"
#include "steering/mean_frame.h"

namespace vandplan::steering {

/// A word, and the symmetry of the mean frame that maps it onto the task.
struct FoundWord {
  SolvedWord word;
  Symmetry symmetry{};
};

/// A clothoid that straightens the wheels before a word, or turns them after it. A word that begins
/// (ends) by driving the clothoid back saves both.
struct Winding {
  double gear = 1.0;    ///< gear in which a word drives the clothoid back: 1 or -1
  double side = 0.0;    ///< side of its curvature: 1 left, -1 right
  double length = 0.0;  ///< length [turning radii]; 0: there is no winding
};

struct Windings {
  Winding start, goal;

  [[nodiscard]] double length() const { return start.length + goal.length; }
};

/// Two poses to join by a word, and the windings before and after it.
struct WordTask {
  WordTask() = default;
  WordTask(const MeanFrame& between, const Windings& around, const Stops& at) noexcept;
  /// `half`: sine and cosine of the absolute half turn of `between`.
  WordTask(const MeanFrame& between, const Windings& around, const Stops& at,
           const base::SinCos& half) noexcept;

  MeanFrame frame;
  Windings windings;
  Stops stops;
  WordFrame folded{};                      ///< `frame` with positive signs
  reeds_shepp_formulas::Solution sharp{};  ///< the Reeds-Shepp word in `folded`
};

/// Length that a word in the frame of its task saves by driving windings back [turning radii].
[[nodiscard]] double saved(const WordSolver& solver, const FoundWord& found,
                           const Windings& windings) noexcept;

/// Every word of the families, at most one of each formula and symmetry.
[[nodiscard]] std::vector<FoundWord> all_words(const WordSolver& solver, const WordTask& task);

/// The shortest word of several tasks.
struct LeastWord {
  std::size_t task = 0;  ///< index of its task
  FoundWord found;
  double length = 0.0;  ///< length of both windings and the word, less what the word saves
};

/// Words that the search for the shortest one considers: likely ones, or many more. Many are needed
/// where poses are so near to each other that the Reeds-Shepp word tells little.
enum class Looked { likely, many };

/// The shortest word below `cutoff`, if there is one, for at most four tasks with the same stops.
[[nodiscard]] std::optional<LeastWord> least_word(const WordSolver& solver,
                                                  std::span<const WordTask> tasks, double cutoff,
                                                  Looked looked);

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
void for_cheap_words(const WordSolver& solver, std::span<const PricedTask> tasks,
                     const GearPrices& prices, int gear_changes, double cutoff,
                     const TakeWord& take);

}  // namespace vandplan::steering
