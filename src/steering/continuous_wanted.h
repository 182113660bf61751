// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words of continuous steering join two poses, for whoever minds more than the length?

#include <vector>

#include "vandplan/continuous_steering.h"

namespace vandplan::steering {

/// Fills `words` with the words from pose to pose that are shorter than `longest` [m], by all
/// formulas with so many gear changes (0 to 2) in all symmetries, those with an inner arc of more
/// than half a turn among them. A word that lacks a part may have fewer gear changes; one that
/// straightens bent wheels first may have more. Equal words come once, in no order of lengths. The
/// poses are finite and the curvatures at most 1/radius; `query.cutoff` is of no account.
void find_continuous_words(const ContinuousSteering& steering, const Pose& from, const Pose& to,
                           const ContinuousQuery& query, int gear_changes, double longest,
                           std::vector<Piece>& words);

}  // namespace vandplan::steering
