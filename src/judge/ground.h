// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What may a vehicle hit, and how far is it away, in the eyes of the judge?
//
// Method and proof: docs/algorithms/path_check.md.

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "judge/cell_tree.h"
#include "judge/clearance.h"
#include "judge/polygon_tree.h"
#include "vandplan/path_check.h"
#include "vandplan/problem.h"
#include "vandplan/vehicle.h"

namespace vandplan::judge {

/// What of a vehicle must not touch: the footprint obstacles and maps, the wheels kerbs.
struct Outlines {
  Outline body, wheels;
};

/// What may be hit, and by what.
struct Thing {
  std::string name;  ///< such as "obstacles[2]" or "the map"
  std::string part;  ///< of what drives: "the footprint" or "the wheels"
  Hit hit = {};
};

/// What makes a verdict impossible: a problem that nobody made, or a margin that is no distance.
/// Empty if there is nothing.
[[nodiscard]] std::string door_fault(const Problem& problem, double margin);

[[nodiscard]] Outlines outlines_of(const Vehicle& vehicle);
[[nodiscard]] Outlines outlines_of(const Trailer& trailer);

/// Obstacles, kerbs and map, ready to be asked. Of no vehicle, so one serves all.
class Ground {
 public:
  /// The surroundings must stay where they are as long as the ground is used.
  explicit Ground(const Surroundings& surroundings);

  /// The same surroundings with other polygons, and with other cells of the map in some ranges.
  Ground(const Ground& before, const Surroundings& surroundings, std::span<const CellRange> cells);

  /// Whether there is nothing to hit, wherever one looks.
  [[nodiscard]] bool is_empty() const { return is_empty_; }

  /// Between the vehicle and the nearest thing that it must not touch [m]. At one position it is
  /// the distance, 0 if they touch or one holds the other; on a passage it is no more than that at
  /// any of its positions. It is never more than `most`.
  [[nodiscard]] double clearance(const View& view, const Outlines& outlines, double most,
                                 Effort& effort) const;

  /// Something at a position that is at most so far from the vehicle [m].
  [[nodiscard]] Thing first_within(double distance, const View& view,
                                   const Outlines& outlines) const;

 private:
  std::vector<std::size_t> fences_;  // of each area that the body stays in: they come first
  PolygonTree obstacles_;
  PolygonTree kerbs_;
  std::optional<CellTree> cells_;
  bool is_empty_;
};

/// What can be hit in a world; made when the judge needs it first, and kept with the world.
[[nodiscard]] std::shared_ptr<const Ground> ground_of(const World& world);

/// For a world that has changed, from what could be hit before.
void renew_ground(const World& world, const Ground& before, std::span<const CellRange> cells);

}  // namespace vandplan::judge
