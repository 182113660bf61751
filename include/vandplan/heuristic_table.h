// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it, answered from a table? (the thesis' heuristic look-up table, HLUT)
//
// Algorithms 5, 6 and 7 of Guo 2020 as settled in docs/algorithms/heuristic_table.md.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan {

/// Range and grid of a table of lengths. Both ends of every range are grid points. Lengths are
/// 1e-6 to 1e6 m.
struct HeuristicTableOptions {
  double extent = 10.0;   ///< entries count for |dx| and |dy| below it [m]; a multiple of `step`
  double step = 1.0;      ///< distance of grid points along x and y [m]; > 0
  int heading_cells = 8;  ///< steps of a full turn; >= 1; one more heading is stored
  double turning_radius = 7.0;  ///< turning radius of the lengths [m]; > 0
  bool operator==(const HeuristicTableOptions&) const = default;
};

/// Options of one of the four tables of the thesis. Throws InputError naming "number" unless it is
/// 1 to 4.
[[nodiscard]] HeuristicTableOptions thesis_table_options(int number);

/// Reeds-Shepp lengths between relative poses on a four-dimensional grid. Immutable; copies share
/// the entries.
class HeuristicTable {
 public:
  /// Computes all entries of a table (Algorithm 6). Throws InputError naming the option that is out
  /// of range; "step" if there would be more than 2^28 entries.
  explicit HeuristicTable(const HeuristicTableOptions& options);

  /// Makes a table of entries that were computed before. Throws InputError naming the option that
  /// is out of range, or "entries" if their number is not what the options ask for.
  HeuristicTable(const HeuristicTableOptions& options, std::vector<float> entries);

  /// Makes a table of constant data: the entries must outlive it and all its copies. Throws
  /// InputError naming the option that is out of range, or "entries" if their number is not what
  /// the options ask for.
  HeuristicTable(const HeuristicTableOptions& options, std::span<const float> entries);

  /// Position of an entry in the grid of the table.
  struct GridPoint {
    int x, y, heading_node, heading_sample;
    bool operator==(const GridPoint&) const = default;
  };

  /// Place of a grid point in `entries()`: row-major [x][y][heading_node][heading_sample].
  [[nodiscard]] std::size_t index_of(const GridPoint& point) const noexcept;

  /// Pose of the node of a grid point [m, rad], in the frame with the sample's position as origin.
  [[nodiscard]] Pose node_of(const GridPoint& point) const noexcept;
  /// Pose of the sample of a grid point: at the origin, heading in [-pi, pi] [rad].
  [[nodiscard]] Pose sample_of(const GridPoint& point) const noexcept;

  /// Estimated length between a node and a sample [m] for a vehicle of turning radius `radius` [m]
  /// (Algorithm 7). It is an entry where |dx| and |dy| are below the extent, and the Euclidean
  /// distance elsewhere. |dx| and |dy| are rounded down to the grid, headings to the nearest grid
  /// point, so the estimate is no bound: it may be too small or too large. The table scales with
  /// the radius: extent and step hold for the table's own radius. Throws InputError naming "radius"
  /// unless it is finite and > 0.
  [[nodiscard]] double distance(const Pose& node, const Pose& sample, double radius) const;

  /// Estimated lengths between every node and one sample, in float [m]: out[i] belongs to node i.
  /// They are those of `distance` for the sample as rounded to float, which differs far from the
  /// origin. Headings of nodes are in [-pi, pi]. Throws InputError naming "radius" unless it is
  /// finite and > 0, or "nodes" unless all columns have as many numbers as `out`.
  void distances(const PoseColumns& nodes, const Pose& sample, double radius,
                 std::span<float> out) const;

  /// Range and grid of the table.
  [[nodiscard]] const HeuristicTableOptions& options() const noexcept { return options_; }
  /// All lengths [m], in the order of `index_of`.
  [[nodiscard]] std::span<const float> entries() const noexcept { return entries_; }

  /// Number of grid points along x; along y there are as many.
  [[nodiscard]] int positions() const noexcept { return positions_; }
  /// Number of grid points of a heading, both ends of the turn counted.
  [[nodiscard]] int headings() const noexcept { return options_.heading_cells + 1; }

 private:
  HeuristicTableOptions options_;
  int positions_ = 0;
  std::shared_ptr<const std::vector<float>> storage_;  // empty when the entries are constant data
  std::span<const float> entries_;
};

/// One of the four tables of the thesis, turning radius 7 m, computed when the library was built.
/// `number` is 1 to 4, otherwise InputError names it. Costs nothing to call.
[[nodiscard]] HeuristicTable thesis_table(int number);

}  // namespace vandplan
