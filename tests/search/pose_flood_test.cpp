// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Is the bound that knows headings true, and does it know them? Held against paths among obstacles
// that are put as near to them as may be.
#include "search/pose_flood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "../support/cases.h"
#include "../support/draws.h"
#include "../support/grids.h"
#include "../support/problems.h"
#include "search/geodesic.h"
#include "search/geodesic_field.h"
#include "search/zone_bound.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using search::GeodesicField, search::OpenRows;

/// What is proven after so many steps, of paths up to `longest` in one gear, or in both.
double flood_bound(const Task& task, double longest, int steps, search::GearSign only = 0) {
  search::PoseFlood flood(task, only);
  while (steps-- > 0 && flood.step(longest)) {
  }
  return flood.bound();
}

/// A few arcs and lines, back and forth.
std::vector<Segment> shunting(double radius, Rng& rng) {
  std::vector<Segment> segments;
  double gear = any_sign(1, rng);
  for (auto count = 1 + rng() % 5; count > 0; --count) {
    const double curvature = (static_cast<double>(rng() % 3) - 1) / radius;
    segments.push_back({curvature, gear * uniform(0.1, chance(0.5, rng) ? 2 : 1, rng) * radius});
    if (chance(0.4, rng)) gear = -gear;
  }
  return segments;
}

/// A few arcs and lines in one gear.
std::vector<Segment> driven_on(double radius, double gear, Rng& rng) {
  std::vector<Segment> segments = shunting(radius, rng);
  for (Segment& segment : segments) segment.length = gear * std::abs(segment.length);
  return segments;
}

/// The least box around the rear axle on its way.
Bounds box_around(const Path& path) {
  Bounds box{path.start.x, path.start.x, path.start.y, path.start.y};
  for (const auto& [s, pose, curvature, direction] : sampled(path, 0.01)) {
    box = {std::min(box.x_min, pose.x), std::max(box.x_max, pose.x), std::min(box.y_min, pose.y),
           std::max(box.y_max, pose.y)};
  }
  return box;
}

/// Obstacles, kerbs and bounds that a path of the vehicle just passes.
Surroundings just_beside(const Path& path, const Vehicle& vehicle, const Margin& margin, Rng& rng) {
  const Bounds box_of_path = box_around(path);
  const double by = chance(0.3, rng) ? 0.02 : 30;
  Surroundings around{.bounds = {box_of_path.x_min - by, box_of_path.x_max + by,
                                 box_of_path.y_min - by, box_of_path.y_max + by}};
  const std::vector<PathPoint> points = sampled(path, 0.1);
  const double reach = vehicle.wheelbase + vehicle.front_overhang + 1;
  for (int i = 0; i < 60; ++i) {
    const Pose& near = points[rng() % points.size()].pose;
    const double x = near.x + uniform(-reach, reach, rng);
    const double y = near.y + uniform(-reach, reach, rng);
    const bool is_wall = chance(0.5, rng);
    const Polygon polygon =
        box(x, y, x + (is_wall ? uniform(0.01, 6, rng) : 0.05), y + uniform(0.01, 3, rng));
    Surroundings more = around;
    (chance(0.1, rng) ? more.kerbs : more.obstacles).push_back(polygon);
    const CollisionChecker checker(vehicle, more, margin);
    if (checker.is_free(Local(path.start), path.segments)) around = std::move(more);
  }
  for (int i = 0; i < 5 && chance(0.2, rng); ++i) {
    Surroundings more = around;
    more.map = random_grid(60, 60, 0.01, rng);
    more.map->origin = {path.start.x + uniform(-20, 0, rng), path.start.y + uniform(-20, 0, rng),
                        uniform(-1, 1, rng)};
    more.map->resolution = 0.4;
    more.map->unknown_is_free = true;
    const CollisionChecker checker(vehicle, more, margin);
    if (checker.is_free(Local(path.start), path.segments)) around = std::move(more);
  }
  return around;
}

