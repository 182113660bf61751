// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which obstacles may a vehicle hit, and how far are they, in the eyes of the judge?
//
// Method: docs/algorithms/path_check.md; proof: docs/proofs/judge.md.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "judge/cell_tree.h"
#include "judge/clearance.h"
#include "judge/polygon_tree.h"
#include "vandplan/judge.h"
#include "vandplan/problem.h"
#include "vandplan/vehicle.h"

namespace vandplan::judge {

/// Outlines of a body: `body` must not touch obstacles and the map, `wheels` must not touch kerbs.
struct Outlines {
  Outline body, wheels;
};

/// An obstacle, kerb or map, and the part of the vehicle that may hit it.
struct Thing {
  std::string name;  ///< name of the obstacle, such as "obstacles[2]" or "the map"
  std::string part;  ///< part of the vehicle: "the footprint" or "the wheels"
  Hit hit = {};
};

/// Obstacles in a row that a world put in the place of one thing.
struct Stand {
  std::size_t count = 0;
  Thing thing = {};
};

/// Reason why a verdict is impossible: an empty problem, or a negative margin. Empty if there is
/// none.
[[nodiscard]] std::string door_fault(const Problem& problem, double margin);

[[nodiscard]] Outlines outlines_of(const Vehicle& vehicle);
[[nodiscard]] Outlines outlines_of(const Trailer& trailer);

/// Obstacles, kerbs and map in search trees. They do not depend on a vehicle, so one ground serves
/// all.
class Ground {
 public:
  /// `surroundings` is kept by reference.
  explicit Ground(const Surroundings& surroundings);

  /// Ground after a change: other polygons, and other cells in the ranges `cells` of the map.
  /// `before` is the ground before the change.
  Ground(const Ground& before, const Surroundings& surroundings, std::span<const CellRange> cells);

  /// Whether there are no obstacles, kerbs and map.
  [[nodiscard]] bool is_empty() const { return is_empty_; }

  /// Distance of the vehicle from the nearest obstacle, kerb or blocked cell [m]; 0 if they touch
  /// or one contains the other. On a passage it is a lower bound for all positions. Values are cut
  /// off at `most`.
  [[nodiscard]] double clearance(const View& view, const Outlines& outlines, double most,
                                 Effort& effort) const;

  /// First obstacle that is at most `distance` [m] from the vehicle at a position; else the first
  /// kerb, else the map.
  [[nodiscard]] Thing first_within(double distance, const View& view,
                                   const Outlines& outlines) const;

 private:
  std::vector<Stand> stands_;  // what the first obstacles stand for, in their order
  PolygonTree obstacles_;
  PolygonTree kerbs_;
  std::optional<CellTree> cells_;
  bool is_empty_;
};

/// Ground of a world. The first call builds it and stores it in the world.
[[nodiscard]] std::shared_ptr<const Ground> ground_of(const World& world);

/// Stores a new ground in a world that has changed; `before` is the ground before the change.
void renew_ground(const World& world, const Ground& before, std::span<const CellRange> cells);

}  // namespace vandplan::judge
