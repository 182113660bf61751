// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the next thing, and how far the middle between things?
//
// Distances on a grid, as a guide: nothing is decided by them. The middle is the medial axis: there
// a step aside has another nearest thing, more than 60 degrees away from the first one.

#include <cstdint>
#include <span>
#include <vector>

#include "vandplan/problem.h"

namespace vandplan::search {

/// Distances from the obstacles, kerbs and map of a task, and from the middle between them.
class VoronoiField {
 public:
  /// The task outlives the field. Cells have that side [m], more on large grounds.
  VoronoiField(const Task& task, double side);

  /// Some hundred microseconds of work. False when there is no more to do.
  bool step();

  /// From the nearest thing, and from the middle between things [m], to half a cell or so; far away
  /// where there is none.
  struct Distances {
    double obstacle, middle;
  };
  [[nodiscard]] Distances at(const Point& point) const noexcept;

  /// How far things are felt [m]: the potential falls the more slowly the larger `falloff` is, and
  /// is 0 from `reach` on.
  struct Range {
    double falloff, reach;
  };
  /// The potential of Dolgov et al. (2010): 1 at things, 0 in the middle between them and where
  /// nothing is within reach.
  [[nodiscard]] double potential(const Point& point, const Range& range) const noexcept;
  /// Its integral over what the rear axle drives [m].
  [[nodiscard]] double along(Pose from, std::span<const Segment> segments,
                             const Range& range) const noexcept;

 private:
  struct Spot {
    std::int32_t x, y;
  };
  /// Which seed is nearest to each cell; seeds spread ring by ring.
  struct Nearest {
    std::vector<Spot> spots;  // x < 0: none is known
    std::vector<Spot> ring, next_ring;
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
  std::int32_t map_row_ = 0;     // that is seeded next
  std::int32_t middle_row_ = 0;  // likewise, once all obstacles have spread
};

}  // namespace vandplan::search