/// Zones that the path keeps out of, if just so: closed ones, or ones of the other gear than
/// `only`.
void add_zones_beside(const Path& path, const Vehicle& vehicle, search::GearSign only,
                      Surroundings& around, Rng& rng) {
  const std::vector<PathPoint> points = sampled(path, 0.1);
  for (int i = 0; i < 40; ++i) {
    const Pose& near = points[rng() % points.size()].pose;
    const double x = near.x + uniform(-5, 5, rng), y = near.y + uniform(-5, 5, rng);
    const auto corner = [&](double from_x, double from_y) {
      return Point{x + from_x * uniform(0.2, 4, rng), y + from_y * uniform(0.2, 4, rng)};
    };
    Zone zone{.area = {corner(-1, -1), corner(1, -1), corner(1, 1)}, .body = chance(0.4, rng)};
    if (chance(0.3, rng)) zone.area = box(x, y, x + uniform(0.05, 5, rng), y + 5);
    if (chance(0.3, rng)) zone.area = {{x, y}, corner(-1, -1), corner(1, -1), corner(1, 1)};
    zone.closed = only == 0 || chance(0.5, rng);
    if (!zone.closed) zone.gears = only > 0 ? AllowedGears::reverse : AllowedGears::forward;
    Surroundings more = around;
    more.zones.push_back(zone);
    const CollisionChecker checker(vehicle, more, {});
    if (checker.is_free(Local(path.start), path.segments)) around = std::move(more);
  }
}

/// One-way streets that the path keeps to, if just so.
void add_streets_beside(const Path& path, const Vehicle& vehicle, Surroundings& around, Rng& rng) {
  const std::vector<PathPoint> points = sampled(path, 0.1);
  for (int i = 0; i < 40; ++i) {
    const PathPoint& near = points[rng() % points.size()];
    const double x = near.pose.x, y = near.pose.y;
    const double middle = chance(0.4, rng) ? std::numbers::pi / 2 * static_cast<double>(rng() % 4)
                                           : near.pose.heading + uniform(-1.5, 1.5, rng);
    const double half = uniform(0, 1.5, rng);
    const auto corner = [&](double from_x, double from_y) {
      return Point{x + from_x * uniform(0.02, 6, rng), y + from_y * uniform(0.02, 6, rng)};
    };
    Zone zone{.area = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)},
              .direction = HeadingRange{middle - half, middle + half},
              .body = chance(0.4, rng)};
    if (chance(0.5, rng))
      zone.area = box(x - uniform(0, 5, rng), y - uniform(0, 5, rng), x + 3, y + 3);
    const auto is_free = [&](const Zone& street) {
      Surroundings more = around;
      more.zones.push_back(street);
      return CollisionChecker(vehicle, more, {}).is_free(Local(path.start), path.segments);
    };
    if (!is_free(zone)) continue;
    // It grows, as long as the path is free.
    for (double by = 4; by > 1e-4 && i < 10; by /= 2) {
      Zone wider = zone;
      for (Point& p : wider.area) p = {x + (1 + by) * (p.x - x), y + (1 + by) * (p.y - y)};
      if (is_free(wider)) zone = std::move(wider);
    }
    around.zones.push_back(std::move(zone));
  }
}

/// Boxes that are ready to be asked; none where they prove nothing.
std::unique_ptr<search::PoseBoxes> boxes_of(const Task& task, double side, double longest) {
  auto boxes = std::make_unique<search::PoseBoxes>(task, side, longest);
  while (boxes->is_usable() && !boxes->prepare(1000)) {
  }
  return boxes->is_usable() ? std::move(boxes) : nullptr;
}

/// Of paths through a pose.
double length_lower_bound(search::PoseBoxes& boxes, search::PoseCut* cut, const Pose& pose,
                          search::PoseCut::Index& by) {
  const auto box = boxes.box_of(pose);
  const double known = static_cast<double>(boxes.length_lower_bound(box));
  if (std::isinf(known) || cut == nullptr || !cut->is_near(box)) return known;
  return std::max(known, static_cast<double>(cut->length_lower_bound(box, 0, by)));
}
double length_lower_bound(search::PoseBoxes& boxes, search::PoseCut* cut, const Pose& pose) {
  search::PoseCut::Index by = search::PoseCut::none;
  return length_lower_bound(boxes, cut, pose, by);
}

/// Likewise a cut through them.
std::unique_ptr<search::PoseCut> cut_of(const Task& task, search::PoseBoxes& boxes) {
  auto cut = std::make_unique<search::PoseCut>(task, boxes);
  while (!cut->prepare()) {
  }
  return cut->is_usable() ? std::move(cut) : nullptr;
}

