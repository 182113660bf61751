// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a word look as a symmetry makes it, and how much may it save beside windings?

#include <cstddef>

#include "steering/continuous_families.h"
#include "steering/continuous_kinds.h"
#include "steering/continuous_shortlists.h"

namespace vandplan::steering::images {

using namespace families;

/// How a word of the folded frame has to begin (or end) so that it drives a winding back, and how
/// much it saves by that.
struct Back {
  shortlists::Way way;
  double saved;
};

inline Back back_of(const Winding& winding, const Symmetry& undo) {
  if (winding.length <= 0) return {shortlists::no_way, 0};
  return {shortlists::way_of(winding.gear, winding.side) ^ shortlists::flips_of(undo),
          2 * winding.length};
}

/// A task, with what the search asks of it again and again.
struct View {
  const WordTask* task;
  Symmetry undo;  ///< from the folded frame
  Back first, last;
  double least;            ///< no path of a word is shorter, less what it saves
  shortlists::Rows worth;  ///< the rows of the list that are worth a look

  /// By any word.
  [[nodiscard]] double most_saved() const { return first.saved + last.saved; }
};

/// A frame of a task, which is a symmetry of its folded frame.
struct Seen {
  const WordFrame* frame;
  Symmetry symmetry;
};

/// A word of a task as a symmetry of a frame of it makes it.
struct Image {
  const View* view;
  Seen seen;
  Symmetry of_seen;
  Symmetry symmetry;               ///< of the folded frame
  double first_saves, last_saves;  ///< no such word saves more by its first and by its last step

  [[nodiscard]] double most_saved() const { return first_saves + last_saves; }

  [[nodiscard]] WordFrame frame() const { return families::image_of(*seen.frame, of_seen); }
  [[nodiscard]] Symmetry made() const { return both(view->undo, symmetry); }
  [[nodiscard]] Stops stops() const { return seen_by(made(), view->task->stops); }
};

/// An image of a word of a kind.
inline Image image_of(const View& view, const Kind& kind, const Seen& seen,
                      const Symmetry& of_seen) {
  const Symmetry made = both(seen.symmetry, of_seen);
  if (view.most_saved() == 0) return {&view, seen, of_seen, made, 0, 0};
  const auto [first, last] = shortlists::ways_of(kind, made);
  // No branches: nobody foresees which images save something.
  const double may_save[] = {0, view.first.saved, 0, view.last.saved};
  const double saves[] = {may_save[first == view.first.way ? 1 : 0],
                          may_save[last == view.last.way ? 3 : 2]};
  const std::size_t swapped = made.swaps_ends() ? 1 : 0;
  return {&view, seen, of_seen, made, saves[swapped], saves[1 - swapped]};
}

}  // namespace vandplan::steering::images
