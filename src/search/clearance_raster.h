// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the vehicle from obstacles, approximately, for searches that test very many poses?

#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/raster.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Approximate clearance of the body from obstacles and blocked cells, beyond the margin. It uses
/// distances on a raster, and discs and corners in place of the body. Kerbs are ignored. An
/// estimate, no guarantee.
class ClearanceRaster {
 public:
  /// Covers a box. Clearances above `most` [m] are not distinguished. The task's world must outlive
  /// the raster.
  ClearanceRaster(const Task& task, const Bounds& box, double most);

  /// Does some ten microseconds of work. False when nothing is left to do.
  bool step();

  /// Clearance at a pose with this cosine and sine of the heading [m]; negative if bodies overlap.
  /// Requires that `step` is finished. Map cells are looked up when first asked for.
  [[nodiscard]] float clearance(float x, float y, float cos, float sin) noexcept;
  /// Whether a pose with enough clearance is free but for rules of zones: there are no kerbs, and
  /// the body is a rectangle.
  [[nodiscard]] bool is_trusted() const noexcept { return is_trusted_; }
  /// Whether zones have rules.
  [[nodiscard]] bool has_rules() const noexcept { return has_rules_; }
  /// Approximate error of the clearance [m].
  [[nodiscard]] float fineness() const noexcept { return static_cast<float>(raster_.side) / 4; }

 private:
  /// Disc of the body in the vehicle's frame [m]; a corner has only the margin as radius.
  struct Disc {
    float ahead, aside, radius;
  };

  std::int64_t mark(const Point& a, const Point& b);
  [[nodiscard]] std::size_t index_of(RasterCell cell) const noexcept {
    return static_cast<std::size_t>(cell.y * columns_ + cell.x);
  }
  [[nodiscard]] float distance_of(RasterCell cell) noexcept;
  void ask_map(RasterCell cell) noexcept;
  [[nodiscard]] float distance(float x, float y) noexcept;

  const Surroundings* ground_;
  const CollisionChecker* map_;  // Null without a map.
  double margin_;                // Margin that the body keeps [m].
  float most_;                   // Largest clearance that is given back [m].
  /// Middle of the body ahead of the rear axle, and its largest reach from there plus margin [m].
  float middle_, reach_;
  double furthest_;  // Largest distance on the raster [m].
  Raster raster_;
  float per_side_;
  std::int32_t columns_, rows_;
  std::vector<float> distances_;  // Distance from a cell's centre to the nearest obstacle [m].
  std::vector<bool> is_asked_;    // Whether the map was looked up, for each cell.
  std::vector<Disc> discs_;
  bool is_trusted_, has_rules_;
  std::size_t polygon_ = 0;  // Obstacle marked next.
  std::size_t corner_ = 0;   // End of the side marked next.
};

}  // namespace vandplan::search
