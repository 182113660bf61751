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

#include "steering/continuous/bounds.h"
#include "steering/continuous/candidate.h"
#include "steering/continuous/circle_batch.h"
#include "steering/continuous/estimates.h"
#include "steering/continuous/mirrored_task.h"
#include "steering/continuous/shortlist.h"
#include "steering/continuous/unsolved_words.h"
#include "steering/continuous/word_search.h"

namespace vandplan::steering::continuous {
namespace {

using shortlists::RowSet, shortlists::Shortlist;

const Shortlist& shortlist_with(const Stops& stops) {
  if (is_leg(stops)) return shortlists::leg_shortlist;
  return stops.inside ? shortlists::standing_shortlist : shortlists::rolling_shortlist;
}

/// The quick search for the shortest word.
class ShortestWordSearch {
 public:
  ShortestWordSearch(const WordSolver& solver, std::span<const WordTask> tasks, double cutoff,
                     SearchBreadth breadth)
      : solver_(solver),
        given_(tasks),
        stops_(tasks[0].stops),
        list_(shortlist_with(stops_)),
        ramp_(solver.turns().ramp()),
        is_quick_(breadth == SearchBreadth::likely && ramp_ <= shortlists::longest_ramp),
        joints_{Joints(solver.turns(), stops_), Joints(solver.turns(), stops_.swapped())},
        limits_{ramp_, std::min(1.0, 0.4 + 1.6 * ramp_)},
        best_(cutoff) {}

  std::optional<ShortestWord> run() {
    prepare_tasks();
    if (!try_batch()) {
      for (std::size_t i = 0; i < count_; ++i) {
        if (tasks_[i].lower_bound - tasks_[i].max_saving() < best_) try_task(tasks_[i]);
        if (is_quick_ && stops_.inside) solve_words();  // otherwise after the last task
      }
    }
    solve_words();
    return shortest_;
  }

 private:
  /// Fills `tasks_`, the most promising first.
  void prepare_tasks() {
    if (given_.size() == 1) {
      tasks_[count_++] = prepared(given_[0]);
      return;
    }
    std::array<PreparedTask, 4> tasks;
    std::array<double, 4> promise;
    for (const WordTask& task : given_) {
      tasks[count_] = prepared(task);
      promise[count_] = tasks[count_].lower_bound - reeds_shepp_word(tasks[count_]).max_saving();
      ++count_;
    }
    for (std::size_t i = 0; i < count_; ++i) {
      std::size_t before = 0;
      for (std::size_t j = 0; j < count_; ++j) {
        before += (j < i ? promise[j] <= promise[i] : promise[j] < promise[i]) ? 1 : 0;
      }
      tasks_[before] = tasks[i];
    }
  }

  /// Works out the circles of all tasks at once, and tries their words. Returns false if it did
  /// not: it works for likely words that never jump, between poses neither too near nor too far.
  bool try_batch() {
    // One task, of straight ends, has so few words that one after the other is as fast.
    if (count_ == 1 || stops_.inside || !is_quick_) return false;
    CircleBatch batch;
    std::array<std::size_t, 8> ends;
    for (std::size_t i = 0; i < count_; ++i) {
      const PreparedTask& task = tasks_[i];
      const WordFrame& f = task.task->folded;
      if (is_tiny(f) || !(f.x + f.y < 1e50)) return false;
      const bool is_short = task.lower_bound - task.max_saving() < best_;
      batch.add(is_short ? rows_of(task) : 0, f, ramp_);
      ends[2 * i] = batch.count();
      if (const RowSet rows = is_short ? rows_of_opposite_turn(task) : 0) {
        batch.add(rows, *opposite_turn(task).frame, ramp_);
      }
      ends[2 * i + 1] = batch.count();
    }
    if (!batch.work_out(joints_[0], limits_)) return false;
    std::size_t next = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const PreparedTask& task = tasks_[i];
      if (task.lower_bound - task.max_saving() < best_) {
        try_line(task);
        for (; next < ends[2 * i]; ++next) try_entry(batch, batch[next], task, folded_frame(task));
        try_short_line(task);
        const TaskFrame opposite{&opposite_[i], {true, true, true}};
        for (; next < ends[2 * i + 1]; ++next) try_entry(batch, batch[next], task, opposite);
      }
      next = ends[2 * i + 1];
    }
    return true;
  }

  /// Tries a word whose circles are worked out.
  void try_entry(const CircleBatch& batch, const BatchEntry& entry, const PreparedTask& task,
                 const TaskFrame& frame) {
    const double length = batch.length(entry);
    if (task.task->windings.length() + (length - task.max_saving()) >= best_) return;
    const shortlists::Row& row = list_.rows[entry.row];
    const Candidate candidate = candidate_of(task, row.formula, frame, row.symmetry);
    if (task.lower_bound - candidate.max_saving() >= best_) return;
    try_estimated(candidate, batch.arcs(entry), length);
  }

