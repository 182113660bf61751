// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous_families.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vandplan::steering {
namespace {

using namespace reeds_shepp_formulas;

constexpr double full_turn = 2 * std::numbers::pi;

/// What of a formula `all_words` needs to know.
struct Kind {
  Formula formula;
  Arcs (*arcs)(const Circles&);
  Symmetry own;  ///< maps the word onto itself; none for a word that has eight images
};

constexpr Symmetry none{false, false, false};
constexpr Symmetry in_x{true, false, false};
constexpr Symmetry in_y{false, true, false};
constexpr Symmetry in_half_turn{false, false, true};

constexpr std::array<Kind, 11> kinds = {{
    {Formula::lsl, lsl, in_y},
    {Formula::lsr, lsr, in_half_turn},
    {Formula::l_r_l, l_r_l, in_y},
    {Formula::r_lr, r_lr, none},
    {Formula::lr_lr, lr_lr, in_x},
    {Formula::r_lr_l, r_lr_l, in_half_turn},
    {Formula::r_lsr, r_lsr, none},
    {Formula::r_lsl, r_lsl, none},
    {Formula::r_lsr_l, r_lsr_l, in_half_turn},
    {Formula::lrl, lrl, in_y},
    {Formula::r_lr_wide, r_lr_wide, none},
}};

/// In [-slack, 2 pi - slack): a turn that should be a little less than nothing is a bad guess of a
/// small one, not of a whole turn.
double in_one_turn(double arc) {
  constexpr double slack = 0.5;
  return arc - full_turn * std::floor((arc + slack) / full_turn);
}

Arcs arcs_at(const Kind& kind, const MeanFrame& frame, double radius) {
  Arcs arcs = kind.arcs(Circles({frame.x / radius, frame.y / radius, frame.half_turn}));
  arcs.first = in_one_turn(arcs.first);
  arcs.last = in_one_turn(arcs.last);
  return arcs;
}

MeanFrame image_of(const MeanFrame& f, const Symmetry& s) {
  return {s.x ? -f.x : f.x, s.y ? -f.y : f.y, s.half_turn ? -f.half_turn : f.half_turn};
}

/// From the arcs at full lock or else from those at the radius which turns of their size have.
std::optional<SolvedWord> solved(const WordSolver& solver, const Kind& kind, const MeanFrame& frame,
                                 bool jumps) {
  Arcs arcs = arcs_at(kind, frame, 1);
  std::optional<SolvedWord> word = solver.solve(kind.formula, jumps, frame, arcs, 1);
  if (word) return word;
  double radius = 1;
  for (int round = 0; round < 3; ++round) {
    radius = solver.radius_of(std::max({arcs.first, arcs.inner, arcs.last}));
    arcs = arcs_at(kind, frame, radius);
  }
  return solver.solve(kind.formula, jumps, frame, arcs, radius);
}

template <typename Take>
void for_each_word(const WordSolver& solver, const MeanFrame& frame, bool jumps, Take take) {
  for (const Kind& kind : kinds) {
    for (const bool x : {false, true}) {
      for (const bool y : {false, true}) {
        for (const bool half_turn : {false, true}) {
          const Symmetry symmetry{x, y, half_turn};
          if ((x && kind.own.x) || (y && kind.own.y) || (half_turn && kind.own.half_turn)) continue;
          const auto word = solved(solver, kind, image_of(frame, symmetry), jumps);
          if (word) take(FoundWord{*word, symmetry});
        }
      }
    }
  }
}

}  // namespace

std::vector<FoundWord> all_words(const WordSolver& solver, const MeanFrame& frame, bool jumps) {
  std::vector<FoundWord> words;
  for_each_word(solver, frame, jumps, [&](const FoundWord& found) { words.push_back(found); });
  return words;
}

std::optional<FoundWord> least_word(const WordSolver& solver, const MeanFrame& frame, bool jumps,
                                    double cutoff) noexcept {
  std::optional<FoundWord> least;
  for_each_word(solver, frame, jumps, [&](const FoundWord& found) {
    if (found.word.length >= (least ? least->word.length : cutoff)) return;
    least = found;
  });
  return least;
}

}  // namespace vandplan::steering
