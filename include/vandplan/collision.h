// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is the vehicle free of obstacles, its rear axle inside the bounds, and no rule of a zone broken?
//
// Checks along an edge are exact, without a step size. docs/algorithms/collision.md says how, and
// why no hit is ever missed.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/geometry.h"
#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan {

namespace collision {
struct Ground;
}

/// An area with rules for driving in it. The rules hold while the midpoint of the rear axle is in
/// the area or on its edge, unless `body` is set.
struct Zone {
  std::string name = {};                    ///< name for people; need not be unique
  Polygon area = {};                        ///< simple polygon [m]
  bool closed = false;                      ///< whether the area is forbidden
  AllowedGears gears = AllowedGears::both;  ///< gears that may be driven there
  /// Directions of travel that are allowed: headings of the vehicle, turned by half a turn in
  /// reverse. None: any direction.
  std::optional<HeadingRange> direction = {};
  double cost = 1.0;                     ///< how many times as much a metre costs there; 1 to 1000
  std::optional<double> max_speed = {};  ///< largest speed there, in either gear [m/s]; > 0
  /// Whether the rules hold as soon as any part of the vehicle or its trailer is in the area.
  bool body = false;
  bool operator==(const Zone&) const = default;
};

/// What the cells of a mask are.
enum class MaskUse : std::uint8_t {
  obstacles,  ///< occupied cells are obstacles
  max_speed,  ///< cells limit the speed; a cell of 0 % sets no limit
  cost,       ///< metres cost more
};

/// Name of a use in files: "obstacles", "max_speed" or "cost".
[[nodiscard]] std::string_view name_of(MaskUse use) noexcept;

/// An occupancy map that adds obstacles, speed limits or prices, like the masks of Nav2's costmap
/// filters. Unknown cells add nothing, nor does the ground outside the map. A speed limit or price
/// holds while the midpoint of the rear axle is in the cell. A cell that is occupied by p percent
/// has the value `base` + `multiplier` * p.
struct Mask {
  /// Percentage that stands for an unknown cell.
  static constexpr std::uint8_t unknown = 255;

  std::string map_file = {};  ///< file of the map
  OccupancyGrid map = {};     ///< the map; `unknown_is_free` is ignored
  MaskUse use = MaskUse::obstacles;
  double base = 0.0;        ///< value where nothing is occupied [m/s]; of costs a factor
  double multiplier = 0.0;  ///< change of the value for each percent
  /// Occupancy of each cell, in the order of the map's cells: 0 to 100 or `unknown`. None: occupied
  /// cells have 100 and free ones 0.
  std::shared_ptr<const std::vector<std::uint8_t>> percents = {};
  std::size_t blocks = 0;  ///< number of obstacles that stand for it; a world sets it
};

/// A mask whose cells limit the speed to (1 - p) * `speed` [m/s] where they are occupied by p.
[[nodiscard]] Mask speed_mask(OccupancyGrid map, double speed);
/// A mask where a metre costs 1 + p * `most` times as much in a cell that is occupied by p.
[[nodiscard]] Mask cost_mask(OccupancyGrid map, double most);

/// Bounds, obstacles, kerbs, map and zones, all in one frame.
struct Surroundings {
  Bounds bounds = {};                   ///< where the midpoint of the rear axle may be [m]
  std::vector<Polygon> obstacles = {};  ///< outlines that the footprint may not touch [m]
  /// Outlines for the wheels alone [m]; overhangs may swing over them.
  std::vector<Polygon> kerbs = {};
  std::optional<OccupancyGrid> map = {};  ///< occupancy map; none: there is no map
  /// Areas that do not touch each other [m]. The whole body stays in one of them. Empty: no such
  /// limit.
  std::vector<Polygon> inside = {};
  std::vector<Zone> zones = {};  ///< areas with rules
  std::vector<Mask> masks = {};  ///< maps that add rules; a world has obstacles in their place
};

/// Part of a segment on which the same zones hold.
struct GroundPart {
  double begin = 0.0, end = 0.0;  ///< driven distances from the start of the segment [m]
  double cost = 1.0;              ///< how many times as much a metre costs
  /// Largest speed [m/s].
  double max_speed = std::numeric_limits<double>::infinity();
};

/// What zones and masks are asked for.
enum class GroundRules : std::uint8_t {
  all,
  prices,  ///< costs alone: speeds are infinite
};

/// Order in which segments are driven in time.
enum class InTime : std::uint8_t {
  onward,
  /// A search from the goal: the vehicle drives each segment from its end to its begin, in the gear
  /// opposite to that of the segment.
  backward,
};

/// A place around which a smaller margin is enough. With the rear axle at `centre` the margin is
/// `least`. It grows linearly with the distance of the rear axle, up to the usual margin at
/// `reach`.
struct MarginRamp {
  Local<Point> centre = {};  ///< the place, in the frame of the checker [m]
  double least = 0.0;        ///< margin at the centre [m]; >= 0
  double reach = 1.0;        ///< distance at which the usual margin holds again [m]; > 0
  bool operator==(const MarginRamp&) const = default;
};

/// Distance that a vehicle keeps: the body from obstacles and map, the wheels from kerbs.
struct Margin {
  double wanted = 0.0;                 ///< margin outside of all ramps [m]; >= 0
  std::vector<MarginRamp> ramps = {};  ///< places around which less is enough
  bool operator==(const Margin&) const = default;

  /// Least margin anywhere, ramps included [m].
  [[nodiscard]] double least() const noexcept;
};

