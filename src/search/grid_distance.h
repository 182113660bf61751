// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it around the obstacles, for a disc as wide as the vehicle is at its narrowest?

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "search/guide.h"
#include "search/polygon_squares.h"
#include "search/raster.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Price of small clearance: a metre costs 1 + weight * max(0, 1 - clearance / distance).
struct ClearancePrice {
  double weight = 0.0;    ///< Added price of a metre that touches an obstacle; >= 0.
  double distance = 1.0;  ///< Clearance from which on there is no added price [m]; > 0.
};

/// Side of the cells of a fine grid, the guide of a search [vehicle widths].
inline constexpr double fine_guide_side = 0.5;

/// Side of the cells of a grid that covers the whole box [m]: `side` vehicle widths, more in large
/// boxes.
[[nodiscard]] double side_over_all(const Task& task, const Bounds& box, double side);

/// Whether a grid over the whole box would need cells wider than the vehicle.
[[nodiscard]] bool is_site(const Task& task, const Bounds& box);

/// Obstacles and kerbs of a world, for queries about small boxes.
struct SiteSquares {
  PolygonSquares obstacles;
  PolygonSquares kerbs;
};

/// Distances to one target on a grid with eight neighbours: an estimate, not a bound. A* computes
/// them from the target, so only where a search from the root is likely to come. The grid exists
/// only in tiles that it reaches. Polygons are marked tile by tile, and a map's cell is looked up
/// when first reached. So work and memory grow with the length of the way, not with the area.
class GridDistance final : public Guide {
 public:
  /// What the grid is like and how it is searched.
  struct Options {
    double side = 1.0;  ///< Side of a cell [m].
    /// With a price the distances are costs for a disc as wide as the vehicle, at the cheapest
    /// place of each cell. Kerbs add no price.
    ClearancePrice price = {};
    /// Factor on the estimate, >= 1, a multiple of 1/4. The way found is at most this many times as
    /// long as the shortest one on the grid. Larger values find it sooner.
    double greediness = 1.0;
    /// Cells are settled on ways up to this factor longer than the shortest.
    double detour = 1.1;
  };

  /// Covers `box`. Computes hardly anything yet. The task's world must outlive the grid.
  GridDistance(const Task& task, const Bounds& box, const Pose& target, const Pose& root,
               const Options& options);
  GridDistance(GridDistance&&) noexcept = default;

  /// Settles the next cells: some microseconds, and more where it makes tiles with very many sides.
  /// False when nothing is left to do.
  bool step() override;

  /// Whether a way between target and root was found.
  [[nodiscard]] bool is_connected() const noexcept override { return reached_; }

  /// Distance to the target [m]; where it is not known, a lower bound on it.
  [[nodiscard]] double at(double x, double y) const noexcept override;

  /// The way that was found, from the root to the target: both points, and the centres of the cells
  /// between them. Requires `is_connected`.
  [[nodiscard]] std::vector<Point> way() const;

 private:
  static constexpr std::int32_t tile_side = 32;  // Side of a tile [cells].
  struct Tile {
    std::array<std::int32_t, std::size_t{tile_side} * tile_side> costs;  // [1/5 cell]; -1: blocked.
    /// Squared distances from the centres to the nearest side [m^2]. Empty without a price.
    std::vector<float> squared_gaps;
  };

  /// Cell that contains a point of the box, the nearest one for other points.
  [[nodiscard]] RasterCell cell_of(const Point& point) const noexcept;
  [[nodiscard]] std::size_t index_of_tile(const RasterCell& cell) const noexcept;
  [[nodiscard]] static std::size_t place_of(const RasterCell& cell) noexcept;
  /// Tile of a cell, made when first asked for.
  [[nodiscard]] Tile& tile_of(const RasterCell& cell);
  [[nodiscard]] std::int32_t known_cost(const RasterCell& cell) const noexcept;
  /// Blocks the cells of a tile within `near` [m] of sides. Stores the distances of others up to
  /// `noted` [m].
  void mark(Tile& tile, const RasterCell& first, const PolygonSquares& polygons, double near,
            double noted);
  [[nodiscard]] bool is_blocked_by_map(const RasterCell& cell) const;
  [[nodiscard]] bool is_priced() const noexcept { return price_.weight > 0.0; }
  [[nodiscard]] double price_at(const RasterCell& cell, float gap) const;
  [[nodiscard]] std::int64_t rank_of(const RasterCell& cell, std::int32_t cost) const noexcept;
  /// Reaches a cell by a step from a cell with this cost.
  void reach(const RasterCell& cell, std::int32_t cost, std::int32_t step);
  void settle(const RasterCell& cell);

  std::shared_ptr<const SiteSquares> site_;
  const CollisionChecker* map_;  // Null without a map.
  Bounds box_;
  Point target_, root_place_;
  Raster raster_;
  double disc_;  // Radius of the disc [m].
  double near_;  // Largest distance from the centre of a blocked cell to an obstacle [m].
  std::int32_t columns_, rows_;
  ClearancePrice price_;
  std::int64_t whole_;       // Units of ranks in 1/5 cell.
  std::int64_t greediness_;  // Factor on the estimate in these units.
  double detour_;
  RasterCell root_, to_;  // Cells of the root and the target.
  std::vector<std::unique_ptr<Tile>> tiles_;
  std::int32_t tile_columns_;
  std::size_t made_tiles_ = 0;
  std::int64_t least_;                            // Least rank that a cell may have.
  std::int64_t front_;                            // Least rank of the cells to settle.
  std::int64_t greatest_;                         // Greatest value that `front_` had.
  std::vector<std::vector<RasterCell>> buckets_;  // Cells to settle, by rank less `least_`.
  std::int64_t last_;                             // Greatest rank to settle.
  bool reached_ = false;                          // Whether the search reached the root.
};

}  // namespace vandplan::search
