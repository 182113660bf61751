// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <optional>
#include <vector>

#include "steering/continuous_families.h"
#include "steering/continuous_kinds.h"

namespace vandplan::steering {
namespace {

using namespace families;

/// Whether the circles of the Reeds-Shepp word of a kind meet, so that the word exists.
bool exists_sharp(const Kind& kind, const WordFrame& f) {
  static const Joints joints(SharpTurns(1e9), {true, true, true});
  if (kind.formula != Formula::lrl) return circles::word_of(kind.formula, f, joints).exact;
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
                              const Symmetry& made) {
  const int sign = made.swaps_gears() ? -1 : 1;
  const auto gear_of = [&](std::size_t i) { return steps.list[i].gear > 0 ? sign : -sign; };
  const std::size_t last = steps.count - 1;
  const int begin = gear_of(made.swaps_ends() ? last : 0);
  const int end = gear_of(made.swaps_ends() ? 0 : last);
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
Arcs parts_of(const SolvedWord& word) {
  const bool has_line = shape_of(word.formula, word.stops).has_line;
  const auto& [first, middle, last] = word.lengths;
  return {word.length, first, has_line ? word.quarter : middle, has_line ? middle : 0, last};
}

/// Bounds of a task that do not depend on a word.
struct TaskBounds {
  double shortest;  ///< length of the Reeds-Shepp path; no path is shorter [turning radii]
  double spare;     ///< largest amount by which a word costs more than its path
  double line;      ///< length of the straight line if that is the path, otherwise 0
};

bool is_that_line(const SolvedWord& word, const TaskBounds& bounds) {
  return bounds.line > 0.0 && word.length <= bounds.line * (1 + 1e-9);
}

/// A task under a symmetry of its folded frame.
struct TaskImage {
  std::size_t task;  ///< index of the task
  Symmetry made;
  WordFrame frame;
};

/// A word in closed form, or one that Newton's method has to find.
struct CheapWord {
  TaskImage image;
  Pricing pricing;
  double bound;  ///< bound of the path's cost: exact if the word is known, otherwise practical
  Formula formula;
  std::optional<SolvedWord> known;  ///< the word, if it has a closed form
  Arcs sharp, circles;              ///< guesses for Newton's method
  bool has_circles;
};

/// Words of some tasks whose paths may cost less than the cutoff.
class CheapWords {
 public:
  CheapWords(const WordSolver& solver, std::span<const PricedTask> tasks, const GearPrices& prices,
             int gear_changes, double cutoff)
      : solver_(solver), tasks_(tasks), prices_(prices), cutoff_(cutoff) {
    for (std::size_t i = 0; i < tasks.size(); ++i) look_at(i, gear_changes);
  }

  void take_all(const TakeWord& take) {
    while (!words_.empty()) {
      const auto next = std::min_element(
          words_.begin(), words_.end(),
          [](const CheapWord& a, const CheapWord& b) { return a.bound < b.bound; });
      if (next->bound >= cutoff_) return;
      const auto word = next->known ? next->known : solved(*next);
      if (word) cutoff_ = std::min(cutoff_, take(next->image.task, {*word, next->image.made}));
      *next = words_.back();
      words_.pop_back();
    }
  }

 private:
  void look_at(std::size_t i, int gear_changes) {
    const WordTask& task = tasks_[i].task;
    const double shortest = task.sharp.arcs.length;
    // A word may drive the windings back, so that its path is shorter by their length.
    const double spare = task.windings.length() * std::max(prices_.forward, prices_.reverse);
    const bool is_straight = gear_changes == 0 && is_line(folded(task.frame));
    const double line = is_straight ? task.folded.x : 0.0;
    bounds_.push_back({shortest, spare, line});
    if (line > 0.0) {
      const TaskImage image{i, unfolding(task.frame), task.folded};
      const auto pricing = pricing_of(image, Formula::lsl);
      const Stops stops = seen_by(image.made, task.stops);
      if (pricing) add_known(image, *pricing, {Formula::lsl, stops, {0, line, 0}, 0, line});
    }
    for_each_image(task, gear_changes,
                   [&](const Kind& kind, const WordFrame& f, const Symmetry& made) {
                     const TaskImage image{i, made, f};
                     const auto pricing = pricing_of(image, kind.formula);
                     if (pricing) look_at(kind, image, *pricing);
                   });
  }

  /// Prices of a word; nothing if its path must cost at least the cutoff.
  [[nodiscard]] std::optional<Pricing> pricing_of(const TaskImage& image, Formula formula) const {
    const auto pricing = priced(tasks_[image.task], prices_, steps_of(formula), image.made);
    if (!pricing || is_too_dear(*pricing, bounds_[image.task].shortest, image)) return std::nullopt;
    return pricing;
  }

  [[nodiscard]] bool is_too_dear(const Pricing& pricing, double length,
                                 const TaskImage& image) const {
    const double least = pricing.changes + pricing.cheapest * length;
    return least - bounds_[image.task].spare >= cutoff_;
  }

  void look_at(const Kind& kind, const TaskImage& image, const Pricing& pricing) {
    const WordFrame& f = image.frame;
    const Stops stops = seen_by(image.made, tasks_[image.task].task.stops);
    const SharpTurns& turns = solver_.turns();
    const CircleWord circles = circles::word_of(kind.formula, f, Joints(turns, stops));
    if (is_too_dear(pricing, circles.line, image)) return;
    Arcs met{};
    if (circles.exact) {
      met = in_one_turn(circles.arcs());
      if (const auto known = solver_.at_full_lock(kind.formula, stops, met)) {
        if (!is_that_line(*known, bounds_[image.task])) add_known(image, pricing, *known);
        return;
      }
      // With a smaller angle by its circles, a turn does not exist.
      const double least = -turns.ramp();
      if (met.first < least || met.last < least || met.line < 2 * least) return;
    } else if (!exists_sharp(kind, f)) {
      return;
    }
    Arcs sharp = in_one_turn(kind.arcs(Circles({f.x, f.y, f.a}, {f.s, f.c})));
    const double bound = pricing.of(steps_of(kind.formula), sharp) - bounds_[image.task].spare;
    if (bound >= cutoff_) return;
    sharp.line -= 2 * turns.centre().x;
    const bool has_circles = circles.exact && is_leg(stops);
    words_.push_back({image, pricing, bound, kind.formula, {}, sharp, met, has_circles});
  }

  void add_known(const TaskImage& image, const Pricing& pricing, const SolvedWord& known) {
    const double bound =
        pricing.of(steps_of(known.formula), parts_of(known)) - bounds_[image.task].spare;
    if (bound >= cutoff_) return;
    words_.push_back({image, pricing, bound, known.formula, known, {}, {}, false});
  }

  [[nodiscard]] std::optional<SolvedWord> solved(const CheapWord& word) const {
    const TaskBounds& bounds = bounds_[word.image.task];
    const double left = cutoff_ + bounds.spare - word.pricing.changes;
    const Patience quick{12, 4, left / word.pricing.cheapest};
    const Stops stops = seen_by(word.image.made, tasks_[word.image.task].task.stops);
    auto found = solver_.solve(word.formula, stops, word.image.frame, word.sharp, quick);
    if (!found && word.has_circles) {
      found = solver_.solve(word.formula, stops, word.image.frame, word.circles, quick);
    }
    return found && is_that_line(*found, bounds) ? std::nullopt : found;
  }

  const WordSolver& solver_;
  std::span<const PricedTask> tasks_;
  GearPrices prices_;
  double cutoff_;
  std::vector<TaskBounds> bounds_;  ///< one for each task
  std::vector<CheapWord> words_;
};

}  // namespace

void for_cheap_words(const WordSolver& solver, std::span<const PricedTask> tasks,
                     const GearPrices& prices, int gear_changes, double cutoff,
                     const TakeWord& take) {
  CheapWords(solver, tasks, prices, gear_changes, cutoff).take_all(take);
}

}  // namespace vandplan::steering
