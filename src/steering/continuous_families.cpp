// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous_families.h"

#include <algorithm>
#include <array>
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

Arcs in_one_turn(Arcs arcs) {
  arcs.first = in_one_turn(arcs.first);
  arcs.last = in_one_turn(arcs.last);
  return arcs;
}

/// The arcs of Reeds and Shepp at `radius`, with the line that turns with clothoids leave.
Arcs sharp_arcs(const Kind& kind, const WordFrame& f, double radius, const SharpTurns& turns) {
  Arcs arcs = in_one_turn(kind.arcs(Circles({f.x / radius, f.y / radius, f.a})));
  arcs.line = arcs.line * radius - 2 * turns.centre().x;
  return arcs;
}

WordFrame image_of(WordFrame f, const Symmetry& s) {
  if (s.x) f.x = -f.x;
  if (s.y) f.y = -f.y;
  if (s.half_turn) {
    f.a = -f.a;
    f.s = -f.s;
  }
  return f;
}

constexpr int patient = 25;

/// The word with circles if every turn reaches full lock; else by Newton's method from these
/// circles, from circles without clothoids, or from circles of the radius that turns have which are
/// so small.
std::optional<SolvedWord> solved(const WordSolver& solver, const Kind& kind, const WordFrame& frame,
                                 bool jumps) {
  const SharpTurns& turns = solver.turns();
  const CircleWord circles = circles::word_of(kind.formula, frame, Joints(turns, jumps));
  const Arcs found = in_one_turn(circles.arcs());
  if (circles.exact) {
    if (auto word = solver.at_full_lock(kind.formula, jumps, found)) return word;
  }
  std::optional<SolvedWord> least = solver.solve(kind.formula, jumps, frame, found, patient);
  const auto consider = [&](const Arcs& arcs) {
    const auto word = solver.solve(kind.formula, jumps, frame, arcs, patient);
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

MeanFrame folded(const MeanFrame& f) {
  return {std::abs(f.x), std::abs(f.y), std::abs(f.half_turn)};
}

/// What undoes `folded`. For the frame from the other end it differs in all three, zeros included.
Symmetry unfolding(const MeanFrame& f) {
  const bool backwards = f.x != 0 ? f.x < 0 : f.y != 0 ? f.y < 0 : f.half_turn < 0;
  const auto is_negative = [&](double v) { return v != 0 ? v < 0 : backwards; };
  return {backwards, is_negative(f.y), is_negative(f.half_turn)};
}

Symmetry both(const Symmetry& a, const Symmetry& b) {
  return {a.x != b.x, a.y != b.y, a.half_turn != b.half_turn};
}

template <typename Take>
void for_each_word(const WordSolver& solver, const WordTask& task, Take take) {
  const WordFrame frame(folded(task.frame));
  const Symmetry undo = unfolding(task.frame);
  for (const Kind& kind : kinds) {
    for (const bool x : {false, true}) {
      for (const bool y : {false, true}) {
        for (const bool half_turn : {false, true}) {
          const Symmetry symmetry{x, y, half_turn};
          if ((x && kind.own.x) || (y && kind.own.y) || (half_turn && kind.own.half_turn)) continue;
          const auto word = solved(solver, kind, image_of(frame, symmetry), task.jumps);
          if (word) take(FoundWord{*word, both(undo, symmetry)});
        }
      }
    }
  }
}

/// A word that the quick search looks at, unless its first or last turn is shorter than nothing by
/// so many ramps (while rolling, between stops: measured, see the document).
struct Likely {
  std::size_t kind;
  Symmetry symmetry;
  double rolling;
  double first_between_stops, last_between_stops;
};

constexpr std::array<Likely, 12> likely = {{
    {0, none, 0.3, 0.02, 0.02},
    {1, none, 0.4, 0.02, 0.02},
    {6, none, 0.5, 0.02, 0.02},
    {7, none, 0.5, 0.02, 0.02},
    {2, none, 0.2, 0.0, 0.0},
    {2, in_x, 1.0, 0.0, 0.0},
    {3, none, 0.7, 0.0, 0.6},
    {4, none, 0.8, 0.6, 0.6},
    {5, none, 0.2, 0.02, 0.02},
    {8, none, 0.2, 0.02, 0.02},
    {6, {false, true, true}, 0.1, 0.0, 0.0},
    {7, {false, true, true}, 0.1, 0.0, 0.0},
}};

/// Whether the angle of an arrow is from -low to a quarter turn and a little or, of a word of three
/// arcs, to half a turn.
bool is_likely(const Arrow& arrow, double low, double high, bool is_three_arcs) {
  const double squared = arrow.squared();
  const double least = low * low + 1e-24;
  if (arrow.im < 0 && (arrow.re < 0 || arrow.im * arrow.im > least * squared)) return false;
  return arrow.re >= 0 || is_three_arcs || arrow.re * arrow.re <= high * high * squared;
}

/// A word that Newton's method has to find.
struct Open {
  const Likely* trial;
  WordFrame frame;
  Arcs guess;
  double bound;  ///< no path of the word is much shorter
  double rank;   ///< the bound, so coarse that rounding decides nothing
};

/// The quick search for the least word.
class Search {
 public:
  Search(const WordSolver& solver, const WordTask& task, double cutoff)
      : solver_(solver), task_(task), best_(cutoff) {
    if (task.windings.start.length > 0 || task.windings.goal.length > 0) {
      most_saved_ = 2 * (task.windings.start.length + task.windings.goal.length);
    }
  }

  std::optional<FoundWord> run() {
    look_at_circles();
    std::sort(open_.begin(), open_.begin() + static_cast<std::ptrdiff_t>(count_),
              [](const Open& a, const Open& b) {
                return a.rank != b.rank ? a.rank < b.rank : a.trial < b.trial;
              });
    constexpr int quick = 12;
    for (std::size_t i = 0; i < count_ && open_[i].bound - most_saved_ < best_; ++i) {
      const Open& open = open_[i];
      const Formula formula = kinds[open.trial->kind].formula;
      consider(solver_.solve(formula, task_.jumps, open.frame, open.guess, quick), *open.trial);
    }
    return least_;
  }

 private:
  void look_at_circles() {
    const WordFrame frame(folded(task_.frame));
    const SharpTurns& turns = solver_.turns();
    const Joints joints(turns, task_.jumps);
    const double ramp = turns.ramp();
    const double high = std::min(1.0, 0.4 + 1.6 * ramp);
    for (const Likely& trial : likely) {
      const Kind& kind = kinds[trial.kind];
      const WordFrame image = image_of(frame, trial.symmetry);
      const CircleWord circles = circles::word_of(kind.formula, image, joints);
      const double low_first = ramp * (task_.jumps ? trial.first_between_stops : trial.rolling);
      const double low_last = ramp * (task_.jumps ? trial.last_between_stops : trial.rolling);
      const bool is_three_arcs = kind.formula == Formula::l_r_l;
      if (!circles.exact || circles.line < -2 * ramp ||
          !is_likely(circles.first, low_first, high, is_three_arcs) ||
          !is_likely(circles.last, low_last, high, is_three_arcs)) {
        continue;
      }
      const auto word =
          solver_.at_full_lock(kind.formula, task_.jumps, in_one_turn(circles.arcs()));
      if (word) {
        consider(word, trial);
        continue;
      }
      Arcs sharp = in_one_turn(kind.arcs(Circles({image.x, image.y, image.a})));
      const double bound = least_length(shape_of(kind.formula, task_.jumps).steps, sharp);
      sharp.line -= 2 * turns.centre().x;
      open_[count_++] = {&trial, image, sharp, bound, std::floor(bound * 1e9)};
    }
  }

  static double least_length(const Steps& steps, const Arcs& arcs) {
    const double parts[] = {arcs.first, arcs.inner, arcs.line, arcs.last};
    double sum = 0;
    for (std::size_t i = 0; i < steps.count; ++i) sum += std::max(0.0, parts[steps.list[i].part]);
    return sum;
  }

  void consider(const std::optional<SolvedWord>& word, const Likely& trial) {
    if (!word || word->length - most_saved_ >= best_) return;
    const FoundWord found{*word, both(unfolding(task_.frame), trial.symmetry)};
    const double length =
        most_saved_ > 0 ? word->length - saved(solver_, found, task_.windings) : word->length;
    constexpr double tie = 1e-13;  // the word that was asked first, with fewer strokes
    if (length >= best_ * (1 - tie)) return;
    best_ = length;
    least_ = found;
  }

  const WordSolver& solver_;
  const WordTask& task_;
  double best_;
  double most_saved_ = 0;
  std::optional<FoundWord> least_;
  std::array<Open, likely.size()> open_;
  std::size_t count_ = 0;
};

/// Whether a step of a found word begins (or ends) at straight wheels by driving a winding back.
bool drives_back(const WordSolver& solver, const FoundWord& found, bool at_start,
                 const Winding& winding) {
  if (winding.length <= 0 || found.word.jumps) return false;
  const Steps& steps = steps_of(found.word.formula);
  const std::size_t i = at_start == found.symmetry.swaps_ends() ? steps.count - 1 : 0;
  const Step& step = steps.list[i];
  const double side = found.symmetry.swaps_sides() ? -step.turn : step.turn;
  const double gear = found.symmetry.swaps_gears() ? -step.gear : step.gear;
  return side == winding.side && gear == winding.gear &&
         solver.ramp_of(found.word, i) >= winding.length;
}

}  // namespace

double saved(const WordSolver& solver, const FoundWord& found, const Windings& windings) noexcept {
  double sum = 0;
  if (drives_back(solver, found, true, windings.start)) sum += 2 * windings.start.length;
  if (drives_back(solver, found, false, windings.goal)) sum += 2 * windings.goal.length;
  return sum;
}

std::vector<FoundWord> all_words(const WordSolver& solver, const WordTask& task) {
  std::vector<FoundWord> words;
  for_each_word(solver, task, [&](const FoundWord& found) { words.push_back(found); });
  return words;
}

std::optional<FoundWord> least_word(const WordSolver& solver, const WordTask& task, double cutoff) {
  if (auto found = Search(solver, task, cutoff).run()) return found;
  return std::nullopt;
}

}  // namespace vandplan::steering
