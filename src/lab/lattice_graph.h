// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where are the vertices of a lattice in a task, and what leads from one to the next?
//
// The lattice is laid so that the goal is its vertex at the origin: what ends there ends at the
// goal exactly, and one table of ways to one vertex serves every task.

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "lab/lattice_table.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Primitives for a task, with their table of ways.
struct LatticeParts {
  std::shared_ptr<const Primitives> primitives;
  std::shared_ptr<const LatticeTable> table;  ///< null if making it was interrupted
  double table_scale = 1.0;                   ///< a length of the table in metres
  AllowedGears gears = AllowedGears::both;    ///< in which the primitives are driven
};

/// The primitives of `make_primitives` for the vehicle, those in the allowed gears; they and their
/// table are computed once in a process, for radius 1.
[[nodiscard]] LatticeParts standard_lattice(const Task& task,
                                            const std::function<bool()>& is_interrupted,
                                            AllowedGears gears = AllowedGears::both);

/// Given primitives, those in the allowed gears. Throws InputError naming "primitives" when they
/// turn more sharply than the vehicle can, or when there is none.
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
  /// What a search reads of a primitive.
  struct Move {
    std::int32_t dx, dy, to;
    double length;  ///< [m]
  };

  LatticeGraph(const Task& task, LatticeParts parts);

  [[nodiscard]] const Vertex& goal() const noexcept { return goal_; }
  [[nodiscard]] LocalPose pose_of(const Vertex& vertex) const noexcept;
  /// Moves that begin with a heading; `first_move` is the position of the first one in `piece`.
  [[nodiscard]] std::span<const Move> moves(std::int32_t heading) const noexcept;
  [[nodiscard]] std::int32_t first_move(std::int32_t heading) const noexcept;
  [[nodiscard]] const Piece& piece(std::int32_t move) const noexcept {
    return parts_.primitives->all()[static_cast<std::size_t>(move)].piece;
  }

  /// The shortest pieces from a pose to the vertices around it, in the order of the vertices.
  [[nodiscard]] std::vector<Joint> joints(const Pose& start) const;

  /// What no way over the lattice from a vertex to the goal is shorter than [m].
  [[nodiscard]] double least_way(const Vertex& vertex) const noexcept;

  [[nodiscard]] const LatticeParts& parts() const noexcept { return parts_; }

 private:
  const Task& task_;
  LatticeParts parts_;
  double radius_;  // turning radius [m]
  Vertex goal_;
  Pose frame_;  // of the grid, in the frame of the task
  double sin_, cos_;
  std::vector<double> headings_;  // in the frame of the task
  std::vector<Move> moves_;
};

}  // namespace vandplan::search
