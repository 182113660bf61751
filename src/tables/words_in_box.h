// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where do the words lead, and how long are their arcs, for all pairs of poses in a box?
//
// Turning radius 1. Formulas: docs/algorithms/steering.md.

#include <array>
#include <numbers>
#include <optional>
#include <vector>

#include "tables/interval.h"

namespace vandplan::tables {

/// Box of pairs of poses, in the coordinates of simd/bound_grid.h, each in [0, 1].
struct PairBox {
  Interval radial;
  Interval side;
  Interval turn;
};

/// Distance [turning radii] or bearing [rad] in the mean frame, from a coordinate of the grid.
[[nodiscard]] double distance_at(double radial);
[[nodiscard]] double bearing_at(double side);

namespace words_in_box {

/// Bound on the rounding error of an arc [rad] or of a distance of centres [turning radii]. Three
/// times this bounds the rounding error of a word's length. Proof: docs/proofs/bound_table.md.
inline constexpr double margin = 1e-7;
/// Distance [turning radii] beyond which the slopes of words with a line are computed relative to
/// it.
inline constexpr double far = 2.5;

/// Centre of the last turning circle relative to that of the first, over a box.
struct CirclePair {
  Interval distance;
  Interval direction;
  Interval lean;    ///< Direction of the centres - bearing [rad].
  Interval across;  ///< Component of the difference across the bearing.
  Interval cos_lean;
  Interval stretch;      ///< Distance of the poses / distance of the centres; set beyond `far`.
  Interval tangent;      ///< Length of the inner tangent, where there is one.
  Interval tilt;         ///< Angle between the inner tangent and the line of the centres [rad].
  bool directed = true;  ///< Whether the centres differ everywhere in the box.
};

/// Box of pairs of poses in polar coordinates of the mean frame.
struct Polar {
  Interval distance;
  Interval nearness;  ///< 1 / distance
  Interval bearing;
  Interval turn;
  Interval cos_bearing, sin_bearing;
  // First and last turning circles: left to left, right to right, left to right, right to left. By
  // symmetry each word needs just one of the four.
  std::array<CirclePair, 4> circles;
};

/// Polar coordinates of the box. `wanted` says which circles are computed.
[[nodiscard]] Polar polar(const PairBox& box, const std::array<bool, 4>& wanted);

/// The nine words of docs/algorithms/steering.md, each beginning with a left turn forward. In the
/// names l and r are arcs, s is a line, `_` a change of gear. Words that
/// steering/reeds_shepp_formulas.h begins with a right turn or in reverse are mirrored or reversed
/// here.
enum LeftWord { lsl, lsr, lr_l, l_r_l, lr_lr, l_rl_r, l_rsl, l_rsr, l_rsl_r };

/// Formula for the component of the costate along the heading, at one end of the path.
enum class End { cos_arc, sin_arc, sin_rest };

/// Properties of a left word that do not depend on its angles.
struct Shape {
  bool same_side;      ///< Whether the word begins and ends with a left turn.
  double least, most;  ///< Distances of the centres where it can be shortest.
  bool has_line;
  End first_end, last_end;
  int last_turn;  ///< Rotation of the vehicle on the last arc: 1 counter-clockwise, -1 clockwise.
};

[[nodiscard]] const Shape& shape_of(LeftWord left_word);

/// One of the 48 words: a left word and the signs applied to x, y and turn.
struct Word {
  LeftWord left_word;
  int x, y, turn;
};

[[nodiscard]] std::vector<Word> list_words();

/// Box as a left word sees it, after the word's changes of sign.
struct View {
  const CirclePair* circles;
  Interval direction;
  Interval half_turn;
  int handed;  ///< -1 when the signs exchange left and right in the plane, else 1.
};

/// Index of the pair in `Polar::circles` that a word uses.
[[nodiscard]] std::size_t circles_of(const Word& word);

[[nodiscard]] View view_of(const Polar& box, const Word& word);

/// Lengths of a word's pieces over a box [turning radii].
struct Pieces {
  Interval tilt;         ///< Angle of the costate from the direction of the centres [rad].
  Interval first, last;  ///< Outer arcs.
  Interval middle;       ///< Arc between the outer arcs, of words without a line.
  Interval rest;         ///< Sum of all pieces between the outer arcs.
  double longest = std::numbers::pi / 2;  ///< Longest outer arc of a shortest path.
  bool everywhere = true;                 ///< Whether the formula is smooth in the whole box.

  [[nodiscard]] Interval length() const { return first + rest + last; }
  /// Lower bound on the length of this word where it is shortest in the box, up to the rounding
  /// error of three pieces.
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

/// Pieces of a left word over a box. Empty if the distance of the centres, or the arc between the
/// outer arcs, shows that the word is shortest nowhere in the box.
[[nodiscard]] std::optional<Pieces> pieces_of(const Polar& box, LeftWord left_word,
                                              const View& view);

}  // namespace words_in_box
}  // namespace vandplan::tables
