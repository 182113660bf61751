// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "steering/continuous/mirrored_task.h"
#include "steering/continuous/word_search.h"
#include "steering/word.h"

namespace vandplan::steering::continuous {
namespace {

/// Whether the circles of the Reeds-Shepp word of a formula meet, so that the word exists.
bool exists_without_clothoids(Formula formula, const WordFrame& f) {
  static const Joints joints(SharpTurns(1e9), {true, true, true});
  if (formula != Formula::lrl) return circle_word_of(formula, f, joints).exists;
  const double x = f.x - 2 * f.s;
  return x * x + f.y * f.y <= 16;
}

/// Prices of a word of one formula under one symmetry.
struct Pricing {
  double ahead, back;  ///< prices of a radius that the formula drives forward, and in reverse
  double cheapest;     ///< least price of a radius in the gears that the formula drives
  double changes;      ///< cost of all gear changes, those at both ends included

  /// Cost of the word with these arcs; negative ones count as 0.
  [[nodiscard]] double of(const Steps& steps, const Arcs& arcs) const {
    const double parts[] = {arcs.first, arcs.inner, arcs.line, arcs.last};
    double sum = changes;
    for (std::size_t i = 0; i < steps.count; ++i) {
      const Step& step = steps.list[i];
      sum += (step.gear > 0 ? ahead : back) * std::max(0.0, parts[step.part]);
    }
    return sum;
  }
};

/// Prices of a word; nothing if it begins or ends in a gear that the task forbids.
std::optional<Pricing> priced(const PricedTask& task, const GearPrices& prices, const Steps& steps,
                              const Symmetry& onto_task) {
  const int sign = onto_task.swaps_gears() ? -1 : 1;
  const auto gear_of = [&](std::size_t i) { return steps.list[i].gear > 0 ? sign : -sign; };
  const std::size_t last = steps.count - 1;
  const int begin = gear_of(onto_task.swaps_ends() ? last : 0);
  const int end = gear_of(onto_task.swaps_ends() ? 0 : last);
  if (task.first_gear * begin < 0 || task.last_gear * end < 0) return std::nullopt;
  int changes = gear_changes_of(steps);
  const bool goes_back = changes > 0;  // true for all formulas with a gear change, and no other
  changes += task.before * begin < 0 ? 1 : 0;
  changes += task.after * end < 0 ? 1 : 0;
  const double ahead = sign > 0 ? prices.forward : prices.reverse;
  const double back = sign > 0 ? prices.reverse : prices.forward;
  return Pricing{ahead, back, goes_back ? std::min(ahead, back) : ahead,
                 changes * prices.gear_change};
}

/// Lengths of the parts of a solved word.
Arcs arcs_of(const SolvedWord& word) {
  const bool has_line = shape_of(word.formula, word.stops).has_line;
  const auto& [first, middle, last] = word.lengths;
  return {word.length, first, has_line ? word.quarter : middle, has_line ? middle : 0, last};
}

/// Bounds of a task that do not depend on a word.
struct TaskBounds {
  double reeds_shepp;  ///< length of the Reeds-Shepp path; no path is shorter [turning radii]
  double max_saving;   ///< largest amount by which a word costs more than its path
  double line;         ///< length of the straight line if that is the path, otherwise 0
};

bool is_that_line(const SolvedWord& word, const TaskBounds& bounds) {
  return bounds.line > 0.0 && word.length <= bounds.line * (1 + 1e-9);
}

/// A task under a symmetry of its folded frame.
struct MirroredTask {
  std::size_t task;    ///< index of the task
  Symmetry onto_task;  ///< symmetry that maps words in `frame` onto the task
  WordFrame frame;
};

/// A word in closed form, or one that Newton's method has to find.
struct PricedWord {
  MirroredTask mirrored;
  Pricing pricing;
  double bound;  ///< bound of the path's cost: exact if the word is known, otherwise practical
  Formula formula;
  std::optional<SolvedWord> known;  ///< the word, if it has a closed form
  Arcs reeds_shepp, circles;        ///< guesses for Newton's method
  bool has_circles;
};

/// Words of some tasks whose paths may cost less than the cutoff.
class PricedWords {
 public:
  PricedWords(const WordSolver& solver, std::span<const PricedTask> tasks, const GearPrices& prices,
              int gear_changes, double cutoff)
      : solver_(solver), tasks_(tasks), prices_(prices), cutoff_(cutoff) {
    for (std::size_t i = 0; i < tasks.size(); ++i) add_words_of(i, gear_changes);
  }

  void take_all(const TakeWord& take) {
    while (!words_.empty()) {
      const auto next = std::min_element(
          words_.begin(), words_.end(),
          [](const PricedWord& a, const PricedWord& b) { return a.bound < b.bound; });
      if (next->bound >= cutoff_) return;
      const auto word = next->known ? next->known : solved(*next);
      const auto& [task, onto_task, frame] = next->mirrored;
      if (word) cutoff_ = std::min(cutoff_, take(task, {*word, onto_task}));
      *next = words_.back();
      words_.pop_back();
    }
  }

