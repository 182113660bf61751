// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "draw/paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "vandplan/steering.h"
#include "vandplan/vehicle.h"

namespace vandplan::drawing {
namespace {

// Limit for coordinates [page units]: Cairo's are 24-bit fixed-point, so points beyond are moved to
// it.
constexpr double far_outside = 2e5;

void add_corner(cairo_t* cairo, const View& view, const Point& corner) {
  const Point p = view.on_page(corner);
  cairo_line_to(cairo, std::clamp(p.x, -far_outside, far_outside),
                std::clamp(p.y, -far_outside, far_outside));
}

void add_polygon(cairo_t* cairo, const View& view, std::span<const Point> corners) {
  cairo_new_sub_path(cairo);
  for (const Point& corner : corners) add_corner(cairo, view, corner);
  cairo_close_path(cairo);
}

void add_line(cairo_t* cairo, const View& view, std::span<const Pose> poses) {
  cairo_new_sub_path(cairo);
  for (const Pose& pose : poses) add_corner(cairo, view, {pose.x, pose.y});
}

void stroke(cairo_t* cairo, double width, const Colour& colour, double alpha) {
  set_colour(cairo, colour, alpha);
  cairo_set_line_width(cairo, width);
  cairo_stroke(cairo);
}

// Paints the ground and the bounds of the rear axle.
void paint_bounds(cairo_t* cairo, const Scene& scene, const View& view) {
  const Bounds& b = scene.bounds;
  const Point box[] = {
      {b.x_min, b.y_min}, {b.x_max, b.y_min}, {b.x_max, b.y_max}, {b.x_min, b.y_max}};
  set_colour(cairo, colour::outside, 1.0);
  cairo_paint(cairo);
  add_polygon(cairo, view, box);
  set_colour(cairo, colour::paper, 1.0);
  cairo_fill(cairo);
  add_polygon(cairo, view, box);
  const double dashes[] = {6.0, 4.0};
  cairo_set_dash(cairo, dashes, 2, 0.0);
  stroke(cairo, 1.0, colour::faint_ink, 1.0);
  cairo_set_dash(cairo, nullptr, 0, 0.0);
}

void paint_polygons(cairo_t* cairo, const std::vector<Polygon>& polygons, const Colour& colour,
                    const View& view) {
  for (const Polygon& polygon : polygons) {
    add_polygon(cairo, view, polygon);
    set_colour(cairo, colour, 1.0);
    cairo_fill_preserve(cairo);
    stroke(cairo, 0.4, colour, 1.0);  // Avoids hairlines between neighbours.
  }
}

// Paints moving obstacles: at the start in full colour, later ever fainter.
void paint_moving(cairo_t* cairo, const Scene& scene, const View& view) {
  for (const Shadow& shadow : scene.shadows) {
    add_polygon(cairo, view, shadow.outline);
    set_colour(cairo, colour::moving, 0.6 * shadow.strength);
    cairo_fill_preserve(cairo);
    stroke(cairo, 0.8, colour::moving, shadow.strength);
  }
}

double distance(const Bounds& box, const Point& point) {
  const double dx = point.x - std::clamp(point.x, box.x_min, box.x_max);
  const double dy = point.y - std::clamp(point.y, box.y_min, box.y_max);
  return std::hypot(dx, dy);
}

// Paints the tree. Its edges are the steering function's paths from parent to child.
void paint_tree(cairo_t* cairo, const Scene& scene, const View& view) {
  const TreeSnapshot& tree = scene.tree;
  const double step = std::max(0.25, 4.0 / view.scale);
  constexpr int edges_per_stroke = 250;  // Few enough to be fast, many enough for a small file.
  int count = 0;
  for (std::size_t i = 0; i < tree.poses.size(); ++i) {
    if (tree.parents[i] < 0) continue;
    const Pose& from = tree.poses[static_cast<std::size_t>(tree.parents[i])];
    const Piece piece = reeds_shepp(from, tree.poses[i], scene.vehicle.min_turning_radius);
    if (distance(view.visible, {from.x, from.y}) > piece.length) continue;
    const Path edge{from, {piece.view().begin(), piece.view().end()}};
    cairo_new_sub_path(cairo);
    for (const PathPoint& point : sampled(edge, std::max(step, piece.length / 200))) {
      add_corner(cairo, view, {point.pose.x, point.pose.y});
    }
    if (++count % edges_per_stroke == 0) stroke(cairo, 0.5, colour::tree, 1.0);
  }
  stroke(cairo, 0.5, colour::tree, 1.0);
}

// Area that a body sweeps between two near poses: the convex hull of both, by Andrew's monotone
// chain.
std::vector<Point> swept(const Polygon& body, const Pose& from, const Pose& to) {
  Polygon points = placed(body, from);
  std::ranges::copy(placed(body, to), std::back_inserter(points));
  std::ranges::sort(points, {}, [](const Point& p) { return std::pair(p.x, p.y); });
  const auto turns_left = [](const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) > (b.y - a.y) * (c.x - a.x);
  };
  std::vector<Point> hull;
  const auto add_chain = [&](const auto& chain) {
    const std::size_t first = hull.size();
    for (const Point& point : chain) {
      while (hull.size() >= first + 2 && !turns_left(hull.end()[-2], hull.back(), point)) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();  // The other chain starts with this point.
  };
  add_chain(points);
  std::ranges::reverse(points);
  add_chain(points);
  return hull;
}

// Distance of poses whose footprints are joined to the swept area [m].
double fine_step(const Scene& scene) {
  return std::max(scene.vehicle.min_turning_radius / 8, length(scene.path->segments) / 5000);
}

void add_swept(cairo_t* cairo, const View& view, const Polygon& body,
               const std::vector<Pose>& poses) {
  for (std::size_t i = 1; i < poses.size(); ++i) {
    add_polygon(cairo, view, swept(body, poses[i - 1], poses[i]));
  }
}

// Adds the area that the vehicle and its trailer sweep.
void add_swept(cairo_t* cairo, const View& view, const Bodies& bodies, const Stroke& part) {
  add_swept(cairo, view, bodies.vehicle, part.poses);
  add_swept(cairo, view, bodies.trailer, part.trailer);
}

// Paints everything within the margin of the swept area, as one translucent area.
void paint_margin(cairo_t* cairo, const Scene& scene, const View& view) {
  cairo_push_group(cairo);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  const Bodies bodies = bodies_of(scene);
  for (const Stroke& part : strokes_of(scene, fine_step(scene))) {
    add_swept(cairo, view, bodies, part);
    set_colour(cairo, colour::margin, 1.0);
    cairo_fill_preserve(cairo);
    stroke(cairo, 2 * scene.margin * view.scale, colour::margin, 1.0);
  }
  cairo_pop_group_to_source(cairo);
  cairo_paint_with_alpha(cairo, 0.35);
}

// Paints the swept area, translucent in the colour of the gear, and outlines of the vehicle at
// intervals.
void paint_sweep(cairo_t* cairo, const Scene& scene, const View& view) {
  const Bodies bodies = bodies_of(scene);
  const Footprint body = footprint(scene.vehicle);
  const double total = length(scene.path->segments);
  for (const Stroke& part : strokes_of(scene, fine_step(scene))) {
    add_swept(cairo, view, bodies, part);
    set_colour(cairo, colour_of_gear(part.direction), 0.13);
    cairo_fill(cairo);
  }
  const double coarse = std::max((body.rear + body.front) / 4, total / 60);
  for (const Stroke& part : strokes_of(scene, coarse)) {
    for (const Pose& pose : part.poses) add_polygon(cairo, view, placed(bodies.vehicle, pose));
    for (const Pose& pose : part.trailer) add_polygon(cairo, view, placed(bodies.trailer, pose));
    stroke(cairo, 0.5, colour_of_gear(part.direction), 0.4);
  }
}

void paint_path(cairo_t* cairo, const Scene& scene, const View& view) {
  const double step = std::max(4.0 / view.scale, length(scene.path->segments) / 20000);
  const std::vector<Stroke> parts = strokes_of(scene, step);
  for (const Stroke& part : parts) {
    if (!part.trailer.empty()) {
      add_line(cairo, view, part.trailer);
      stroke(cairo, 1.0, colour_of_gear(part.direction), 0.6);
    }
    add_line(cairo, view, part.poses);
    stroke(cairo, 2.0, colour_of_gear(part.direction), 1.0);
  }
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Pose& change = parts[i].poses.front();
    paint_gear_change(cairo, view.on_page({change.x, change.y}));
  }
}

}  // namespace