  static TaskFrame folded_frame(const PreparedTask& task) { return {&task.task->folded, identity}; }

  [[nodiscard]] PreparedTask prepared(const WordTask& task) const {
    const auto& [start, goal] = task.windings;
    const Symmetry undo = unfolding(task.frame);
    PreparedTask made{&task, undo, saving_of(start, undo), saving_of(goal, undo), 0, 0};
    if (undo.swaps_ends()) std::swap(made.first, made.last);
    made.lower_bound = task.windings.length() + task.reeds_shepp.arcs.length;
    if (!stops_.inside && is_quick_) {
      made.lower_bound += added_length_bound(task.reeds_shepp, ramp_);
    }
    made.rows = listed_rows(made);
    return made;
  }

  /// The word with the letters of the Reeds-Shepp word.
  static Candidate reeds_shepp_word(const PreparedTask& task) {
    return candidate_of(task, task.task->reeds_shepp.formula, folded_frame(task), identity);
  }

  void try_task(const PreparedTask& task) {
    try_line(task);
    try_rows(task, rows_of(task), folded_frame(task));
    try_short_line(task);
    if (const RowSet rows = rows_of_opposite_turn(task)) {
      try_rows(task, rows, opposite_turn(task));
    }
    if (!is_quick_ && task.max_saving() > 0) try_all_that_save(task);
  }

  /// Considers a line alone, if the goal is straight ahead.
  void try_line(const PreparedTask& task) {
    const auto& [x, y, a, s, c] = task.task->folded;
    if (!is_straight_ahead({x, y, a})) return;
    const Candidate line = candidate_of(task, Formula::lsl, folded_frame(task), identity);
    consider(SolvedWord{Formula::lsl, line.stops(), {0, x, 0}, 0, x}, line);
  }

  /// Rows to try with `opposite_turn`, which is as good if the headings are opposite.
  [[nodiscard]] RowSet rows_of_opposite_turn(const PreparedTask& task) const {
    const double missing = std::numbers::pi / 2 - task.task->folded.a;
    if (missing >= 0.05 + 0.6 * ramp_) return 0;
    const bool any = stops_.inside || !is_quick_ || missing < 0.05;
    return task.rows & (any ? list_.likely : list_.half_turns);
  }

  /// Frame of a task with the heading turned the other way round.
  TaskFrame opposite_turn(const PreparedTask& task) {
    const WordFrame& f = task.task->folded;
    WordFrame& frame = opposite_[static_cast<std::size_t>(&task - tasks_.data())];
    frame = word_frame({f.x, f.y, f.a + 2 * (std::numbers::pi / 2 - f.a)});
    return {&frame, {true, true, true}};
  }

  /// Rows that the shortlist has for the Reeds-Shepp word and the windings of a task.
  [[nodiscard]] RowSet listed_rows(const PreparedTask& task) const {
    if (!is_quick_) return list_.likely;
    const reeds_shepp_formulas::Solution& reeds_shepp = task.task->reeds_shepp;
    const auto formula = static_cast<std::size_t>(reeds_shepp.formula);
    const auto [first, last] = std::pair(task.first.letter, task.last.letter);
    return is_on_border(reeds_shepp)
               ? list_.likely | list_.by_first_letter[first] | list_.by_last_letter[last]
               : list_.candidates[formula][first][last];
  }

  /// Rows whose words may be shorter than the best. A row counts with what it can save: at both
  /// ends, at one end, or not at all.
  [[nodiscard]] RowSet short_enough(const PreparedTask& task) const {
    if (!is_quick_ || task.lower_bound < best_) return ~RowSet{0};
    const RowSet first = list_.by_first_letter[task.first.letter];
    const RowSet last = list_.by_last_letter[task.last.letter];
    RowSet rows = first & last;
    if (task.lower_bound - task.first.length < best_) rows |= first;
    if (task.lower_bound - task.last.length < best_) rows |= last;
    return rows;
  }

  /// Rows to try in the folded frame.
  [[nodiscard]] RowSet rows_of(const PreparedTask& task) const {
    const WordFrame& f = task.task->folded;
    const RowSet rows = task.rows & short_enough(task);
    const double longest = 4 * (joints_[0].stop + joints_[0].reach);
    const bool is_far = f.x * f.x + f.y * f.y > longest * longest;
    return is_far ? rows & ~list_.arcs : rows;
  }

