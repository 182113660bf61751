// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous_families.h"

#include <algorithm>
#include <cmath>

#include "steering/continuous_kinds.h"

namespace vandplan::steering {
namespace {

using namespace families;

/// The arcs of Reeds and Shepp at `radius`, with the line that turns with clothoids leave.
Arcs sharp_arcs(const Kind& kind, const WordFrame& f, double radius, const SharpTurns& turns) {
  Arcs arcs = in_one_turn(kind.arcs(Circles({f.x / radius, f.y / radius, f.a})));
  arcs.line = arcs.line * radius - 2 * turns.centre().x;
  return arcs;
}

constexpr Patience patient{25};

/// The word with circles if every turn reaches full lock; else by Newton's method from these
/// circles, from circles without clothoids, or from circles of the radius that turns have which are
/// so small.
std::optional<SolvedWord> solved(const WordSolver& solver, const Kind& kind, const WordFrame& frame,
                                 const Stops& stops) {
  const SharpTurns& turns = solver.turns();
  const CircleWord circles = circles::word_of(kind.formula, frame, Joints(turns, stops));
  const Arcs found = in_one_turn(circles.arcs());
  if (circles.exact) {
    if (auto word = solver.at_full_lock(kind.formula, stops, found)) return word;
  }
  std::optional<SolvedWord> least = solver.solve(kind.formula, stops, frame, found, patient);
  const auto consider = [&](const Arcs& arcs) {
    const auto word = solver.solve(kind.formula, stops, frame, arcs, patient);
    if (word && (!least || word->length < least->length)) least = word;
  };
  Arcs arcs = sharp_arcs(kind, frame, 1, turns);
  consider(arcs);
  if (least) return least;
  for (int round = 0; round < 3; ++round) {
    const double radius = solver.radius_of(std::max({arcs.first, arcs.inner, arcs.last}));
    arcs = sharp_arcs(kind, frame, radius, turns);
  }
  consider(arcs);
  return least;
}

int gear_changes_of(const Steps& steps) {
  int changes = 0;
  for (std::size_t i = 1; i < steps.count; ++i) {
    changes += steps.list[i].gear != steps.list[i - 1].gear ? 1 : 0;
  }
  return changes;
}

/// Whether Reeds and Shepp have a word of that kind.
bool exists_sharp(const Kind& kind, const WordFrame& f) {
  static const Joints joints(SharpTurns(1e9), {true, true, true});
  if (kind.formula != Formula::lrl) return circles::word_of(kind.formula, f, joints).exact;
  const double x = f.x - 2 * f.s;
  return x * x + f.y * f.y <= 16;
}

/// The word in closed form, or by Newton's method if it may be shorter than `longest`.
std::optional<SolvedWord> wanted_word(const WordSolver& solver, const Kind& kind,
                                      const WordFrame& frame, const Stops& stops, double longest) {
  constexpr Patience quick{12};
  const CircleWord circles = circles::word_of(kind.formula, frame, Joints(solver.turns(), stops));
  if (circles.line >= longest) return std::nullopt;
  Arcs found;
  if (circles.exact) {
    found = in_one_turn(circles.arcs());
    if (auto word = solver.at_full_lock(kind.formula, stops, found)) return word;
    const double least = -solver.turns().ramp();  // shorter turns than that are none
    if (found.first < least || found.last < least || found.line < 2 * least) return std::nullopt;
  } else if (!exists_sharp(kind, frame)) {
    return std::nullopt;
  }
  Arcs sharp = in_one_turn(kind.arcs(Circles({frame.x, frame.y, frame.a})));
  if (driven_length(steps_of(kind.formula), sharp) >= longest) return std::nullopt;
  sharp.line -= 2 * solver.turns().centre().x;
  if (auto word = solver.solve(kind.formula, stops, frame, sharp, quick)) return word;
  if (!circles.exact || !is_leg(stops)) return std::nullopt;
  return solver.solve(kind.formula, stops, frame, found, quick);
}

/// Calls `visit` with the kinds that have so many gear changes, or with all, each in all its
/// symmetries.
template <typename Visit>
void for_each_image(const MeanFrame& task, int gear_changes, Visit visit) {
  const WordFrame frame = word_frame(folded(task));
  const Symmetry undo = unfolding(task);
  for (const Kind& kind : kinds) {
    if (gear_changes >= 0 && gear_changes_of(steps_of(kind.formula)) != gear_changes) continue;
    for (unsigned i = 0; i < 8; ++i) {
      const Symmetry symmetry{(i & 4U) != 0, (i & 2U) != 0, (i & 1U) != 0};
      const auto& [x, y, half_turn] = symmetry;
      if ((x && kind.own.x) || (y && kind.own.y) || (half_turn && kind.own.half_turn)) continue;
      visit(kind, image_of(frame, symmetry), both(undo, symmetry));
    }
  }
}

}  // namespace

double saved(const WordSolver& solver, const FoundWord& found, const Windings& windings) noexcept {
  constexpr double rounding = 1e-12;
  const auto saves = [&](bool at_start, const Winding& winding) {
    if (winding.length <= 0) return 0.0;
    const Steps& steps = steps_of(found.word.formula);
    const bool from_end = at_start == found.symmetry.swaps_ends();
    for (std::size_t i = 0; i < steps.count; ++i) {
      const std::size_t step = from_end ? steps.count - 1 - i : i;
      const double length = solver.step_length(found.word, step);
      if (length == 0) continue;
      // Something is left, or else the curvature jumps before the step and the vehicle rolls there.
      return may_drive_back(steps.list[step], found.symmetry, winding) &&
                     length > winding.length * (1 + rounding) + rounding / 10 &&
                     solver.ramp_of(found.word, step) * (1 + rounding) >= winding.length
                 ? 2 * winding.length
                 : 0.0;
    }
    return 0.0;
  };
  return saves(true, windings.start) + saves(false, windings.goal);
}

std::vector<FoundWord> all_words(const WordSolver& solver, const WordTask& task) {
  constexpr int any = -1;
  std::vector<FoundWord> words;
  for_each_image(task.frame, any,
                 [&](const Kind& kind, const WordFrame& image, const Symmetry& made) {
                   const auto word = solved(solver, kind, image, seen_by(made, task.stops));
                   if (word) words.push_back({*word, made});
                 });
  return words;
}

void for_each_wanted_word(const WordSolver& solver, const WordTask& task, const WantedWords& wanted,
                          const std::function<void(const FoundWord&)>& take) {
  const MeanFrame near = folded(task.frame);
  const bool is_straight = wanted.gear_changes == 0 && is_line(near);
  if (is_straight) {
    const Symmetry made = unfolding(task.frame);
    take({{Formula::lsl, seen_by(made, task.stops), {0, near.x, 0}, 0, near.x}, made});
  }
  const auto is_that_line = [&](const SolvedWord& w) {
    return is_straight && w.length <= near.x * (1 + 1e-9);
  };
  const auto is_wanted = [&](const Steps& steps, const Symmetry& made) {
    const double sign = made.swaps_gears() ? -1 : 1;
    const std::size_t last = steps.count - 1;
    const double begin = sign * steps.list[made.swaps_ends() ? last : 0].gear;
    const double end = sign * steps.list[made.swaps_ends() ? 0 : last].gear;
    return wanted.first_gear * begin >= 0 && wanted.last_gear * end >= 0;
  };
  const auto visit = [&](const Kind& kind, const WordFrame& image, const Symmetry& made) {
    if (!is_wanted(steps_of(kind.formula), made)) return;
    const Stops stops = seen_by(made, task.stops);
    const auto word = wanted_word(solver, kind, image, stops, wanted.longest);
    if (word && word->length < wanted.longest && !is_that_line(*word)) take({*word, made});
  };
  for_each_image(task.frame, wanted.gear_changes, visit);
}

}  // namespace vandplan::steering
