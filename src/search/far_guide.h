// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it around the obstacles of a whole site, of which only a strip is ever looked at?

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

/// What stands on a site, for those who look at parts of it.
struct SiteSquares {
  PolygonSquares obstacles;
  PolygonSquares kerbs;
};

/// Distances to one target on a grid (eight neighbours) that exists in tiles only where the search
/// from the target comes: a greedy A*, whose work and memory grow with the way and not with the
/// area. Obstacles are marked tile by tile, those of a map when a cell is first reached.
class FarGuide final : public Guide {
 public:
  /// Whether a grid over the whole box would need cells wider than the vehicle.
  [[nodiscard]] static bool is_wanted(const Task& task, const Bounds& box);

  /// How fine and how greedy it is.
  struct Options {
    double side = 1.0;  ///< of a cell [vehicle widths]
    /// The way found is at most so many times as long as the shortest one on the grid, and is found
    /// the sooner the more; >= 1.
    double greediness = 1.0;
    bool operator==(const Options&) const = default;
  };

  FarGuide(const Task& task, const Bounds& box, const Options& options, const Pose& target,
           const Pose& root);

  bool step() override;
  [[nodiscard]] bool is_connected() const noexcept override { return reached_; }
  [[nodiscard]] double at(double x, double y) const noexcept override;

  /// The way that was found, from the root to the target: the places of both, and the centres of
  /// the cells between. Needs `is_connected`.
  [[nodiscard]] std::vector<Point> way() const;

 private:
  struct Entry {
    std::int64_t rank;
    RasterCell cell;
    bool operator<(const Entry& other) const { return rank > other.rank; }
  };
  static constexpr std::int32_t tile_side = 32;  // cells
  using Tile = std::array<std::int32_t, std::size_t{tile_side} * tile_side>;

  [[nodiscard]] RasterCell cell_of(const Point& point) const noexcept;
  [[nodiscard]] Point centre_of(const RasterCell& cell) const noexcept;
  [[nodiscard]] bool is_closed(const RasterCell& cell) const;
  /// The cells of a tile that are near to a side of a polygon; `first` is its first cell.
  void mark(Tile& tile, const RasterCell& first, const PolygonSquares& polygons, double near) const;
  void mark(Tile& tile, const RasterCell& first, const Point& a, const Point& b, double near) const;
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
  double side_;              // of a cell [m]
  double near_;              // from the centre of a blocked cell to an obstacle, at most [m]
  std::int64_t greediness_;  // in parts of `whole`
  RasterCell root_;
  std::unordered_map<std::uint64_t, std::unique_ptr<Tile>> tiles_;  // costs in fifths of a cell
  std::uint64_t last_key_ = 0;  // of the tile that was asked for last,
  Tile* last_tile_ = nullptr;   // and the tile
  std::priority_queue<Entry> open_;
  std::int64_t front_ = 0;  // the greatest rank that was settled
  bool reached_ = false;    // the root
};

}  // namespace vandplan::search