void paint_vehicle(cairo_t* cairo, const ParkedVehicle& vehicle, const View& view) {
  const auto& [body, pose, colour] = vehicle;
  add_polygon(cairo, view, placed(body, pose));
  set_colour(cairo, colour, 0.30);
  cairo_fill_preserve(cairo);
  stroke(cairo, 1.6, colour, 1.0);

  const Point rear = view.on_page({pose.x, pose.y});
  const Bounds box = bounding_box(body);
  const double tip = 0.86 * box.x_max * view.scale;
  const double head = std::min({0.5 * tip, (box.y_max - box.y_min) / 2 * view.scale, 12.0});
  cairo_save(cairo);
  cairo_translate(cairo, rear.x, rear.y);
  cairo_rotate(cairo, -pose.heading);
  cairo_move_to(cairo, 0.0, 0.0);
  cairo_line_to(cairo, tip - head / 2, 0.0);
  stroke(cairo, 1.4, colour, 1.0);
  cairo_move_to(cairo, tip, 0.0);
  cairo_line_to(cairo, tip - head, 0.5 * head);
  cairo_line_to(cairo, tip - head, -0.5 * head);
  cairo_close_path(cairo);
  cairo_arc(cairo, 0.0, 0.0, std::min(2.4, 0.3 * head + 0.6), 0.0, 2 * std::numbers::pi);
  set_colour(cairo, colour, 1.0);
  cairo_fill(cairo);
  cairo_restore(cairo);
}

