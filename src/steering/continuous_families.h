// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words of continuous steering lead from one pose to another?

#include <optional>
#include <vector>

#include "steering/continuous_word.h"
#include "steering/mean_frame.h"

namespace vandplan::steering {

/// A word as a symmetry of the mean frame makes it.
struct FoundWord {
  SolvedWord word;
  Symmetry symmetry{};
};

/// Every word of the families between the poses of a frame, at most one of each formula and
/// symmetry.
[[nodiscard]] std::vector<FoundWord> all_words(const WordSolver& solver, const MeanFrame& frame,
                                               bool jumps);

/// The shortest of them, if it is shorter than `cutoff`.
[[nodiscard]] std::optional<FoundWord> least_word(const WordSolver& solver, const MeanFrame& frame,
                                                  bool jumps, double cutoff) noexcept;

}  // namespace vandplan::steering
