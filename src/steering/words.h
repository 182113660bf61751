// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words join two poses, for whoever minds more than the length?
//
// The 48 of Reeds and Shepp, the four of Dubins with three arcs, and what is left of a word where
// arcs vanish: there the length in one gear jumps, and a path that lacks the arc still ends at the
// pose, but for rounding. docs/algorithms/steering.md, section 8.

#include <optional>
#include <span>
#include <vector>

#include "vandplan/path.h"

namespace vandplan::steering {

/// How far from a pose a piece may end and still end there.
struct Closing {
  double position = 0.0;  ///< [m]
  double heading = 0.0;   ///< [rad]
};

/// How far the ends of a path may be from start and goal: what the judge allows. A test holds both
/// together.
inline constexpr Closing judged{1e-6, 1e-6};

/// How far from the goal the last piece of a path may end: as far as leaves room for rounding, and
/// for a goal that was rounded to six decimals.
inline constexpr Closing at_goal{0.8e-6, 0.8e-6};

/// How far from a pose on the way a piece may end: rounding, so that the ends of many add up to
/// next to nothing.
inline constexpr Closing on_the_way{1e-11, 1e-13};

/// The piece with its lengths changed a little so that it ends at `to`, as nearly as they can; a
/// segment that this makes shorter than nothing is left out. None if it still ends farther away
/// than `closing` allows. Clothoids stay as they are.
[[nodiscard]] std::optional<Piece> mended(const Pose& from, const Pose& to, const Piece& piece,
                                          const Closing& closing);

/// So many segments can be mended at once.
inline constexpr std::size_t most_mended = 8;

/// What `mended` gives of a piece, of at most `most_mended` segments.
[[nodiscard]] std::optional<std::vector<Segment>> mended(const Pose& from, const Pose& to,
                                                         std::span<const Segment> segments,
                                                         const Closing& closing);

/// Which words are of interest.
struct Wanted {
  int gear_changes = 0;  ///< of the formula; 0 to 2
  double longest = 0.0;  ///< shorter than this [m]
  Closing closing;
  bool wide_arcs = false;  ///< those with an inner arc of more than half a turn, too
};

/// Fills `words` with the wanted words from pose to pose at a turning `radius` > 0 [m]: first those
/// that end there but for rounding, then those that lack a part of a word (and maybe a gear change)
/// and end as near as `closing` allows.
void find_words(const Pose& from, const Pose& to, double radius, const Wanted& wanted,
                std::vector<Piece>& words);

}  // namespace vandplan::steering
