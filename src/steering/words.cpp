// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/require.h"
#include "steering/mean_frame.h"
#include "steering/reeds_shepp_formulas.h"
#include "steering/word.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using namespace steering;
using namespace steering::reeds_shepp_formulas;

constexpr double full_turn = 2 * std::numbers::pi;

double from_left_to_left(const Circles& p) { return (p.x - 2 * p.s) * (p.x - 2 * p.s) + p.y * p.y; }
double from_right_to_right(const Circles& p) {
  return (p.x + 2 * p.s) * (p.x + 2 * p.s) + p.y * p.y;
}

/// Functions of the formulas, in the order of their enumerators: the word exists where its function
/// is >= 0.
constexpr std::array<double (*)(const Circles&), formula_count> margins = {
    [](const Circles&) { return 0.0; },                            // lsl
    [](const Circles& p) { return p.lr; },                         // lsr
    [](const Circles& p) { return 16 - from_left_to_left(p); },    // l_r_l
    [](const Circles& p) { return 16 - from_right_to_right(p); },  // r_lr
    [](const Circles& p) { return -p.lr; },                        // lr_lr
    [](const Circles& p) { return std::min(p.rl, 32 - p.rl); },    // r_lr_l
    [](const Circles& p) { return from_right_to_right(p) - 8; },   // r_lsr
    [](const Circles& p) { return p.rl; },                         // r_lsl
    [](const Circles& p) { return p.rl - 16; },                    // r_lsr_l
    [](const Circles& p) { return 16 - from_left_to_left(p); },    // lrl
    [](const Circles& p) { return 16 - from_right_to_right(p); },  // r_lr_wide
};

/// Whether the inner arc is more than half a turn.
bool is_wide(Formula formula) { return formula == Formula::lrl || formula == Formula::r_lr_wide; }

/// The arc plus whole turns, in [0, 2 pi). An arc that rounding pushed below 0 stays there.
double in_one_turn(double arc) {
  const double wrapped = arc - full_turn * std::floor(arc / full_turn);
  return wrapped < full_turn - 1e-12 ? wrapped : wrapped - full_turn;
}

/// A word of a formula between two poses, under one symmetry.
struct Word {
  Formula formula;
  Symmetry symmetry;
  Arcs arcs;  ///< first and last arc are in [0, 2 pi), except for rounding
  double margin;
};

/// Calls `take` with each word of a formula whose margin is at least `least`.
template <typename Take>
void for_each_word(const Circles& circles, Formula formula, double least, Take take) {
  for_each_symmetry(formula, [&](const Symmetry& symmetry) {
    const Circles mirrored = symmetry.of(circles);
    const double margin = margins[static_cast<std::size_t>(formula)](mirrored);
    if (margin < least) return;
    Arcs arcs = arcs_of(formula, mirrored);
    arcs.first = in_one_turn(arcs.first);
    arcs.last = in_one_turn(arcs.last);
    take(Word{formula, symmetry, arcs, margin});
  });
}

/// Length of a word [turning radii]. A first or last arc that rounding made negative shortens it by
/// next to nothing.
double length_of(const Word& word) {
  const Arcs& a = word.arcs;
  const double parts[] = {a.first, a.inner, a.line, a.last};
  const Steps& steps = steps_of(word.formula);
  double sum = 0.0;
  for (std::size_t i = 0; i < steps.count; ++i) sum += parts[steps.list[i].part];
  return sum;
}

/// The segments of a word, without those of length 0.
Piece piece_of(const Word& word, double radius) {
  const Arcs arcs = without_noise(word.formula, word.arcs);
  Piece piece = piece_of(word.formula, arcs, word.symmetry, radius);
  piece.length = length(piece.view());
  return piece;
}

/// The arcs without vanishing parts: those shorter than `reach`, or within `reach` of a whole turn.
Arcs without_vanishing(Arcs arcs, double reach) {
  for (double* part : {&arcs.first, &arcs.inner, &arcs.line, &arcs.last}) {
    const bool is_whole = part != &arcs.line && *part > full_turn - reach;
    if (is_whole || *part < reach) *part = 0.0;
  }
  return arcs;
}

