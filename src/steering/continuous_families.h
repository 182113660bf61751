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

/// A word as a symmetry of the mean frame makes it.
struct FoundWord {
  SolvedWord word;
  Symmetry symmetry{};
};

/// A clothoid on which the wheels were straightened before a word, or are turned after it. A word
/// that begins (ends) by driving the same way back saves both.
struct Winding {
  double gear = 1.0;    ///< in which the word drives it back
  double side = 0.0;    ///< to which its curvature is
  double length = 0.0;  ///< 0: there is none
};

struct Windings {
  Winding start, goal;

  [[nodiscard]] double length() const { return start.length + goal.length; }
};

/// Two poses and what is driven before and after.
struct WordTask {
  WordTask() = default;
  WordTask(const MeanFrame& between, const Windings& around, const Stops& at) noexcept;
  /// With the sine and cosine of half the turn to the left.
  WordTask(const MeanFrame& between, const Windings& around, const Stops& at,
           const base::SinCos& half) noexcept;

  MeanFrame frame;
  Windings windings;
  Stops stops;
  WordFrame folded{};                      ///< the frame with positive signs
  reeds_shepp_formulas::Solution sharp{};  ///< the shortest word if the wheels took no time
};

/// How much shorter a word in the frame of its task is for what it drives back.
[[nodiscard]] double saved(const WordSolver& solver, const FoundWord& found,
                           const Windings& windings) noexcept;

/// Every word of the families, at most one of each formula and symmetry.
[[nodiscard]] std::vector<FoundWord> all_words(const WordSolver& solver, const WordTask& task);

/// The least word of several tasks.
struct LeastWord {
  std::size_t task = 0;  ///< which of them it is for
  FoundWord found;
  double length = 0.0;  ///< of both windings and the word, less what it saves
};

/// Which words are looked at for the least one: those that are likely to be it, or many more where
/// poses are so near to each other that the word of Reeds and Shepp tells little.
enum class Looked { likely, many };

/// The least of all words for at most four tasks of the same stops, if one is below `cutoff`.
[[nodiscard]] std::optional<LeastWord> least_word(const WordSolver& solver,
                                                  std::span<const WordTask> tasks, double cutoff,
                                                  Looked looked);

/// What driving a word costs, in turning radii.
struct GearPrices {
  double forward = 1.0;      ///< of one driven forward; > 0
  double reverse = 1.0;      ///< in reverse; > 0
  double gear_change = 0.0;  ///< >= 0
};

/// A task, the gear of a word at either end of it, and the gears driven before and after; 0: any.
struct PricedTask {
  WordTask task;
  int first_gear = 0, last_gear = 0;
  int before = 0, after = 0;
};

/// Takes the word of a task and says what the next ones have to undercut.
using TakeWord = std::function<double(std::size_t task, const FoundWord&)>;

/// Calls `take` with the words of formulas with so many gear changes (0 to 2) that may cost less
/// than `cutoff` and then what `take` says, those first that cost least by the arcs of Reeds and
/// Shepp: with turns that reach full lock in closed form, others by Newton's method.
void for_cheap_words(const WordSolver& solver, std::span<const PricedTask> tasks,
                     const GearPrices& prices, int gear_changes, double cutoff,
                     const TakeWord& take);

}  // namespace vandplan::steering
