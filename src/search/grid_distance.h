// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it around the obstacles, for a disc that the vehicle never gets narrower than?

#include <cstdint>
#include <vector>

#include "search/guide.h"
#include "search/raster.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// A metre costs 1 + weight * max(0, 1 - clearance / distance) times as much.
struct ClearancePrice {
  double weight = 0.0;    ///< >= 0
  double distance = 1.0;  ///< [m]; > 0
};

/// Distances to one target on a grid (eight neighbours), as a guide and not as a bound. They are
/// computed by A* from the target, so only where a search from `root` is likely to come.
class GridDistance final : public Guide {
 public:
  /// The side of the cells that cover `box` [m]: `side` vehicle widths, in large boxes more.
  [[nodiscard]] static double side_of_cells(const Task& task, const Bounds& box, double side);

  /// Covers `box` with cells of `side` vehicle widths, in large boxes of more; nothing is computed
  /// yet, and the task's world outlives the grid. With a price they are what driving costs a disc
  /// as wide as the vehicle, wherever in a cell that is least; kerbs cost nothing.
  GridDistance(const Task& task, const Bounds& box, double side, const Pose& target,
               const Pose& root, const ClearancePrice& price = {});

  /// Marks the next obstacles, some milliseconds of work at most, or settles the next cells, some
  /// microseconds. False when there is no more to do.
  bool step() override;

  /// Whether a way between target and root was found.
  [[nodiscard]] bool is_connected() const noexcept override { return reached_; }

  /// Distance to the target [m]; where it is not known, what it must exceed.
  [[nodiscard]] double at(double x, double y) const noexcept override;
  [[nodiscard]] double length_at(double x, double y) const noexcept override;

 private:
  /// The cell that holds a point of the box.
  [[nodiscard]] RasterCell cell_of(const Point& point) const noexcept;
  void mark_border();
  [[nodiscard]] Point centre_of(const RasterCell& cell) const noexcept;
  [[nodiscard]] bool is_blocked_by_map(const RasterCell& cell) const;
  /// Goes on with the sides of obstacles and kerbs; true when all are marked.
  bool mark();
  /// Blocks the cells that are near to a side, and notes how far others are up to `noted` [m].
  /// Returns at how many it looked.
  std::int64_t mark_side(const Point& a, const Point& b, double near, double noted);
  void begin();
  /// The cell, of `count` inside of the border, that a place falls into; beside them the nearest.
  [[nodiscard]] std::int32_t inner_index(double offset, std::int32_t count) const noexcept;
  [[nodiscard]] bool is_priced() const noexcept { return price_.weight > 0.0; }
  [[nodiscard]] double price_at(const RasterCell& cell) const;
  /// By a step from a cell that `cost` and `length` lead to.
  void reach(const RasterCell& cell, std::int32_t cost, std::int32_t length, std::int32_t step);
  [[nodiscard]] std::size_t index_of(const RasterCell& cell) const noexcept;

  const Surroundings* ground_;
  const CollisionChecker* map_;  // null without a map
  Bounds box_;
  Point target_;
  double side_ = 1.0;  // of a cell [m]
  double near_ = 1.0;  // from the centre of a blocked cell to an obstacle, at most [m]
  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  std::vector<std::int32_t> costs_;  // in fifths of a cell; -1 blocked
  ClearancePrice price_;
  double disc_;                        // its radius [m]
  std::vector<float> gaps_;            // with a price: from the centre to the nearest side [m],
  std::vector<std::int32_t> lengths_;  // and how long the way is, in fifths of a cell
  std::vector<std::vector<RasterCell>> buckets_;
  std::size_t polygon_ = 0;  // an obstacle, or behind them a kerb: what is marked next,
  std::size_t corner_ = 0;   // from the side that ends there
  bool is_marked_ = false;
  std::int32_t front_ = 0;  // cost and distance to the root of what is settled next
  std::int32_t last_;       // of `front_`
  RasterCell root_;
  bool reached_ = false;  // the root
};

}  // namespace vandplan::search
