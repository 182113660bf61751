// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a word look as a symmetry makes it, and how much may it save beside windings?

#include <utility>

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
  double least;  ///< no path of a word is shorter, less what it saves

  /// By any word.
  [[nodiscard]] double most_saved() const { return first.saved + last.saved; }
};

/// A word of a task as a symmetry of its folded frame makes it.
struct Image {
  const View* view;
  Symmetry symmetry;
  WordFrame frame;
  double first_saves, last_saves;  ///< no such word saves more by its first and by its last step

  [[nodiscard]] double most_saved() const { return first_saves + last_saves; }

  [[nodiscard]] Symmetry made() const { return both(view->undo, symmetry); }
  [[nodiscard]] Stops stops() const { return seen_by(made(), view->task->stops); }
};

/// An image of a word of a kind; `frame` is that of `seen`, a symmetry of the folded frame.
inline Image image_of(const View& view, const Kind& kind, const Symmetry& seen,
                      const WordFrame& frame, const Symmetry& symmetry) {
  const Symmetry made = both(seen, symmetry);
  Image image{&view, made, families::image_of(frame, symmetry), 0, 0};
  if (view.most_saved() > 0) {
    const auto [first, last] = shortlists::ways_of(kind, made);
    image.first_saves = first == view.first.way ? view.first.saved : 0;
    image.last_saves = last == view.last.way ? view.last.saved : 0;
    if (made.swaps_ends()) std::swap(image.first_saves, image.last_saves);
  }
  return image;
}

}  // namespace vandplan::steering::images
