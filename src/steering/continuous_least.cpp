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

/// An image of a word that may be shortest where it drives a winding back, and only there
/// (measured, see the document).
struct Saving {
  std::size_t kind;
  Symmetry symmetry;
};

constexpr double quick_steering = 0.6;  ///< the longest ramp for which that was measured
constexpr std::array<Saving, 19> saving_images = {{
    {0, {true, true, true}},
    {1, in_x},
    {2, {true, false, true}},
    {2, {false, true, true}},
    {2, {true, true, true}},
    {3, in_x},
    {3, in_half_turn},
    {3, {true, false, true}},
    {3, {false, true, true}},
    {4, in_half_turn},
    {4, {false, true, true}},
    {5, in_x},
    {6, in_x},
    {6, in_half_turn},
    {6, {true, false, true}},
    {6, {false, true, true}},
    {7, {false, true, true}},
    {7, {true, true, true}},
    {8, in_x},
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

/// A task, with what the search asks of it again and again.
struct View {
  const WordTask* task;
  Symmetry undo;      ///< from the folded frame
  WordFrame frame;    ///< the folded one
  double most_saved;  ///< by any word
  double least;       ///< no path of a word is shorter, less what it saves
};

/// A word of a task as a symmetry of its folded frame makes it.
struct Image {
  const View* view;
  Symmetry symmetry;
  WordFrame frame;

  [[nodiscard]] Symmetry made() const { return both(view->undo, symmetry); }
  [[nodiscard]] Stops stops() const { return seen_by(made(), view->task->stops); }
};

/// A word that Newton's method has to find.
struct Open {
  Formula formula;
  Image image;
  Arcs guess;
  Arcs circles;  ///< a second guess, on a leg: the arcs of the word at full lock
  bool has_circles;
  double most_saved;  ///< no word of the image saves more
  double bound;       ///< no path of the word is much shorter, less what it may save
};

/// What the arcs of a word add up to; nearly a whole turn is a little less than none.
double signed_length(const Steps& steps, const Arcs& arcs) {
  const auto turned = [](double arc) { return arc > full_turn - 1 ? arc - full_turn : arc; };
  const double parts[] = {turned(arcs.first), arcs.inner, arcs.line, turned(arcs.last)};
  double sum = 0;
  for (std::size_t i = 0; i < steps.count; ++i) sum += parts[steps.list[i].part];
  return sum;
}

/// The quick search for the least word.
class Search {
 public:
  Search(const WordSolver& solver, std::span<const WordTask> tasks, double cutoff)
      : solver_(solver),
        tasks_(tasks),
        stops_(tasks[0].stops),
        ramp_(solver.turns().ramp()),
        joints_{Joints(solver.turns(), stops_), Joints(solver.turns(), stops_.swapped())},
        high_(std::min(1.0, 0.4 + 1.6 * ramp_)),
        best_(cutoff) {}

  std::optional<LeastWord> run() {
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      views_[i] = view_of(tasks_[i]);
      if (views_[i].least - views_[i].most_saved < best_) look_at_likely(views_[i]);
    }
    for (std::size_t i = 0; i < tasks_.size(); ++i) look_at_saving(views_[i]);
    solve_open();
    return least_;
  }

 private:
  static View view_of(const WordTask& task) {
    const MeanFrame near = folded(task.frame);
    const WordFrame frame = word_frame(near);
    const double wound = task.windings.length();
    const double least =
        wound > 0
            ? reeds_shepp_formulas::shortest(Circles(near, {frame.s, frame.c})).arcs.length + wound
            : 0;
    return {&task, unfolding(task.frame), frame, 2 * wound, least};
  }

  void look_at_likely(const View& view) {
    constexpr Symmetry all{true, true, true};
    const MeanFrame near{view.frame.x, view.frame.y, view.frame.a};
    const Image image{&view, none, view.frame};
    if (is_line(near)) {
      consider(SolvedWord{Formula::lsl, image.stops(), {0, near.x, 0}, 0, near.x}, image);
    }
    look_at_likely_images(image);
    if (near.x * near.x + near.y * near.y < 9 * ramp_ * ramp_) look_at_short(image);
    // Where the headings are opposite the other way round is as good.
    const double half = std::numbers::pi / 2;
    if (near.half_turn > half - 0.05 - 0.6 * ramp_) {
      const MeanFrame other{near.x, near.y, 2 * half - near.half_turn};
      look_at_likely_images({&view, all, word_frame(other)});
    }
  }

  void look_at_likely_images(const Image& image) {
    for (const Likely& trial : likely_with(stops_)) {
      const Image seen = seen_in(image, trial.symmetry);
      const Stops stops = seen.stops();
      const double first = ramp_ * trial.first.where(stops.start);
      const double last = ramp_ * trial.last.where(stops.goal);
      look_at(kinds[trial.kind], seen, first, last);
    }
  }

  /// A line between small turns, where it is too short for the circles of turns to full lock.
  void look_at_short(const Image& image) {
    const auto& [x, y, a, s, c] = image.frame;
    add_open(kinds[0], image, std::nullopt);
    if (Circles({x, y, a}, {s, c}).lr >= 0) add_open(kinds[1], image, std::nullopt);
  }

  /// The other words that drive a winding back.
  void look_at_saving(const View& view) {
    if (view.most_saved <= 0) return;
    if (ramp_ <= quick_steering) {
      for (const auto& [kind, symmetry] : saving_images) look_at_saving(view, kind, symmetry);
      return;
    }
    for (std::size_t kind = 0; kind < 9; ++kind) {
      for (unsigned i = 1; i < 8; ++i) {
        const Symmetry symmetry{(i & 1) != 0, (i & 2) != 0, (i & 4) != 0};
        const Symmetry& own = kinds[kind].own;
        const bool is_own =
            (symmetry.x && own.x) || (symmetry.y && own.y) || (symmetry.half_turn && own.half_turn);
        if (!is_own) look_at_saving(view, kind, symmetry);
      }
    }
  }

  void look_at_saving(const View& view, std::size_t kind, const Symmetry& symmetry) {
    const Image image{&view, symmetry, image_of(view.frame, symmetry)};
    const double most = may_save(kinds[kind].formula, image);
    if (most <= 0 || view.least - most >= best_) return;
    look_at(kinds[kind], image, ramp_ / 2, ramp_ / 2);
  }

  static Image seen_in(const Image& image, const Symmetry& symmetry) {
    return {image.view, both(image.symmetry, symmetry), image_of(image.frame, symmetry)};
  }

  void look_at(const Kind& kind, const Image& image, double low_first, double low_last) {
    const Joints& joints = joints_[image.made().swaps_ends() ? 1 : 0];
    const CircleWord circles = circles::word_of(kind.formula, image.frame, joints);
    const bool is_three_arcs = kind.formula == Formula::l_r_l;
    if (!circles.exact || circles.line < -2 * ramp_ ||
        !is_likely(circles.first, low_first, high_, is_three_arcs) ||
        !is_likely(circles.last, low_last, high_, is_three_arcs)) {
      return;
    }
    const Arcs arcs = in_one_turn(circles.arcs());
    const auto word = solver_.at_full_lock(kind.formula, image.stops(), arcs);
    if (word) {
      consider(*word, image);
      return;
    }
    add_open(kind, image, is_leg(stops_) ? std::optional(arcs) : std::nullopt);
  }

  void add_open(const Kind& kind, const Image& image, const std::optional<Arcs>& circles) {
    const auto& [x, y, a, s, c] = image.frame;
    Arcs sharp = in_one_turn(kind.arcs(Circles({x, y, a}, {s, c})));
    const Steps& steps = steps_of(kind.formula);
    double bound = driven_length(steps, sharp);
    if (image.view->most_saved > 0) {
      bound = signed_length(steps, sharp);
      if (circles) bound = std::min(bound, signed_length(steps, *circles));
    }
    // Where an end vanishes, the step beside it may save as much as any.
    constexpr double vanishes = 1e-6;
    const bool is_known = std::min(sharp.first, sharp.last) > vanishes;
    const double most_saved = is_known ? may_save(kind.formula, image) : image.view->most_saved;
    const double least = image.view->task->windings.length() + bound - most_saved;
    if (least >= best_ || count_ == open_.size()) return;
    sharp.line -= 2 * solver_.turns().centre().x;
    open_[count_++] = {kind.formula,        image,      sharp, circles.value_or(Arcs{}),
                       circles.has_value(), most_saved, least};
  }

  /// No word of the image saves more.
  [[nodiscard]] static double may_save(Formula formula, const Image& image) {
    if (image.view->most_saved <= 0) return 0;
    const Symmetry made = image.made();
    const auto& [start, goal] = image.view->task->windings;
    return (may_drive_back(formula, made, true, start) ? 2 * start.length : 0) +
           (may_drive_back(formula, made, false, goal) ? 2 * goal.length : 0);
  }

  /// The open words in the order of their bounds, as long as one may be shorter.
  void solve_open() {
    constexpr double same = 1e-9;  // bounds so near are equal: the word that was asked first
    for (std::size_t n = count_; n > 0; --n) {
      std::size_t next = 0;
      for (std::size_t i = 1; i < count_; ++i) {
        if (open_[i].bound < open_[next].bound - same) next = i;
      }
      Open& open = open_[next];
      if (open.bound >= best_) return;
      const Stops stops = open.image.stops();
      const Patience quick{12, best_ - open.image.view->task->windings.length() + open.most_saved};
      auto word = solver_.solve(open.formula, stops, open.image.frame, open.guess, quick);
      if (!word && open.has_circles) {
        word = solver_.solve(open.formula, stops, open.image.frame, open.circles, quick);
      }
      if (word) consider(*word, open.image);
      open.bound = std::numeric_limits<double>::infinity();
    }
  }

  void consider(const SolvedWord& word, const Image& image) {
    constexpr double tie = 1e-13;  // then the word that was asked first
    const View& view = *image.view;
    const Windings& windings = view.task->windings;
    const double longest = windings.length() + word.length;
    if (longest - view.most_saved >= best_) return;
    const FoundWord found{word, image.made()};
    const double length = view.most_saved > 0 ? longest - saved(solver_, found, windings) : longest;
    if (length >= best_ * (1 - tie)) return;
    best_ = length;
    least_ = {static_cast<std::size_t>(view.task - tasks_.data()), found, length};
  }

  const WordSolver& solver_;
  std::span<const WordTask> tasks_;
  Stops stops_;
  double ramp_;
  std::array<Joints, 2> joints_;  ///< for words from the start, and from the goal
  double high_;
  double best_;
  std::array<View, 4> views_;
  std::optional<LeastWord> least_;
  std::array<Open, 160> open_;
  std::size_t count_ = 0;
};

}  // namespace

std::optional<LeastWord> least_word(const WordSolver& solver, std::span<const WordTask> tasks,
                                    double cutoff) {
  return Search(solver, tasks, cutoff).run();
}

}  // namespace vandplan::steering
