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
#include "steering/continuous_looks.h"
#include "steering/continuous_open.h"
#include "steering/continuous_shortlists.h"

namespace vandplan::steering {
namespace {

using namespace families;
using images::Back, images::Image, images::Seen, images::View;
using images::back_of, images::image_of;
using looks::Lows, looks::Room;
using open_words::Open, open_words::OpenWords;
using shortlists::List, shortlists::Rows;

const List& list_with(const Stops& stops) {
  if (is_leg(stops)) return shortlists::leg_list;
  return stops.inside ? shortlists::standing_list : shortlists::rolling_list;
}

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
        room_{ramp_, std::min(1.0, 0.4 + 1.6 * ramp_)},
        best_(cutoff) {}

  std::optional<LeastWord> run() {
    sort_views();
    if (!look_at_circles()) {
      for (std::size_t i = 0; i < views_; ++i) {
        if (view_[i].least - view_[i].most_saved() < best_) look_at(view_[i]);
        if (is_quick_ && stops_.inside) solve_open();  // otherwise after the last view
      }
    }
    solve_open();
    return least_;
  }

 private:
  /// Fills `view_` with views of the tasks, the most promising first.
  void sort_views() {
    if (tasks_.size() == 1) {
      view_[views_++] = view_of(tasks_[0]);
      return;
    }
    std::array<View, 4> views;
    std::array<double, 4> promise;
    for (const WordTask& task : tasks_) {
      views[views_] = view_of(task);
      promise[views_] = views[views_].least - image_of_sharp(views[views_]).most_saved();
      ++views_;
    }
    for (std::size_t i = 0; i < views_; ++i) {
      std::size_t before = 0;
      for (std::size_t j = 0; j < views_; ++j) {
        before += (j < i ? promise[j] <= promise[i] : promise[j] < promise[i]) ? 1 : 0;
      }
      view_[before] = views[i];
    }
  }

  /// Looks at the circles of all views at once. Returns false if it did not: it works for likely
  /// words that never jump, between poses neither too near nor too far.
  bool look_at_circles() {
    // One view, of straight ends, has so few words that one after the other is as fast.
    if (views_ == 1 || stops_.inside || !is_quick_) return false;
    looks::Looks looks;
    std::array<std::size_t, 8> ends;
    for (std::size_t i = 0; i < views_; ++i) {
      const View& view = view_[i];
      const WordFrame& f = view.task->folded;
      if (is_tiny(f) || !(f.x + f.y < 1e50)) return false;
      const bool is_short = view.least - view.most_saved() < best_;
      looks.add(is_short ? rows_of(view) : 0, f, ramp_);
      ends[2 * i] = looks.count();
      if (const Rows rows = is_short ? rows_of_other_way(view) : 0) {
        looks.add(rows, *other_way(view).frame, ramp_);
      }
      ends[2 * i + 1] = looks.count();
    }
    if (!looks.work_out(joints_[0], room_)) return false;
    std::size_t next = 0;
    for (std::size_t i = 0; i < views_; ++i) {
      const View& view = view_[i];
      if (view.least - view.most_saved() < best_) {
        look_at_line(view);
        for (; next < ends[2 * i]; ++next) take(looks, looks[next], view, folded(view));
        look_at_short(view);
        const Seen other{&other_[i], {true, true, true}};
        for (; next < ends[2 * i + 1]; ++next) take(looks, looks[next], view, other);
      }
      next = ends[2 * i + 1];
    }
    return true;
  }

  /// Takes up a word whose circles are worked out.
  void take(const looks::Looks& looks, const looks::Look& look, const View& view,
            const Seen& seen) {
    const double length = looks.length(look);
    if (view.task->windings.length() + (length - view.most_saved()) >= best_) return;
    const shortlists::Likely& row = list_.rows[look.row];
    const Kind& kind = kinds[row.kind];
    const Image image = image_of(view, kind, seen, row.symmetry);
    if (view.least - image.most_saved() >= best_) return;
    look_near_circles(kind.formula, image, looks.arcs(look), length);
  }

  static Seen folded(const View& view) { return {&view.task->folded, none}; }

  [[nodiscard]] View view_of(const WordTask& task) const {
    const auto& [start, goal] = task.windings;
    const Symmetry undo = unfolding(task.frame);
    View view{&task, undo, back_of(start, undo), back_of(goal, undo), 0, 0};
    if (undo.swaps_ends()) std::swap(view.first, view.last);
    view.least = task.windings.length() + task.sharp.arcs.length;
    if (!stops_.inside && is_quick_) view.least += bounds::least_added(task.sharp, ramp_);
    view.worth = worth_a_look(view);
    return view;
  }

  /// Image of the Reeds-Shepp word of a view.
  static Image image_of_sharp(const View& view) {
    const auto kind = static_cast<std::size_t>(view.task->sharp.formula);
    return image_of(view, kinds[kind], folded(view), none);
  }

