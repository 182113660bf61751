// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "steering/continuous_families.h"
#include "steering/continuous_kinds.h"

namespace vandplan::steering {
namespace {

using namespace families;

/// By how many ramps a first or last turn may be shorter than nothing, for the quick search to look
/// at its word (measured, see the document).
struct Slack {
  double rolls, stands;  ///< there, at the start or the goal
  [[nodiscard]] double where(bool it_stands) const { return it_stands ? stands : rolls; }
};

/// A word that the quick search looks at.
struct Likely {
  std::size_t kind;
  Symmetry symmetry;
  Slack first, last;
};

/// Where the curvature never jumps, or at both ends and inside.
constexpr std::array<Likely, 10> likely_words = {{
    {0, none, {0.3, 0.02}, {0.3, 0.02}},
    {1, none, {0.4, 0.02}, {0.4, 0.02}},
    {6, none, {0.5, 0.02}, {0.5, 0.02}},
    {7, none, {0.5, 0.02}, {0.5, 0.02}},
    {2, none, {0.2, 0.0}, {0.2, 0.0}},
    {2, in_x, {1.0, 0.0}, {1.0, 0.0}},
    {3, none, {0.7, 0.0}, {0.7, 0.6}},
    {4, none, {0.8, 0.6}, {0.8, 0.6}},
    {5, none, {0.2, 0.02}, {0.2, 0.02}},
    {8, none, {0.2, 0.02}, {0.2, 0.02}},
}};

/// On a leg.
constexpr std::array<Likely, 16> likely_legs = {{
    {0, none, {0.02, 0.02}, {0.05, 0.02}},
    {1, none, {0.02, 0.02}, {0.02, 0.02}},
    {6, none, {0.25, 0.02}, {0.12, 0.1}},
    {7, none, {0.27, 0.02}, {0.02, 0.02}},
    {2, none, {0.27, 0.06}, {0.2, 0.06}},
    {2, in_x, {0.3, 0.3}, {0.27, 0.2}},
    {3, none, {0.3, 0.05}, {0.55, 0.55}},
    {4, none, {0.6, 0.7}, {0.65, 0.5}},
    {5, none, {0.2, 0.06}, {0.22, 0.1}},
    {8, none, {0.05, 0.1}, {0.12, 0.02}},
    {3, in_half_turn, {0.25, 0.3}, {0.0, 0.0}},
    {3, in_x, {0.0, 0.0}, {0.5, 0.0}},
    {4, in_half_turn, {0.2, 0.5}, {0.0, 0.0}},
    {4, {false, true, true}, {0.15, 0.05}, {0.0, 0.0}},
    {5, in_x, {0.0, 0.0}, {0.0, 0.0}},
    {5, {true, true, false}, {0.0, 0.0}, {0.0, 0.0}},
}};

std::span<const Likely> likely_with(const Stops& stops) {
  return is_leg(stops) ? std::span<const Likely>(likely_legs) : likely_words;
}

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
  Formula formula;
  Symmetry symmetry;
  WordFrame frame;
  Arcs guess;
  std::optional<Arcs> circles;  ///< a second guess: the arcs of the word at full lock
  double bound;                 ///< no path of the word is much shorter, less what it may save
};

/// The quick search for the least word.
class Search {
 public:
  Search(const WordSolver& solver, const WordTask& task, double cutoff)
      : solver_(solver),
        task_(task),
        undo_(unfolding(task.frame)),
        joints_{Joints(solver.turns(), task.stops), Joints(solver.turns(), task.stops.swapped())},
        high_(std::min(1.0, 0.4 + 1.6 * solver.turns().ramp())),
        most_saved_(2 * (task.windings.start.length + task.windings.goal.length)),
        best_(cutoff) {}