Vehicle small_vehicle(Rng& rng) {
  Vehicle vehicle{.wheelbase = uniform(1.5, 5, rng),
                  .front_overhang = uniform(0.1, 1.5, rng),
                  .rear_overhang = chance(0.2, rng) ? 0 : uniform(0.1, 2, rng),
                  .width = uniform(0.8, 2.5, rng),
                  .min_turning_radius = uniform(2, 8, rng)};
  if (chance(0.2, rng)) vehicle.track_width = vehicle.width * uniform(0.5, 1, rng);
  return vehicle;
}

/// The shortest way around, for a disc.
double way_around(const Problem& problem) {
  search::Geodesic geodesic(problem.task(), 1e3);
  while (geodesic.step()) {
  }
  return geodesic.bound();
}

const Vehicle car{.wheelbase = 2.8,
                  .front_overhang = 0.96,
                  .rear_overhang = 0.93,
                  .width = 1.94,
                  .min_turning_radius = 5};

// Parking: the disc goes straight into the slot, and open ground knows no slot.
TEST(PoseFlood, KnowsThatAVehicleTurnsOutOfASlot) {
  const Pose start{9, 4, 0};
  const Pose goal{0, 0, std::numbers::pi / 2};
  const Problem problem =
      problem_of(start, goal, {box(-6, -2, -1.1, 2.2), box(1.1, -2, 6, 2.2), box(-20, 6, 20, 7)},
                 {-20, 20, -20, 20}, car);
  PlanOptions options{.cost = shortest_style};
  options.budget.max_iterations = 100000;
  const PlanResult result = plan(problem, options);
  ASSERT_EQ(result.status, PlanStatus::solved);
  const double known = std::max(way_around(problem), reeds_shepp_length(start, goal, 5));
  const double bound = flood_bound(problem.task(), result.cost, 3000);
  EXPECT_GT(bound, 1.05 * known) << known << " " << bound << " " << result.cost;
  EXPECT_LE(bound, result.cost);
  EXPECT_GT(result.lower_bound, 1.05 * known);
}

// Turning behind a gate: the disc and open ground know no way around with a turn on it.
TEST(PoseFlood, KnowsThatAVehicleTurnsBehindAGate) {
  const Vehicle truck{.wheelbase = 4.5,
                      .front_overhang = 1.4,
                      .rear_overhang = 1.6,
                      .width = 2.55,
                      .min_turning_radius = 7};
  const Problem problem =
      problem_of({0, 0, 0}, {45, 20, 0},
                 {box(-16, -16, -15, -2.5), box(-16, 2.5, -15, 16), box(15, -16, 16, 16),
                  box(-15, -16, 15, -15), box(-15, 15, 15, 16)},
                 {-200, 200, -200, 200}, truck);
  const double around = way_around(problem);
  const double bound = flood_bound(problem.task(), 104.34, 15000);
  EXPECT_GT(bound, 99) << around;
  EXPECT_LT(bound, 104.34);
}

// On open ground it is known what every pose of a box needs.
TEST(PoseBoxes, NeedNoLongerPathThanTheOneByAnyOfTheirPoses) {
  for_each_case(2, 200, [](Rng& rng) {
    Vehicle vehicle = small_vehicle(rng);
    vehicle.min_turning_radius = any_size(0.5, 50, rng);
    const double radius = vehicle.min_turning_radius;
    const Bounds field{-3 * radius, 3 * radius, -3 * radius, 3 * radius};
    const Pose start = uniform_pose(field, rng);
    const Pose goal = uniform_pose(field, rng);
    const Problem problem = problem_of(start, goal, {}, {-999, 999, -999, 999}, vehicle);
    const double longest = 1.5 * reeds_shepp_length(start, goal, radius);
    const double side = any_size(0.02, 0.3, rng) * vehicle.width;
    const auto boxes = boxes_of(problem.task(), side, longest);
    if (!boxes) return;
    const auto cut = chance(0.3, rng) ? cut_of(problem.task(), *boxes) : nullptr;
    for (int i = 0; i < 200; ++i) {
      Pose by = uniform_pose(field, rng);
      if (chance(0.3, rng)) {  // near an end, where lengths are steep
        const double near = any_size(0.01, 1, rng) * radius;
        by = {start.x + uniform(-near, near, rng), start.y + uniform(-near, near, rng),
              start.heading + uniform(-near, near, rng) / radius};
      }
      const double length =
          reeds_shepp_length(start, by, radius) + reeds_shepp_length(by, goal, radius);
      if (length > longest) continue;
      EXPECT_LE(length_lower_bound(*boxes, cut.get(), by), length)
          << as_code(start) << " to " << as_code(goal) << " by " << as_code(by);
    }
  });
}

