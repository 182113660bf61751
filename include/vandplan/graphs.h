// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which graphs can be searched, and which estimates guide a search?

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/problem.h"
#include "vandplan/tables.h"

namespace vandplan::base {
class Derived;
}

namespace vandplan::search {

// ---- Which motions join the vertices of a state lattice? ----
//
// A vertex is a point of a square grid with one of a few headings. A primitive drives from a vertex
// at the origin exactly to another vertex. Moved to any vertex with its first heading, it again
// ends at a vertex. docs/algorithms/lattice.md says how ours are chosen; files.h reads
// those of other programs.

/// A motion from one vertex to another.
struct Primitive {
  std::int32_t from = 0;  ///< index of the heading at the begin
  std::int32_t to = 0;    ///< index of the heading at the end
  std::int32_t dx = 0;    ///< way along x from vertex to vertex [steps of the grid]
  std::int32_t dy = 0;    ///< way along y from vertex to vertex [steps of the grid]
  Piece piece = {};       ///< segments that are driven
};

/// All motions of a lattice. They are checked and immutable, so that threads may share them.
class Primitives {
 public:
  /// Largest distance of a primitive's end from its vertex, for rounding [m, rad]. For vertices
  /// more than a metre apart it is a share of their distance.
  static constexpr double closing = 1e-9;

  /// Makes the primitives of a grid whose squares have the side `step` [m]. `headings` are the
  /// angles that the indices mean [rad]. Throws InputError naming:
  ///
  /// - "step" or "headings" if it is out of range, or two headings are equal,
  /// - "primitives" if there is none,
  /// - "primitives[3]" if it has a number out of range or does not end at its vertex.
  Primitives(double step, std::vector<double> headings, std::vector<Primitive> all);
  ~Primitives();
  Primitives(const Primitives&) = delete;
  Primitives& operator=(const Primitives&) = delete;

  /// Side of the grid's squares [m].
  [[nodiscard]] double step() const noexcept { return step_; }
  /// Angle of each index of a heading [rad], in [-pi, pi).
  [[nodiscard]] std::span<const double> headings() const noexcept { return headings_; }
  /// All primitives, ordered by the heading at their begin.
  [[nodiscard]] std::span<const Primitive> all() const noexcept { return all_; }
  /// Position in `all` of the first primitive that begins with that heading. Those of one heading
  /// end where those of the next heading begin; `headings().size()` gives the end of the list.
  [[nodiscard]] std::int32_t first_from(std::size_t heading) const { return first_[heading]; }
  /// Largest absolute curvature of all primitives [1/m].
  [[nodiscard]] double largest_curvature() const noexcept { return largest_curvature_; }
  /// Length of the longest primitive [m].
  [[nodiscard]] double longest() const noexcept { return longest_; }

  /// Values that parts of the library derive from the primitives, once for all who share them.
  [[nodiscard]] base::Derived& derived() const noexcept { return *derived_; }

 private:
  double step_;
  std::vector<double> headings_;
  std::vector<Primitive> all_;
  std::vector<std::int32_t> first_;
  double largest_curvature_ = 0.0;
  double longest_ = 0.0;
  std::unique_ptr<base::Derived> derived_;
};

/// Choice of the primitives that are made.
struct PrimitiveOptions {
  int steps_per_radius = 8;  ///< steps of the grid in a turning radius; [1, 32]
  /// Headings are the directions of all grid points whose coordinates are at most this; [1, 5]. 2
  /// gives 16 headings, 3 gives 32.
  int largest_coordinate = 2;
  double longest = 1.25;  ///< largest length of one primitive [turning radii]; [0.5, 4]
  /// A primitive is left out if shorter ones lead there at no more than this many times its length;
  /// [1, 2].
  double detour = 1.1;
};

/// Primitives of one stroke, forward and in reverse, for a turning radius > 0 [m]: arcs and lines
/// of Dubins between vertices. Throws InputError naming "radius" or the option that is out of
/// range.
[[nodiscard]] std::shared_ptr<const Primitives> make_primitives(
    double radius, const PrimitiveOptions& options = {});

/// The piece of one gear from `begin` exactly to `end` that passes nearest to sampled poses: a
/// line, an arc between lines, or a word of Dubins. The first and the last pose are `begin` and
/// `end`. None if it passes a pose by more than `tolerance` [m], or the poses are not in one gear.
[[nodiscard]] std::optional<Piece> fitted_piece(const Pose& begin, const Pose& end,
                                                std::span<const Pose> poses, double tolerance);

/// The exact heading that was rounded to `heading` [rad], within 2e-4. It is the direction of a
/// grid point whose coordinates are at most 8, or a multiple of a turn divided by `count`. None if
/// there is no such heading.
[[nodiscard]] std::optional<double> exact_heading(double heading, int count);

// ---- How far is it to the goal, about? ----
//
// Estimates guide searches. docs/algorithms/estimates.md says what each of them knows and leaves
// out. All poses are in the frame of the task.

/// Estimated length from a pose to the goal of one task. It is made for one run: a call may fill a
/// cache, so threads do not share it.
struct GoalEstimate {
  std::string name = {};
  /// Whether the estimate is never above the length of the shortest path among the obstacles, but
  /// for rounding (1e-9, relative). A search that proves what it finds needs that.
  bool is_admissible = false;
  /// Estimated length from a pose to the goal [m]; infinite where the goal cannot be reached.
  std::function<double(const LocalPose&)> length = {};
};

/// Names of the estimates, the simplest first: "euclid", "hlut-1", ..., "choi".
[[nodiscard]] std::span<const std::string_view> goal_estimate_names() noexcept;

/// Name of the estimate that looks up a user's table (`PlanOptions::table`).
inline constexpr std::string_view user_table = "table";

/// Name of the estimate that looks up the costs of `PlanOptions::site`. Planners alone can make it.
inline constexpr std::string_view site_estimate = "site";

/// The estimate of that name for a task, which must outlive it. Throws InputError naming "estimate"
/// for an unknown name (the message lists the names), for `user_table` and for `site_estimate`.
[[nodiscard]] GoalEstimate make_goal_estimate(std::string_view name, const Task& task);

/// The estimate of that name for a task, which must outlive it. `user_table` looks up `table`,
/// which may be null for other names. Throws InputError naming "estimate" if the name is unknown,
/// the table is missing, or it is `site_estimate`.
[[nodiscard]] GoalEstimate make_goal_estimate(std::string_view name, const Task& task,
                                              const HeuristicTable* table);

/// The larger of two estimates at each pose; admissible if both are.
[[nodiscard]] GoalEstimate max_of(GoalEstimate a, GoalEstimate b);

}  // namespace vandplan::search

namespace vandplan {

// ---- How do I plan many times in one world? ----
//
//   const Roadmap roadmap = build_roadmap(world, vehicle);
//   const auto way = roadmap.route(start, goal);
//
// A probabilistic roadmap: free poses, each joined to the nearest older ones by shortest paths. It
// is built once and asked as often as one likes: docs/algorithms/prm.md.

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
