// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "nasty/nasty_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "nasty/naive_judge.h"
#include "support/draws.h"
#include "support/grids.h"
#include "support/problems.h"
#include "vandplan/random.h"

namespace vandplan::nasty {
namespace {

constexpr double pi = std::numbers::pi;

/// The world that grows, and how large things are in it.
struct Site {
  Scenario scenario;
  double size = 0.0;  ///< length of the vehicle, or its turning radius if that is more [m]
  Rng& rng;

  Pose somewhere(double reach) {
    const Pose& start = scenario.start;
    return {start.x + uniform(-reach, reach, rng) * size,
            start.y + uniform(-reach, reach, rng) * size, uniform(-pi, pi, rng)};
  }
};

double whole_length(const Vehicle& v) { return v.rear_overhang + v.wheelbase + v.front_overhang; }

Vehicle nasty_vehicle(Rng& rng) {
  Vehicle v = chance(0.6, rng) ? any_vehicle(rng) : any_body(rng);
  v.min_turning_radius = chance(0.5, rng) ? 7.0 : any_size(0.3, 6, rng) * v.wheelbase;
  const double kind = uniform01(rng);
  const double scale = kind < 0.1 ? any_size(0.02, 0.3, rng) : kind > 0.9 ? uniform(3, 12, rng) : 1;
  for (double* const length :
       {&v.wheelbase, &v.front_overhang, &v.rear_overhang, &v.width, &v.min_turning_radius}) {
    *length *= scale;
  }
  for (Point& corner : v.outline) corner = {corner.x * scale, corner.y * scale};
  if (chance(0.2, rng)) v.track_width = v.width * any_size(0.2, 1, rng);
  return v;
}

/// Beside the start, on it, turned on the spot, or anywhere.
Pose nasty_goal(Site& site) {
  Rng& rng = site.rng;
  const Pose& start = site.scenario.start;
  const double kind = uniform01(rng);
  if (kind < 0.02) return start;
  if (kind < 0.1) return {start.x, start.y, start.heading + uniform(-pi, pi, rng)};
  if (kind < 0.2) return compose(start, {0, any_sign(any_size(1e-6, 2, rng) * site.size, rng), 0});
  if (kind < 0.3) return compose(start, {any_sign(any_size(1e-6, 8, rng) * site.size, rng), 0, 0});
  return site.somewhere(any_size(0.3, 6, rng));
}

Polygon placed(const Pose& at, const Polygon& polygon) {
  Polygon moved;
  for (const Point& p : polygon) {
    const Pose corner = compose(at, {p.x, p.y, 0});
    moved.push_back({corner.x, corner.y});
  }
  return moved;
}

// ---- Polygons, each beside what stands there already ----

using Polygons = std::vector<Polygon>;

/// Thin and up to a thousand times as long as the vehicle.
void needle(Site& site, Polygons& to) {
  Rng& rng = site.rng;
  const double length = any_size(0.1, 1000, rng) * site.size;
  const double width = any_size(1e-6, 1e-2, rng) * site.size;
  to.push_back(
      placed(site.somewhere(8),
             {{0, 0}, {length, -width * uniform01(rng)}, {length * uniform01(rng), width}}));
}

/// Teeth with gaps that the vehicle may just fit between, or its corners.
void comb(Site& site, Polygons& to) {
  Rng& rng = site.rng;
  const double gap = site.scenario.vehicle.width * any_size(0.1, 1.5, rng);
  const double tooth = any_size(1e-4, 0.3, rng) * site.size;
  const double depth = any_size(0.1, 2, rng) * site.size;
  const int teeth = 2 + static_cast<int>(uniform(0, 12, rng));
  Polygon comb = {{0, -0.1 * site.size}};
  for (int i = 0; i < teeth; ++i) {
    const double x = i * (gap + tooth);
    comb.insert(comb.begin(), {{x, depth}, {x, 0}});
    comb.insert(comb.begin(), {{x + tooth, 0}, {x + tooth, depth}});
  }
  comb.insert(comb.begin(), {(teeth - 1) * (gap + tooth) + tooth, -0.1 * site.size});
  to.push_back(placed(site.somewhere(4), comb));
}

/// Deep dents, or none.
void star(Site& site, Polygons& to) {
  Rng& rng = site.rng;
  const int corners = 3 + static_cast<int>(any_size(1, 60, rng));
  const double radius = any_size(1e-3, 3, rng) * site.size;
  const double dent = any_size(0.01, 1, rng);
  Polygon star;
  for (int i = 0; i < corners; ++i) {
    const double r = radius * uniform(dent, 1, rng);
    const double turn = 2 * pi * i / corners;
    star.push_back({r * std::cos(turn), r * std::sin(turn)});
  }
  if (chance(0.3, rng)) std::reverse(star.begin(), star.end());
  to.push_back(placed(site.somewhere(6), star));
}

/// Boxes in boxes, or boxes that share sides and corners.
void boxes(Site& site, Polygons& to) {
  Rng& rng = site.rng;
  const Pose at = site.somewhere(5);
  const double side = any_size(0.01, 1, rng) * site.size;
  const bool nested = chance(0.3, rng);
  for (int i = 0; i < 5; ++i) {
    const double inset = nested ? side * i / 12 : 0;
    const double x = nested ? 0 : side * (i % 3);
    const double y = nested ? 0 : side * static_cast<int>(uniform(0, 2, rng));
    to.push_back(placed(at, box(x + inset, y + inset, x + side - inset, y + side - inset)));
  }
}

/// A point, a pebble, or a polygon with repeated corners and corners on its sides.
void odd_ends(Site& site, Polygons& to) {
  Rng& rng = site.rng;
  const Pose at = site.somewhere(4);
  const double side = any_size(1e-6, 0.5, rng) * site.size;
  const double kind = uniform01(rng);
  if (kind < 0.3) {
    to.push_back(Polygon(3, {at.x, at.y}));
  } else if (kind < 0.6) {
    to.push_back(placed(at, {{0, 0}, {side, 0}, {side, side}}));
  } else {
    to.push_back(placed(
        at, {{0, 0}, {side, 0}, {side, 0}, {side, side / 2}, {side, side}, {0, side}, {0, 0}}));
  }
}

/// How near walls stand: touching, by the width of a hair, or around the checker's tolerance [m].
double hair(Rng& rng) {
  constexpr std::array gaps = {0.0, 1e-12, 1e-9, 1e-6, 3e-4, 1e-3};
  if (chance(0.3, rng)) return gaps[static_cast<std::size_t>(uniform(0, gaps.size(), rng))];
  return chance(0.7, rng) ? uniform(0, 2e-3, rng) : any_size(1e-6, 0.1, rng);
}

/// Along a side of the body or at its bumper, as it stands at the start or at the goal.
void near_wall(Site& site, Polygons& to) {
  Rng& rng = site.rng;
  const Footprint body = footprint(site.scenario.vehicle);
  const Pose& at = chance(0.6, rng) ? site.scenario.start : site.scenario.goal;
  const double gap = hair(rng);
  const double thick = any_size(1e-5, 1, rng) * site.size;
  const double reach = any_size(0.01, 3, rng) * site.size;
  const double kind = uniform01(rng);
  const double side = any_sign(1, rng);
  const double near = body.half_width + gap;
  if (kind < 0.6) {
    const double far = near + thick;
    to.push_back(placed(at, box(-reach, std::min(side * near, side * far), reach,
                                std::max(side * near, side * far))));
  } else if (kind < 0.8) {
    const double x = body.front + gap;
    to.push_back(placed(at, box(x, -reach, x + thick, reach)));
  } else {  // a tip that points at a corner of the body
    to.push_back(placed(at, {{body.front + gap, side * near},
                             {body.front + gap + reach, side * near},
                             {body.front + gap + reach, side * (near + thick)}}));
  }
}

/// Two walls with the body between them, all the way from the start onwards.
void lane(Site& site, Polygons& to) {
  Rng& rng = site.rng;
  const Footprint body = footprint(site.scenario.vehicle);
  const double length = any_size(1, 20, rng) * site.size;
  for (const double side : {1.0, -1.0}) {
    const double near = side * (body.half_width + std::max(hair(rng), 2e-4));
    const double far = near + side * 0.2 * site.size;
    to.push_back(placed(site.scenario.start,
                        box(-length / 4, std::min(near, far), length, std::max(near, far))));
  }
}

/// A ring with a door, around the start or with it outside.
void ring(Site& site, Polygons& to) {
  Rng& rng = site.rng;
  const Pose at = chance(0.6, rng) ? site.scenario.start : site.somewhere(6);
  const double outer = any_size(1.5, 8, rng) * site.size;
  const double inner = outer * uniform(0.5, 0.99, rng);
  const double door = chance(0.3, rng) ? 1e-3 : uniform(0.05, 1.5, rng);
  Polygon ring;
  constexpr int corners = 12;
  for (const bool is_outer : {true, false}) {
    for (int i = 0; i <= corners; ++i) {
      const int at_corner = is_outer ? i : corners - i;
      const double turn = door + (2 * pi - door) * at_corner / corners;
      const double radius = is_outer ? outer : inner;
      ring.push_back({radius * std::cos(turn), radius * std::sin(turn)});
    }
  }
  to.push_back(placed({at.x, at.y, uniform(-pi, pi, rng)}, ring));
}

using Builder = void (*)(Site&, Polygons&);
constexpr std::array<Builder, 9> builders = {needle,    comb,      star, boxes, odd_ends,
                                             near_wall, near_wall, lane, ring};

void build(Site& site, Polygons& to, int most) {
  const int count = static_cast<int>(uniform(0, most + 1, site.rng));
  for (int i = 0; i < count; ++i) {
    builders[static_cast<std::size_t>(uniform(0, builders.size(), site.rng))](site, to);
  }
}

/// Takes away what stands where the vehicle starts or ends, by the naive judge's eye.
void clear_ends(const Scenario& scenario, Polygons& things, double margin) {
  Scenario alone{.vehicle = scenario.vehicle,
                 .bounds = {-1e9, 1e9, -1e9, 1e9},
                 .start = scenario.start,
                 .goal = scenario.goal};
  std::erase_if(things, [&](const Polygon& thing) {
    alone.obstacles = {thing};
    return !naive_hit(alone, alone.start, margin).empty() ||
           !naive_hit(alone, alone.goal, margin).empty();
  });
}

// ---- Map, bounds and where all of it lies ----

/// Blocked cells anywhere but under start and goal, most of the time.
OccupancyGrid nasty_map(Site& site) {
  Rng& rng = site.rng;
  const auto side = [&] { return static_cast<std::int32_t>(any_size(1, 60, rng)); };
  const std::int32_t columns = side();
  const std::int32_t rows = side();
  OccupancyGrid grid = random_grid(columns, rows, any_size(1e-3, 0.3, rng), rng);
  grid.resolution = any_size(0.05, 3, rng) * site.size;
  grid.unknown_is_free = chance(0.85, rng);
  const Pose& start = site.scenario.start;
  const Pose middle{start.x, start.y, chance(0.2, rng) ? 0 : uniform(-pi, pi, rng)};
  const double width = columns * grid.resolution;
  const double height = rows * grid.resolution;
  grid.origin = compose(middle, {-width * uniform01(rng), -height * uniform01(rng), 0});
  auto cells = *grid.cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto column = static_cast<std::int32_t>(i) % columns;
    const auto row = static_cast<std::int32_t>(i) / columns;
    const Pose cell =
        compose(grid.origin, {(column + 0.5) * grid.resolution, (row + 0.5) * grid.resolution, 0});
    for (const Pose& pose : {start, site.scenario.goal}) {
      const double far = std::hypot(cell.x - pose.x, cell.y - pose.y);
      if (far < whole_length(site.scenario.vehicle) + grid.resolution) cells[i] = Cell::free;
    }
    if (chance(0.02, rng)) cells[i] = Cell::unknown;
  }
  grid.cells = std::move(cells);
  return grid;
}

/// Around start and goal: roomy, with one of them on the border, or far beyond all that matters.
Bounds nasty_bounds(Site& site) {
  Rng& rng = site.rng;
  const Pose& start = site.scenario.start;
  const Pose& goal = site.scenario.goal;
  const double kind = uniform01(rng);
  const double room = kind < 0.1   ? any_size(1e-9, 0.1, rng) * site.size
                      : kind < 0.8 ? uniform(1, 12, rng) * site.size
                                   : any_size(1e3, 1e6, rng);
  const auto margin = [&] { return room * uniform(0.5, 1, rng); };
  return {std::min(start.x, goal.x) - (chance(0.05, rng) ? 0 : margin()),
          std::max(start.x, goal.x) + margin(), std::min(start.y, goal.y) - margin(),
          std::max(start.y, goal.y) + (chance(0.05, rng) ? 0 : margin())};
}

/// How the wheels are turned at both ends: straight, most of the time, or as far as planners with
/// continuous curvature take them.
EndCurvatures nasty_curvatures(std::uint64_t seed, const Vehicle& vehicle) {
  Rng rng(stream_seed(seed, 3));
  const double slowest = 1.001 * std::sqrt(0.1 / max_curvature_rate(vehicle));
  const double radius = std::max(vehicle.min_turning_radius, slowest);
  const auto any = [&] {
    const double kind = uniform01(rng);
    const double share = kind < 0.8 ? 0.0 : kind < 0.9 ? 1.0 : uniform01(rng);
    return any_sign(share, rng) / radius;
  };
  const double start = any();
  return {start, any()};
}

}  // namespace

