// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words of continuous steering join two poses, for whoever minds more than the length?

#include <vector>

#include "vandplan/continuous_steering.h"

namespace vandplan::steering {

/// Which words of continuous steering are of interest.
struct WantedContinuous {
  int gear_changes = 0;  ///< of the formula; 0 to 2
  double longest = 0.0;  ///< shorter than this [m]
  int first_gear = 0;    ///< in which the formula begins, 1 or -1; 0: in either
  int last_gear = 0;     ///< and ends
};

/// Fills `words` with the wanted words from pose to pose, by all formulas in all symmetries, those
/// with an inner arc of more than half a turn among them. A word that lacks a part may have fewer
/// gear changes, or begin in the other gear; one that straightens bent wheels first may have more.
/// Equal words come once, in no order of lengths. The poses are finite and the curvatures at most
/// 1/radius; `query.cutoff` is of no account.
void find_continuous_words(const ContinuousSteering& steering, const Pose& from, const Pose& to,
                           const ContinuousQuery& query, const WantedContinuous& wanted,
                           std::vector<Piece>& words);

}  // namespace vandplan::steering
