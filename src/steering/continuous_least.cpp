// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "steering/continuous_bounds.h"
#include "steering/continuous_families.h"
#include "steering/continuous_images.h"
#include "steering/continuous_kinds.h"
#include "steering/continuous_shortlists.h"

namespace vandplan::steering {
namespace {

using namespace families;
using images::Back, images::Image, images::View;
using images::back_of, images::image_of;
using shortlists::List, shortlists::Rows;

const List& list_with(const Stops& stops) {
  if (is_leg(stops)) return shortlists::leg_list;
  return stops.inside ? shortlists::standing_list : shortlists::rolling_list;
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
  Image image;
  Arcs guess, second_guess;
  bool has_second;
  double bound;  ///< its path is not much shorter
};

/// The quick search for the least word.
class Search {
 public:
  Search(const WordSolver& solver, std::span<const WordTask> tasks, double cutoff, Looked looked)
      : solver_(solver),
        tasks_(tasks),
        stops_(tasks[0].stops),
        list_(list_with(stops_)),
        ramp_(solver.turns().ramp()),
        is_quick_(looked == Looked::likely && ramp_ <= shortlists::longest_ramp),
        joints_{Joints(solver.turns(), stops_), Joints(solver.turns(), stops_.swapped())},
        high_(std::min(1.0, 0.4 + 1.6 * ramp_)),
        best_(cutoff) {}

  std::optional<LeastWord> run() {
    std::array<View, 4> views;
    std::array<double, 4> order;
    std::size_t count = 0;
    for (const WordTask& task : tasks_) {  // those that promise most are the first
      const View view = view_of(task);
      const double promise = view.least - image_of_sharp(view).most_saved();
      std::size_t i = count++;
      for (; i > 0 && order[i - 1] > promise; --i) {
        views[i] = views[i - 1];
        order[i] = order[i - 1];
      }
      views[i] = view;
      order[i] = promise;
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (views[i].least - views[i].most_saved() < best_) look_at(views[i]);
      if (is_quick_ && stops_.inside) solve_open();  // elsewhere the bounds of all tell more
    }
    solve_open();
    return least_;
  }

 private:
  [[nodiscard]] View view_of(const WordTask& task) const {
    const auto& [start, goal] = task.windings;
    const Symmetry undo = unfolding(task.frame);
    View view{&task, undo, back_of(start, undo), back_of(goal, undo), 0};
    if (undo.swaps_ends()) std::swap(view.first, view.last);
    view.least = task.windings.length() + task.sharp.arcs.length;
    if (!stops_.inside && is_quick_) view.least += bounds::least_added(task.sharp, ramp_);
    return view;
  }

  /// The word of Reeds and Shepp.
  static Image image_of_sharp(const View& view) {
    const auto kind = static_cast<std::size_t>(view.task->sharp.formula);
    return image_of(view, kinds[kind], none, view.task->folded, none);
  }

  void look_at(const View& view) {
    const WordFrame& folded = view.task->folded;
    const MeanFrame near{folded.x, folded.y, folded.a};
    if (is_line(near)) {
      const Image line = image_of(view, kinds[0], none, folded, none);
      consider(SolvedWord{Formula::lsl, line.stops(), {0, near.x, 0}, 0, near.x}, line);
    }
    look_at_rows(view);
    if (near.x * near.x + near.y * near.y < 9 * ramp_ * ramp_) look_at_short(view);
    // Where the headings are opposite the other way round is as good.
    const double missing = std::numbers::pi / 2 - near.half_turn;
    if (missing < 0.05 + 0.6 * ramp_) {
      const bool any = stops_.inside || !is_quick_ || missing < 0.05;
      look_at_other_way(view, word_frame({near.x, near.y, near.half_turn + 2 * missing}),
                        any ? list_.likely : list_.half_turns);
    }
    if (!is_quick_ && view.most_saved() > 0) look_at_all_that_save(view);
  }

