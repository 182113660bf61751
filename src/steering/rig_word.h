// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which lengths must the four letters of a word have, so that a rig ends in the wanted state?
//
// A letter is a turn to full lock or a line, its length negative in reverse. Where it would bend
// the rig beyond the limit, it goes on with the curvature that holds the limit. Lengths are in
// turning radii, hitch angles the tangents of their halves: docs/algorithms/rig_steering.md.

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "steering/hitch_turn.h"
#include "vandplan/path.h"

namespace vandplan::steering {

/// A state of a rig at unit radius.
struct RigPlace {
  double x = 0.0, y = 0.0, heading = 0.0;
  double u = 0.0;               ///< tangent of half the hitch angle
  double sin = 0.0, cos = 1.0;  ///< sine and cosine of the heading
};

[[nodiscard]] RigPlace rig_place(double x, double y, double heading, double u) noexcept;

/// Segments of a path, in turning radii.
struct RigSegments {
  std::array<Segment, 8> list{};
  std::size_t count = 0;

  [[nodiscard]] std::span<const Segment> view() const noexcept { return {list.data(), count}; }
};

/// Prices of a radius driven in either gear, and of a gear change [turning radii].
struct WordPrices {
  double forward = 1.0;
  double reverse = 1.0;
  double gear_change = 0.0;
};

/// A word of four letters. A shorter word has letters of length 0.
struct RigWord {
  static constexpr std::size_t letters = 4;
  std::array<int, letters> turns{};       ///< 1 left, 0 straight, -1 right; neighbours differ
  std::array<double, letters> lengths{};  ///< negative in reverse
};

[[nodiscard]] double price_of(const RigWord& word, const WordPrices& prices) noexcept;

/// Finds lengths with which words join two states.
class RigWordSolver {
 public:
  explicit RigWordSolver(const HitchTurn& hitch) noexcept;

  /// Two states to join by a word, and the prices of words.
  struct Task {
    RigPlace start, goal;
    double tolerance = 1e-12;  ///< largest gap of a closed word [turning radii, rad]
    WordPrices prices;
    double cutoff = 0.0;        ///< largest price of a useful word
    bool is_backwards = false;  ///< the path will be driven from the goal to the start
    bool is_rounded = false;  ///< other segments come first, so a straight rig has rounding errors
  };

  /// Segments of the word with the letters of `guess` that Newton's method finds from its lengths.
  /// Nothing if it finds none, or one above the cutoff. `guess` receives the lengths.
  [[nodiscard]] std::optional<RigSegments> solve(const Task& task, RigWord& guess) const noexcept;

  /// Place of a rig after driving `segments` from `place`.
  [[nodiscard]] RigPlace after(const RigPlace& place,
                               std::span<const Segment> segments) const noexcept;

  /// Whether the segments, driven one after the other, lead to the goal within the limits, and
  /// rounding does not grow too much on the way (7).
  [[nodiscard]] bool leads(const Task& task, std::span<const Segment> segments) const noexcept;

  [[nodiscard]] const HitchTurn& hitch() const noexcept { return hitch_; }

  /// The radius of the sharpest circle on which the rig can go on for ever.
  [[nodiscard]] double hold_radius() const noexcept { return hold_radius_; }

 private:
  struct Slope;
  struct Mismatch;
  struct Letter;
  struct Parts;

  [[nodiscard]] bool evaluate(const Task& task, const RigWord& word, std::size_t meeting,
                              Mismatch& mismatch) const noexcept;
  [[nodiscard]] static double determinant(const Slope& a, const Slope& b, const Slope& c,
                                          const Slope& d) noexcept;
  [[nodiscard]] static std::optional<std::array<double, 4>> newton_step(
      const Mismatch& here) noexcept;
  [[nodiscard]] bool drive(RigPlace& place, const Letter& letter, Slope* slopes,
                           std::size_t count) const noexcept;
  [[nodiscard]] bool divide(const RigPlace& place, const Letter& letter,
                            Parts& parts) const noexcept;
  [[nodiscard]] std::optional<RigSegments> segments_of(const Task& task, const RigWord& word,
                                                       std::size_t meeting) const noexcept;

  HitchTurn hitch_;
  double hold_;  // curvature that holds the largest hitch angle
  double hold_radius_;
};

}  // namespace vandplan::steering
