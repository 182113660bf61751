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

/// Which roadmap is wanted.
struct RoadmapOptions {
  std::int64_t nodes = 10'000;  ///< free poses; [1, 1000000]
  int neighbours = 12;          ///< older ones that each is joined to; [1, 100]
  std::uint64_t seed = 1;       ///< of the random poses
  double margin = 0.0;          ///< that the vehicle keeps from things [m]; >= 0
  /// Where poses are drawn, in the frame of the world [m]; none: the bounds of the world.
  std::optional<Local<Bounds>> region = {};
};

/// The way that a roadmap knows between two poses.
struct RoadmapRoute {
  double length = 0.0;                 ///< [m]
  std::vector<LocalPose> poses = {};   ///< from the first to the last, on the way the nodes
  std::vector<Segment> segments = {};  ///< neighbouring ones are joined
};

/// How a roadmap is asked.
struct RouteOptions {
  /// Guides the search to the goal. With an admissible one the route is the shortest one in the
  /// roadmap; none: the exact length on open ground.
  std::function<double(const LocalPose&)> estimate = {};
  /// The search ends without a route soon after this returns true; none: it goes on.
  std::function<bool()> is_interrupted = {};
  bool keep_tree = false;  ///< return the poses as they were searched
};

/// What a roadmap answers.
struct RoadmapAnswer {
  std::optional<RoadmapRoute> route = {};  ///< none: the roadmap knows none
  std::int64_t expansions = 0;             ///< poses whose neighbours were looked at
  std::optional<TreeSnapshot> tree = {};   ///< these poses in their order, when asked for
};

/// Free poses, and which of them are near to which. All poses are in the frame of the world: see
/// `to_local`. Whether an edge is free is found out when a route wants it, and remembered. An
/// answer depends on nothing else than on the roadmap and the query: not on what was asked before.
/// May be asked from several threads at once.
class Roadmap {
 public:
  /// The milestones as they are now, ready to be asked. What `earlier`, a roadmap of fewer of them,
  /// remembers of its edges is taken over.
  explicit Roadmap(const search::Milestones& milestones, const Roadmap* earlier = nullptr);
  ~Roadmap();
  Roadmap(Roadmap&& other) noexcept;
  Roadmap& operator=(Roadmap&& other) noexcept;

  /// The way from pose to pose, both of them free.
  [[nodiscard]] RoadmapAnswer route(const LocalPose& from, const LocalPose& to,
                                    const RouteOptions& options = {}) const;

  /// Finds out about every edge now instead of when a route wants it.
  void check_edges() const;

  /// How many poses there are, how many edges, and how many poses were drawn to find them.
  [[nodiscard]] std::int64_t nodes() const noexcept;
  [[nodiscard]] std::int64_t edges() const noexcept;
  [[nodiscard]] std::int64_t samples() const noexcept;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

/// Draws poses until there are enough free ones. Throws InputError naming the option that is out of
/// range, and if of a million poses, one after the other, none is free.
[[nodiscard]] Roadmap build_roadmap(const World& world, const Vehicle& vehicle,
                                    const RoadmapOptions& options = {});

}  // namespace vandplan