  /// The rows that are worth a look where the word of Reeds and Shepp is what it is.
  [[nodiscard]] Rows worth_a_look(const View& view) const {
    if (!is_quick_) return list_.likely;
    const reeds_shepp_formulas::Solution& sharp = view.task->sharp;
    const auto formula = static_cast<std::size_t>(sharp.formula);
    const auto [first, last] = std::pair(view.first.way, view.last.way);
    return bounds::is_on_border(sharp)
               ? list_.likely | list_.first_way[first] | list_.last_way[last]
               : list_.here[formula][first][last];
  }

  /// The rows that may be shorter than the best: what saves nothing, or at one end only, has to be
  /// that all the same.
  [[nodiscard]] Rows short_enough(const View& view) const {
    if (!is_quick_ || view.least < best_) return ~Rows{0};
    const Rows first = list_.first_way[view.first.way];
    const Rows last = list_.last_way[view.last.way];
    Rows rows = first & last;
    if (view.least - view.first.saved < best_) rows |= first;
    if (view.least - view.last.saved < best_) rows |= last;
    return rows;
  }

  void look_at_rows(const View& view) {
    const WordFrame& folded = view.task->folded;
    Rows rows = worth_a_look(view) & short_enough(view);
    const double most = 4 * (joints_[0].stop + joints_[0].reach);
    if (folded.x * folded.x + folded.y * folded.y > most * most) rows &= ~list_.arcs;
    for (; rows != 0; rows &= rows - 1) {
      const auto& row = list_.rows[static_cast<std::size_t>(std::countr_zero(rows))];
      look_at_row(row, image_of(view, kinds[row.kind], none, folded, row.symmetry));
    }
  }

  void look_at_other_way(const View& view, const WordFrame& frame, Rows which) {
    constexpr Symmetry all{true, true, true};
    for (Rows rows = worth_a_look(view) & which; rows != 0; rows &= rows - 1) {
      const auto& row = list_.rows[static_cast<std::size_t>(std::countr_zero(rows))];
      look_at_row(row, image_of(view, kinds[row.kind], all, frame, row.symmetry));
    }
  }

  void look_at_row(const shortlists::Likely& row, const Image& image) {
    const Stops stops = image.stops();
    look_at(kinds[row.kind], image, ramp_ * row.first.where(stops.start),
            ramp_ * row.last.where(stops.goal));
  }

  /// A line between small turns, where it is too short for the circles of turns to full lock.
  void look_at_short(const View& view) {
    const Rows rows = worth_a_look(view) & short_enough(view);
    const WordFrame& folded = view.task->folded;
    const Circles circles({folded.x, folded.y, folded.a}, {folded.s, folded.c});
    const auto look = [&](const Kind& kind) {
      const Arcs sharp = kind.arcs(circles);
      // Larger turns get to full lock, where the word is found by its circles.
      if (is_quick_ && !stops_.inside && std::max(sharp.first, sharp.last) > ramp_) return;
      add_sharp(kind, image_of(view, kind, none, folded, none), std::nullopt);
    };
    if ((rows & 1) != 0) look(kinds[0]);
    if ((rows & 2) != 0 && circles.lr >= 0) look(kinds[1]);
  }

