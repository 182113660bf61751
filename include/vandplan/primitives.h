// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which motions join the vertices of a state lattice?
//
// A vertex is a point of a square grid with one of a few headings; a primitive drives from a vertex
// at the origin exactly to another one. Moved to any vertex of its heading it does the same there.
// docs/algorithms/lattice.md says how ours are chosen; primitives_file.h reads those of others.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "vandplan/path.h"

namespace vandplan::base {
class Derived;
}

namespace vandplan::search {

/// A motion from a vertex to another one.
struct Primitive {
  std::int32_t from = 0;  ///< heading at its begin, as an index
  std::int32_t to = 0;    ///< heading at its end, as an index
  std::int32_t dx = 0;    ///< from vertex to vertex [steps of the grid]
  std::int32_t dy = 0;    ///< from vertex to vertex [steps of the grid]
  Piece piece = {};       ///< what is driven
};

/// All motions of a lattice; checked and immutable, so that threads may share it.
class Primitives {
 public:
  /// How far from its vertex a primitive may end, for rounding [m, rad]; of one that is longer than
  /// a metre as a part of its length.
  static constexpr double closing = 1e-9;

  /// `step` is the side of the grid's squares [m]; `headings` are the angles that an index means
  /// [rad]. Throws InputError naming "step", "headings" or "primitives[3]" when a number is out of
  /// range, two headings are one, there is no primitive, or one does not end at its vertex.
  Primitives(double step, std::vector<double> headings, std::vector<Primitive> all);
  ~Primitives();
  Primitives(const Primitives&) = delete;
  Primitives& operator=(const Primitives&) = delete;

  /// Side of the grid's squares [m].
  [[nodiscard]] double step() const noexcept { return step_; }
  /// What an index of a heading means [rad], in [-pi, pi).
  [[nodiscard]] std::span<const double> headings() const noexcept { return headings_; }
  /// Ordered by the heading at the begin.
  [[nodiscard]] std::span<const Primitive> all() const noexcept { return all_; }
  /// Positions in `all` of those that begin with a heading: from the first up to the second.
  [[nodiscard]] std::int32_t first_from(std::size_t heading) const { return first_[heading]; }
  /// The largest curvature [1/m], never negative.
  [[nodiscard]] double largest_curvature() const noexcept { return largest_curvature_; }
  /// Length of the longest one [m].
  [[nodiscard]] double longest() const noexcept { return longest_; }

  /// What parts of the library make of the primitives, once for all who share them.
  [[nodiscard]] base::Derived& derived() const noexcept { return *derived_; }

 private:
  double step_;
  std::vector<double> headings_;
  std::vector<Primitive> all_;
  std::vector<std::int32_t> first_;
  double largest_curvature_ = 0.0;
  double longest_ = 0.0;
  std::unique_ptr<base::Derived> derived_;
};

/// Which primitives are made.
struct PrimitiveOptions {
  int steps_per_radius = 8;  ///< of the grid, in a turning radius; [1, 32]
  /// Headings are the directions of all points of the grid whose coordinates are at most this; 2
  /// gives 16, 3 gives 32; [1, 5]
  int largest_coordinate = 2;
  double longest = 1.25;  ///< of one primitive [turning radii]; [0.5, 4]
  /// Left out is what shorter ones reach at no more than this many times the length; [1, 2]
  double detour = 1.1;
};

/// Primitives of one stroke, forward and in reverse, for a turning radius > 0 [m]: arcs and lines
/// of Dubins between vertices. Throws InputError naming the option that is out of range.
[[nodiscard]] std::shared_ptr<const Primitives> make_primitives(
    double radius, const PrimitiveOptions& options = {});

/// The piece of one gear from `begin` exactly to `end` that passes nearest to sampled poses, the
/// first and the last of which are those two: a line, an arc between lines, or a word of Dubins.
/// None if it passes one of them by more than `tolerance` [m], or they are not in one gear.
[[nodiscard]] std::optional<Piece> fitted_piece(const Pose& begin, const Pose& end,
                                                std::span<const Pose> poses, double tolerance);

/// The heading that was rounded to `heading` [rad]: a multiple of a turn by `count`, or the
/// direction of a point of the grid whose coordinates are small. None if there is no such heading
/// within 2e-4.
[[nodiscard]] std::optional<double> exact_heading(double heading, int count);

}  // namespace vandplan::search
