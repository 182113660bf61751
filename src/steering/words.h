// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words join two poses, if gears and gear changes have prices?
//
// They are the 48 words of Reeds and Shepp, the four Dubins words of three arcs, and words without
// vanishing arcs. Where an arc vanishes, the length in one gear jumps, but a path without the arc
// still ends at the pose, except for rounding: docs/algorithms/steering.md, section 8.

#include <optional>
#include <span>
#include <vector>

#include "vandplan/path.h"

namespace vandplan::steering {

/// How far from a pose a piece may end.
struct Closing {
  double position = 0.0;  ///< distance of the positions [m]
  double heading = 0.0;   ///< difference of the headings [rad]
};

/// How far the ends of a path may be from start and goal, as the judge allows. A test compares
/// these numbers with the judge's.
inline constexpr Closing judged{1e-6, 1e-6};
/// How far the curvature of a path may be above the vehicle's, relative, as the judge allows.
inline constexpr double judged_curvature = 1e-9;

/// How far from the goal the last piece of a path may end. It leaves room for rounding within
/// `judged`, and is enough for a goal that was rounded to six decimals.
inline constexpr Closing at_goal{0.8e-6, 0.8e-6};

/// How far from a pose on the way a piece may end: only by rounding, so that the errors of many
/// pieces add up to next to nothing.
inline constexpr Closing on_the_way{1e-11, 1e-13};

/// The piece with its lengths changed a little, so that it ends as near to `to` as possible. A
/// segment that would become negative is left out; clothoids stay as they are. Nothing if the piece
/// still ends farther away than `closing` allows.
[[nodiscard]] std::optional<Piece> mended(const Pose& from, const Pose& to, const Piece& piece,
                                          const Closing& closing);

/// Largest number of segments that can be mended at once.
inline constexpr std::size_t most_mended = 8;

/// The segments, at most `most_mended`, with their lengths changed as `mended` changes a piece.
[[nodiscard]] std::optional<std::vector<Segment>> mended(const Pose& from, const Pose& to,
                                                         std::span<const Segment> segments,
                                                         const Closing& closing);

/// Which words `find_words` gives.
struct Wanted {
  int gear_changes = 0;  ///< number of gear changes of the formula, 0 to 2
  double longest = 0.0;  ///< words have to be shorter than this [m]
  Closing closing;
  bool wide_arcs = false;  ///< words with an inner arc of more than half a turn, too
};

/// Fills `words` with the wanted words from pose to pose at a turning `radius` > 0 [m]. Words that
/// end at the pose except for rounding come first. Words that lack a part (and maybe a gear change)
/// follow; they end as near to the pose as `closing` allows.
void find_words(const Pose& from, const Pose& to, double radius, const Wanted& wanted,
                std::vector<Piece>& words);

}  // namespace vandplan::steering
