// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which parts of a segment does the distance field leave in doubt?
//
// Discs that cover the body are followed along the segment: where the field is so large that
// none of them can get to a blocked cell, all is clear as far as that reaches. The idea is sphere
// tracing (Hart 1996), here from the middle of what is left instead of from one end.

#include <array>
#include <cstddef>
#include <span>

#include "collision/sweep.h"
#include "geometry/distance_field.h"
#include "vandplan/vehicle.h"

namespace vandplan::collision {

/// Equal discs that cover a body, their centres in a row along its middle.
struct DiscRow {
  double first;     // centre ahead of the rear axle [m]
  double step;      // from one centre to the next [m]
  int count;        // >= 1
  double furthest;  // centre from the rear axle [m]
  double outer;     // radius with which they cover the body, and a margin [m]
  double inner;     // radius with which the body covers each of them, less a margin [m]
};

/// Two covers of a body.
struct DiscRows {
  /// Of the body and all that is within a margin of it [m].
  explicit DiscRows(const Shape& body, double margin = 0.0) noexcept;

  DiscRow one;   // of one disc
  DiscRow slim;  // of so many that they are hardly wider than the box around the body
};

/// A part of a segment: where it begins and ends, from the start of the segment [m].
struct Part {
  double begin, end;
};

/// What the field tells of a segment.
struct DiscTrace {
  static constexpr std::size_t most_looks = 64;

  bool is_hit = false;  ///< the body certainly touches a blocked cell
  std::size_t doubtful_count = 0;
  std::array<Part, most_looks + 1> doubtful;  ///< a tree of looks has one leaf more than forks

  /// The parts of the segment, in order, outside of which all is clear if it is no hit.
  [[nodiscard]] std::span<const Part> in_doubt() const noexcept {
    return {doubtful.data(), doubtful_count};
  }
};

/// What the field tells of a segment that lies in the frame of the cells, whose side is that long
/// [m].
[[nodiscard]] DiscTrace trace_discs(const geometry::DistanceField& field, double side,
                                    const DiscRows& discs, const PlacedSegment& placed) noexcept;

}  // namespace vandplan::collision
