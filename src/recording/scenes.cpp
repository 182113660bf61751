// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "recording/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "recording/solids.h"
#include "vandplan/vehicle.h"

namespace vandplan::recording {
namespace {

// Colours that the colour-blind can tell apart (Okabe and Ito 2008), those of pictures.
constexpr Colour grey{0.35, 0.38, 0.43};
constexpr Colour sand{0.80, 0.71, 0.55};
constexpr Colour purple{0.58, 0.29, 0.72, 0.8};
constexpr Colour faint{0.66, 0.72, 0.79, 0.6};
constexpr Colour blue{0.0, 0.447, 0.698};
constexpr Colour orange{0.835, 0.369, 0.0};
constexpr Colour red{0.85, 0.07, 0.07};
constexpr Colour green{0.0, 0.62, 0.451};
constexpr Colour pink{0.70, 0.30, 0.55};
constexpr Colour yellow{0.94, 0.89, 0.26};

constexpr double obstacle_height = 1.5;      // [m]
constexpr double kerb_height = 0.15;         // [m]
constexpr double body_height = 0.9;          // [widths of the body]
constexpr double line_height = 0.1;          // Height of paths and trees above the ground [m].
constexpr double tree_width = 0.03;          // [m]
constexpr double footprint_width = 0.04;     // [m]
constexpr double footprint_distance = 2.0;   // Distance between footprints along a path [m].
constexpr std::size_t most_nodes = 100'000;  // Largest number of nodes shown of a tree.
constexpr std::size_t most_places = 20'000;  // Largest number of places of a driven line.
constexpr double label_height = 4.0;         // [m]

Point shifted(const Point& point, const Point& origin) {
  return {point.x - origin.x, point.y - origin.y};
}

Pose shifted(const Pose& pose, const Point& origin) {
  return {pose.x - origin.x, pose.y - origin.y, pose.heading};
}

void shift(std::vector<Polygon>& polygons, const Point& origin) {
  for (Polygon& polygon : polygons) {
    for (Point& corner : polygon) corner = shifted(corner, origin);
  }
}

void shift(GoalRegion& region, const Point& origin) {
  region.x = {region.x.least - origin.x, region.x.most - origin.x};
  region.y = {region.y.least - origin.y, region.y.most - origin.y};
  for (Point& corner : region.area) corner = shifted(corner, origin);
}

Polygon box_of(const Interval& x, const Interval& y) {
  return {{x.least, y.least}, {x.most, y.least}, {x.most, y.most}, {x.least, y.most}};
}

/// Outlines of a vehicle and its trailer on the ground.
std::vector<Line> footprints_at(const Vehicle& vehicle, const State& state, const Colour& colour) {
  std::vector<Line> lines = {outline_of(body_outline(vehicle), colour)};
  lines.back().pose = state.pose;
  if (!vehicle.trailer) return lines;
  lines.push_back(outline_of(body_outline(*vehicle.trailer), colour));
  lines.back().pose = trailer_pose(vehicle, state);
  return lines;
}

Entity entity_of(std::string id) { return {.id = std::move(id), .frame = std::string(site_frame)}; }

/// State of the vehicle at some goal of a region.
State some_state(const Vehicle& vehicle, const GoalRegion& region) {
  const double angle = (region.hitch_angle.least + region.hitch_angle.most) / 2;
  const Pose pose = some_pose(region);
  return {region.is_of_trailer ? tractor_pose(vehicle, pose, angle) : pose, angle};
}

/// Area of a region, or outlines of the vehicle at its only place.
Entity entity_of(std::string id, const Vehicle& vehicle, const GoalRegion& region,
                 const Colour& colour) {
  Entity entity = entity_of(std::move(id));
  const bool is_place = region.x.least == region.x.most && region.y.least == region.y.most;
  if (!region.area.empty()) {
    entity.lines = {outline_of(region.area, colour)};
  } else if (!is_place) {
    entity.lines = {outline_of(box_of(region.x, region.y), colour)};
  } else {
    entity.lines = footprints_at(vehicle, some_state(vehicle, region), colour);
  }
  return entity;
}

void add_goals(SceneChange& scene, const Scenario& scenario) {
  const Vehicle& vehicle = scenario.vehicle;
  if (scenario.goal_set.empty()) {
    Entity& goal = scene.entities.emplace_back(entity_of("goal"));
    goal.lines = footprints_at(vehicle, {scenario.goal, scenario.hitch_angles.goal}, pink);
  }
  for (std::size_t i = 0; i < scenario.goal_set.size(); ++i) {
    scene.entities.push_back(
        entity_of(fmt::format("goal.any_of[{}]", i), vehicle, scenario.goal_set[i], pink));
  }
  for (std::size_t i = 0; i < scenario.via.size(); ++i) {
    const std::vector<GoalRegion>& any_of = scenario.via[i].any_of;
    for (std::size_t k = 0; k < any_of.size(); ++k) {
      const std::string entry = any_of.size() > 1 ? fmt::format(".any_of[{}]", k) : "";
      scene.entities.push_back(
          entity_of(fmt::format("via[{}]{}", i, entry), vehicle, any_of[k], yellow));
    }
  }
}

/// Polygons of a key of the scenario, as high as `height` [m].
struct Walls {
  std::string_view key;
  const std::vector<Polygon>& polygons;
  double height;
  Colour colour;
};

/// Whether the polygon with this number, of a key of the scenario, is hit.
bool is_hit(const std::optional<Hit>& hit, std::string_view key, std::size_t i) {
  return hit && name_of(hit->kind) == key && hit->index == i;
}

void add_walls(SceneChange& scene, const Walls& walls, const std::optional<Hit>& hit) {
  for (std::size_t i = 0; i < walls.polygons.size(); ++i) {
    Entity& entity = scene.entities.emplace_back(entity_of(fmt::format("{}[{}]", walls.key, i)));
    entity.triangles = {
        prism_of(walls.polygons[i], walls.height, is_hit(hit, walls.key, i) ? red : walls.colour)};
  }
}

/// The body of a vehicle or trailer in its own frame, with a line from its axle to its front.
Entity body_of(std::string_view frame, const Polygon& outline, double width) {
  const double height = body_height * width;
  double front = 0.0;
  for (const Point& corner : outline) front = std::max(front, corner.x);
  Entity body{.id = std::string(frame), .frame = std::string(frame), .moves_with_frame = true};
  body.triangles = {prism_of(outline, height, green)};
  const double top = height + line_height / 2;
  body.lines = {{.join = Join::strip, .points = {{0, 0, top}, {front, 0, top}}, .colour = yellow}};
  return body;
}

void add_footprint(Line& pairs, const Polygon& outline, const Pose& pose) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    for (const Point& corner : {outline[i], outline[(i + 1) % outline.size()]}) {
      const Pose place = compose(pose, {corner.x, corner.y, 0.0});
      pairs.points.push_back({place.x, place.y, line_height / 2});
    }
  }
}

