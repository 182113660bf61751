// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it around the obstacles of a large site, of which a search sees only a strip?

#include <array>
#include <cstdint>
#include <memory>
#include <queue>
#include <unordered_map>
#include <vector>

#include "search/guide.h"
#include "search/polygon_squares.h"
#include "search/raster.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Obstacles and kerbs of a site, for queries about small boxes.
struct SiteSquares {
  PolygonSquares obstacles;
  PolygonSquares kerbs;
};

/// Distances to one target on a grid with eight neighbours. The grid exists only in tiles that the
/// search from the target reaches: a greedy A* whose work and memory grow with the length of the
/// way, not with the area. Polygons are marked tile by tile; a map's cell is looked up when first
/// reached.
class FarGuide final : public Guide {
 public:
  /// Whether a grid over the whole box would need cells wider than the vehicle.
  [[nodiscard]] static bool is_wanted(const Task& task, const Bounds& box);

  /// Resolution and greediness of the search.
  struct Options {
    double side = 1.0;  ///< Side of a cell [vehicle widths].
    /// Factor on the estimate, >= 1. The way found is at most this many times as long as the
    /// shortest one on the grid. Larger values find it sooner.
    double greediness = 1.0;
    bool operator==(const Options&) const = default;
  };

  FarGuide(const Task& task, const Bounds& box, const Options& options, const Pose& target,
           const Pose& root);

  bool step() override;
  [[nodiscard]] bool is_connected() const noexcept override { return reached_; }
  [[nodiscard]] double at(double x, double y) const noexcept override;

  /// The way that was found, from the root to the target: both points, and the centres of the cells
  /// between them. Requires `is_connected`.
  [[nodiscard]] std::vector<Point> way() const;

 private:
  struct Entry {
    std::int64_t rank;
    RasterCell cell;
    bool operator<(const Entry& other) const { return rank > other.rank; }
  };
  static constexpr std::int32_t tile_side = 32;  // Side of a tile [cells].
  using Tile = std::array<std::int32_t, std::size_t{tile_side} * tile_side>;

  [[nodiscard]] bool is_closed(const RasterCell& cell) const;
  /// Closes the cells of a tile within `near` [m] of the sides of polygons. `first` is the tile's
  /// first cell.
  void mark(Tile& tile, const RasterCell& first, const PolygonSquares& polygons, double near) const;
  [[nodiscard]] static std::uint64_t tile_of(const RasterCell& cell) noexcept;
  [[nodiscard]] static std::size_t place_in_tile(const RasterCell& cell) noexcept;
  [[nodiscard]] std::int32_t& cost_at(const RasterCell& cell);
  [[nodiscard]] std::int32_t known_cost(const RasterCell& cell) const noexcept;
  void reach(const RasterCell& cell, std::int32_t cost);
  void settle(const RasterCell& cell, std::int32_t cost);
  [[nodiscard]] std::int64_t rank_of(const RasterCell& cell, std::int32_t cost) const noexcept;

  std::shared_ptr<const SiteSquares> site_;
  const CollisionChecker* map_;  // null without a map
  Bounds box_;
  Point target_;
  Point root_place_;
  Raster raster_;
  double near_;  // Largest distance from the centre of a blocked cell to an obstacle [m].
  std::int64_t greediness_;  // Greediness in units of 1 / `whole`.
  RasterCell root_;
  std::unordered_map<std::uint64_t, std::unique_ptr<Tile>> tiles_;  // Cost of each cell [1/5 cell].
  std::uint64_t last_key_ = 0;  // Key of the tile last asked for.
  Tile* last_tile_ = nullptr;   // The tile last asked for.
  std::priority_queue<Entry> open_;
  std::int64_t front_ = 0;  // Greatest rank that was settled.
  bool reached_ = false;    // Whether the search reached the root.
};

}  // namespace vandplan::search