double size_of(const Vehicle& vehicle) {
  return std::max(whole_length(vehicle), vehicle.min_turning_radius);
}

Scenario nasty_world(std::uint64_t seed) {
  Rng rng(stream_seed(seed, 0));
  Site site{{}, 0.0, rng};
  Scenario& scenario = site.scenario;
  scenario.name = "nasty " + std::to_string(seed);
  scenario.vehicle = nasty_vehicle(rng);
  site.size = size_of(scenario.vehicle);
  scenario.start = uniform_pose({-10, 10, -10, 10}, rng);
  if (chance(0.2, rng)) scenario.start.heading = pi / 2 * static_cast<int>(uniform(-2, 3, rng));
  scenario.goal = nasty_goal(site);
  build(site, scenario.obstacles, 10);
  if (chance(0.3, rng)) build(site, scenario.kerbs, 3);
  if (chance(0.95, rng)) {  // most by so much that the checker has to accept start and goal
    const double margin = chance(0.8, rng) ? 1.01e-3 : 0;
    clear_ends(scenario, scenario.obstacles, margin);
    clear_ends(scenario, scenario.kerbs, margin);
  }
  if (chance(0.3, rng)) scenario.map = nasty_map(site);
  scenario.bounds = nasty_bounds(site);
  scenario.curvatures = nasty_curvatures(seed, scenario.vehicle);
  if (!chance(0.2, rng)) return scenario;
  const double far = any_size(1e3, 1e9, rng);
  return moved_by(std::move(scenario), any_sign(far, rng), any_sign(far * uniform01(rng), rng));
}

