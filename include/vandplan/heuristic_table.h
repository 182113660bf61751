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

/// What a table of lengths covers. Both ends of every range are grid points.
struct HeuristicTableOptions {
  double extent = 10.0;         ///< of |dx| and |dy| [m]; a multiple of `step`
  double step = 1.0;            ///< of the positions [m]; > 0
  int heading_cells = 8;        ///< steps of one full turn; >= 1; headings stored: one more
  double turning_radius = 7.0;  ///< [m]; > 0
  bool operator==(const HeuristicTableOptions&) const = default;
};

/// What one of the four tables of the thesis covers. Throws InputError unless `number` is 1 to 4.
[[nodiscard]] HeuristicTableOptions thesis_table_options(int number);

/// Reeds-Shepp lengths between relative poses on a four-dimensional grid. Immutable; copies share
/// the entries.
class HeuristicTable {
 public:
  /// Computes all entries of a table (Algorithm 6). Throws InputError if an option is out of range.
  explicit HeuristicTable(const HeuristicTableOptions& options);

  /// Makes a table of entries that were computed before. Throws InputError if an option is out of
  /// range or their number is not what the options ask for.
  HeuristicTable(const HeuristicTableOptions& options, std::vector<float> entries);

  /// Makes a table that looks at entries which outlive it and all its copies: constant data. Throws
  /// InputError if an option is out of range or their number is not what the options ask for.
  HeuristicTable(const HeuristicTableOptions& options, std::span<const float> entries);

  /// Position of an entry in the grid of the table.
  struct GridPoint {
    int x, y, heading_node, heading_sample;
    bool operator==(const GridPoint&) const = default;
  };

  /// Place of a grid point in `entries()`: row-major [x][y][heading_node][heading_sample].
  [[nodiscard]] std::size_t index_of(const GridPoint& point) const noexcept;

  /// The pose of the node of a grid point [m, rad], in a frame with the sample at the origin.
  [[nodiscard]] Pose node_of(const GridPoint& point) const noexcept;
  /// The pose of the sample of a grid point: at the origin, its heading in [-pi, pi] [rad].
  [[nodiscard]] Pose sample_of(const GridPoint& point) const noexcept;

  /// Estimated length between a node and a sample [m] for a vehicle of turning radius `radius`
  /// (Algorithm 7): an entry inside the table, Euclid outside. The table scales with the radius:
  /// extent and step hold for the table's own.
  [[nodiscard]] double distance(const Pose& node, const Pose& sample, double radius) const;

  /// Estimated lengths between every node and one sample, in float [m]: out[i] belongs to node i.
  /// Sizes are equal. Otherwise like `distance`.
  void distances(const PoseColumns& nodes, const Pose& sample, double radius,
                 std::span<float> out) const;

  /// What the table covers.
  [[nodiscard]] const HeuristicTableOptions& options() const noexcept { return options_; }
  /// All lengths [m], in the order of `index_of`.
  [[nodiscard]] std::span<const float> entries() const noexcept { return entries_; }

  /// The number of grid points along x, and likewise along y.
  [[nodiscard]] int positions() const noexcept { return positions_; }
  /// The number of grid points of a heading, both ends of the turn counted.
  [[nodiscard]] int headings() const noexcept { return options_.heading_cells + 1; }

 private:
  HeuristicTableOptions options_;
  int positions_ = 0;
  std::shared_ptr<const std::vector<float>> storage_;  // empty when the entries are constant data
  std::span<const float> entries_;
};

/// One of the four tables of the thesis, turning radius 7 m, computed when the library was built.
/// `number` is in 1..4. Costs nothing to call.
[[nodiscard]] HeuristicTable thesis_table(int number);

}  // namespace vandplan
