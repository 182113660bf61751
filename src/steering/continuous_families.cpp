// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous_families.h"

#include <algorithm>
#include <cmath>

#include "steering/continuous_kinds.h"

namespace vandplan::steering {
namespace {

using namespace families;

/// Arcs of the Reeds-Shepp word at `radius`; the line is shorter by what two clothoids take of it.
Arcs sharp_arcs(const Kind& kind, const WordFrame& f, double radius, const SharpTurns& turns) {
  Arcs arcs = in_one_turn(kind.arcs(Circles({f.x / radius, f.y / radius, f.a})));
  arcs.line = arcs.line * radius - 2 * turns.centre().x;
  return arcs;
}

constexpr Patience patient{25};

/// The word of a kind: in closed form if every turn reaches full lock, otherwise by Newton's
/// method. Guesses are the circles at full lock and those without clothoids. If both fail, the
/// guess is circles with the radius of such small turns.
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

}  // namespace

WordTask::WordTask(const MeanFrame& between, const Windings& around, const Stops& at) noexcept
    : WordTask(between, around, at, base::sin_cos(std::abs(between.half_turn))) {}

WordTask::WordTask(const MeanFrame& between, const Windings& around, const Stops& at,
                   const base::SinCos& half) noexcept
    : frame(between), windings(around), stops(at) {
  const MeanFrame positive = families::folded(between);
  folded = {positive.x, positive.y, positive.half_turn, half.sin, half.cos};
  const auto& [x, y, a, s, c] = folded;
  sharp = reeds_shepp_formulas::shortest(Circles({x, y, a}, {s, c}));
}

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
      // The step must be longer than the winding: without a rest the curvature would jump there
      // while the vehicle rolls.
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
  std::vector<FoundWord> words;
  for_each_image(task, any_gear_changes,
                 [&](const Kind& kind, const WordFrame& image, const Symmetry& made) {
                   const auto word = solved(solver, kind, image, seen_by(made, task.stops));
                   if (word) words.push_back({*word, made});
                 });
  return words;
}

}  // namespace vandplan::steering
