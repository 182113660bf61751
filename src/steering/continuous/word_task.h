// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which two poses does a word join, and what may it save of the clothoids before and after it?

#include "steering/continuous/word_solver.h"
#include "steering/mean_frame.h"

namespace vandplan::steering::continuous {

/// A clothoid that straightens the wheels before a word, or turns them after it. A word that begins
/// (ends) by driving the clothoid back saves both.
struct Winding {
  double gear = 1.0;    ///< gear in which a word drives the clothoid back: 1 or -1
  double side = 0.0;    ///< side of its curvature: 1 left, -1 right
  double length = 0.0;  ///< length [turning radii]; 0: there is no winding
};

struct Windings {
  Winding start, goal;

  [[nodiscard]] double length() const { return start.length + goal.length; }
};

/// Two poses to join by a word, and the windings before and after it.
struct WordTask {
  WordTask() = default;
  WordTask(const MeanFrame& between, const Windings& around, const Stops& at) noexcept;
  /// `half`: sine and cosine of the absolute half turn of `between`.
  WordTask(const MeanFrame& between, const Windings& around, const Stops& at,
           const base::SinCos& half) noexcept;

  MeanFrame frame;
  Windings windings;
  Stops stops;
  WordFrame folded{};                            ///< `frame` with positive signs
  reeds_shepp_formulas::Solution reeds_shepp{};  ///< the Reeds-Shepp word in `folded`
};

/// A word, and the symmetry of the mean frame that maps it onto the task.
struct FoundWord {
  SolvedWord word;
  Symmetry symmetry{};
};

/// Length that a word in the frame of its task saves by driving windings back [turning radii].
[[nodiscard]] double saved_length(const WordSolver& solver, const FoundWord& found,
                                  const Windings& windings) noexcept;

}  // namespace vandplan::steering::continuous
