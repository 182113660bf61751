// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is a well-posed planning problem?
//
//  Scenario (what a file says, unchecked) --make_problem--> Problem in a World (checked)
//
// A world lies near its own origin, the start rounded to whole metres: double resolves no more than
// a micrometre at 5*10^9 m. A scenario moved by whole metres gives the same problem bit for bit as
// long as its coordinates have at most 15 digits. Files are written in the scenario's frame.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "vandplan/collision.h"
#include "vandplan/vehicle.h"

namespace vandplan {

namespace judge {
class CellTree;
}

/// One goal of a scenario, with obstacles that exist for this goal only.
struct Goal {
  std::optional<double> distance = {};  ///< how far this goal counts in a row of goals [m]
  Pose pose;
  std::vector<Polygon> obstacles = {};
};

/// Exactly what a scenario file says, unchecked, in the file's own frame.
struct Scenario {
  std::string name;
  std::string description;
  Vehicle vehicle;
  Bounds bounds;
  Pose start;
  std::vector<Goal> goals;       ///< one for `goal:`, several for `goals:`
  bool goals_are_a_row = false;  ///< the file says `goals:`, and the furthest one reached counts
  std::vector<Polygon> obstacles;
  std::vector<Polygon> kerbs = {};        ///< low ones, that overhangs may swing over
  std::string map_file = {};              ///< as the file says: relative to it; empty without map
  std::optional<OccupancyGrid> map = {};  ///< what stands there
};

/// Where the vehicle may drive: checked, immutable, shared between threads and problems.
class World {
 public:
  /// All in the local frame. Throws InputError naming the key ("bounds.x", "obstacles[2]",
  /// "vehicle.width") when a number is not finite or out of range, bounds are crossed, or a polygon
  /// has fewer than three corners, no area, or crosses or touches itself. Repeated corners are
  /// dropped; a polygon of one repeated corner stands for that point.
  World(const Vehicle& vehicle, const Bounds& bounds, std::vector<Polygon> obstacles,
        const Point& origin);
  /// The same with a map; "map" and what of it is wrong are named likewise.
  World(const Vehicle& vehicle, Surroundings surroundings, const Point& origin);

  [[nodiscard]] const Vehicle& vehicle() const noexcept { return vehicle_; }
  [[nodiscard]] const Bounds& bounds() const noexcept { return surroundings_.bounds; }
  [[nodiscard]] const std::vector<Polygon>& obstacles() const noexcept {
    return surroundings_.obstacles;
  }
  [[nodiscard]] const std::vector<Polygon>& kerbs() const noexcept { return surroundings_.kerbs; }
  /// None without a map.
  [[nodiscard]] const std::optional<OccupancyGrid>& map() const noexcept {
    return surroundings_.map;
  }
  /// Where the origin of the local frame lies in the scenario's frame [m].
  [[nodiscard]] const Point& origin() const noexcept { return origin_; }
  [[nodiscard]] const CollisionChecker& checker() const noexcept { return checker_; }
  /// What the judge, and nobody else, needs of the map; none without one.
  [[nodiscard]] const judge::CellTree* judges_cells() const noexcept { return judges_cells_.get(); }

 private:
  Vehicle vehicle_;
  Surroundings surroundings_;
  Point origin_;
  CollisionChecker checker_;
  std::shared_ptr<const judge::CellTree> judges_cells_;
};

/// One start and one goal in a world, in its local frame; headings in [-pi, pi).
struct Problem {
  std::shared_ptr<const World> world;
  Pose start;
  Pose goal;
};

/// Checks a scenario without building a world: the same errors as `make_problem`.
void check_scenario(const Scenario& scenario);

/// Checks a map alone; errors name "map.resolution", "map.origin" or "map".
void check_map(const OccupancyGrid& map);

/// The problem of one goal. A start or goal in collision or outside the bounds is no error: the
/// planner names it. Throws InputError naming the key that is wrong. `goal` < goals.size().
[[nodiscard]] Problem make_problem(const Scenario& scenario, std::size_t goal);

/// The problems of all goals, the same as one by one. Goals without obstacles of their own share
/// one world, which is built once.
[[nodiscard]] std::vector<Problem> make_problems(const Scenario& scenario);

/// One more problem in a world that is there: nothing of it is built again, so thousands of
/// problems may share it, on as many threads as one likes. The poses are in the scenario's frame;
/// throws InputError naming "start" or "goal" when they are out of range.
[[nodiscard]] Problem make_problem(std::shared_ptr<const World> world, const Pose& start,
                                   const Pose& goal);

/// From the scenario's frame into the world's, heading in [-pi, pi), and back.
[[nodiscard]] Pose to_local(const World& world, const Pose& pose) noexcept;
[[nodiscard]] Pose to_scenario(const World& world, const Pose& pose) noexcept;

/// Where samples are drawn; driving is allowed in the bounds either way.
enum class Region {
  bounds,  ///< the bounds of the scenario
  scene,   ///< bounding box of start, goal, obstacles and map plus 20 m, cut to the bounds
};

[[nodiscard]] Bounds sampling_region(const Problem& problem, Region region) noexcept;

}  // namespace vandplan
