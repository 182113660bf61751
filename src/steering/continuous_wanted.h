// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words of continuous steering join two poses, for whoever minds more than the length?

#include <functional>
#include <span>

#include "vandplan/continuous_steering.h"

namespace vandplan::steering {

/// How a piece may begin and end.
struct WantedEnds {
  ContinuousQuery query;  ///< its cutoff is of no account
  int first_gear = 0;     ///< in which the formula begins, 1 or -1; 0: in either
  int last_gear = 0;      ///< and ends
};

/// What is of interest of a word.
struct WantedContinuous {
  int gear_changes = 0;       ///< of the formula; 0 to 2
  double cutoff = 0.0;        ///< costs less than this [m]
  double forward = 1.0;       ///< price of a metre driven forward; > 0
  double reverse = 1.0;       ///< in reverse; > 0
  double gear_change = 0.0;   ///< of a change of gear [m]; >= 0
  int before = 0, after = 0;  ///< gears driven before and after the piece; 0: any
};

/// Takes a piece that begins and ends in the ways of that index, and says what the next ones have
/// to undercut [m].
using TakeWanted = std::function<double(const Piece& piece, std::size_t ends)>;

/// Calls `take` with words from pose to pose that may be of interest, by all formulas in all
/// symmetries, those with an inner arc of more than half a turn among them. Those come first that
/// cost least by the arcs of Reeds and Shepp of the same letters, and none whose arcs cost as much
/// as is to be undercut. A word that lacks a part may have fewer gear changes, or begin in the
/// other gear; one that straightens bent wheels first may have more. The poses are finite and the
/// curvatures at most 1/radius; there are up to four `ends`.
void for_wanted_words(const ContinuousSteering& steering, const Pose& from, const Pose& to,
                      std::span<const WantedEnds> ends, const WantedContinuous& wanted,
                      const TakeWanted& take);

}  // namespace vandplan::steering
