// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the nearest obstacle, and how far the middle between obstacles?
//
// Distances on a grid, which only guide a search. The middle is the medial axis: from there and
// from one cell beside it, the nearest obstacles are in directions more than 60 degrees apart.

#include <cstdint>
#include <span>
#include <vector>

#include "vandplan/problem.h"

namespace vandplan::search {

/// Distances from the obstacles, kerbs and map of a task, and from the middle between them.
class VoronoiField {
 public:
  /// The task outlives the field. `side`: side of a cell [m]; on large grounds cells are larger.
  VoronoiField(const Task& task, double side);

  /// Computes a part of the field, some hundred microseconds of work. False when the field is
  /// complete.
  bool step();

  /// Distances from the nearest obstacle and from the middle [m], to about half a cell; 10^6 m if
  /// there is none.
  struct Distances {
    double obstacle, middle;
  };
  /// Distances at a point in the frame of the task.
  [[nodiscard]] Distances at(const Point& point) const noexcept;

  /// Range of the potential [m]. The larger `falloff` is, the more slowly the potential falls; from
  /// `reach` on it is 0.
  struct Range {
    double falloff, reach;
  };
  /// Voronoi potential of Dolgov et al. (2010): 1 at obstacles, 0 in the middle between them and
  /// where no obstacle is within reach.
  [[nodiscard]] double potential(const Point& point, const Range& range) const noexcept;
  /// Integral of the potential over the path of the rear axle [m].
  [[nodiscard]] double along(Pose from, std::span<const Segment> segments,
                             const Range& range) const noexcept;

 private:
  /// Column and row of a cell.
  struct Spot {
    std::int32_t x, y;
  };
  /// The nearest seed of each cell. Seeds spread over the grid ring by ring.
  struct Nearest {
    std::vector<Spot> spots;            // nearest seed of each cell; x < 0: unknown
    std::vector<Spot> ring, next_ring;  // cells that spread now, and after them
  };

  [[nodiscard]] std::size_t index(const Spot& spot) const noexcept {
    return static_cast<std::size_t>(spot.y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(spot.x);
  }
  [[nodiscard]] bool contains(const Spot& spot) const noexcept {
    return spot.x >= 0 && spot.y >= 0 && spot.x < columns_ && spot.y < rows_;
  }
  [[nodiscard]] Spot spot_of(const Point& point) const noexcept;
  [[nodiscard]] Point centre_of(const Spot& spot) const noexcept;
  void seed(Nearest& field, const Spot& spot) const;
  void seed_polygons(const std::vector<Polygon>& polygons);
  void seed_inside(const Polygon& polygon);
  void seed_map_row();
  bool spread(Nearest& field) const;
  void seed_middle_row();
  [[nodiscard]] double distance(const Nearest& field, const Spot& spot) const noexcept;

  const Task& task_;
  Bounds box_;
  double side_;
  std::int32_t columns_, rows_;
  Nearest obstacles_, middle_;
  std::int32_t map_row_ = 0;     // next row of cells to seed from the map
  std::int32_t middle_row_ = 0;  // next row whose cells on the middle are seeded
};

}  // namespace vandplan::search
