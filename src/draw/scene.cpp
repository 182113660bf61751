// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "draw/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/boxes.h"
#include "vandplan/input_error.h"
#include "vandplan/vehicle.h"

namespace vandplan::drawing {
namespace {

constexpr double most_around = 1.5;  // Surroundings shown on each side [extents of the path].
// Largest extent of the scene with its bounds [extents of the scene].
constexpr double most_fence = 1.5;

void require_finite(double value, const char* where) {
  if (!std::isfinite(value)) throw InputError(where, "must be finite");
}

// Origin near a coordinate [m]; 0 as long as labels of the axes stay short.
double origin_near(double coordinate) {
  constexpr double far = 1e5;
  return std::abs(coordinate) < far ? 0.0 : std::floor(coordinate / 1e3) * 1e3;
}

Pose moved(const Pose& pose, const Point& origin, const char* where) {
  require_finite(pose.x, where);
  require_finite(pose.y, where);
  require_finite(pose.heading, where);
  return {pose.x - origin.x, pose.y - origin.y, pose.heading};
}

std::vector<Polygon> moved(std::vector<Polygon> polygons, const Point& origin) {
  for (Polygon& polygon : polygons) {
    for (Point& corner : polygon) corner = {corner.x - origin.x, corner.y - origin.y};
  }
  return polygons;
}

Path moved(Path path, const Point& origin) {
  path.start = moved(path.start, origin, "path.start");
  for (const Segment& segment : path.segments) {
    require_finite(segment.curvature, "path.segments");
    require_finite(segment.length, "path.segments");
    require_finite(segment.curvature_rate, "path.segments");
  }
  return path;
}

TreeSnapshot moved(TreeSnapshot tree, const Point& origin) {
  for (Pose& pose : tree.poses) pose = moved(pose, origin, "tree");
  return tree;
}

bool is_inside(const Bounds& box, const Bounds& around) {
  return geometry::shared(box, around) == box;
}

double extent(const Bounds& box) { return std::max(box.x_max - box.x_min, box.y_max - box.y_min); }

/// Area where a region's axle may be; empty if it is one place.
Polygon area_of(const GoalRegion& region) {
  if (!region.area.empty()) return region.area;
  const auto& [x_min, x_max] = region.x;
  const auto& [y_min, y_max] = region.y;
  if (x_min == x_max && y_min == y_max) return {};
  return {{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}};
}

/// Some goals of a region, with headings spread over its range.
std::vector<State> goals_of(const Vehicle& vehicle, const GoalRegion& region) {
  const auto& [least, most] = region.hitch_angle;
  State middle{some_pose(region), 0.5 * (least + most)};
  if (region.is_of_trailer) middle.pose = tractor_pose(vehicle, middle.pose, middle.hitch_angle);
  constexpr double apart = std::numbers::pi / 4;
  const double turns = width(region.heading);
  const int steps = static_cast<int>(std::ceil(turns / apart));
  std::vector<State> goals;
  for (int i = 0; i <= steps; ++i) {
    const double turn = steps == 0 ? 0.0 : turns * i / steps - 0.5 * turns;
    for (const double turned : {0.0, std::numbers::pi}) {
      if (turned > 0.0 && !region.either_way) continue;
      const Pose& pose = middle.pose;
      goals.push_back({{pose.x, pose.y, pose.heading + turn + turned}, middle.hitch_angle});
    }
  }
  return goals;
}

/// Box around all places of the vehicle.
Bounds surroundings_of_path(const Scene& scene) {
  const auto [vehicle, trailer] = bodies_of(scene);
  std::vector<Point> points;
  const auto add = [&](const Polygon& body, const Pose& pose) {
    for (const Point& corner : placed(body, pose)) points.push_back(corner);
  };
  const auto add_vehicle = [&, &body = vehicle](const Pose& pose) { add(body, pose); };
  const auto add_trailer = [&, &body = trailer](const Pose& pose) { add(body, pose); };
  add_vehicle(scene.start);
  add_vehicle(scene.goal);
  for (const State& goal : scene.goals) add_vehicle(goal.pose);
  for (const State& via : scene.vias) add_vehicle(via.pose);
  for (const Polygon& area : scene.goal_areas)
    points.insert(points.end(), area.begin(), area.end());
  if (scene.vehicle.trailer) {
    add_trailer(trailer_pose(scene.vehicle, {scene.start, scene.hitch_angles.start}));
    add_trailer(trailer_pose(scene.vehicle, {scene.goal, scene.hitch_angles.goal}));
  }
  if (scene.path) {
    const double step = std::max(1.0, length(scene.path->segments) / 5000);
    for (const Stroke& stroke : strokes_of(scene, step)) {
      for (const Pose& pose : stroke.poses) add_vehicle(pose);
      for (const Pose& pose : stroke.trailer) add_trailer(pose);
    }
  }
  for (const Pose& pose : scene.driven) points.push_back({pose.x, pose.y});
  return bounding_box(points);
}

/// Moving obstacles at some times, from 0 until they rest or leave.
std::vector<Shadow> shadows_of(const std::vector<MovingObstacle>& moving, const Point& origin) {
  constexpr int steps = 8;
  std::vector<Shadow> shadows;
  for (int i = steps; i >= 0; --i) {
    for (const MovingObstacle& obstacle : moving) {
      const double t = std::max(obstacle.trajectory.back().t, 0.0) * i / steps;
      if (i > 0 && t == 0.0) continue;
      const std::optional<Pose> pose = pose_at(obstacle, t);
      if (!pose) continue;
      shadows.push_back({placed(obstacle.outline, moved(*pose, origin, "moving")),
                         i == 0 ? 1.0 : 0.5 - 0.4 * i / steps});
    }
  }
  return shadows;
}

/// The map of a mask. Only cells that say something are occupied.
OccupancyGrid without_unknown(const Mask& mask) {
  OccupancyGrid map = mask.map;
  std::vector<Cell> cells = *map.cells;
  std::replace(cells.begin(), cells.end(), Cell::unknown, Cell::free);
  for (std::size_t i = 0; mask.percents && i < cells.size(); ++i) {
    const std::uint8_t percent = (*mask.percents)[i];
    cells[i] = percent == 0 || percent == Mask::unknown ? Cell::free : Cell::occupied;
  }
  map.cells = std::move(cells);
  return map;
}

/// Outlines of all objects in the scene; a map is one object.
std::vector<Polygon> things_in(const Scene& scene) {
  std::vector<Polygon> things = scene.obstacles;
  things.insert(things.end(), scene.kerbs.begin(), scene.kerbs.end());
  things.insert(things.end(), scene.inside.begin(), scene.inside.end());
  for (const Zone& zone : scene.zones) things.push_back(zone.area);
  for (const auto* masks : {&scene.masks, &scene.faint_masks}) {
    for (const OccupancyGrid& map : *masks) things.push_back(outline(map));
  }
  if (scene.map) things.push_back(outline(*scene.map));
  for (const Shadow& shadow : scene.shadows) things.push_back(shadow.outline);
  return things;
}

/// State at the end of a scene's path.
State end_of(const Scene& scene) {
  State state{scene.path->start, scene.hitch_angles.start};
  for (const Segment& segment : scene.path->segments) {
    state = advance(scene.vehicle, state, segment);
  }
  return state;
}

}  // namespace

/// Corners of the object that is hit; empty if the scenario lacks it.
std::vector<Polygon> outline_of(const Scenario& scenario, const Hit& hit) {
  if (hit.kind == HitKind::mask) return {};
  if (hit.kind == HitKind::zone) {
    if (hit.index >= scenario.zones.size()) return {};
    return {scenario.zones[hit.index].area};
  }
  if (has_index(hit.kind)) {
    const std::vector<Polygon>& all = hit.kind == HitKind::kerb     ? scenario.kerbs
                                      : hit.kind == HitKind::inside ? scenario.inside
                                                                    : scenario.obstacles;
    if (hit.index >= all.size()) return {};
    return {all[hit.index]};
  }
  if (hit.kind == HitKind::bounds) {
    const auto& [x_min, x_max, y_min, y_max] = scenario.bounds;
    return {{{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}}};
  }
  if (!hit.cell || !scenario.map) return {};
  const Pose middle{hit.cell->x, hit.cell->y, scenario.map->origin.heading};
  const double half = scenario.map->resolution / 2;
  return {placed({{-half, -half}, {half, -half}, {half, half}, {-half, half}}, middle)};
}

namespace {

/// Adds areas and some poses of regions, moved to `origin`.
void add_regions(const Vehicle& vehicle, const std::vector<GoalRegion>& regions,
                 const Point& origin, std::vector<Polygon>& areas, std::vector<State>& poses) {
  for (const GoalRegion& region : regions) {
    if (const Polygon area = area_of(region); !area.empty()) {
      areas.push_back(moved(std::vector<Polygon>{area}, origin).front());
    }
    for (State state : goals_of(vehicle, region)) {
      state.pose = moved(state.pose, origin, "goal");
      poses.push_back(state);
    }
  }
}

/// Lines along which paths end: `straight` metres behind and ahead of goals, as either gear may be
/// driven.
std::vector<std::array<Pose, 2>> stretches_of(const Vehicle& vehicle,
                                              const std::vector<GoalRegion>& regions,
                                              const Point& origin) {
  std::vector<std::array<Pose, 2>> lines;
  for (const GoalRegion& region : regions) {
    if (region.straight == 0.0) continue;
    for (const State& goal : goals_of(vehicle, region)) {
      const Pose pose = moved(goal.pose, origin, "goal");
      lines.push_back(
          {advance(pose, {0.0, -region.straight}), advance(pose, {0.0, region.straight})});
    }
  }
  return lines;
}

}  // namespace

Scene scene_of(const Drawing& drawing) {
  if (drawing.scenario == nullptr) throw InputError("scenario", "is missing");
  const Scenario& scenario = *drawing.scenario;
  check_scenario(scenario);
  Scene scene;
  scene.origin = {origin_near(scenario.start.x), origin_near(scenario.start.y)};
  scene.vehicle = scenario.vehicle;
  const Bounds& bounds = scenario.bounds;
  scene.bounds = {bounds.x_min - scene.origin.x, bounds.x_max - scene.origin.x,
                  bounds.y_min - scene.origin.y, bounds.y_max - scene.origin.y};
  scene.start = moved(scenario.start, scene.origin, "start");
  scene.goal = moved(scenario.goal, scene.origin, "goal");
  scene.hitch_angles = scenario.hitch_angles;
  add_regions(scenario.vehicle, scenario.goal_set, scene.origin, scene.goal_areas, scene.goals);
  scene.stretches = stretches_of(scenario.vehicle, scenario.goal_set, scene.origin);
  for (const Via& via : scenario.via) {
    add_regions(scenario.vehicle, via.any_of, scene.origin, scene.via_areas, scene.vias);
  }
  scene.obstacles = moved(scenario.obstacles, scene.origin);
  scene.kerbs = moved(scenario.kerbs, scene.origin);
  scene.inside = moved(scenario.inside, scene.origin);
  scene.zones = scenario.zones;
  for (Zone& zone : scene.zones) {
    zone.area = moved(std::vector<Polygon>{zone.area}, scene.origin).front();
  }
  for (const Mask& mask : scenario.masks) {
    OccupancyGrid map = without_unknown(mask);
    map.origin = moved(map.origin, scene.origin, "masks");
    (mask.use == MaskUse::obstacles ? scene.masks : scene.faint_masks).push_back(std::move(map));
  }
  scene.shadows = shadows_of(scenario.moving, scene.origin);
  scene.map = scenario.map;
  if (scene.map) scene.map->origin = moved(scene.map->origin, scene.origin, "map.origin");
  if (drawing.path) scene.path = moved(*drawing.path, scene.origin);
  if (!scene.goals.empty()) {
    const State goal = scene.path ? end_of(scene) : scene.goals.front();
    scene.goal = goal.pose;
    scene.hitch_angles.goal = goal.hitch_angle;
  }
  if (!(drawing.margin >= 0.0)) throw InputError("margin", "must be at least 0 [m]");
  scene.margin = drawing.margin;
  scene.curvature_strip = drawing.curvature_strip && drawing.path != nullptr;
  if (drawing.hit) scene.hit = moved(outline_of(scenario, *drawing.hit), scene.origin);
  if (drawing.tree) scene.tree = moved(*drawing.tree, scene.origin);
  if (drawing.driven) {
    for (const Pose& pose : *drawing.driven) {
      scene.driven.push_back(moved(pose, scene.origin, "driven"));
    }
  }
  return scene;
}

Bodies bodies_of(const Scene& scene) {
  const std::optional<Trailer>& trailer = scene.vehicle.trailer;
  return {body_outline(scene.vehicle), trailer ? body_outline(*trailer) : Polygon{}};
}

Polygon placed(const Polygon& outline, const Pose& pose) {
  Polygon there;
  const double cos = std::cos(pose.heading);
  const double sin = std::sin(pose.heading);
  for (const auto& [x, y] : outline) {
    there.push_back({pose.x + cos * x - sin * y, pose.y + sin * x + cos * y});
  }
  return there;
}

std::vector<Stroke> strokes_of(const Scene& scene, double step) {
  const bool has_trailer = scene.vehicle.trailer.has_value();
  std::vector<Stroke> strokes;
  State state{scene.path->start, scene.hitch_angles.start};
  for (const Segment& segment : scene.path->segments) {
    if (segment.length == 0.0) continue;
    const int direction = segment.length > 0.0 ? 1 : -1;
    if (strokes.empty() || strokes.back().direction != direction) {
      strokes.push_back({direction, {state.pose}, {}});
      if (has_trailer) strokes.back().trailer = {trailer_pose(scene.vehicle, state)};
    }
    for (const PathPoint& point : sampled({state.pose, {segment}}, step)) {
      if (!(point.s > 0.0)) continue;
      strokes.back().poses.push_back(point.pose);
      if (!has_trailer) continue;
      const Segment driven = part_of(segment, 0.0, point.s);
      const double angle = hitch_angle_after(scene.vehicle, state.hitch_angle, driven);
      strokes.back().trailer.push_back(trailer_pose(scene.vehicle, {point.pose, angle}));
    }
    state.pose = strokes.back().poses.back();
    if (has_trailer) {
      state.hitch_angle = hitch_angle_after(scene.vehicle, state.hitch_angle, segment);
    }
  }
  return strokes;
}

Framing framed(const Scene& scene) {
  const Bounds core = surroundings_of_path(scene);
  const Bounds reach = geometry::widened(core, most_around * extent(core));
  Framing framing{core, false};
  for (const Polygon& thing : things_in(scene)) {
    const Bounds box = bounding_box(thing);
    framing.is_cropped |= !is_inside(box, reach);
    const Bounds near = geometry::shared(box, reach);
    if (near.x_min <= near.x_max && near.y_min <= near.y_max) {
      framing.seen = geometry::united(framing.seen, near);
    }
  }
  // The bounds of a yard are worth seeing, unlike bounds that were chosen generously.
  const Bounds fenced = geometry::united(framing.seen, scene.bounds);
  if (extent(fenced) <= most_fence * extent(framing.seen)) framing.seen = fenced;
  framing.seen = geometry::widened(framing.seen, 1.0 + 0.03 * extent(framing.seen));
  return framing;
}

Point View::on_page(const Point& point) const noexcept {
  return {plot.x + (point.x - visible.x_min) * scale, plot.y + (visible.y_max - point.y) * scale};
}

View view_of(const Bounds& visible, const Box& plot) noexcept {
  const double scale = std::min(plot.width / (visible.x_max - visible.x_min),
                                plot.height / (visible.y_max - visible.y_min));
  const double x = (visible.x_min + visible.x_max) / 2;
  const double y = (visible.y_min + visible.y_max) / 2;
  const double half_width = plot.width / scale / 2;
  const double half_height = plot.height / scale / 2;
  return {{x - half_width, x + half_width, y - half_height, y + half_height}, plot, scale};
}

}  // namespace vandplan::drawing