 private:
  void add_words_of(std::size_t i, int gear_changes) {
    const WordTask& task = tasks_[i].task;
    // A word may drive the windings back, so that its path is shorter by their length.
    const double max_saving = task.windings.length() * std::max(prices_.forward, prices_.reverse);
    const bool is_straight = gear_changes == 0 && is_straight_ahead(folded(task.frame));
    const double line = is_straight ? task.folded.x : 0.0;
    bounds_.push_back({task.reeds_shepp.arcs.length, max_saving, line});
    if (line > 0.0) {
      const MirroredTask unmirrored{i, unfolding(task.frame), task.folded};
      const auto pricing = pricing_of(unmirrored, Formula::lsl);
      const Stops stops = stops_of(unmirrored);
      if (pricing) add_known(unmirrored, *pricing, {Formula::lsl, stops, {0, line, 0}, 0, line});
    }
    for_each_candidate(task, gear_changes,
                       [&](Formula formula, const WordFrame& frame, const Symmetry& onto_task) {
                         const MirroredTask mirrored{i, onto_task, frame};
                         const auto pricing = pricing_of(mirrored, formula);
                         if (pricing) add_word(formula, mirrored, *pricing);
                       });
  }

  [[nodiscard]] Stops stops_of(const MirroredTask& task) const {
    return mirrored(tasks_[task.task].task.stops, task.onto_task);
  }

  /// Prices of a word; nothing if its path must cost at least the cutoff.
  [[nodiscard]] std::optional<Pricing> pricing_of(const MirroredTask& task, Formula formula) const {
    const auto pricing = priced(tasks_[task.task], prices_, steps_of(formula), task.onto_task);
    const double length = bounds_[task.task].reeds_shepp;
    return pricing && !is_too_dear(*pricing, length, task) ? pricing : std::nullopt;
  }

  [[nodiscard]] bool is_too_dear(const Pricing& pricing, double length,
                                 const MirroredTask& task) const {
    const double bound = pricing.changes + pricing.cheapest * length;
    return bound - bounds_[task.task].max_saving >= cutoff_;
  }

  void add_word(Formula formula, const MirroredTask& task, const Pricing& pricing) {
    const WordFrame& f = task.frame;
    const Stops stops = stops_of(task);
    const SharpTurns& turns = solver_.turns();
    const CircleWord circles = circle_word_of(formula, f, Joints(turns, stops));
    if (is_too_dear(pricing, circles.line, task)) return;
    Arcs met{};
    if (circles.exists) {
      met = in_one_turn(circles.arcs());
      if (const auto known = solver_.at_full_lock(formula, stops, met)) {
        if (!is_that_line(*known, bounds_[task.task])) add_known(task, pricing, *known);
        return;
      }
      // With a smaller angle by its circles, a turn does not exist.
      const double min_angle = -turns.ramp();
      if (met.first < min_angle || met.last < min_angle || met.line < 2 * min_angle) return;
    } else if (!exists_without_clothoids(formula, f)) {
      return;
    }
    Arcs arcs = in_one_turn(arcs_of(formula, Circles({f.x, f.y, f.a}, {f.s, f.c})));
    const double bound = pricing.of(steps_of(formula), arcs) - bounds_[task.task].max_saving;
    if (bound >= cutoff_) return;
    arcs.line -= 2 * turns.centre().x;
    const bool has_circles = circles.exists && is_leg(stops);
    words_.push_back({task, pricing, bound, formula, {}, arcs, met, has_circles});
  }

  void add_known(const MirroredTask& task, const Pricing& pricing, const SolvedWord& known) {
    const double bound =
        pricing.of(steps_of(known.formula), arcs_of(known)) - bounds_[task.task].max_saving;
    if (bound >= cutoff_) return;
    words_.push_back({task, pricing, bound, known.formula, known, {}, {}, false});
  }

  [[nodiscard]] std::optional<SolvedWord> solved(const PricedWord& word) const {
    const TaskBounds& bounds = bounds_[word.mirrored.task];
    const double left = cutoff_ + bounds.max_saving - word.pricing.changes;
    const NewtonLimits quick{12, 4, left / word.pricing.cheapest};
    const Stops stops = stops_of(word.mirrored);
    auto found = solver_.solve(word.formula, stops, word.mirrored.frame, word.reeds_shepp, quick);
    if (!found && word.has_circles) {
      found = solver_.solve(word.formula, stops, word.mirrored.frame, word.circles, quick);
    }
    return found && is_that_line(*found, bounds) ? std::nullopt : found;
  }

  const WordSolver& solver_;
  std::span<const PricedTask> tasks_;
  GearPrices prices_;
  double cutoff_;
  std::vector<TaskBounds> bounds_;  ///< one for each task
  std::vector<PricedWord> words_;
};

}  // namespace

void for_priced_words(const WordSolver& solver, std::span<const PricedTask> tasks,
                      const GearPrices& prices, int gear_changes, double cutoff,
                      const TakeWord& take) {
  PricedWords(solver, tasks, prices, gear_changes, cutoff).take_all(take);
}

}  // namespace vandplan::steering::continuous