  std::optional<FoundWord> run() {
    constexpr Symmetry all{true, true, true};
    const MeanFrame near = folded(task_.frame);
    if (is_line(near)) {
      consider(SolvedWord{Formula::lsl, stops_of(none), {0, near.x, 0}, 0, near.x}, none);
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
    for (const Likely& trial : likely_with(task_.stops)) {
      const Symmetry symmetry = both(turned, trial.symmetry);
      const Stops stops = stops_of(symmetry);
      const double first = ramp * trial.first.where(stops.start);
      const double last = ramp * trial.last.where(stops.goal);
      look_at(kinds[trial.kind], image_of(frame, trial.symmetry), symmetry, first, last);
    }
  }

  /// A line between small turns, where it is too short for the circles of turns to full lock.
  void look_at_short(const WordFrame& frame) {
    for (const Kind& kind : {kinds[0], kinds[1]}) add_open(kind, frame, none, std::nullopt);
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
    const Joints& joints = joints_[both(undo_, symmetry).swaps_ends() ? 1 : 0];
    const CircleWord circles = circles::word_of(kind.formula, image, joints);
    const bool is_three_arcs = kind.formula == Formula::l_r_l;
    if (!circles.exact || circles.line < -2 * solver_.turns().ramp() ||
        !is_likely(circles.first, low_first, high_, is_three_arcs) ||
        !is_likely(circles.last, low_last, high_, is_three_arcs)) {
      return;
    }
    const Arcs arcs = in_one_turn(circles.arcs());
    const auto word = solver_.at_full_lock(kind.formula, stops_of(symmetry), arcs);
    if (word) {
      consider(word, symmetry);
      return;
    }
    add_open(kind, image, symmetry, is_leg(task_.stops) ? std::optional(arcs) : std::nullopt);
  }

  void add_open(const Kind& kind, const WordFrame& image, const Symmetry& symmetry,
                const std::optional<Arcs>& circles) {
    Arcs sharp = in_one_turn(kind.arcs(Circles({image.x, image.y, image.a})));
    const double bound = driven_length(steps_of(kind.formula), sharp);
    // Where an end vanishes, the step beside it may save as much as any.
    constexpr double vanishes = 1e-6;
    const bool is_known = std::min(sharp.first, sharp.last) > vanishes;
    const double least = bound - (is_known ? may_save(kind.formula, symmetry) : most_saved_);
    if (least >= best_ || count_ == open_.size()) return;
    sharp.line -= 2 * solver_.turns().centre().x;
    open_[count_++] = {kind.formula, symmetry, image, sharp, circles, least};
  }

  /// No word saves more.
  [[nodiscard]] double may_save(Formula formula, const Symmetry& symmetry) const {
    if (most_saved_ <= 0) return 0;
    const Symmetry made = both(undo_, symmetry);
    const Windings& w = task_.windings;
    return (may_drive_back(formula, made, true, w.start) ? 2 * w.start.length : 0) +
           (may_drive_back(formula, made, false, w.goal) ? 2 * w.goal.length : 0);
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
      const Stops stops = stops_of(open.symmetry);
      auto word = solver_.solve(open.formula, stops, open.frame, open.guess, quick);
      if (!word && open.circles) {
        word = solver_.solve(open.formula, stops, open.frame, *open.circles, quick);
      }
      consider(word, open.symmetry);
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

  /// Of the task, as the word of a symmetry sees them.
  [[nodiscard]] Stops stops_of(const Symmetry& symmetry) const {
    return seen_by(both(undo_, symmetry), task_.stops);
  }

  const WordSolver& solver_;
  const WordTask& task_;
  Symmetry undo_;
  std::array<Joints, 2> joints_;  ///< for words from the start, and from the goal
  double high_;
  double most_saved_;
  double best_;
  std::optional<FoundWord> least_;
  std::array<Open, 40> open_;
  std::size_t count_ = 0;
};

}  // namespace

std::optional<FoundWord> least_word(const WordSolver& solver, const WordTask& task, double cutoff) {
  return Search(solver, task, cutoff).run();
}

}  // namespace vandplan::steering
