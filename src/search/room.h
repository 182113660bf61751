// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// About how far is the vehicle from what stands around it, for searches that look at a great many
// poses?

#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/raster.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// About how far the body of a vehicle is from obstacles and blocked cells, beyond the margin that
/// it keeps: distances on a raster, and discs and corners in place of the body. Kerbs are left out.
/// A guide and no promise.
class Room {
 public:
  /// In a box; what is farther than `most` is not told apart [m]. The task's world outlives the
  /// room.
  Room(const Task& task, const Bounds& box, double most);

  /// Some ten microseconds of work. False when there is no more to do.
  bool step();

  /// At a pose with that sine and cosine of the heading [m]: less than 0 where they overlap. To be
  /// asked when there is no more to do. What a map says is looked up when it is first asked for.
  [[nodiscard]] float clearance(float x, float y, float cos, float sin) noexcept;
  /// Whether what has much room is free: there are no kerbs, and the body is a rectangle.
  [[nodiscard]] bool is_trusted() const noexcept { return is_trusted_; }
  /// How far that may be off, about [m].
  [[nodiscard]] float fineness() const noexcept { return static_cast<float>(side_) / 4; }

 private:
  /// A part of the body in its frame [m]; a corner has no radius.
  struct Disc {
    float ahead, aside, radius;
  };

  std::int64_t mark(const Point& a, const Point& b);
  [[nodiscard]] std::int32_t column_of(double x) const noexcept;
  [[nodiscard]] std::int32_t row_of(double y) const noexcept;
  [[nodiscard]] float distance_of(std::int32_t column, std::int32_t row) noexcept;
  [[nodiscard]] float distance(float x, float y) noexcept;

  const Surroundings* ground_;
  const CollisionChecker* map_;  // null without a map
  Bounds box_;
  double margin_;  // that the body keeps [m]
  float most_;
  float middle_, reach_;  // of the body: how far ahead it is, and what is farthest from it [m]
  double furthest_;       // distance that is told apart [m]
  double side_;           // of a cell [m]
  float per_side_;
  std::int32_t columns_, rows_;
  std::vector<float> distances_;  // from the centres of cells to what is nearest [m]
  std::vector<bool> is_asked_;    // whether the map was, for each of them
  std::vector<Disc> discs_;
  bool is_trusted_;
  std::size_t polygon_ = 0;  // what is marked next,
  std::size_t corner_ = 0;   // from the side that ends there
};

}  // namespace vandplan::search
