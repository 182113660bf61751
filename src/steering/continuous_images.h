// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is the image of a word under a symmetry, and how much may it save by driving windings back?

#include <cstddef>

#include "steering/continuous_families.h"
#include "steering/continuous_kinds.h"
#include "steering/continuous_shortlists.h"

namespace vandplan::steering::images {

using namespace families;

/// How a word of the folded frame has to begin (or end) to drive a winding back, and the length
/// that it saves then.
struct Back {
  shortlists::Way way;
  double saved;
};

inline Back back_of(const Winding& winding, const Symmetry& undo) {
  if (winding.length <= 0) return {shortlists::no_way, 0};
  return {shortlists::way_of(winding.gear, winding.side) ^ shortlists::flips_of(undo),
          2 * winding.length};
}

/// A task, with values that the search uses again and again.
struct View {
  const WordTask* task;
  Symmetry undo;  ///< symmetry from the folded frame to the frame of the task
  Back first, last;
  double least;            ///< bound of the length of windings and word, before savings
  shortlists::Rows worth;  ///< rows of the list that are worth a look

  /// Largest length that any word saves.
  [[nodiscard]] double most_saved() const { return first.saved + last.saved; }
};

/// A frame of a task, and the symmetry that makes it from the folded frame.
struct Seen {
  const WordFrame* frame;
  Symmetry symmetry;
};

/// The image of a word under a symmetry of a frame of a task.
struct Image {
  const View* view;
  Seen seen;
  Symmetry of_seen;                ///< symmetry of `seen.frame`
  Symmetry symmetry;               ///< symmetry of the folded frame: both of `seen` and `of_seen`
  double first_saves, last_saves;  ///< largest lengths saved by the first and by the last step

  [[nodiscard]] double most_saved() const { return first_saves + last_saves; }

  [[nodiscard]] WordFrame frame() const { return families::image_of(*seen.frame, of_seen); }
  [[nodiscard]] Symmetry made() const { return both(view->undo, symmetry); }
  [[nodiscard]] Stops stops() const { return seen_by(made(), view->task->stops); }
};

/// The image of the word of a kind under the symmetry `of_seen` of a frame.
inline Image image_of(const View& view, const Kind& kind, const Seen& seen,
                      const Symmetry& of_seen) {
  const Symmetry made = both(seen.symmetry, of_seen);
  if (view.most_saved() == 0) return {&view, seen, of_seen, made, 0, 0};
  const auto [first, last] = shortlists::ways_of(kind, made);
  // Tables, because branches would be mispredicted: any image may save something.
  const double may_save[] = {0, view.first.saved, 0, view.last.saved};
  const double saves[] = {may_save[first == view.first.way ? 1 : 0],
                          may_save[last == view.last.way ? 3 : 2]};
  const std::size_t swapped = made.swaps_ends() ? 1 : 0;
  return {&view, seen, of_seen, made, saves[swapped], saves[1 - swapped]};
}

}  // namespace vandplan::steering::images
