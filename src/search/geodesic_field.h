// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it from one point to any other one, through the open cells of a lattice? Exactly.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "search/taut_ways.h"

namespace vandplan::search {

/// Lengths of the shortest ways from a start, in cells of the lattice, for all places that lie on a
/// way to the goal which is no longer than `longest`.
class GeodesicField {
 public:
  GeodesicField() = default;
  /// Both points, in cells, are in open cells.
  GeodesicField(OpenRows lattice, const Point& start, const Point& goal, double longest);

  /// Goes on until its work is at least `work` nodes. False when there is nothing left to do.
  bool go_on(std::int64_t work);
  [[nodiscard]] std::int64_t work() const noexcept { return ways_.work(); }
  /// Whether it was given up, as there is too much of it: what it says is worth nothing.
  [[nodiscard]] bool is_given_up() const noexcept { return is_given_up_; }

  /// Length of the shortest way to the point, but for rounding (1e-6); infinite in closed cells and
  /// where no way leads. Elsewhere than on ways up to `longest` it may be too long.
  [[nodiscard]] double at(const Point& point);
  /// Whether some way comes by a row of cells.
  [[nodiscard]] bool has_row(std::int32_t row) { return ways_.lattice().is_known(row); }
  /// The cells of a row whose middle is so far from the start, give or take `near`.
  [[nodiscard]] std::vector<std::int32_t> cells_at(std::int32_t row, double distance, double near);

 private:
  TautWays ways_;
  bool is_given_up_ = false;
  std::size_t count_ = 0;
  std::unordered_map<std::int64_t, std::vector<TautWays::Node>> into_;  // by run
};

}  // namespace vandplan::search
