// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which lengths must the turns and the line of a word have, so that it ends at the goal?
//
// The words are those of Reeds and Shepp (word.h), driven with turns that begin and end with the
// wheels straight or, where the vehicle stands, with any curvature. Lengths are in turning radii.

#include <array>
#include <limits>
#include <optional>

#include "steering/continuous_circles.h"
#include "steering/continuous_turn.h"
#include "steering/mean_frame.h"
#include "steering/reeds_shepp_formulas.h"
#include "steering/word.h"
#include "vandplan/path.h"

namespace vandplan::steering {

/// How the steps of a word begin and end.
struct Shape {
  Steps steps;
  std::array<Ends, 5> ends{};
  std::array<std::size_t, 5>
      length_of{};                 ///< which of the three lengths each step has, 3: a quarter turn
  std::array<double, 3> senses{};  ///< how the heading turns: with the first, inner, last turns
  std::size_t inner = 0;           ///< the first inner turn, if there is one
  bool has_line = false;
  std::array<double, 3> counts{};  ///< how many steps have each of the three lengths
  double quarters = 0;             ///< and how many the quarter turn
  std::array<double, 3> least{};   ///< of each of the three lengths, in clothoids to full lock
  bool may_dip = false;            ///< the turns beside the line are to the same side
  bool may_cut_first = false;      ///< the first turn stands before and rolls into another turn
  bool may_cut_last = false;       ///< the last turn stands after and rolls out of another turn
};

[[nodiscard]] const Shape& shape_of(reeds_shepp_formulas::Formula formula,
                                    const Stops& stops) noexcept;

/// A word of which lengths are known: of the first step, of the inner turns or else the line, of
/// the last step.
struct SolvedWord {
  reeds_shepp_formulas::Formula formula{};
  Stops stops;
  std::array<double, 3> lengths{};
  double quarter = 0.0;  ///< length of each inner turn beside a line
  double length = 0.0;   ///< of all
};

/// What is driven, in turning radii; clothoids that go on as one are one.
struct UnitSegments {
  std::array<Segment, 16> list{};
  std::size_t count = 0;

  /// Appends a segment; of no length it is left out, and so is the last one if that is no longer
  /// than rounding and the wheels need it for nothing.
  void add(const Segment& segment) noexcept;
};

/// By how much longer a word may be if its first (or last) step has a length.
struct Bonus {
  double longer = 0.0;
  double least_length = 0.0;
};

/// How long Newton's method goes on.
struct Patience {
  int most_steps;
  int most_limited = most_steps;  ///< so many steps may be shorter than they should
  /// Longer words are of no use, but for their bonus. If this is finite it gives up as well where a
  /// part seems to become less than nothing.
  double longest = std::numeric_limits<double>::infinity();
  Bonus first{}, last{};
  double if_one_vanishes = 0.0;  ///< the bonus if the first or last step does
};

/// The word of a formula between the poses of a frame that is near the guess, if there is one.
class WordSolver {
 public:
  explicit WordSolver(const SharpTurns& turns) noexcept;

  [[nodiscard]] const SharpTurns& turns() const noexcept { return turns_; }

  /// The word of a formula whose turns have the angles of its circles, if these are enough for the
  /// clothoids.
  [[nodiscard]] std::optional<SolvedWord> at_full_lock(
      reeds_shepp_formulas::Formula formula, const Stops& stops,
      const reeds_shepp_formulas::Arcs& arcs) const noexcept;

  /// The word of a formula that is near the guess, if there is one and Newton's method finds it.
  /// It gives up where the word would be too long.
  [[nodiscard]] std::optional<SolvedWord> solve(reeds_shepp_formulas::Formula formula,
                                                const Stops& stops, const WordFrame& frame,
                                                const reeds_shepp_formulas::Arcs& guess,
                                                const Patience& patience) const noexcept;

  /// The radius of the circle on which a turn by `angle` with straight wheels at both ends begins
  /// and ends, in the directions of a circle.
  [[nodiscard]] double radius_of(double angle) const noexcept;

  [[nodiscard]] UnitSegments segments_of(const SolvedWord& word) const noexcept;

  /// Length of a step; negative if it is taken from its neighbours.
  [[nodiscard]] double step_length(const SolvedWord& word, std::size_t step) const noexcept;

  /// Length of the clothoid on either side of a turn of a word.
  [[nodiscard]] double ramp_of(const SolvedWord& word, std::size_t step) const noexcept;

 private:
  /// Changes the lengths until the word ends at the goal with the heading changed by `turn`.
  [[nodiscard]] bool close(SolvedWord& word, const WordFrame& frame, double turn,
                           const Patience& patience) const noexcept;

  /// Leaves out parts so short that they are what Newton's method leaves of nothing, where the
  /// others lead to the goal as well.
  void leave_out_crumbs(SolvedWord& word, const WordFrame& frame, double turn) const noexcept;

  /// Changes the other two lengths until the word ends at the goal, if they can.
  [[nodiscard]] bool close_without(std::size_t part, SolvedWord& word, const WordFrame& frame,
                                   double turn) const noexcept;

  /// Changes the lengths by a part of what Newton's method says; returns by how much at most.
  double move(SolvedWord& word, const Shape& shape, const std::array<double, 3>& change,
              double part) const noexcept;

  /// Whether the lengths, which were last moved by so much, seem to become none of use.
  [[nodiscard]] bool is_hopeless(const SolvedWord& word, const Shape& shape, double moved,
                                 const Patience& patience) const noexcept;

  /// Whether no part is driven backwards; works out the length.
  [[nodiscard]] bool is_drivable(SolvedWord& word) const noexcept;

  /// Whether the curvature jumps only where the vehicle stands, although parts have no length.
  [[nodiscard]] bool jumps_at_stops(const SolvedWord& word) const noexcept;

  SharpTurns turns_;
  /// A step so small misses by no more than its square, times how fast the curvature changes.
  double small_step_;
};

}  // namespace vandplan::steering