namespace {

/// From a value to either side, mostly nowhere.
Interval nasty_interval(double middle, double size, Rng& rng) {
  if (chance(0.4, rng)) return {middle, middle};
  const double width = any_size(1e-9, 2, rng) * size;
  const double least = middle - uniform01(rng) * width;
  return {least, least + width};
}

GoalRegion nasty_region(const Scenario& scenario, double size, Rng& rng) {
  Pose at = scenario.goal;
  if (chance(0.4, rng)) {
    at = {at.x + uniform(-2, 2, rng) * size, at.y + uniform(-2, 2, rng) * size,
          uniform(-pi, pi, rng)};
  }
  if (chance(0.05, rng)) at = scenario.start;
  GoalRegion region = region_of_pose(at);
  if (chance(0.3, rng)) {
    const double reach = any_size(1e-3, 2, rng) * size;
    const double notch = uniform(0.05, 0.95, rng) * reach;
    region.area = {{at.x - reach, at.y - reach},
                   {at.x + reach, at.y - reach},
                   {at.x + reach, at.y + reach},
                   {at.x, at.y + reach - notch},
                   {at.x - reach, at.y + reach}};
  } else {
    region.x = nasty_interval(at.x, size, rng);
    region.y = nasty_interval(at.y, size, rng);
  }
  const Interval turn = nasty_interval(at.heading, chance(0.3, rng) ? pi : 0.1, rng);
  region.heading = chance(0.3, rng) ? any_heading : HeadingRange{turn.least, turn.most};
  region.either_way = chance(0.3, rng);
  region.curvature = chance(0.9, rng) ? 0.0 : scenario.curvatures.start;
  if (region.curvature == 0.0 && chance(0.3, rng)) region.straight = any_size(1e-3, 3, rng) * size;
  if (!scenario.vehicle.trailer) return region;
  const double most = scenario.vehicle.max_hitch_angle;
  const Interval angle = nasty_interval(scenario.hitch_angles.goal, 0.2, rng);
  region.hitch_angle = {std::clamp(angle.least, -most, most), std::clamp(angle.most, -most, most)};
  if (chance(0.2, rng)) region.hitch_angle = {-most, most};
  region.is_of_trailer = chance(0.3, rng);
  return region;
}

}  // namespace