  void try_rows(const PreparedTask& task, RowSet rows, const TaskFrame& frame) {
    for (; rows != 0; rows &= rows - 1) {
      const auto& row = list_.rows[static_cast<std::size_t>(std::countr_zero(rows))];
      try_row(row, candidate_of(task, row.formula, frame, row.symmetry));
    }
  }

  void try_row(const shortlists::Row& row, const Candidate& candidate) {
    const Stops stops = candidate.stops();
    try_candidate(candidate, {ramp_ * row.first.at(stops.start), ramp_ * row.last.at(stops.goal)});
  }

  /// Tries a line between small turns, if it is too short for circles at full lock.
  void try_short_line(const PreparedTask& task) {
    const auto& [x, y, a, s, c] = task.task->folded;
    if ((task.rows & 3) == 0 || x * x + y * y >= 9 * ramp_ * ramp_) return;
    const RowSet rows = task.rows & short_enough(task);
    const Circles circles({x, y, a}, {s, c});
    const auto try_formula = [&](Formula formula) {
      const Arcs arcs = arcs_of(formula, circles);
      // With larger turns, which reach full lock, the word is found by its circles.
      if (is_quick_ && !stops_.inside && std::max(arcs.first, arcs.last) > ramp_) return;
      add_by_reeds_shepp(candidate_of(task, formula, folded_frame(task), identity), std::nullopt);
    };
    if ((rows & 1) != 0) try_formula(Formula::lsl);
    if ((rows & 2) != 0 && circles.lr >= 0) try_formula(Formula::lsr);
  }

  /// Tries all words that may save a winding, for searches to which the shortlists do not apply.
  void try_all_that_save(const PreparedTask& task) {
    for_each_mirrored_formula([&](Formula formula, const Symmetry& symmetry) {
      const Candidate candidate = candidate_of(task, formula, folded_frame(task), symmetry);
      if (candidate.max_saving() > 0) try_candidate(candidate, {ramp_ / 2, ramp_ / 2});
    });
  }

  void try_candidate(const Candidate& candidate, const EndSlack& slack) {
    if (candidate.task->lower_bound - candidate.max_saving() >= best_) return;
    const Joints& joints = joints_[candidate.onto_task().swaps_ends() ? 1 : 0];
    const Formula formula = candidate.formula;
    const bool has_estimate = !stops_.inside && is_quick_;
    if (has_estimate && !is_tiny(*candidate.base.frame)) {
      const auto word = estimated_word(formula, candidate.frame(), joints, limits_, slack);
      if (word) try_estimated(candidate, word->arcs, word->length);
      return;
    }
    const CircleWord circles = circle_word_of(formula, candidate.frame(), joints);
    const auto found = has_estimate ? likely_arcs(formula, circles, limits_, slack)
                                    : likely_arcs_at_stops(formula, circles, limits_, slack);
    if (!found) return;
    if (const auto word = solver_.at_full_lock(formula, candidate.stops(), *found)) {
      consider(*word, candidate);
    } else {
      add_by_reeds_shepp(candidate, stops_.inside ? found : std::nullopt);
    }
  }

  /// Whether the goal is so near that circles at full lock tell nothing about a word.
  [[nodiscard]] bool is_tiny(const WordFrame& f) const {
    return f.x * f.x + f.y * f.y < 0.01 * ramp_ * ramp_;
  }

  /// Tries a word between straight wheels with the angles and the length that its circles estimate.
  /// Always inlined: otherwise a call takes 1.02 times as long.
  [[gnu::always_inline]] void try_estimated(const Candidate& candidate, const Arcs& arcs,
                                            double estimate) {
    constexpr double vanishes = 1e-6;
    const double length = estimate - max_saving_by_circles(candidate, arcs, ramp_);
    if (candidate.task->task->windings.length() + length >= best_) return;
    const bool may_be_full = std::min(arcs.first, arcs.last) > ramp_ - vanishes;
    const auto word = may_be_full ? solver_.at_full_lock(candidate.formula, candidate.stops(), arcs)
                                  : std::nullopt;
    if (word) {
      consider(*word, candidate);
    } else if (UnsolvedWord* added = add_unsolved(candidate, length)) {
      added->guess = guess_by_circles(candidate.formula, arcs);
    }
  }