  void look_at(const View& view) {
    look_at_line(view);
    look_at_rows(view, rows_of(view), folded(view));
    look_at_short(view);
    if (const Rows rows = rows_of_other_way(view)) look_at_rows(view, rows, other_way(view));
    if (!is_quick_ && view.most_saved() > 0) look_at_all_that_save(view);
  }

  /// Considers a line alone, if the goal is straight ahead.
  void look_at_line(const View& view) {
    const auto& [x, y, a, s, c] = view.task->folded;
    if (!is_line({x, y, a})) return;
    const Image line = image_of(view, kinds[0], folded(view), none);
    consider(SolvedWord{Formula::lsl, line.stops(), {0, x, 0}, 0, x}, line);
  }

  /// Rows to look at in the frame of `other_way`, which is as good if the headings are opposite.
  [[nodiscard]] Rows rows_of_other_way(const View& view) const {
    const double missing = std::numbers::pi / 2 - view.task->folded.a;
    if (missing >= 0.05 + 0.6 * ramp_) return 0;
    const bool any = stops_.inside || !is_quick_ || missing < 0.05;
    return view.worth & (any ? list_.likely : list_.half_turns);
  }

  /// Frame of a view with the heading turned the other way round.
  Seen other_way(const View& view) {
    const WordFrame& f = view.task->folded;
    WordFrame& other = other_[static_cast<std::size_t>(&view - view_.data())];
    other = word_frame({f.x, f.y, f.a + 2 * (std::numbers::pi / 2 - f.a)});
    return {&other, {true, true, true}};
  }

  /// Rows that are worth a look, given the Reeds-Shepp word of a view.
  [[nodiscard]] Rows worth_a_look(const View& view) const {
    if (!is_quick_) return list_.likely;
    const reeds_shepp_formulas::Solution& sharp = view.task->sharp;
    const auto formula = static_cast<std::size_t>(sharp.formula);
    const auto [first, last] = std::pair(view.first.way, view.last.way);
    return bounds::is_on_border(sharp)
               ? list_.likely | list_.first_way[first] | list_.last_way[last]
               : list_.here[formula][first][last];
  }

  /// Rows whose words may be shorter than the best. A row counts with what it can save: at both
  /// ends, at one end, or not at all.
  [[nodiscard]] Rows short_enough(const View& view) const {
    if (!is_quick_ || view.least < best_) return ~Rows{0};
    const Rows first = list_.first_way[view.first.way];
    const Rows last = list_.last_way[view.last.way];
    Rows rows = first & last;
    if (view.least - view.first.saved < best_) rows |= first;
    if (view.least - view.last.saved < best_) rows |= last;
    return rows;
  }

  /// Rows of a view to look at.
  [[nodiscard]] Rows rows_of(const View& view) const {
    const WordFrame& f = view.task->folded;
    const Rows rows = view.worth & short_enough(view);
    const double most = 4 * (joints_[0].stop + joints_[0].reach);
    const bool is_far = f.x * f.x + f.y * f.y > most * most;
    return is_far ? rows & ~list_.arcs : rows;
  }

  /// Looks at rows as images of a frame.
  void look_at_rows(const View& view, Rows rows, const Seen& seen) {
    for (; rows != 0; rows &= rows - 1) {
      const auto& row = list_.rows[static_cast<std::size_t>(std::countr_zero(rows))];
      look_at_row(row, image_of(view, kinds[row.kind], seen, row.symmetry));
    }
  }

  void look_at_row(const shortlists::Likely& row, const Image& image) {
    const Stops stops = image.stops();
    look_at(kinds[row.kind], image,
            {ramp_ * row.first.where(stops.start), ramp_ * row.last.where(stops.goal)});
  }

  /// Looks at a line between small turns, if it is too short for circles at full lock.
  void look_at_short(const View& view) {
    const auto& [x, y, a, s, c] = view.task->folded;
    if ((view.worth & 3) == 0 || x * x + y * y >= 9 * ramp_ * ramp_) return;
    const Rows rows = view.worth & short_enough(view);
    const Circles circles({x, y, a}, {s, c});
    const auto look = [&](const Kind& kind) {
      const Arcs sharp = kind.arcs(circles);
      // With larger turns, which reach full lock, the word is found by its circles.
      if (is_quick_ && !stops_.inside && std::max(sharp.first, sharp.last) > ramp_) return;
      add_sharp(kind, image_of(view, kind, folded(view), none), std::nullopt);
    };
    if ((rows & 1) != 0) look(kinds[0]);
    if ((rows & 2) != 0 && circles.lr >= 0) look(kinds[1]);
  }

