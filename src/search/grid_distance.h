// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it around the obstacles, for a disc as wide as the vehicle is at its narrowest?

#include <cstdint>
#include <vector>

#include "search/guide.h"
#include "search/raster.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Price of small clearance: a metre costs 1 + weight * max(0, 1 - clearance / distance).
struct ClearancePrice {
  double weight = 0.0;    ///< Added price of a metre that touches an obstacle; >= 0.
  double distance = 1.0;  ///< Clearance from which on there is no added price [m]; > 0.
};

/// Largest distance from an obstacle to the centre of a cell in which no point is free for the disc
/// [m]. At least the cells that the obstacle's sides cross are blocked.
[[nodiscard]] double blocked_within(const Task& task, double side);

/// Distances to one target on a grid with eight neighbours: an estimate, not a bound. A* computes
/// them from the target, so only where a search from `root` is likely to come.
class GridDistance final : public Guide {
 public:
  /// Side of the cells that cover `box` [m]: `side` vehicle widths, more in large boxes.
  [[nodiscard]] static double side_of_cells(const Task& task, const Bounds& box, double side);

  /// Covers `box` with cells of `side` vehicle widths, more in large boxes. Computes nothing yet;
  /// the task's world must outlive the grid. With a price the distances are costs for a disc as
  /// wide as the vehicle, at the cheapest place of each cell. Kerbs add no price.
  GridDistance(const Task& task, const Bounds& box, double side, const Pose& target,
               const Pose& root, const ClearancePrice& price = {});

  /// Marks the next obstacles (some milliseconds at most) or settles the next cells (some
  /// microseconds). False when nothing is left to do.
  bool step() override;

  /// Whether a way between target and root was found.
  [[nodiscard]] bool is_connected() const noexcept override { return reached_; }

  /// Distance to the target [m]; where it is not known, a lower bound on it.
  [[nodiscard]] double at(double x, double y) const noexcept override;
  [[nodiscard]] double length_at(double x, double y) const noexcept override;

 private:
  [[nodiscard]] RasterCell cell_in_box(const Point& point) const noexcept;
  [[nodiscard]] bool is_blocked_by_map(const RasterCell& cell) const;
  /// Marks the sides of more obstacles and kerbs; true when all are marked.
  bool mark();
  /// Blocks the cells within `near` [m] of a side, and stores the distances of others up to `noted`
  /// [m]. Returns the number of cells it looked at.
  std::int64_t mark_side(const Point& a, const Point& b, double near, double noted);
  void begin();
  [[nodiscard]] bool is_priced() const noexcept { return price_.weight > 0.0; }
  [[nodiscard]] double price_at(const RasterCell& cell) const;
  /// Reaches a cell by a step from a cell with this cost and length.
  void reach(const RasterCell& cell, std::int32_t cost, std::int32_t length, std::int32_t step);
  [[nodiscard]] std::size_t index_of(const RasterCell& cell) const noexcept;

  const Surroundings* ground_;
  const CollisionChecker* map_;  // Null without a map.
  Bounds box_;
  Point target_;
  Raster raster_;
  double near_ = 1.0;  // Largest distance from the centre of a blocked cell to an obstacle [m].
  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  std::vector<std::int32_t> costs_;  // Cost of each cell [1/5 cell]; -1: blocked.
  ClearancePrice price_;
  double disc_;              // Radius of the disc [m].
  std::vector<float> gaps_;  // With a price: distance from a cell's centre to the nearest side [m].
  std::vector<std::int32_t> lengths_;  // With a price: length of the way from each cell [1/5 cell].
  std::vector<std::vector<RasterCell>> buckets_;
  std::size_t polygon_ = 0;  // Polygon marked next: obstacles first, then kerbs.
  std::size_t corner_ = 0;   // End of the side marked next.
  bool is_marked_ = false;
  std::int32_t front_ = 0;  // Cost plus distance to the root of the cells settled next.
  std::int32_t last_;       // Largest value of `front_` to settle.
  RasterCell root_, to_;    // Cells of the root and the target.
  bool reached_ = false;    // Whether the search reached the root.
};

}  // namespace vandplan::search