  /// For steering so slow that the lists were not measured for it.
  void look_at_all_that_save(const View& view) {
    const WordFrame& folded = view.task->folded;
    for (std::size_t i = 0; i < 9; ++i) {
      for (unsigned bits = 1; bits < 8; ++bits) {
        const Symmetry symmetry{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
        const Symmetry& own = kinds[i].own;
        if ((symmetry.x && own.x) || (symmetry.y && own.y) ||
            (symmetry.half_turn && own.half_turn)) {
          continue;
        }
        const Image image = image_of(view, kinds[i], none, folded, symmetry);
        if (image.most_saved() > 0) look_at(kinds[i], image, ramp_ / 2, ramp_ / 2);
      }
    }
  }

  void look_at(const Kind& kind, const Image& image, double low_first, double low_last) {
    if (image.view->least - image.most_saved() >= best_) return;
    const Joints& joints = joints_[image.made().swaps_ends() ? 1 : 0];
    const CircleWord circles = circles::word_of(kind.formula, image.frame, joints);
    const bool is_near_circles = !stops_.inside && is_quick_;
    if (!circles.exact || circles.line < (is_near_circles ? -1.05 : -2) * ramp_) return;
    if (is_near_circles && circles.line > 3 * ramp_) {  // which moves the turns but little
      low_first = std::min(low_first, 0.01 * ramp_);
      low_last = std::min(low_last, 0.01 * ramp_);
    }
    const bool is_three_arcs = kind.formula == Formula::l_r_l;
    if (!is_likely(circles.first, low_first, high_, is_three_arcs) ||
        !is_likely(circles.last, low_last, high_, is_three_arcs)) {
      return;
    }
    const Arcs arcs = in_one_turn(circles.arcs());
    if (is_near_circles && !is_tiny(image.frame)) {
      look_near_circles(kind.formula, image, arcs);
    } else if (const auto word = solver_.at_full_lock(kind.formula, image.stops(), arcs)) {
      consider(*word, image);
    } else {
      add_sharp(kind, image, stops_.inside ? std::optional(arcs) : std::nullopt);
    }
  }

  /// Whether the goal is so near that no circle to full lock tells anything.
  [[nodiscard]] bool is_tiny(const WordFrame& f) const {
    return f.x * f.x + f.y * f.y < 0.01 * ramp_ * ramp_;
  }

  /// A word between straight wheels is near its circles.
  void look_near_circles(Formula formula, const Image& image, const Arcs& arcs) {
    auto [first, inner, last] = bounds::small_turns_of(formula);
    first.least -= bounds::wide(arcs.inner);
    last.least -= bounds::wide(arcs.inner);
    if (arcs.first < first.least * ramp_ || arcs.last < last.least * ramp_ ||
        arcs.inner < inner.least * ramp_) {
      return;
    }
    constexpr double vanishes = 1e-6;
    const auto saves = [&](const bounds::Small& turn, double arc, double most) {
      const bool may = arcs.line < 0 || bounds::may_wind(turn, arc, most / 2, ramp_);
      return may ? most : 0;
    };
    // Where an end vanishes, the step beside it may save as much as any.
    const bool has_ends =
        arcs.first > first.gone * ramp_ + vanishes && arcs.last > last.gone * ramp_ + vanishes;
    const double saved = has_ends ? saves(first, arcs.first, image.first_saves) +
                                        saves(last, arcs.last, image.last_saves)
                                  : image.view->most_saved();
    const double length = bounds::length_near(formula, arcs, ramp_) - saved;
    if (image.view->task->windings.length() + length >= best_) return;
    const bool may_be_full = std::min(arcs.first, arcs.last) > ramp_ - vanishes;
    const auto word =
        may_be_full ? solver_.at_full_lock(formula, image.stops(), arcs) : std::nullopt;
    if (word) {
      consider(*word, image);
    } else if (Open* open = opened(formula, image, length)) {
      open->guess = guess_near(formula, arcs);
    }
  }

  /// A word about as long as that of Reeds and Shepp.
  void add_sharp(const Kind& kind, const Image& image, const std::optional<Arcs>& circles) {
    const auto& [x, y, a, s, c] = image.frame;
    Arcs sharp = in_one_turn(kind.arcs(Circles({x, y, a}, {s, c})));
    const Steps& steps = steps_of(kind.formula);
    double length = driven_length(steps, sharp);
    if (image.view->most_saved() > 0) {
      length = bounds::signed_length(steps, sharp);
      if (circles) length = std::min(length, bounds::signed_length(steps, *circles));
    }
    // Where an end vanishes, the step beside it may save as much as any.
    constexpr double vanishes = 1e-6;
    const bool has_ends = std::min(sharp.first, sharp.last) > vanishes;
    length -= has_ends ? image.most_saved() : image.view->most_saved();
    Open* open = opened(kind.formula, image, length);
    if (open == nullptr) return;
    sharp.line -= 2 * solver_.turns().centre().x;
    open->guess = open->second_guess = sharp;
    if (!circles) return;
    const bool is_poor = std::min({circles->first, circles->inner, circles->last}) < 0;
    open->has_second = is_leg(stops_) && (is_poor || !is_quick_);
    (is_quick_ ? open->guess : open->second_guess) = guess_near(kind.formula, *circles);
  }

  /// The arcs of circles to begin with. From next to nothing a turn beside another moves badly.
  [[nodiscard]] Arcs guess_near(Formula formula, Arcs arcs) const {
    if (shape_of(formula, stops_).has_line) return arcs;
    const double least = 0.1 * ramp_;
    arcs.first = std::max(arcs.first, least);
    arcs.inner = std::max(arcs.inner, least);
    arcs.last = std::max(arcs.last, least);
    return arcs;
  }

  /// One more open word, which is not much shorter than `length`, nothing if that is too long.
  Open* opened(Formula formula, const Image& image, double length) {
    const double bound = image.view->task->windings.length() + length;
    if (bound >= best_ || count_ == open_.size()) return nullptr;
    Open& open = open_[count_++];
    open.formula = formula;
    open.image = image;
    open.has_second = false;
    open.bound = bound;
    return &open;
  }

  /// The open words in the order of their bounds, as long as one may be shorter; then none is left.
  void solve_open() {
    constexpr double same = 1e-9;  // bounds so near are equal: the word that was asked first
    const std::size_t words = std::exchange(count_, 0);
    for (std::size_t n = words; n > 0; --n) {
      std::size_t next = 0;
      for (std::size_t i = 1; i < words; ++i) {
        if (open_[i].bound < open_[next].bound - same) next = i;
      }
      Open& open = open_[next];
      if (open.bound >= best_) return;
      const auto word = solved(open);
      if (word) consider(*word, open.image);
      open.bound = std::numeric_limits<double>::infinity();
    }
  }

  [[nodiscard]] std::optional<SolvedWord> solved(const Open& open) const {
    const auto& [view, symmetry, frame, first_saves, last_saves] = open.image;
    // So long is a turn that drives a winding back: its clothoids are as long as that.
    const double part = stops_.inside ? 0.5 : 1;
    const Patience quick{12,
                         is_quick_ ? 4 : 12,
                         best_ - view->task->windings.length(),
                         {first_saves, part * first_saves},
                         {last_saves, part * last_saves},
                         view->most_saved()};
    const Stops stops = open.image.stops();
    const auto word = solver_.solve(open.formula, stops, frame, open.guess, quick);
    if (word || !open.has_second) return word;
    return solver_.solve(open.formula, stops, frame, open.second_guess, quick);
  }

  void consider(const SolvedWord& word, const Image& image) {
    constexpr double tie = 1e-13;  // then the word that was asked first
    const View& view = *image.view;
    const Windings& windings = view.task->windings;
    const bool begins_and_ends = word.lengths[0] != 0 && word.lengths[2] != 0;
    const double most_saved = begins_and_ends ? image.most_saved() : view.most_saved();
    double length = windings.length() + word.length;
    if (length - most_saved >= best_) return;
    const FoundWord found{word, image.made()};
    if (most_saved > 0) length -= saved(solver_, found, windings);
    if (length >= best_ * (1 - tie)) return;
    best_ = length;
    least_ = {static_cast<std::size_t>(view.task - tasks_.data()), found, length};
  }

  const WordSolver& solver_;
  std::span<const WordTask> tasks_;
  Stops stops_;
  const List& list_;
  double ramp_;
  bool is_quick_;                 ///< looks at what the lists say, which were measured for it
  std::array<Joints, 2> joints_;  ///< for words from the start, and from the goal
  double high_;
  double best_;
  std::optional<LeastWord> least_;
  std::array<Open, 160> open_;
  std::size_t count_ = 0;
};

}  // namespace

std::optional<LeastWord> least_word(const WordSolver& solver, std::span<const WordTask> tasks,
                                    double cutoff, Looked looked) {
  return Search(solver, tasks, cutoff, looked).run();
}

}  // namespace vandplan::steering