  /// Looks at all images that may save a winding, for searches to which the lists do not apply.
  void look_at_all_that_save(const View& view) {
    for_each_symmetry([&](const Kind& kind, const Symmetry& symmetry) {
      const Image image = image_of(view, kind, folded(view), symmetry);
      if (image.most_saved() > 0) look_at(kind, image, {ramp_ / 2, ramp_ / 2});
    });
  }

  void look_at(const Kind& kind, const Image& image, const Lows& lows) {
    if (image.view->least - image.most_saved() >= best_) return;
    const Joints& joints = joints_[image.made().swaps_ends() ? 1 : 0];
    const Formula formula = kind.formula;
    const bool is_near_circles = !stops_.inside && is_quick_;
    if (is_near_circles && !is_tiny(*image.seen.frame)) {
      const auto word = looks::near_word(formula, image.frame(), joints, room_, lows);
      if (word) look_near_circles(formula, image, word->arcs, word->length);
      return;
    }
    const CircleWord circles = circles::word_of(formula, image.frame(), joints);
    const auto found = is_near_circles ? looks::likely_arcs(formula, circles, room_, lows)
                                       : looks::likely_arcs_at_stops(formula, circles, room_, lows);
    if (!found) return;
    if (const auto word = solver_.at_full_lock(formula, image.stops(), *found)) {
      consider(*word, image);
    } else {
      add_sharp(kind, image, stops_.inside ? found : std::nullopt);
    }
  }

  /// Whether the goal is so near that circles at full lock tell nothing about a word.
  [[nodiscard]] bool is_tiny(const WordFrame& f) const {
    return f.x * f.x + f.y * f.y < 0.01 * ramp_ * ramp_;
  }

  /// Looks at a word between straight wheels by its circles; `near` is its estimated length.
  /// Always inlined: otherwise a call takes 1.02 times as long.
  [[gnu::always_inline]] void look_near_circles(Formula formula, const Image& image,
                                                const Arcs& arcs, double near) {
    constexpr double vanishes = 1e-6;
    const double length = near - looks::most_saved_near(formula, image, arcs, ramp_);
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

  /// Adds an open word, with the Reeds-Shepp word of its letters as guess and bound.
  void add_sharp(const Kind& kind, const Image& image, const std::optional<Arcs>& circles) {
    const auto [x, y, a, s, c] = image.frame();
    Arcs sharp = in_one_turn(kind.arcs(Circles({x, y, a}, {s, c})));
    const Steps& steps = steps_of(kind.formula);
    double length = driven_length(steps, sharp);
    if (image.view->most_saved() > 0) {
      length = bounds::signed_length(steps, sharp);
      if (circles) length = std::min(length, bounds::signed_length(steps, *circles));
    }
    // If an end step vanishes, the step beside it may save as much as any word.
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

  /// Guess from arcs by circles. Newton's method moves badly from a tiny turn beside another turn.
  [[nodiscard]] Arcs guess_near(Formula formula, Arcs arcs) const {
    if (shape_of(formula, stops_).has_line) return arcs;
    const double least = 0.1 * ramp_;
    arcs.first = std::max(arcs.first, least);
    arcs.inner = std::max(arcs.inner, least);
    arcs.last = std::max(arcs.last, least);
    return arcs;
  }

  /// Adds an open word not much shorter than `length`; null if it is too long or there is no room.
  Open* opened(Formula formula, const Image& image, double length) {
    const double bound = image.view->task->windings.length() + length;
    return bound < best_ ? open_.add(formula, image, bound) : nullptr;
  }

  /// Solves open words in the order of their bounds, while one may be the best; drops the others.
  void solve_open() {
    while (const Open* open = open_.next(best_)) {
      if (const auto word = solved(*open)) consider(*word, open->image);
    }
    open_.clear();
  }

  [[nodiscard]] std::optional<SolvedWord> solved(const Open& open) const {
    const View* view = open.image.view;
    const double first_saves = open.image.first_saves, last_saves = open.image.last_saves;
    const WordFrame frame = open.image.frame();
    // A turn that drives a winding back has clothoids as long as the winding, one or both.
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
    constexpr double tie = 1e-13;  // relative; of equal words the first one stays
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
  bool is_quick_;                 ///< whether the measured lists apply
  std::array<Joints, 2> joints_;  ///< joints of words from the start, and from the goal
  Room room_;
  double best_;
  std::optional<LeastWord> least_;
  std::array<View, 4> view_;
  std::array<WordFrame, 4> other_;  ///< frames of `other_way`, one for each view
  std::size_t views_ = 0;
  OpenWords open_;
};

}  // namespace

std::optional<LeastWord> least_word(const WordSolver& solver, std::span<const WordTask> tasks,
                                    double cutoff, Looked looked) {
  return Search(solver, tasks, cutoff, looked).run();
}

}  // namespace vandplan::steering
