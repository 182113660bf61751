// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words may be the shortest of a task, and how much may they save by driving windings back?

#include <cstddef>

#include "steering/continuous/mirrored_task.h"
#include "steering/continuous/shortlist.h"
#include "steering/continuous/word_task.h"

namespace vandplan::steering::continuous {

/// The letter with which a word of the folded frame has to begin (or end) to drive a winding back,
/// and the length that it saves then.
struct Saving {
  shortlists::Letter letter;
  double length;
};

inline Saving saving_of(const Winding& winding, const Symmetry& undo) {
  if (winding.length <= 0) return {shortlists::no_letter, 0};
  return {shortlists::letter_of(winding.gear, winding.side) ^ shortlists::flips_of(undo),
          2 * winding.length};
}

/// A task, with values that the search uses again and again.
struct PreparedTask {
  const WordTask* task;
  Symmetry undo;  ///< symmetry from the folded frame to the frame of the task
  Saving first, last;
  double lower_bound;       ///< practical bound of the length of windings and word, before savings
  shortlists::RowSet rows;  ///< rows of the shortlist that may be shortest

  /// Largest length that any word saves.
  [[nodiscard]] double max_saving() const { return first.length + last.length; }
};

/// A frame of a task, and the symmetry that makes it from the folded frame.
struct TaskFrame {
  const WordFrame* frame;
  Symmetry symmetry;
};

/// The word of a formula under a symmetry.
struct Candidate {
  Formula formula;
  const PreparedTask* task;
  TaskFrame base;
  Symmetry of_base;                  ///< symmetry of `base.frame`
  Symmetry symmetry;                 ///< symmetry of the folded frame: `of_base`, then `base`'s
  double first_saving, last_saving;  ///< largest lengths saved by the first and by the last step

  [[nodiscard]] double max_saving() const { return first_saving + last_saving; }

  /// The mirrored frame, in which the formula holds.
  [[nodiscard]] WordFrame frame() const { return mirrored(*base.frame, of_base); }
  /// The symmetry that maps the word onto the task.
  [[nodiscard]] Symmetry onto_task() const { return combined(task->undo, symmetry); }
  [[nodiscard]] Stops stops() const { return mirrored(task->task->stops, onto_task()); }
};

/// The word of a formula under the symmetry `of_base` of a frame.
inline Candidate candidate_of(const PreparedTask& task, Formula formula, const TaskFrame& base,
                              const Symmetry& of_base) {
  const Symmetry symmetry = combined(base.symmetry, of_base);
  if (task.max_saving() == 0) return {formula, &task, base, of_base, symmetry, 0, 0};
  const auto [first, last] = shortlists::end_letters_of(formula, symmetry);
  // Tables, because branches would be mispredicted: any word may save something.
  const double may_save[] = {0, task.first.length, 0, task.last.length};
  const double saves[] = {may_save[first == task.first.letter ? 1 : 0],
                          may_save[last == task.last.letter ? 3 : 2]};
  const std::size_t swapped = symmetry.swaps_ends() ? 1 : 0;
  return {formula, &task, base, of_base, symmetry, saves[swapped], saves[1 - swapped]};
}

}  // namespace vandplan::steering::continuous
