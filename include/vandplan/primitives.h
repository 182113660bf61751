// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which motions join the vertices of a state lattice?
//
// A vertex is a point of a square grid with one of a few headings. A primitive drives from a vertex
// at the origin exactly to another vertex. Moved to any vertex with its first heading, it again
// ends at a vertex. docs/algorithms/lattice.md says how ours are chosen; primitives_file.h reads
// those of other programs.

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

/// A motion from one vertex to another.
struct Primitive {
  std::int32_t from = 0;  ///< index of the heading at the begin
  std::int32_t to = 0;    ///< index of the heading at the end
  std::int32_t dx = 0;    ///< way along x from vertex to vertex [steps of the grid]
  std::int32_t dy = 0;    ///< way along y from vertex to vertex [steps of the grid]
  Piece piece = {};       ///< segments that are driven
};

/// All motions of a lattice. They are checked and immutable, so that threads may share them.
class Primitives {
 public:
  /// Largest distance of a primitive's end from its vertex, for rounding [m, rad]. For vertices
  /// more than a metre apart it is a share of their distance.
  static constexpr double closing = 1e-9;

  /// Makes the primitives of a grid whose squares have the side `step` [m]. `headings` are the
  /// angles that the indices mean [rad]. Throws InputError naming:
  ///
  /// - "step" or "headings" if it is out of range, or two headings are equal,
  /// - "primitives" if there is none,
  /// - "primitives[3]" if it has a number out of range or does not end at its vertex.
  Primitives(double step, std::vector<double> headings, std::vector<Primitive> all);
  ~Primitives();
  Primitives(const Primitives&) = delete;
  Primitives& operator=(const Primitives&) = delete;

  /// Side of the grid's squares [m].
  [[nodiscard]] double step() const noexcept { return step_; }
  /// Angle of each index of a heading [rad], in [-pi, pi).
  [[nodiscard]] std::span<const double> headings() const noexcept { return headings_; }
  /// All primitives, ordered by the heading at their begin.
  [[nodiscard]] std::span<const Primitive> all() const noexcept { return all_; }
  /// Position in `all` of the first primitive that begins with that heading. Those of one heading
  /// end where those of the next heading begin; `headings().size()` gives the end of the list.
  [[nodiscard]] std::int32_t first_from(std::size_t heading) const { return first_[heading]; }
  /// Largest absolute curvature of all primitives [1/m].
  [[nodiscard]] double largest_curvature() const noexcept { return largest_curvature_; }
  /// Length of the longest primitive [m].
  [[nodiscard]] double longest() const noexcept { return longest_; }

  /// Values that parts of the library derive from the primitives, once for all who share them.
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

/// Choice of the primitives that are made.
struct PrimitiveOptions {
  int steps_per_radius = 8;  ///< steps of the grid in a turning radius; [1, 32]
  /// Headings are the directions of all grid points whose coordinates are at most this; [1, 5]. 2
  /// gives 16 headings, 3 gives 32.
  int largest_coordinate = 2;
  double longest = 1.25;  ///< largest length of one primitive [turning radii]; [0.5, 4]
  /// A primitive is left out if shorter ones lead there at no more than this many times its length;
  /// [1, 2].
  double detour = 1.1;
};

/// Primitives of one stroke, forward and in reverse, for a turning radius > 0 [m]: arcs and lines
/// of Dubins between vertices. Throws InputError naming "radius" or the option that is out of
/// range.
[[nodiscard]] std::shared_ptr<const Primitives> make_primitives(
    double radius, const PrimitiveOptions& options = {});

/// The piece of one gear from `begin` exactly to `end` that passes nearest to sampled poses: a
/// line, an arc between lines, or a word of Dubins. The first and the last pose are `begin` and
/// `end`. None if it passes a pose by more than `tolerance` [m], or the poses are not in one gear.
[[nodiscard]] std::optional<Piece> fitted_piece(const Pose& begin, const Pose& end,
                                                std::span<const Pose> poses, double tolerance);

/// The exact heading that was rounded to `heading` [rad], within 2e-4. It is the direction of a
/// grid point whose coordinates are at most 8, or a multiple of a turn divided by `count`. None if
/// there is no such heading.
[[nodiscard]] std::optional<double> exact_heading(double heading, int count);

}  // namespace vandplan::search
