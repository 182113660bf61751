// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is the footprint free of obstacles, and the rear axle inside the bounds?
//
// Exact along an edge, without a step size: docs/algorithms/collision.md says how and why no hit
// is ever missed.

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "vandplan/occupancy_grid.h"
#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan {

struct RigState;  // rig.h

namespace collision {
struct Ground;
}

/// Where one may drive and what stands in the way, all in one frame.
struct Surroundings {
  Bounds bounds = {};
  std::vector<Polygon> obstacles = {};  ///< the footprint keeps clear of them
  std::vector<Polygon> kerbs = {};      ///< the wheels do, overhangs may swing over them
  std::optional<OccupancyGrid> map = {};
  /// The whole body stays in one of these areas, which have nothing in common. None: anywhere.
  std::vector<Polygon> inside = {};
};

/// Around a place the margin is less than elsewhere: `least` there, and it grows evenly with the
/// distance of the rear axle until that is `reach`.
struct MarginRamp {
  Local<Point> centre = {};  ///< [m]
  double least = 0.0;        ///< [m]; >= 0
  double reach = 1.0;        ///< [m]; > 0
  bool operator==(const MarginRamp&) const = default;
};

/// How far a vehicle keeps from things: the body from obstacles and map, the wheels from kerbs.
struct Margin {
  double wanted = 0.0;                 ///< [m]; >= 0
  std::vector<MarginRamp> ramps = {};  ///< where less will do
  bool operator==(const Margin&) const = default;

  /// What is kept everywhere [m].
  [[nodiscard]] double least() const noexcept;
};

/// Answers collision queries for one footprint in one set of obstacles. Immutable after
/// construction and safe to share between threads. A trailer is looked at by `rig_...` alone. Local
/// poses and points are in the frame of the world that the checker is from (`to_local`), or of the
/// surroundings that it was made of. A world puts thin obstacles, fences, around the areas of
/// `inside`; a checker that is made of surroundings adds none.
///
/// Promise: whatever is accepted keeps the closed footprint clear of every closed obstacle, by more
/// than the margin, and the rear axle inside the bounds; whatever has a clearance above the margin
/// and `tolerance` is accepted.
class CollisionChecker {
 public:
  /// [m]
  static constexpr double tolerance = 1e-3;

  /// The polygons must be simple (see `World`).
  CollisionChecker(const Footprint& footprint, const Bounds& bounds,
                   std::span<const Polygon> obstacles);
  /// For all that a vehicle meets. The frame is that of the surroundings.
  CollisionChecker(const Vehicle& vehicle, const Surroundings& surroundings,
                   const Margin& margin = {});
  /// For one of many vehicles on the same ground (`World::checker`).
  CollisionChecker(const Vehicle& vehicle, std::shared_ptr<const collision::Ground> ground,
                   const Margin& margin = {});
  ~CollisionChecker();
  CollisionChecker(const CollisionChecker&) = delete;
  CollisionChecker& operator=(const CollisionChecker&) = delete;

  [[nodiscard]] bool is_free(const LocalPose& pose) const noexcept;

  /// Everything swept from `from` along `segment`, both ends included.
  [[nodiscard]] bool is_free(const LocalPose& from, const Segment& segment) const noexcept;

  /// Everything swept from `from` along the segments, one after the other.
  [[nodiscard]] bool is_free(const LocalPose& from,
                             std::span<const Segment> segments) const noexcept;

  /// Both bodies of a vehicle with a trailer, the vehicle alone if it has none. The hitch angle
  /// is not limited here, and the trailer is not held to the bounds.
  [[nodiscard]] bool rig_is_free(const Local<RigState>& state) const noexcept;

  /// Everything that both bodies sweep from `from` along `segment`, both ends included.
  [[nodiscard]] bool rig_is_free(const Local<RigState>& from,
                                 const Segment& segment) const noexcept;

  /// Everything that both bodies sweep from `from` along the segments, one after the other.
  [[nodiscard]] bool rig_is_free(const Local<RigState>& from,
                                 std::span<const Segment> segments) const noexcept;

  /// Distance of the body from the nearest obstacle or blocked cell, or of the wheels from the
  /// nearest kerb, whichever is less, and no more than `most` [m]; 0 if they touch. Where it is at
  /// least `enough` any number from `enough` to it will do, which is found sooner.
  [[nodiscard]] double clearance(
      const LocalPose& pose, double most,
      double enough = std::numeric_limits<double>::infinity()) const noexcept;

  /// What is nearer to something of both bodies, as `clearance` of one.
  [[nodiscard]] double rig_clearance(
      const Local<RigState>& state, double most,
      double enough = std::numeric_limits<double>::infinity()) const noexcept;

  /// Whether an obstacle of the map is at most this far from the point [m]. False without a map.
  [[nodiscard]] bool map_is_within(const Local<Point>& point, double distance) const noexcept;

  /// Two numbers between which a distance lies [m].
  struct Range {
    double least, most;
  };

  /// How far the nearest obstacle of the map is from the point, quickly. Infinite without a map.
  [[nodiscard]] Range map_distance(const Local<Point>& point) const noexcept;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

}  // namespace vandplan
