// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do I plan many times in one world?
//
//   const Roadmap roadmap = build_roadmap(world, vehicle);
//   const auto way = roadmap.route(start, goal);
//
// A probabilistic roadmap: free poses, each joined to the nearest older ones by shortest paths. It
// is built once and asked as often as one likes: docs/algorithms/prm.md.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "vandplan/goal_estimate.h"
#include "vandplan/outcome.h"
#include "vandplan/problem.h"

namespace vandplan {

namespace search {
class Milestones;
}

/// Size and range of a roadmap.
struct RoadmapOptions {
  std::int64_t nodes = 10'000;  ///< number of free poses; [1, 1000000]
  int neighbours = 12;          ///< number of older poses that each is joined to; [1, 100]
  std::uint64_t seed = 1;       ///< seed of the random poses
  double margin = 0.0;          ///< distance that the vehicle keeps from obstacles [m]; [0, 1000]
  /// Region of the poses, in the frame of the world [m]. None: the bounds of the world.
  std::optional<Local<Bounds>> region = {};
};

/// The route of a roadmap between two poses, in the frame of the world.
struct RoadmapRoute {
  double length = 0.0;                 ///< length of the route [m]
  std::vector<LocalPose> poses = {};   ///< first pose, nodes on the way, last pose
  std::vector<Segment> segments = {};  ///< segments of the route, merged
};

/// Options of one query.
struct RouteOptions {
  /// Estimated length to the goal, which guides the search [m]. With an admissible one the route is
  /// the shortest in the roadmap. None: the exact length on open ground.
  std::function<double(const LocalPose&)> estimate = {};
  /// The search ends without a route soon after this returns true. None: it is not interrupted.
  std::function<bool()> is_interrupted = {};
  bool keep_tree = false;  ///< whether the answer holds the search tree
};

/// Answer of a roadmap to one query.
struct RoadmapAnswer {
  std::optional<RoadmapRoute> route = {};  ///< the route; none: the roadmap has none
  std::int64_t expansions = 0;             ///< number of poses that the search reached
  /// Reached poses in their order, if asked for; in the frame of the world.
  std::optional<TreeSnapshot> tree = {};
};

/// Free poses, and which of them are near each other. All poses are in the frame of the world: see
/// `to_local`. An edge is checked when a route needs it, and the result is remembered. An answer
/// depends only on the roadmap and the query, not on earlier queries. May be asked from several
/// threads at once.
class Roadmap {
 public:
  /// The milestones as they are now, ready for queries. `earlier` is a roadmap of fewer of these
  /// milestones, whose checked edges are taken over; or null.
  explicit Roadmap(const search::Milestones& milestones, const Roadmap* earlier = nullptr);
  ~Roadmap();
  Roadmap(Roadmap&& other) noexcept;
  Roadmap& operator=(Roadmap&& other) noexcept;

  /// The route from pose to pose, both of them free.
  [[nodiscard]] RoadmapAnswer route(const LocalPose& from, const LocalPose& to,
                                    const RouteOptions& options = {}) const;

  /// Checks every edge now instead of when a route needs it.
  void check_edges() const;

  /// Number of poses, of edges, and of poses that were drawn to find the free ones.
  [[nodiscard]] std::int64_t nodes() const noexcept;
  [[nodiscard]] std::int64_t edges() const noexcept;
  [[nodiscard]] std::int64_t samples() const noexcept;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

/// Builds a roadmap: draws poses until there are enough free ones. Throws InputError naming
/// "nodes", "neighbours" or "margin" if it is out of range, "vehicle.trailers" if there is a
/// trailer, or another key of the vehicle. It names "region" if a million poses in a row are not
/// free.
[[nodiscard]] Roadmap build_roadmap(const World& world, const Vehicle& vehicle,
                                    const RoadmapOptions& options = {});

}  // namespace vandplan
