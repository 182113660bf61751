// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which lengths must the turns and the line of a word have, so that it ends at the goal?
//
// The words are those of Reeds and Shepp (word.h). Their turns begin and end with the wheels
// straight or, where the vehicle stands, with any curvature. Lengths are in turning radii.

#include <array>
#include <limits>
#include <optional>

#include "steering/continuous/circle_word.h"
#include "steering/continuous/turn.h"
#include "steering/mean_frame.h"
#include "steering/reeds_shepp_formulas.h"
#include "steering/word.h"
#include "vandplan/path.h"

namespace vandplan::steering::continuous {

/// Everything about a word that its formula and its stops decide.
struct WordShape {
  Steps steps;
  std::array<TurnEnds, 5> ends{};
  /// Index of the length that each step has: 0 to 2, or 3 for a quarter turn.
  std::array<std::size_t, 5> length_of{};
  std::array<double, 3> senses{};  ///< change of heading per radian of first, inner and last turns
  std::size_t inner = 0;           ///< index of the last inner turn; 0 if there is none
  bool has_line = false;
  std::array<double, 3> counts{};       ///< number of steps that have each of the three lengths
  double quarters = 0;                  ///< number of steps that are quarter turns
  std::array<double, 3> min_lengths{};  ///< least value of each length [clothoids to full lock]
  bool may_dip = false;                 ///< the turns beside the line are to the same side
  bool may_cut_first = false;  ///< the first turn stands before and rolls into another turn
  bool may_cut_last = false;   ///< the last turn stands after and rolls out of another turn
};

[[nodiscard]] const WordShape& shape_of(Formula formula, const Stops& stops) noexcept;

/// A word with known lengths.
struct SolvedWord {
  Formula formula{};
  Stops stops;
  /// Lengths of the first step, of the line (without a line: of each inner turn), of the last step.
  std::array<double, 3> lengths{};
  double quarter = 0.0;  ///< length of each inner turn beside a line
  double length = 0.0;   ///< sum of the lengths of all steps
};

/// Segments of a path in turning radii. Clothoids that continue each other are one segment.
struct UnitSegments {
  std::array<Segment, 16> list{};
  std::size_t count = 0;

  /// Appends a segment, unless its length is 0. Drops the last segment if that is as short as
  /// rounding and the curvature goes on without it.
  void add(const Segment& segment) noexcept;
};

/// Length by which a word may be longer if its first (or last) step has at least `min_length`.
struct Bonus {
  double longer = 0.0;
  double min_length = 0.0;
};

/// When Newton's method gives up.
struct NewtonLimits {
  int max_steps;
  int max_limited_steps = max_steps;  ///< number of first steps that may be cut short
  /// Largest useful length of a word, without its bonus. If it is finite, Newton's method also
  /// gives up if a part seems to become negative.
  double max_length = std::numeric_limits<double>::infinity();
  Bonus first{}, last{};
  double if_one_vanishes = 0.0;  ///< bonus if the first or last step vanishes
};

/// Finds the lengths of words for one kind of turns.
class WordSolver {
 public:
  explicit WordSolver(const SharpTurns& turns) noexcept;

  [[nodiscard]] const SharpTurns& turns() const noexcept { return turns_; }

  /// The word of a formula in closed form: its turns have the angles `arcs` of circles at full
  /// lock. Nothing if a turn is too small for its clothoids, or the line is negative.
  [[nodiscard]] std::optional<SolvedWord> at_full_lock(Formula formula, const Stops& stops,
                                                       const Arcs& arcs) const noexcept;

  /// The word of a formula that is near the guess, if there is one and Newton's method finds it.
  /// It gives up where the word would be too long.
  [[nodiscard]] std::optional<SolvedWord> solve(Formula formula, const Stops& stops,
                                                const WordFrame& frame, const Arcs& guess,
                                                const NewtonLimits& limits) const noexcept;

  /// Radius of the circle that has both ends of a turn by `angle` between straight wheels, and the
  /// directions there.
  [[nodiscard]] double radius_of(double angle) const noexcept;

  [[nodiscard]] UnitSegments segments_of(const SolvedWord& word) const noexcept;

  /// Length of a step; negative if it is taken from its neighbours.
  [[nodiscard]] double step_length(const SolvedWord& word, std::size_t step) const noexcept;

  /// Length of the clothoid on either side of a turn of a word.
  [[nodiscard]] double ramp_of(const SolvedWord& word, std::size_t step) const noexcept;

 private:
  /// Changes the lengths by Newton's method until the word ends at the goal with the heading
  /// changed by `turn`.
  [[nodiscard]] bool find_root(SolvedWord& word, const WordFrame& frame, double turn,
                               const NewtonLimits& limits) const noexcept;

  /// Leaves out parts so short that they are what Newton's method leaves of a vanishing part, if
  /// the other parts lead to the goal as well.
  void drop_vanishing_parts(SolvedWord& word, const WordFrame& frame, double turn) const noexcept;

  /// Changes the lengths other than `part` until the word ends at the goal; false if that fails.
  [[nodiscard]] bool find_root_without(std::size_t part, SolvedWord& word, const WordFrame& frame,
                                       double turn) const noexcept;

  /// Changes the lengths by the share `part` of a Newton step; returns the largest change.
  double take_step(SolvedWord& word, const WordShape& shape, const std::array<double, 3>& change,
                   double part) const noexcept;

  /// Whether the word seems to become too long, or one of its parts negative. `moved` is the
  /// largest change of a length in the last step.
  [[nodiscard]] bool is_hopeless(const SolvedWord& word, const WordShape& shape, double moved,
                                 const NewtonLimits& limits) const noexcept;

  /// Whether each part is >= 0 or can be taken from its neighbours. Works out `word.length`.
  [[nodiscard]] bool is_drivable(SolvedWord& word) const noexcept;

  /// Whether the curvature jumps only where the vehicle stands, although parts have no length.
  [[nodiscard]] bool jumps_at_stops(const SolvedWord& word) const noexcept;

  SharpTurns turns_;
  /// Largest last step of Newton's method. The residual after a step is at most its square times
  /// how fast the curvature changes.
  double small_step_;
};

}  // namespace vandplan::steering::continuous
