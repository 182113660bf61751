// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words of continuous steering join two poses, if gears and gear changes have prices?

#include <functional>
#include <span>

#include "vandplan/steering.h"

namespace vandplan::steering::continuous {

/// How a piece may begin and end.
struct PieceEnds {
  ContinuousQuery query;  ///< curvatures at both ends; the cutoff is ignored
  int first_gear = 0;     ///< gear in which the formula begins, 1 or -1; 0: any
  int last_gear = 0;      ///< gear in which the formula ends, 1 or -1; 0: any
};

/// Which words are asked for, and their prices.
struct PieceRequest {
  int gear_changes = 0;       ///< number of gear changes of the formula, 0 to 2
  double cutoff = 0.0;        ///< cost that a word has to undercut [m]
  double forward = 1.0;       ///< price of a metre driven forward; > 0
  double reverse = 1.0;       ///< price of a metre driven in reverse; > 0
  double gear_change = 0.0;   ///< price of a gear change [m]; >= 0
  int before = 0, after = 0;  ///< gears driven before and after the piece; 0: any
};

/// Receives a piece, and the index of the `PieceEnds` by which it begins and ends. Returns the
/// cost that later pieces have to undercut [m].
using TakePiece = std::function<double(const Piece& piece, std::size_t ends)>;

/// Calls `take` with words from pose to pose, by all formulas in all symmetries. Words with
/// an inner arc of more than half a turn are among them. Words come in the order of a bound of
/// their cost: the cost of the Reeds-Shepp word of the same letters, or the exact cost at full
/// lock. A word is left out if its bound is no less than the cost to undercut. A word that lacks a
/// part may have fewer gear changes, or begin in the other gear. A word that straightens bent
/// wheels first may have more gear changes. The poses are finite, the curvatures at most 1/radius,
/// and there are up to four `ends`.
void for_priced_pieces(const ContinuousSteering& steering, const Pose& from, const Pose& to,
                       std::span<const PieceEnds> ends, const PieceRequest& request,
                       const TakePiece& take);

}  // namespace vandplan::steering::continuous
