// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where are the vertices of a lattice in a task, and which primitives join them?
//
// The goal is the lattice's vertex at the origin. So ways over the lattice end exactly at the goal,
// and one table of ways to the origin serves every task.

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "lab/lattice_table.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Primitives for a task, with the table of shortest ways over them.
struct LatticeParts {
  std::shared_ptr<const Primitives> primitives;
  std::shared_ptr<const LatticeTable> table;  ///< null if making it was interrupted
  double table_scale = 1.0;                   ///< metres per unit of the table's lengths
  AllowedGears gears = AllowedGears::both;    ///< gears in which the primitives are driven
};

/// The primitives of `make_primitives` in the allowed gears, scaled to the vehicle. Primitives and
/// table are computed once in a process, for a turning radius of 1 m.
[[nodiscard]] LatticeParts standard_lattice(const Task& task,
                                            const std::function<bool()>& is_interrupted,
                                            AllowedGears gears = AllowedGears::both);

/// The given primitives in the allowed gears. Throws InputError naming "primitives" when they turn
/// more sharply than the vehicle can, or when none of them is left.
[[nodiscard]] LatticeParts given_lattice(const Task& task,
                                         std::shared_ptr<const Primitives> primitives,
                                         const std::function<bool()>& is_interrupted,
                                         AllowedGears gears = AllowedGears::both);

/// A piece from the start to a vertex.
struct Joint {
  Vertex vertex;
  Piece piece;
};

/// A lattice laid through the goal of a task.
class LatticeGraph {
 public:
  /// A primitive as the search sees it.
  struct Move {
    std::int32_t dx, dy, to;  ///< change of x and y [steps]; index of the end heading
    double length;            ///< length of the primitive [m]
  };

  LatticeGraph(const Task& task, LatticeParts parts);

  [[nodiscard]] const Vertex& goal() const noexcept { return goal_; }
  /// Pose of a vertex, in the frame of the task.
  [[nodiscard]] LocalPose pose_of(const Vertex& vertex) const noexcept;
  /// Moves that begin with a heading (index). `first_move` is the number of the first of these
  /// moves, and `piece` takes such numbers.
  [[nodiscard]] std::span<const Move> moves(std::int32_t heading) const noexcept;
  [[nodiscard]] std::int32_t first_move(std::int32_t heading) const noexcept;
  [[nodiscard]] const Piece& piece(std::int32_t move) const noexcept {
    return parts_.primitives->all()[static_cast<std::size_t>(move)].piece;
  }

  /// Shortest pieces from a pose to the vertices around the pose, in the order of the vertices.
  [[nodiscard]] std::vector<Joint> joints(const Pose& start) const;

  /// Lower bound of the length of every way over the lattice from a vertex to the goal [m].
  [[nodiscard]] double least_way(const Vertex& vertex) const noexcept;

  [[nodiscard]] const LatticeParts& parts() const noexcept { return parts_; }

 private:
  const Task& task_;
  LatticeParts parts_;
  double radius_;  // turning radius [m]
  Vertex goal_;
  Pose frame_;                    // frame of the grid, in the frame of the task
  double sin_, cos_;              // sine and cosine of the frame's heading
  std::vector<double> headings_;  // headings of vertices in the frame of the task [rad]
  std::vector<Move> moves_;
};

}  // namespace vandplan::search