/// From pose to pose, each by the shortest path on open ground.
Path path_by(const std::vector<Pose>& poses, double radius) {
  Path path{poses.front(), {}};
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Piece piece = reeds_shepp(poses[i - 1], poses[i], radius);
    path.segments.insert(path.segments.end(), piece.segments.data(),
                         piece.segments.data() + piece.count);
  }
  return path;
}

/// Straight through a gate at x = 0 and around a corner then, or the other way. No path is shorter
/// but for the corner.
Path around_a_corner(const Pose& gate, double before, double radius, Rng& rng) {
  const double gear = std::abs(gate.heading) < 1 ? 1 : -1;
  const Pose start = end_pose({gate, {{0, -gear * before}}});
  Path path{start,
            {{0, gear * 2 * before},
             {any_sign(1 / radius, rng), gear * uniform(0.1, 2, rng) * radius},
             {0, gear * uniform(0.1, 3, rng) * radius}}};
  if (chance(0.5, rng)) return path;
  Path back{end_pose(path), {path.segments.rbegin(), path.segments.rend()}};
  for (Segment& segment : back.segments) segment.length = -segment.length;
  return back;
}

// Each pose of a path through a gate in a long wall is in a box that needs no more than the path,
// and hardly less: there is no much shorter way to the gate and on from it.
TEST(PoseCut, AsksForNoMoreThanAPathThroughAGate) {
  int used = 0;
  for_each_case(3, 300, [&](Rng& rng) {
    Vehicle vehicle = small_vehicle(rng);
    vehicle.min_turning_radius *= any_size(0.5, 1, rng);
    const double radius = vehicle.min_turning_radius;
    const double before = std::max(vehicle.wheelbase + 2, radius + 1);
    const double far = before + 4 * radius;
    const double room = any_size(0.01, 0.3, rng);
    const double tilt = uniform(-0.15, 0.15, rng) * room;
    const Pose gate{0, uniform(-0.8, 0.8, rng) * room,
                    tilt + (chance(0.5, rng) ? 0 : std::numbers::pi)};
    const Pose in{-before, gate.y, gate.heading};
    const Pose out{before, gate.y, gate.heading};
    const Path path = chance(0.5, rng) ? around_a_corner(gate, before, radius, rng)
                                       : path_by({uniform_pose({-far, -before, -far, far}, rng), in,
                                                  out, uniform_pose({before, far, -far, far}, rng)},
                                                 radius);
    const double gap = vehicle.width / 2 + room;
    const std::vector<Polygon> walls{box(-0.1, gap, 0.1, 99), box(-0.1, -99, 0.1, -gap)};
    const Problem problem =
        problem_of(path.start, end_pose(path), walls, {-99, 99, -99, 99}, vehicle);
    if (!problem.task().checker->is_free(Local(path.start), path.segments)) return;
    const double longest = length(path) * (chance(0.5, rng) ? 1 + 1e-9 : uniform(1, 1.3, rng));
    const double side = any_size(0.1, 0.7, rng) * vehicle.width;
    const auto boxes = boxes_of(problem.task(), side, longest);
    if (!boxes) return;
    const auto cut = cut_of(problem.task(), *boxes);
    if (!cut) return;
    ++used;
    search::PoseCut::Index by = search::PoseCut::none;
    for (const PathPoint& point : sampled(path, 0.1)) {
      const double least = length_lower_bound(*boxes, cut.get(), point.pose);
      ASSERT_LE(least, length(path) * (1 + 1e-9))
          << as_code(path) << " by " << as_code(point.pose) << " in boxes of " << side;
      // Whichever box of the cut it looks at first, it finds the best one.
      ASSERT_EQ(length_lower_bound(*boxes, cut.get(), point.pose, by), least);
    }
  });
  EXPECT_GT(used, cases(300) / 10);
}