Entity footprints_along(const Vehicle& vehicle, const SampledPath& path) {
  Line pairs{.join = Join::pairs, .points = {}, .colour = faint, .thickness = footprint_width};
  const Polygon body = body_outline(vehicle);
  const Polygon trailer = vehicle.trailer ? body_outline(*vehicle.trailer) : Polygon{};
  double next = 0.0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    if (path.points[i].s < next && i + 1 < path.points.size()) continue;
    next = path.points[i].s + footprint_distance;
    const Pose& pose = path.points[i].pose;
    add_footprint(pairs, body, pose);
    if (!vehicle.trailer) continue;
    add_footprint(pairs, trailer, trailer_pose(vehicle, {pose, path.hitch_angles[i]}));
  }
  Entity entity = entity_of("footprints");
  entity.lines = {std::move(pairs)};
  return entity;
}

}  // namespace

Scenario moved_to(const Scenario& scenario, const Point& origin) {
  Scenario moved = scenario;
  Bounds& bounds = moved.bounds;
  bounds = {bounds.x_min - origin.x, bounds.x_max - origin.x, bounds.y_min - origin.y,
            bounds.y_max - origin.y};
  moved.start = shifted(moved.start, origin);
  moved.goal = shifted(moved.goal, origin);
  for (GoalRegion& region : moved.goal_set) shift(region, origin);
  for (Via& via : moved.via) {
    for (GoalRegion& region : via.any_of) shift(region, origin);
  }
  for (Zone& zone : moved.zones) {
    for (Point& corner : zone.area) corner = shifted(corner, origin);
  }
  for (auto* polygons : {&moved.obstacles, &moved.kerbs, &moved.inside}) shift(*polygons, origin);
  if (moved.map) moved.map->origin = shifted(moved.map->origin, origin);
  for (MovingObstacle& obstacle : moved.moving) {
    for (TimedPose& row : obstacle.trajectory) row.pose = shifted(row.pose, origin);
  }
  return moved;
}