const Colour& colour_of_gear(int direction) {
  return direction > 0 ? colour::forward : colour::reverse;
}

void paint_gear_change(cairo_t* cairo, const Point& place) {
  cairo_new_sub_path(cairo);
  cairo_arc(cairo, place.x, place.y, 3.4, 0.0, 2 * std::numbers::pi);
  set_colour(cairo, colour::paper, 1.0);
  cairo_fill_preserve(cairo);
  stroke(cairo, 1.3, colour::ink, 1.0);
}

namespace {

// Paints the vehicle, with its trailer if any.
void paint_rig(cairo_t* cairo, const Scene& scene, const State& state, const Colour& colour,
               const View& view) {
  if (scene.vehicle.trailer) {
    const Pose trailer = trailer_pose(scene.vehicle, state);
    add_polygon(cairo, view, placed(body_outline(*scene.vehicle.trailer), trailer));
    set_colour(cairo, colour, 0.30);
    cairo_fill_preserve(cairo);
    stroke(cairo, 1.6, colour, 1.0);
  }
  paint_vehicle(cairo, {body_outline(scene.vehicle), state.pose, colour}, view);
}

// Paints some goals or vias: places as areas, poses as thin outlines.
void paint_regions(cairo_t* cairo, const Vehicle& vehicle, const std::vector<Polygon>& areas,
                   const std::vector<State>& states, const Colour& colour, const View& view) {
  for (const Polygon& area : areas) {
    add_polygon(cairo, view, area);
    set_colour(cairo, colour, 0.15);
    cairo_fill_preserve(cairo);
    stroke(cairo, 1.0, colour, 0.8);
  }
  for (const State& state : states) {
    if (vehicle.trailer) {
      add_polygon(cairo, view,
                  placed(body_outline(*vehicle.trailer), trailer_pose(vehicle, state)));
      stroke(cairo, 0.8, colour, 0.5);
    }
    add_polygon(cairo, view, placed(body_outline(vehicle), state.pose));
    stroke(cairo, 0.8, colour, 0.5);
  }
}

/// Arrow in the middle of a box, in the middle of a range of directions.
void paint_arrow(cairo_t* cairo, const View& view, const Bounds& box, const HeadingRange& range) {
  const double size = 0.3 * std::min(box.x_max - box.x_min, box.y_max - box.y_min);
  const Pose middle{(box.x_min + box.x_max) / 2, (box.y_min + box.y_max) / 2,
                    range.from + width(range) / 2};
  const auto at = [&](double ahead, double left) {
    return compose(middle, {ahead * size, left * size, 0.0});
  };
  add_line(cairo, view, std::array{at(-1, 0), at(1, 0)});
  add_line(cairo, view, std::array{at(0.5, 0.4), at(1, 0), at(0.5, -0.4)});
  stroke(cairo, 1.6, colour::faint_ink, 0.9);
}

/// Name in the lower left corner of a box, if there is room for it.
void paint_name(cairo_t* cairo, const View& view, const Bounds& box, const std::string& name) {
  const TextStyle tag_style{.size = 10.0, .colour = colour::faint_ink};
  const Point corner = view.on_page({box.x_min, box.y_min});
  const double width = view.scale * (box.x_max - box.x_min);
  if (text_width(cairo, name, tag_style) + 12.0 > width) return;
  write_text(cairo, name, corner.x + 6.0, corner.y - 6.0, tag_style);
}

/// Areas of zones: closed ones in the colour of obstacles, others in that of kerbs.
void paint_zones(cairo_t* cairo, const Scene& scene, const View& view) {
  for (const Zone& zone : scene.zones) {
    const Bounds box = bounding_box(zone.area);
    add_polygon(cairo, view, zone.area);
    set_colour(cairo, zone.closed ? colour::obstacle : colour::kerb, 0.25);
    cairo_fill_preserve(cairo);
    stroke(cairo, 0.8, colour::faint_ink, 0.8);
    if (zone.direction) paint_arrow(cairo, view, box, *zone.direction);
    paint_name(cairo, view, box, zone.name);
  }
}

/// Straight last stretches before goals.
void paint_stretches(cairo_t* cairo, const Scene& scene, const View& view) {
  const double dashes[] = {2.0, 3.0};
  cairo_set_dash(cairo, dashes, 2, 0.0);
  for (const auto& line : scene.stretches) {
    add_line(cairo, view, line);
    stroke(cairo, 1.0, colour::goal, 0.8);
  }
  cairo_set_dash(cairo, nullptr, 0, 0.0);
}

}  // namespace