// A box that is closed by mistake cuts every way, and then all of `longest` counts as proven.
TEST(PoseFlood, IsBelowPathsThatJustPass) {
  for_each_case(1, 150, [](Rng& rng) {
    const Vehicle vehicle = small_vehicle(rng);
    const Margin margin{.wanted = chance(0.2, rng) ? uniform(0, 0.5, rng) : 0};
    const double turn = chance(0.3, rng) ? std::numbers::pi / 2 * static_cast<double>(rng() % 4)
                                         : uniform(-3.2, 3.2, rng);
    const Path path{{uniform(-9, 9, rng), uniform(-9, 9, rng), turn},
                    shunting(vehicle.min_turning_radius, rng)};
    const Surroundings around = just_beside(path, vehicle, margin, rng);
    const Problem problem = problem_in(around, path.start, end_pose(path), vehicle);
    PlanOptions options{.cost = shortest_style};
    options.clearance.margin = margin.wanted;
    options.budget.max_iterations = 1000;
    const PlanResult result = plan(problem, options);
    ASSERT_NE(result.status, PlanStatus::rejected) << result.reason;
    double least = length(path);
    if (result.path) least = std::min(least, result.cost);
    Task task = problem.task();
    task.least_margin = margin.wanted;
    ASSERT_LE(flood_bound(task, 1.1 * least, 1000), least * (1 + 1e-9))
        << as_code(path) << " among " << as_code(around.obstacles);
  });
}

// A path in one gear among things that it just passes: the bound in that gear is not above its
// length, nor above that of a shorter one that the planner finds.
TEST(PoseFlood, IsBelowPathsInOneGear) {
  for_each_case(4, 150, [](Rng& rng) {
    const Vehicle vehicle = small_vehicle(rng);
    const search::GearSign gear = chance(0.5, rng) ? 1 : -1;
    const double turn = chance(0.3, rng) ? std::numbers::pi / 2 * static_cast<double>(rng() % 4)
                                         : uniform(-3.2, 3.2, rng);
    const Path path{{uniform(-9, 9, rng), uniform(-9, 9, rng), turn},
                    driven_on(vehicle.min_turning_radius, gear, rng)};
    const Surroundings around = just_beside(path, vehicle, {}, rng);
    const Problem problem = problem_in(around, path.start, end_pose(path), vehicle);
    PlanOptions options{.style = Style::shortest};
    options.cost.gears = gear > 0 ? AllowedGears::forward : AllowedGears::reverse;
    options.budget.max_iterations = 1000;
    const PlanResult result = plan(problem, options);
    ASSERT_NE(result.status, PlanStatus::rejected) << result.reason;
    double least = length(path);
    if (result.path) least = std::min(least, result.cost);
    ASSERT_LE(result.lower_bound, least * (1 + 1e-9)) << as_code(path);
    ASSERT_LE(flood_bound(problem.task(), 1.1 * least, 1000, gear), least * (1 + 1e-9))
        << as_code(path) << " among " << as_code(around.obstacles);
  });
}

// Zones that a path keeps out of are walls for the bounds of both disc and vehicle, and the path is
// not below them.
TEST(PoseFlood, IsBelowPathsThatKeepToZones) {
  int raised = 0;
  for_each_case(6, 300, [&](Rng& rng) {
    const Vehicle vehicle = small_vehicle(rng);
    const search::GearSign only = chance(0.4, rng) ? 0 : chance(0.5, rng) ? 1 : -1;
    const double radius = vehicle.min_turning_radius;
    const Path path{{uniform(-9, 9, rng), uniform(-9, 9, rng), uniform(-3.2, 3.2, rng)},
                    only == 0 ? shunting(radius, rng) : driven_on(radius, only, rng)};
    Surroundings around = just_beside(path, vehicle, {}, rng);
    if (chance(0.7, rng)) around.obstacles.clear();
    add_zones_beside(path, vehicle, only, around, rng);
    const Problem problem = problem_in(around, path.start, end_pose(path), vehicle);
    const double least = length(path);
    search::Geodesic geodesic(problem.task(), 1.1 * least, only);
    while (geodesic.step()) {
    }
    ASSERT_LE(geodesic.bound(), least * (1 + 1e-9)) << as_code(path);
    ASSERT_LE(flood_bound(problem.task(), 1.1 * least, 500, only), least * (1 + 1e-9))
        << as_code(path);
    around.zones.clear();
    const Problem without = problem_in(around, path.start, end_pose(path), vehicle);
    search::Geodesic blind(without.task(), 1.1 * least, only);
    while (blind.step()) {
    }
    raised += geodesic.bound() > blind.bound() + 1e-3 ? 1 : 0;
  });
  EXPECT_GT(raised, cases(300) / 20);
}