/// The arcs with tiny parts in place of vanishing ones (see `without_vanishing`). From these
/// `mended` finds their lengths.
Arcs with_tiny(Arcs arcs, double reach) {
  const double tiny = reach / 100;
  for (double* part : {&arcs.first, &arcs.inner, &arcs.line, &arcs.last}) {
    const bool is_whole = part != &arcs.line && *part > full_turn - reach;
    *part = is_whole ? tiny : std::max(*part, tiny);
  }
  return arcs;
}

/// The piece with neighbours of equal curvature and gear joined, and without whole turns too many.
Piece joined(const Piece& piece, double radius, double reach) {
  Piece result;
  for (const Segment& segment : piece.view()) {
    Segment* const last = result.count > 0 ? &result.segments[result.count - 1U] : nullptr;
    if (last != nullptr && last->curvature == segment.curvature &&
        last->length * segment.length > 0) {
      last->length += segment.length;
    } else {
      result.segments[result.count++] = segment;
    }
  }
  for (Segment& segment : std::span(result.segments.data(), result.count)) {
    const double turns = std::abs(segment.length) / radius;
    if (segment.curvature == 0.0 || turns < full_turn - reach) continue;
    segment.length = std::copysign(std::max(turns - full_turn, 0.0) * radius, segment.length);
  }
  return result;
}

/// Guesses for paths that lack vanishing parts of words.
class Guesses {
 public:
  /// `shift`: how far from the pose a piece may end [turning radii].
  Guesses(double radius, double shift) : radius_(radius), reach_(4 * std::sqrt(shift)) {}

  /// Adds two guesses from a word with a part near 0 or near a whole turn, or whose circles barely
  /// miss each other. Other words add none.
  void add(const Word& word) {
    if (word.margin >= 0.0 && !is_near(word)) return;
    for (const Arcs& arcs : {without_vanishing(word.arcs, reach_), with_tiny(word.arcs, reach_)}) {
      const Piece piece = piece_of(Word{word.formula, word.symmetry, arcs, 0.0}, radius_);
      guesses_.push_back(joined(piece, radius_, reach_));
    }
  }
  [[nodiscard]] const std::vector<Piece>& list() const { return guesses_; }

 private:
  [[nodiscard]] bool is_near(const Word& word) const {
    const double parts[] = {word.arcs.first, word.arcs.inner, word.arcs.line, word.arcs.last};
    const Steps& steps = steps_of(word.formula);
    return std::any_of(steps.list.data(), steps.list.data() + steps.count, [&](const Step& step) {
      const double part = parts[step.part];
      return part < reach_ || (step.turn != 0.0 && part > full_turn - reach_);
    });
  }

  double radius_;
  double reach_;  // shorter parts may vanish; a short one is as long as the root of a shift
  std::vector<Piece> guesses_;
};

}  // namespace

namespace steering {

void find_words(const Pose& from, const Pose& to, double radius, const Wanted& wanted,
                std::vector<Piece>& words) {
  const Circles circles(mean_frame(from, to, radius));
  const double shift = wanted.closing.position / radius + wanted.closing.heading;
  Guesses guesses(radius, shift);
  words.clear();
  for (const FormulaRow& row : formula_rows) {
    if (gear_changes_of(steps_of(row.formula)) != wanted.gear_changes) continue;
    if (is_wide(row.formula) && !wanted.wide_arcs) continue;
    for_each_word(circles, row.formula, -16 * shift, [&](const Word& word) {
      guesses.add(word);
      if (word.margin < 0.0 || length_of(word) * radius >= wanted.longest) return;
      const Piece piece = piece_of(word, radius);
      if (piece.length < wanted.longest) words.push_back(piece);
    });
  }
  for (const Piece& guess : guesses.list()) {
    const std::optional<Piece> piece = mended(from, to, guess, wanted.closing);
    if (piece && piece->length < wanted.longest) words.push_back(*piece);
  }
}

}  // namespace steering

std::vector<Piece> reeds_shepp_words(const Pose& from, const Pose& to, double radius) {
  base::require_radius(radius);
  const Circles circles(mean_frame(from, to, radius));
  std::vector<Piece> words;
  for (const FormulaRow& row : formula_rows) {
    if (is_wide(row.formula)) continue;
    for_each_word(circles, row.formula, 0.0,
                  [&](const Word& word) { words.push_back(piece_of(word, radius)); });
  }
  return words;
}

}  // namespace vandplan