  /// Adds an unsolved word, with the Reeds-Shepp word of its letters as guess and bound.
  void add_by_reeds_shepp(const Candidate& candidate, const std::optional<Arcs>& circles) {
    const auto [x, y, a, s, c] = candidate.frame();
    Arcs arcs = in_one_turn(arcs_of(candidate.formula, Circles({x, y, a}, {s, c})));
    const Steps& steps = steps_of(candidate.formula);
    double length = driven_length(steps, arcs);
    if (candidate.task->max_saving() > 0) {
      length = signed_length(steps, arcs);
      if (circles) length = std::min(length, signed_length(steps, *circles));
    }
    // If an end step vanishes, the step beside it may save as much as any word.
    constexpr double vanishes = 1e-6;
    const bool has_ends = std::min(arcs.first, arcs.last) > vanishes;
    length -= has_ends ? candidate.max_saving() : candidate.task->max_saving();
    UnsolvedWord* added = add_unsolved(candidate, length);
    if (added == nullptr) return;
    arcs.line -= 2 * solver_.turns().centre().x;
    added->guess = added->second_guess = arcs;
    if (!circles) return;
    const bool is_poor = std::min({circles->first, circles->inner, circles->last}) < 0;
    added->has_second = is_leg(stops_) && (is_poor || !is_quick_);
    (is_quick_ ? added->guess : added->second_guess) =
        guess_by_circles(candidate.formula, *circles);
  }

  /// Guess from arcs by circles. Newton's method moves badly from a tiny turn beside another turn.
  [[nodiscard]] Arcs guess_by_circles(Formula formula, Arcs arcs) const {
    if (shape_of(formula, stops_).has_line) return arcs;
    const double min_angle = 0.1 * ramp_;
    arcs.first = std::max(arcs.first, min_angle);
    arcs.inner = std::max(arcs.inner, min_angle);
    arcs.last = std::max(arcs.last, min_angle);
    return arcs;
  }

  /// Adds an unsolved word not much shorter than `length`; null if it is too long or the list full.
  UnsolvedWord* add_unsolved(const Candidate& candidate, double length) {
    const double bound = candidate.task->task->windings.length() + length;
    return bound < best_ ? unsolved_.add(candidate, bound) : nullptr;
  }

  /// Solves words in the order of their bounds, while one may be the best; drops the others.
  void solve_words() {
    while (const UnsolvedWord* next = unsolved_.next(best_)) {
      if (const auto word = solved(*next)) consider(*word, next->candidate);
    }
    unsolved_.clear();
  }

  [[nodiscard]] std::optional<SolvedWord> solved(const UnsolvedWord& word) const {
    const Candidate& candidate = word.candidate;
    const double first_saving = candidate.first_saving, last_saving = candidate.last_saving;
    const WordFrame frame = candidate.frame();
    // A turn that drives a winding back has clothoids as long as the winding, one or both.
    const double part = stops_.inside ? 0.5 : 1;
    const NewtonLimits quick{12,
                             is_quick_ ? 4 : 12,
                             best_ - candidate.task->task->windings.length(),
                             {first_saving, part * first_saving},
                             {last_saving, part * last_saving},
                             candidate.task->max_saving()};
    const Stops stops = candidate.stops();
    const auto found = solver_.solve(candidate.formula, stops, frame, word.guess, quick);
    if (found || !word.has_second) return found;
    return solver_.solve(candidate.formula, stops, frame, word.second_guess, quick);
  }

  void consider(const SolvedWord& word, const Candidate& candidate) {
    constexpr double tie = 1e-13;  // relative; of equal words the first one stays
    const PreparedTask& task = *candidate.task;
    const Windings& windings = task.task->windings;
    const bool begins_and_ends = word.lengths[0] != 0 && word.lengths[2] != 0;
    const double max_saving = begins_and_ends ? candidate.max_saving() : task.max_saving();
    double length = windings.length() + word.length;
    if (length - max_saving >= best_) return;
    const FoundWord found{word, candidate.onto_task()};
    if (max_saving > 0) length -= saved_length(solver_, found, windings);
    if (length >= best_ * (1 - tie)) return;
    best_ = length;
    shortest_ = {static_cast<std::size_t>(task.task - given_.data()), found, length};
  }

  const WordSolver& solver_;
  std::span<const WordTask> given_;
  Stops stops_;
  const Shortlist& list_;
  double ramp_;
  bool is_quick_;                 ///< whether the measured shortlists apply
  std::array<Joints, 2> joints_;  ///< joints of words from the start, and from the goal
  AngleLimits limits_;
  double best_;
  std::optional<ShortestWord> shortest_;
  std::array<PreparedTask, 4> tasks_;
  std::array<WordFrame, 4> opposite_;  ///< frames of `opposite_turn`, one for each task
  std::size_t count_ = 0;              ///< number of tasks
  UnsolvedWords unsolved_;
};

}  // namespace

std::optional<ShortestWord> shortest_word(const WordSolver& solver, std::span<const WordTask> tasks,
                                          double cutoff, SearchBreadth breadth) {
  return ShortestWordSearch(solver, tasks, cutoff, breadth).run();
}

}  // namespace vandplan::steering::continuous
