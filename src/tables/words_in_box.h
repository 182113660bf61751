// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where do the words lead, and how long are their arcs, for all pairs of poses in a box?
//
// Turning radius 1. The formulas are those of docs/algorithms/steering.md.

#include <array>
#include <numbers>
#include <optional>
#include <vector>

#include "tables/interval.h"

namespace vandplan::tables {

/// Pairs of poses by the coordinates of simd/bound_grid.h, each in [0, 1].
struct PairBox {
  Interval radial;
  Interval side;
  Interval turn;
};

/// From the coordinates of the grid to those of the mean frame.
[[nodiscard]] double distance_at(double radial);
[[nodiscard]] double bearing_at(double side);

namespace words_in_box {

/// More than rounding does to an arc [rad] or to a distance of centres; three times it is more than
/// rounding does to the length of a word. docs/algorithms/bound_table.md, "Rounding".
inline constexpr double margin = 1e-7;
/// Beyond this distance the slopes of words with a line are computed relative to it.
inline constexpr double far = 2.5;

/// Two turning circles: centre of the last one as seen from that of the first.
struct CirclePair {
  Interval distance;
  Interval direction;
  Interval lean;    ///< direction - bearing
  Interval across;  ///< component of the difference across the bearing
  Interval cos_lean;
  Interval stretch;  ///< distance of the poses / distance of the centres, when they are far apart
  Interval tangent;  ///< length of the inner tangent, where there is one
  Interval tilt;     ///< between the inner tangent and the line of the centres
  bool directed = true;  ///< the centres differ everywhere in the box
};

/// A box of pairs in polar coordinates of the mean frame.
struct Polar {
  Interval distance;
  Interval nearness;  ///< 1 / distance
  Interval bearing;
  Interval turn;
  Interval cos_bearing, sin_bearing;
  // By symmetry every word looks at one of these: left to left, right to right, left to right,
  // right to left.
  std::array<CirclePair, 4> circles;
};

/// The box in polar coordinates, with the circles that `wanted` asks for.
[[nodiscard]] Polar polar(const PairBox& box, const std::array<bool, 4>& wanted);

/// The nine words of docs/algorithms/steering.md, each beginning with a left turn forward: l and
/// r are arcs, s is a line, `_` a change of gear. Formulas that steering/reeds_shepp_formulas.h
/// begins with a right turn or in reverse are seen mirrored or from the other end here.
enum LeftWord { lsl, lsr, lr_l, l_r_l, lr_lr, l_rl_r, l_rsl, l_rsr, l_rsl_r };

/// How much of the costate points along the heading at an end of the path, seen from the outer arc.
enum class End { cos_arc, sin_arc, sin_rest };

/// What a left word is, apart from its angles.
struct Shape {
  bool same_side;      ///< begins and ends with a left turn
  double least, most;  ///< distances of the centres for which it can be shortest
  bool has_line;
  End first_end, last_end;
  int last_turn;  ///< which way the last arc turns the vehicle: 1 counter-clockwise
};

[[nodiscard]] const Shape& shape_of(LeftWord left_word);

/// One of the 48 words: a left word looked at with the signs of x, y and turn changed.
struct Word {
  LeftWord left_word;
  int x, y, turn;
};

[[nodiscard]] std::vector<Word> list_words();

/// What a left word looks at, after the signs were changed.
struct View {
  const CirclePair* circles;
  Interval direction;
  Interval half_turn;
  int handed;  ///< -1 when left and right were exchanged in the plane
};

/// Which of `Polar::circles` a word looks at.
[[nodiscard]] std::size_t circles_of(const Word& word);

[[nodiscard]] View view_of(const Polar& box, const Word& word);

/// A word over a box.
struct Pieces {
  Interval tilt;                          ///< of the costate, from the direction of the centres
  Interval first, last;                   ///< outer arcs
  Interval middle;                        ///< an arc between them, of words without a line
  Interval rest;                          ///< everything between the outer arcs
  double longest = std::numbers::pi / 2;  ///< what an outer arc of a shortest path can be
  bool everywhere = true;                 ///< the formula is smooth in the whole box

  [[nodiscard]] Interval length() const { return first + rest + last; }
  /// No path of this word that is shortest in a pair of the box is shorter, rounding of three
  /// pieces apart.
  [[nodiscard]] double least() const {
    return std::max(first.low, 0.0) + rest.low + std::max(last.low, 0.0);
  }
  [[nodiscard]] bool can_be_shortest() const {
    const auto fits = [this](Interval arc) {
      return arc.high >= -margin && arc.low <= longest + margin;
    };
    return fits(first) && fits(last);
  }
};

/// The left word over a box; none if no path of it is shortest anywhere in the box for want of
/// circles.
[[nodiscard]] std::optional<Pieces> pieces_of(const Polar& box, LeftWord left_word,
                                              const View& view);

}  // namespace words_in_box
}  // namespace vandplan::tables
