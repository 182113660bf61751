// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which parts of a segment are not decided by the distance field?
//
// Discs that cover the body follow the segment. Where the field shows that no disc can reach a
// blocked cell, the segment is clear as far as the free distance lasts. The idea is sphere tracing
// (Hart 1996), here from the middle of each undecided part instead of from one end.

#include <array>
#include <cstddef>
#include <span>

#include "collision/sweep.h"
#include "geometry/distance_field.h"
#include "vandplan/vehicle.h"

namespace vandplan::collision {

/// Equal discs that cover a body; their centres lie in a row along its middle line.
struct DiscRow {
  double first;     // First centre ahead of the rear axle [m].
  double step;      // Distance from one centre to the next [m].
  int count;        // Number of discs, >= 1.
  double furthest;  // Largest distance of a centre from the rear axle [m].
  double outer;     // Radius with which the discs cover the body and its margin [m].
  double inner;     // Radius of discs inside the body and its margin [m].
};

/// Two covers of one body by discs.
struct DiscRows {
  /// Covers the body and all points within `margin` of it [m].
  explicit DiscRows(const Shape& body, double margin = 0.0) noexcept;

  DiscRow one;   // Cover of one disc.
  DiscRow slim;  // Cover of several discs, hardly wider than the box around the body.
};

/// Part of a segment: distances of its begin and end from the start of the segment [m].
struct Part {
  double begin, end;
};

/// Result of following a segment through the distance field.
struct DiscTrace {
  static constexpr std::size_t most_looks = 64;

  bool is_hit = false;  ///< Whether the body certainly touches a blocked cell.
  std::size_t doubtful_count = 0;
  /// Undecided parts; a tree of looks has one leaf more than forks.
  std::array<Part, most_looks + 1> doubtful;

  /// Undecided parts of the segment, in order. The rest is clear unless `is_hit`.
  [[nodiscard]] std::span<const Part> in_doubt() const noexcept {
    return {doubtful.data(), doubtful_count};
  }
};

/// Follows a segment, given in the frame of the cells, through the field. `side`: side of a cell
/// [m].
[[nodiscard]] DiscTrace trace_discs(const geometry::DistanceField& field, double side,
                                    const DiscRows& discs, const PlacedSegment& placed) noexcept;

}  // namespace vandplan::collision
