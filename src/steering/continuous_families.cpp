// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous_families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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
    for (unsigned i = 0; i < 8; ++i) {
      const Symmetry symmetry{(i & 4U) != 0, (i & 2U) != 0, (i & 1U) != 0};
      const auto& [x, y, half_turn] = symmetry;
      if ((x && kind.own.x) || (y && kind.own.y) || (half_turn && kind.own.half_turn)) continue;
      const auto word = solved(solver, kind, image_of(frame, symmetry), task.jumps);
      if (word) take(FoundWord{*word, both(undo, symmetry)});
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

constexpr std::array<Likely, 10> likely = {{
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
}};

/// Whether the angle of an arrow is from -low to a quarter turn and a little or, of a word of three
/// arcs, to half a turn.
bool is_likely(const Arrow& arrow, double low, double high, bool is_three_arcs) {
  const double squared = arrow.squared();
  const double least = low * low + 1e-24;
  if (arrow.im < 0 && (arrow.re < 0 || arrow.im * arrow.im > least * squared)) return false;
  return arrow.re >= 0 || is_three_arcs || arrow.re * arrow.re <= high * high * squared;
}

/// Whether a word, if its turn is long enough, begins (or ends) by driving a winding back.
bool may_drive_back(const Step& step, const Symmetry& symmetry, const Winding& winding) {
  return winding.length > 0 && (symmetry.swaps_sides() ? -step.turn : step.turn) == winding.side &&
         (symmetry.swaps_gears() ? -step.gear : step.gear) == winding.gear;
}

bool may_drive_back(Formula formula, const Symmetry& symmetry, bool at_start,
                    const Winding& winding) {
  const Steps& steps = steps_of(formula);
  return may_drive_back(steps.list[at_start == symmetry.swaps_ends() ? steps.count - 1 : 0],
                        symmetry, winding);
}

/// A word that Newton's method has to find.
struct Open {
  Formula formula;
  Symmetry symmetry;
  WordFrame frame;
  Arcs guess;
  double bound;  ///< no path of the word is much shorter, less what it may save
};

/// Whether the goal is straight ahead but for rounding, by so much that turns would be no shorter.
bool is_line(const MeanFrame& f) {
  constexpr double noise = 1e-13;
  const bool is_exact = f.y == 0 && f.half_turn == 0;
  return is_exact || (f.x > 1e-3 && f.y <= noise * (1 + f.x) && f.half_turn <= noise);
}

/// The quick search for the least word.
class Search {
 public:
  Search(const WordSolver& solver, const WordTask& task, double cutoff)
      : solver_(solver),
        task_(task),
        undo_(unfolding(task.frame)),
        joints_(solver.turns(), task.jumps),
        high_(std::min(1.0, 0.4 + 1.6 * solver.turns().ramp())),
        most_saved_(2 * (task.windings.start.length + task.windings.goal.length)),
        best_(cutoff) {}

  std::optional<FoundWord> run() {
    constexpr Symmetry all{true, true, true};
    const MeanFrame near = folded(task_.frame);
    if (is_line(near)) {
      consider(SolvedWord{Formula::lsl, task_.jumps, {0, near.x, 0}, 0, near.x}, none);
    }
    look_at_likely(WordFrame(near), none);
    if (near.x * near.x + near.y * near.y < 9 * solver_.turns().ramp() * solver_.turns().ramp()) {
      look_at_short(WordFrame(near));
    }
    // Where the headings are opposite the other way round is as good.
    const double half = std::numbers::pi / 2;
    if (near.half_turn > half - 0.05 - 0.6 * solver_.turns().ramp()) {
      look_at_likely(WordFrame({near.x, near.y, 2 * half - near.half_turn}), all);
    }
    if (most_saved_ > 0) look_at_saving(WordFrame(near));
    solve_open();
    return least_;
  }

 private:
  void look_at_likely(const WordFrame& frame, const Symmetry& turned) {
    const double ramp = solver_.turns().ramp();
    for (const Likely& trial : likely) {
      const double first = ramp * (task_.jumps ? trial.first_between_stops : trial.rolling);
      const double last = ramp * (task_.jumps ? trial.last_between_stops : trial.rolling);
      look_at(kinds[trial.kind], image_of(frame, trial.symmetry), both(turned, trial.symmetry),
              first, last);
    }
  }

  /// A line between small turns, where it is too short for the circles of turns to full lock.
  void look_at_short(const WordFrame& frame) {
    for (const Kind& kind : {kinds[0], kinds[1]}) add_open(kind, frame, none);
  }

  /// The other words that drive a winding back.
  void look_at_saving(const WordFrame& frame) {
    const double low = solver_.turns().ramp() / 2;
    for (std::size_t k = 0; k < 9; ++k) {
      for (unsigned i = 1; i < 8; ++i) {
        const Symmetry symmetry{(i & 1) != 0, (i & 2) != 0, (i & 4) != 0};
        const Symmetry& own = kinds[k].own;
        if ((symmetry.x && own.x) || (symmetry.y && own.y) ||
            (symmetry.half_turn && own.half_turn)) {
          continue;
        }
        const Symmetry made = both(undo_, symmetry);
        if (!may_drive_back(kinds[k].formula, made, true, task_.windings.start) &&
            !may_drive_back(kinds[k].formula, made, false, task_.windings.goal)) {
          continue;
        }
        look_at(kinds[k], image_of(frame, symmetry), symmetry, low, low);
      }
    }
  }

  void look_at(const Kind& kind, const WordFrame& image, const Symmetry& symmetry, double low_first,
               double low_last) {
    const CircleWord circles = circles::word_of(kind.formula, image, joints_);
    const bool is_three_arcs = kind.formula == Formula::l_r_l;
    if (!circles.exact || circles.line < -2 * solver_.turns().ramp() ||
        !is_likely(circles.first, low_first, high_, is_three_arcs) ||
        !is_likely(circles.last, low_last, high_, is_three_arcs)) {
      return;
    }
    const auto word = solver_.at_full_lock(kind.formula, task_.jumps, in_one_turn(circles.arcs()));
    if (word) {
      consider(word, symmetry);
      return;
    }
    add_open(kind, image, symmetry);
  }

  void add_open(const Kind& kind, const WordFrame& image, const Symmetry& symmetry) {
    Arcs sharp = in_one_turn(kind.arcs(Circles({image.x, image.y, image.a})));
    const double bound = least_length(shape_of(kind.formula, task_.jumps).steps, sharp);
    // Where an end vanishes, the step beside it may save as much as any.
    constexpr double vanishes = 1e-6;
    const bool is_known = std::min(sharp.first, sharp.last) > vanishes;
    const double least = bound - (is_known ? may_save(kind.formula, symmetry) : most_saved_);
    if (least >= best_ || count_ == open_.size()) return;
    sharp.line -= 2 * solver_.turns().centre().x;
    open_[count_++] = {kind.formula, symmetry, image, sharp, least};
  }

  /// No word saves more.
  [[nodiscard]] double may_save(Formula formula, const Symmetry& symmetry) const {
    if (most_saved_ <= 0) return 0;
    const Symmetry made = both(undo_, symmetry);
    const Windings& w = task_.windings;
    return (may_drive_back(formula, made, true, w.start) ? 2 * w.start.length : 0) +
           (may_drive_back(formula, made, false, w.goal) ? 2 * w.goal.length : 0);
  }

  static double least_length(const Steps& steps, const Arcs& arcs) {
    const double parts[] = {arcs.first, arcs.inner, arcs.line, arcs.last};
    double sum = 0;
    for (std::size_t i = 0; i < steps.count; ++i) sum += std::max(0.0, parts[steps.list[i].part]);
    return sum;
  }

  /// The open words in the order of their bounds, as long as one may be shorter.
  void solve_open() {
    constexpr int quick = 12;
    constexpr double same = 1e-9;  // bounds so near are equal: the word that was asked first
    for (std::size_t n = count_; n > 0; --n) {
      std::size_t next = 0;
      for (std::size_t i = 1; i < count_; ++i) {
        if (open_[i].bound < open_[next].bound - same) next = i;
      }
      Open& open = open_[next];
      if (open.bound >= best_) return;
      consider(solver_.solve(open.formula, task_.jumps, open.frame, open.guess, quick),
               open.symmetry);
      open.bound = std::numeric_limits<double>::infinity();
    }
  }

  void consider(const std::optional<SolvedWord>& word, const Symmetry& symmetry) {
    constexpr double tie = 1e-13;  // then the word that was asked first
    if (!word || word->length - most_saved_ >= best_) return;
    const FoundWord found{*word, both(undo_, symmetry)};
    const double length =
        most_saved_ > 0 ? word->length - saved(solver_, found, task_.windings) : word->length;
    if (length >= best_ * (1 - tie)) return;
    best_ = length;
    least_ = found;
  }

  const WordSolver& solver_;
  const WordTask& task_;
  Symmetry undo_;
  Joints joints_;
  double high_;
  double most_saved_;
  double best_;
  std::optional<FoundWord> least_;
  std::array<Open, 24> open_;
  std::size_t count_ = 0;
};

}  // namespace

double saved(const WordSolver& solver, const FoundWord& found, const Windings& windings) noexcept {
  constexpr double rounding = 1e-12;
  const auto saves = [&](bool at_start, const Winding& winding) {
    if (winding.length <= 0) return 0.0;
    const Steps& steps = steps_of(found.word.formula);
    const bool from_end = at_start == found.symmetry.swaps_ends();
    for (std::size_t i = 0; i < steps.count; ++i) {
      const std::size_t step = from_end ? steps.count - 1 - i : i;
      if (solver.step_length(found.word, step) == 0) continue;
      return may_drive_back(steps.list[step], found.symmetry, winding) &&
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
  for_each_word(solver, task, [&](const FoundWord& found) { words.push_back(found); });
  return words;
}

std::optional<FoundWord> least_word(const WordSolver& solver, const WordTask& task, double cutoff) {
  return Search(solver, task, cutoff).run();
}

}  // namespace vandplan::steering