SceneChange ground_scene(const Scenario& scenario, const std::optional<Hit>& hit) {
  SceneChange scene;
  const Bounds& b = scenario.bounds;
  Entity& bounds = scene.entities.emplace_back(entity_of("bounds"));
  bounds.lines = {outline_of(box_of({b.x_min, b.x_max}, {b.y_min, b.y_max}), faint)};
  for (std::size_t i = 0; i < scenario.inside.size(); ++i) {
    Entity& area = scene.entities.emplace_back(entity_of(fmt::format("inside[{}]", i)));
    area.lines = {outline_of(scenario.inside[i], grey)};
  }
  for (std::size_t i = 0; i < scenario.zones.size(); ++i) {
    const Zone& zone = scenario.zones[i];
    Entity& area = scene.entities.emplace_back(entity_of(fmt::format("zones[{}]", i)));
    const Colour& colour = zone.closed ? grey : sand;
    area.lines = {outline_of(zone.area, is_hit(hit, "zones", i) ? red : colour)};
  }
  add_walls(scene, {"obstacles", scenario.obstacles, obstacle_height, grey}, hit);
  add_walls(scene, {"kerbs", scenario.kerbs, kerb_height, sand}, hit);
  Entity& start = scene.entities.emplace_back(entity_of("start"));
  start.lines =
      footprints_at(scenario.vehicle, {scenario.start, scenario.hitch_angles.start}, green);
  add_goals(scene, scenario);
  return scene;
}

SceneChange vehicle_scene(const Vehicle& vehicle) {
  SceneChange scene;
  scene.entities.push_back(body_of(vehicle_frame, body_outline(vehicle), vehicle.width));
  if (!vehicle.trailer) return scene;
  const Trailer& trailer = *vehicle.trailer;
  scene.entities.push_back(body_of(trailer_frame, body_outline(trailer), trailer.width));
  return scene;
}

SceneChange moving_scene(std::span<const MovingObstacle> moving, double t) {
  SceneChange scene;
  for (std::size_t i = 0; i < moving.size(); ++i) {
    Entity entity = entity_of(fmt::format("moving[{}]", i));
    const std::optional<Pose> pose = pose_at(moving[i], t);
    if (!pose) {
      scene.gone.push_back(entity.id);
      continue;
    }
    entity.triangles = {prism_of(moving[i].outline, obstacle_height, purple)};
    entity.triangles.front().pose = *pose;
    const double growth = growth_at(moving[i], t);
    if (growth > 0.0) {  // A line with this thickness covers what is as near to the outline.
      entity.lines = {outline_of(moving[i].outline, purple)};
      entity.lines.front().pose = *pose;
      entity.lines.front().thickness = 2.0 * growth;
    }
    scene.entities.push_back(std::move(entity));
  }
  return scene;
}

SceneChange path_scene(const Vehicle& vehicle, const SampledPath& path) {
  Entity line = entity_of("path");
  std::optional<Gear> gear;
  for (const PathPoint& point : path.points) {
    const Place place{point.pose.x, point.pose.y, line_height};
    if (!line.lines.empty()) line.lines.back().points.push_back(place);
    if (point.gear == gear) continue;
    gear = point.gear;
    line.lines.push_back({.points = {place}, .colour = gear == Gear::forward ? blue : orange});
  }
  return {.entities = {std::move(line), footprints_along(vehicle, path)}};
}

SceneChange tree_scene(const TreeSnapshot& tree) {
  Line pairs{.join = Join::pairs, .points = {}, .colour = faint, .thickness = tree_width};
  for (std::size_t i = 0; i < std::min(tree.poses.size(), most_nodes); ++i) {
    if (tree.parents[i] < 0) continue;
    const Pose& node = tree.poses[i];
    const Pose& parent = tree.poses[static_cast<std::size_t>(tree.parents[i])];
    pairs.points.push_back({parent.x, parent.y, line_height});
    pairs.points.push_back({node.x, node.y, line_height});
  }
  Entity entity = entity_of("tree");
  entity.lines = {std::move(pairs)};
  return {.entities = {std::move(entity)}};
}

SceneChange driven_scene(std::span<const DriveMoment> log) {
  const std::size_t step = log.size() / most_places + 1;
  Line line{.points = {}, .colour = yellow};
  for (std::size_t i = 0; i < log.size(); i += step) {
    line.points.push_back({log[i].pose.x, log[i].pose.y, 2 * line_height});
  }
  Entity entity = entity_of("driven");
  entity.lines = {std::move(line)};
  return {.entities = {std::move(entity)}};
}

SceneChange label_scene(std::string_view text, const Pose& pose) {
  Entity entity = entity_of("label");
  entity.labels = {{std::string(text), {pose.x, pose.y, label_height}, green}};
  return {.entities = {std::move(entity)}};
}

}  // namespace vandplan::recording