namespace {

/// An area around start and goal, most of the time: each corner is seen from their middle.
Polygon nasty_area(const Scenario& scenario, double size, Rng& rng) {
  const Pose& start = scenario.start;
  const Pose& goal = scenario.goal;
  const double half = std::hypot(goal.x - start.x, goal.y - start.y) / 2;
  const int corners = static_cast<int>(uniform(3, 10, rng));
  Polygon area;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * (i + uniform(0, 0.8, rng)) / corners;
    const double reach = half + any_size(0.5, 6, rng) * size;
    area.push_back({(start.x + goal.x) / 2 + reach * std::cos(angle),
                    (start.y + goal.y) / 2 + reach * std::sin(angle)});
  }
  if (chance(0.3, rng)) std::reverse(area.begin(), area.end());
  return area;
}

}  // namespace

Scenario nasty_world_of_goals(std::uint64_t seed) {
  Rng rng(stream_seed(seed, 4));
  Scenario scenario = chance(0.2, rng) ? nasty_world_of_a_rig(seed) : nasty_world(seed);
  const double size = size_of(scenario.vehicle);
  if (chance(0.4, rng)) scenario.inside = {nasty_area(scenario, size, rng)};
  if (!scenario.inside.empty() && chance(0.3, rng)) return scenario;
  if (chance(0.3, rng)) {
    for (int i = static_cast<int>(any_size(1, 4, rng)); i > 0; --i) {
      GoalRegion region = nasty_region(scenario, size, rng);
      region.straight = region.curvature = 0.0;
      scenario.via.push_back({.any_of = {region}, .stop = chance(0.5, rng)});
    }
    if (chance(0.5, rng)) return scenario;
  }
  const int regions = 1 + static_cast<int>(any_size(1, 4, rng));
  for (int i = chance(0.5, rng) ? regions : 1; i > 0; --i) {
    scenario.goal_set.push_back(nasty_region(scenario, size, rng));
  }
  return scenario;
}

Scenario nasty_world_of_a_rig(std::uint64_t seed) {
  Scenario scenario = nasty_world(seed);
  Rng rng(stream_seed(seed, 2));
  Vehicle& vehicle = scenario.vehicle;
  const double size = whole_length(vehicle);
  Trailer trailer{.wheelbase = size * any_size(0.1, 4, rng),
                  .width = vehicle.width * any_size(0.3, 2, rng)};
  trailer.front_overhang = uniform(-0.9, 0.5, rng) * trailer.wheelbase;
  trailer.rear_overhang = chance(0.2, rng) ? 0 : uniform(0, 1, rng) * trailer.wheelbase;
  vehicle.trailer = trailer;
  vehicle.hitch = chance(0.3, rng) ? 0 : uniform(-0.5, 0.3, rng) * size;
  vehicle.max_hitch_angle = uniform(0.3, 1.5, rng);
  for (double* const angle : {&scenario.hitch_angles.start, &scenario.hitch_angles.goal}) {
    if (chance(0.5, rng)) *angle = uniform(-0.3, 0.3, rng);
  }
  return scenario;
}

}  // namespace vandplan::nasty