/// Answers collision queries for one vehicle among fixed obstacles. It is immutable after
/// construction and safe to share between threads. A trailer counts; with a bare pose it stands
/// straight behind its tractor. Only functions with `tractor` in their name leave it out.
///
/// Local states and points are in the frame of the checker. It is that of the world from which the
/// checker comes (`to_local`), or that of the surroundings it was made of. A world puts thin
/// obstacles, fences, around the areas of `inside`, and obstacles in the place of masks. A checker
/// that is made of surroundings adds neither.
///
/// Promise: what is accepted keeps the closed footprints clear of every closed obstacle by more
/// than the margin, and the rear axle inside the bounds. The bounds do not hold for a trailer, and
/// its hitch angle is not limited here. What has a clearance above the margin plus `tolerance` is
/// accepted.
///
/// Zones: `is_free` is false if a rule is broken. No margin counts for zones. What keeps
/// `tolerance` to the area of a zone breaks none of its rules. A direction of travel may be off by
/// 1e-9 rad.
class CollisionChecker {
 public:
  /// Clearance beyond the margin above which everything is accepted [m].
  static constexpr double tolerance = 1e-3;

  /// Checker of a rectangle among obstacles, without kerbs, map or margin. The polygons must be
  /// simple (see `World`). Bounds and polygons share one frame.
  CollisionChecker(const Footprint& footprint, const Bounds& bounds,
                   std::span<const Polygon> obstacles);
  /// Checker of a vehicle among surroundings, whose frame it has. The polygons must be simple.
  CollisionChecker(const Vehicle& vehicle, const Surroundings& surroundings,
                   const Margin& margin = {});
  /// Checker of a vehicle on a ground that many vehicles share, with zones and masks in the same
  /// frame. `World::checker` calls it.
  CollisionChecker(const Vehicle& vehicle, std::shared_ptr<const collision::Ground> ground,
                   const Margin& margin = {}, std::span<const Zone> zones = {},
                   std::span<const Mask> masks = {});
  ~CollisionChecker();
  CollisionChecker(const CollisionChecker&) = delete;
  CollisionChecker& operator=(const CollisionChecker&) = delete;

  /// Whether the vehicle is free in the state: it keeps its margin, its rear axle is in the bounds,
  /// and it stands in no closed zone. False for a state that is not finite.
  [[nodiscard]] bool is_free(const LocalState& state) const noexcept;

  /// Whether all ground swept from `from` along the segment is free, both ends included, and the
  /// segment breaks no rule of a zone when it is driven in that order.
  [[nodiscard]] bool is_free(const LocalState& from, const Segment& segment,
                             InTime in_time = InTime::onward) const noexcept;

  /// `is_free` of segments, one after the other.
  [[nodiscard]] bool is_free(const LocalState& from, std::span<const Segment> segments,
                             InTime in_time = InTime::onward) const noexcept;

  /// Whether a segment breaks no rule of a zone, whatever else is in its way.
  [[nodiscard]] bool obeys_zones(const LocalState& from, const Segment& segment,
                                 InTime in_time) const noexcept;

  /// Whether a zone or mask has a price, and whether one has a largest speed.
  [[nodiscard]] bool has_prices() const noexcept;
  [[nodiscard]] bool has_speed_limits() const noexcept;
  /// The parts of a segment from `from`, from its begin to its end, with what zones and masks say
  /// there. The places where the rear axle enters and leaves an area are exact but for rounding.
  /// For a whole body they are off by at most a millimetre.
  [[nodiscard]] std::vector<GroundPart> ground_along(const LocalState& from, const Segment& segment,
                                                     GroundRules which = GroundRules::all) const;

  /// `is_free` of the tractor alone, as if it pulled no trailer and there were no zones.
  [[nodiscard]] bool tractor_is_free(const LocalPose& from,
                                     std::span<const Segment> segments = {}) const noexcept;

  /// Least distance of the bodies from obstacles and blocked cells, and of the wheels from kerbs,
  /// but at most `most` [m]. It is 0 if they touch, with an axle outside all areas of `inside`, and
  /// for a state that is not finite. The bounds do not count, and the margin is not taken off. If
  /// the distance is at least `enough`, the result may be any number from `enough` to that
  /// distance, which is faster.
  [[nodiscard]] double clearance(
      const LocalState& state, double most,
      double enough = std::numeric_limits<double>::infinity()) const noexcept;

  [[deprecated("use is_free")]] [[nodiscard]] bool rig_is_free(
      const LocalState& from, std::span<const Segment> segments = {}) const noexcept {
    return is_free(from, segments);
  }
  [[deprecated("use is_free")]] [[nodiscard]] bool rig_is_free(
      const LocalState& from, const Segment& segment) const noexcept {
    return is_free(from, segment);
  }
  [[deprecated("use clearance")]] [[nodiscard]] double rig_clearance(
      const LocalState& state, double most,
      double enough = std::numeric_limits<double>::infinity()) const noexcept {
    return clearance(state, most, enough);
  }

  /// Whether a blocked cell of the map is at most `distance` from the point [m]. False without a
  /// map.
  [[nodiscard]] bool map_is_within(const Local<Point>& point, double distance) const noexcept;

  /// Lower and upper bound of a distance [m].
  struct Range {
    double least, most;
  };

  /// Bounds of the distance from the point to the nearest blocked cell of the map [m], found
  /// quickly. Both are infinite without a map.
  [[nodiscard]] Range map_distance(const Local<Point>& point) const noexcept;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

}  // namespace vandplan
