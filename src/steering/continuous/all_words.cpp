// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <optional>
#include <vector>

#include "steering/continuous/mirrored_task.h"
#include "steering/continuous/word_search.h"

namespace vandplan::steering::continuous {
namespace {

/// Arcs of the Reeds-Shepp word at `radius`; the line is shorter by what two clothoids take of it.
Arcs reeds_shepp_arcs(Formula formula, const WordFrame& f, double radius, const SharpTurns& turns) {
  Arcs arcs = in_one_turn(arcs_of(formula, Circles({f.x / radius, f.y / radius, f.a})));
  arcs.line = arcs.line * radius - 2 * turns.centre().x;
  return arcs;
}

constexpr NewtonLimits patient{25};

/// The word of a formula: in closed form if every turn reaches full lock, otherwise by Newton's
/// method. Guesses are the circles at full lock and those without clothoids. If both fail, the
/// guess is circles with the radius of such small turns.
std::optional<SolvedWord> solved(const WordSolver& solver, Formula formula, const WordFrame& frame,
                                 const Stops& stops) {
  const SharpTurns& turns = solver.turns();
  const CircleWord circles = circle_word_of(formula, frame, Joints(turns, stops));
  const Arcs found = in_one_turn(circles.arcs());
  if (circles.exists) {
    if (auto word = solver.at_full_lock(formula, stops, found)) return word;
  }
  std::optional<SolvedWord> shortest = solver.solve(formula, stops, frame, found, patient);
  const auto consider = [&](const Arcs& arcs) {
    const auto word = solver.solve(formula, stops, frame, arcs, patient);
    if (word && (!shortest || word->length < shortest->length)) shortest = word;
  };
  Arcs arcs = reeds_shepp_arcs(formula, frame, 1, turns);
  consider(arcs);
  if (shortest) return shortest;
  for (int round = 0; round < 3; ++round) {
    const double radius = solver.radius_of(std::max({arcs.first, arcs.inner, arcs.last}));
    arcs = reeds_shepp_arcs(formula, frame, radius, turns);
  }
  consider(arcs);
  return shortest;
}

}  // namespace

std::vector<FoundWord> all_words(const WordSolver& solver, const WordTask& task) {
  std::vector<FoundWord> words;
  for_each_candidate(task, any_gear_changes,
                     [&](Formula formula, const WordFrame& frame, const Symmetry& onto_task) {
                       const Stops stops = mirrored(task.stops, onto_task);
                       const auto word = solved(solver, formula, frame, stops);
                       if (word) words.push_back({*word, onto_task});
                     });
  return words;
}

}  // namespace vandplan::steering::continuous