void paint_scene(cairo_t* cairo, const Scene& scene, const View& view) {
  paint_bounds(cairo, scene, view);
  for (const Polygon& area : scene.inside) {
    add_polygon(cairo, view, area);
    set_colour(cairo, colour::kerb, 0.12);
    cairo_fill_preserve(cairo);
    stroke(cairo, 1.6, colour::ink, 0.7);
  }
  paint_zones(cairo, scene, view);
  paint_polygons(cairo, scene.kerbs, colour::kerb, view);
  if (scene.map) paint_map(cairo, *scene.map, view);
  for (const OccupancyGrid& map : scene.masks) paint_map(cairo, map, view);
  for (const OccupancyGrid& map : scene.faint_masks) {
    cairo_push_group(cairo);
    paint_map(cairo, map, view);
    cairo_pop_group_to_source(cairo);
    cairo_paint_with_alpha(cairo, 0.25);
  }
  paint_stretches(cairo, scene, view);
  paint_polygons(cairo, scene.obstacles, colour::obstacle, view);
  paint_moving(cairo, scene, view);
  paint_tree(cairo, scene, view);
  if (scene.path && scene.margin > 0.0) paint_margin(cairo, scene, view);
  if (scene.path) paint_sweep(cairo, scene, view);
  const Vehicle& vehicle = scene.vehicle;
  paint_regions(cairo, vehicle, scene.via_areas, scene.vias, colour::faint_ink, view);
  paint_regions(cairo, vehicle, scene.goal_areas, scene.goals, colour::goal, view);
  paint_rig(cairo, scene, {scene.goal, scene.hitch_angles.goal}, colour::goal, view);
  paint_rig(cairo, scene, {scene.start, scene.hitch_angles.start}, colour::start, view);
  for (const Polygon& polygon : scene.hit) {
    add_polygon(cairo, view, polygon);
    stroke(cairo, 2.5, colour::hit, 1.0);
  }
  if (scene.path) paint_path(cairo, scene, view);
  if (!scene.driven.empty()) {
    add_line(cairo, view, scene.driven);
    stroke(cairo, 1.4, colour::driven, 1.0);
  }
}

}  // namespace vandplan::drawing