// What bars a sense of crossing bars no path that keeps to it, however near its edge the path is.
TEST(PoseFlood, IsBelowPathsThatKeepToStreets) {
  int raised = 0;
  for_each_case(8, 150, [&](Rng& rng) {
    const Vehicle vehicle = small_vehicle(rng);
    const search::GearSign only = chance(0.5, rng) ? 0 : chance(0.5, rng) ? 1 : -1;
    const double radius = vehicle.min_turning_radius;
    const double turn = chance(0.3, rng) ? std::numbers::pi / 2 * static_cast<double>(rng() % 4)
                                         : uniform(-3.2, 3.2, rng);
    const Path path{{uniform(-9, 9, rng), uniform(-9, 9, rng), turn},
                    only == 0 ? shunting(radius, rng) : driven_on(radius, only, rng)};
    Surroundings around = just_beside(path, vehicle, {}, rng);
    if (chance(0.7, rng)) around.obstacles.clear();
    add_streets_beside(path, vehicle, around, rng);
    const Problem problem = problem_in(around, path.start, end_pose(path), vehicle);
    const double least = length(path);
    const double bound = flood_bound(problem.task(), 1.1 * least, 500, only);
    ASSERT_LE(bound, least * (1 + 1e-9)) << as_code(path);
    search::ZoneBound zones(problem.task(), only);
    while (zones.step()) {
    }
    ASSERT_FALSE(zones.is_proven()) << as_code(path);
    around.zones.clear();
    const Problem without = problem_in(around, path.start, end_pose(path), vehicle);
    raised += bound > flood_bound(without.task(), 1.1 * least, 500, only) + 1e-3 ? 1 : 0;
  });
  EXPECT_GE(raised, cases(150) / 150);
}

// A block with a street on either side; the nearer one leads the other way.
TEST(PoseFlood, KnowsThatAOneWayStreetIsDrivenRound) {
  Surroundings around{.bounds = {-5, 35, -3, 15}, .obstacles = {box(4, 3, 26, 9)}};
  const double detour = 43;
  for (const bool is_against : {false, true}) {
    const double way = is_against ? std::numbers::pi : 0.0;
    for (const bool body : {false, true}) {
      around.zones = {{.area = box(10, body ? -2.5 : -4, 20, body ? 1.5 : 4),
                       .direction = HeadingRange{way - 1, way + 1},
                       .body = body}};
      for (const search::GearSign only : {0, 1, -1}) {
        const double heading = only < 0 ? std::numbers::pi : 0.0;
        const Problem problem = problem_in(around, {0, 0, heading}, {30, 0, heading}, car);
        const double bound = flood_bound(problem.task(), 50, 10000, only);
        EXPECT_GT(bound, is_against ? 0.95 * detour : 29.9) << only;
        if (only != 0) continue;
        EXPECT_LT(bound, is_against ? 50 : 30.1);
      }
    }
  }
}

// All directions but those against the street are allowed. In both gears that bars nothing.
TEST(PoseFlood, KnowsThatOneGearDoesNotSlideAgainstAStreet) {
  Surroundings around{.bounds = {-5, 35, -3, 25}, .obstacles = {box(4, 3, 26, 15)}};
  const double half = std::numbers::pi / 2;
  for (const double way : {0.0, std::numbers::pi}) {
    around.zones = {
        {.area = box(10, -4, 20, 4), .direction = HeadingRange{way - half, way + half}}};
    for (const search::GearSign only : {1, -1}) {
      const double heading = only > 0 ? 0.0 : std::numbers::pi;
      const Problem problem = problem_in(around, {0, 0, heading}, {30, 0, heading}, car);
      const double bound = flood_bound(problem.task(), 60, 10000, only);
      EXPECT_GT(bound, way > 0 ? 45 : 29.9) << only;
      EXPECT_LT(bound, way > 0 ? 61 : 31) << only;
    }
  }
}

// Parking beside the start: in both gears that is short, in one gear it takes a loop.
TEST(PoseFlood, KnowsThatOneGearTakesALoop) {
  const Problem problem =
      problem_of({0, 0, 0}, {0, 3, 0}, {box(-1, 8, 1, 9)}, {-20, 20, -20, 20}, car);
  const double loop = 2 * std::numbers::pi * car.min_turning_radius;
  EXPECT_LT(flood_bound(problem.task(), 1.2 * loop, 20000), 0.5 * loop);
  EXPECT_GT(flood_bound(problem.task(), 1.2 * loop, 20000, 1), 0.8 * loop);
  EXPECT_GT(flood_bound(problem.task(), 1.2 * loop, 20000, -1), 0.8 * loop);
}

}  // namespace
}  // namespace vandplan
