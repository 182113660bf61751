// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it from one point to all others, through the open cells of a lattice? Exact lengths.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "search/taut_ways.h"

namespace vandplan::search {

/// Lengths of the shortest ways from a start [cells]. They cover all places on ways to the goal
/// that are at most `longest` long.
class GeodesicField {
 public:
  GeodesicField() = default;
  /// Start and goal are in cells of the lattice and lie in open cells.
  GeodesicField(OpenRows lattice, const Point& start, const Point& goal, double longest);

  /// Works until `work()` is at least `work` nodes. False when nothing is left to do.
  bool go_on(std::int64_t work);
  [[nodiscard]] std::int64_t work() const noexcept { return ways_.work(); }
  /// Whether the search stopped because it grew too large. Its lengths are then invalid.
  [[nodiscard]] bool is_given_up() const noexcept { return is_given_up_; }

  /// Length of the shortest way to a point [cells], with a rounding error of 1e-6. Infinite in
  /// closed cells and where no way leads. Too long perhaps at places that are on no way up to
  /// `longest`.
  [[nodiscard]] double at(const Point& point);
  /// Whether a way passes a row of cells.
  [[nodiscard]] bool has_row(std::int32_t row) { return ways_.lattice().is_known(row); }
  /// Cells of a row whose middle is at `distance` from the start, plus or minus `near` [cells].
  [[nodiscard]] std::vector<std::int32_t> cells_at(std::int32_t row, double distance, double near);

 private:
  TautWays ways_;
  bool is_given_up_ = false;
  std::size_t count_ = 0;
  /// Nodes that lead into each run.
  std::unordered_map<std::int64_t, std::vector<TautWays::Node>> into_;
};

}  // namespace vandplan::search
