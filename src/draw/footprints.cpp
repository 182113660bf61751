// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "draw/footprints.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "vandplan/vehicle.h"

namespace vandplan::drawing {
namespace {

constexpr double places_wanted = 150;  // Places along a path; fewer on a short one.
constexpr double least_step = 0.2;     // Distance between places [m].
constexpr double reach = 14;           // Width of the band where the mouse meets a path [points].
constexpr std::size_t most_objects = 2000;

// A footprint shows while the mouse is at its place.
constexpr const char* style =
    "<style>.vandplan-place use{visibility:hidden}"
    ".vandplan-place:hover use{visibility:visible}</style>\n";

/// Definition of a body for `use`, with a line from its axle to its middle.
std::string body_definition(const char* name, const Polygon& outline) {
  double front = 0.0;
  for (const Point& corner : outline) front = std::max(front, corner.x);
  const std::string colour = svg_colour(colour::start);
  return written("<g id=\"%s\" fill=\"%s\" fill-opacity=\"0.3\" stroke=\"%s\" ", name,
                 colour.c_str(), colour.c_str()) +
         "stroke-width=\"0.12\"><polygon points=\"" + svg_points(outline) +
         written("\"/><path d=\"M0,0H%.3f\"/></g>", front);
}

std::string body_at(const char* name, const Pose& pose) {
  return written("<use href=\"#%s\" pointer-events=\"none\" ", name) +
         written("transform=\"translate(%.3f,%.3f) rotate(%.2f)\"/>", pose.x, pose.y,
                 pose.heading * 180 / std::numbers::pi);
}

Point middle_of(const Pose& a, const Pose& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

/// Places of one stroke, each with the band of the path that is nearest to it. `s` is the distance
/// driven before the stroke [m], and after it when the function returns.
std::string places_of(const Stroke& stroke, const Point& origin, double& s) {
  std::string text;
  const std::vector<Pose>& poses = stroke.poses;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose& pose = poses[i];
    const Pose& before = poses[i > 0 ? i - 1 : 0];
    s += std::hypot(pose.x - before.x, pose.y - before.y);
    text += written("<g class=\"vandplan-place\"><title>%.1f m %s: x %.2f m, y %.2f m, ", s,
                    stroke.direction > 0 ? "forward" : "reverse", pose.x + origin.x,
                    pose.y + origin.y) +
            written("heading %.1f\u00b0</title>", pose.heading * 180 / std::numbers::pi) +
            "<polyline points=\"" +
            svg_points({middle_of(before, pose),
                        {pose.x, pose.y},
                        middle_of(pose, poses[std::min(i + 1, poses.size() - 1)])}) +
            "\"/>" + body_at("vandplan-body", pose);
    if (!stroke.trailer.empty()) text += body_at("vandplan-trailer", stroke.trailer[i]);
    text += "</g>\n";
  }
  return text;
}

std::string places_on_path(const Overlay& overlay) {
  const double length = vandplan::length(*overlay.scene.path);
  const Bodies bodies = bodies_of(overlay.scene);
  std::string text =
      "<defs>" + body_definition("vandplan-body", bodies.vehicle) +
      (bodies.trailer.empty() ? "" : body_definition("vandplan-trailer", bodies.trailer)) +
      "</defs>\n" +
      written("<g fill=\"none\" stroke=\"transparent\" stroke-width=\"%.3f\" ",
              reach / overlay.metre()) +
      "pointer-events=\"stroke\">\n";
  double s = 0.0;
  const double step = std::max(length / places_wanted, least_step);
  for (const Stroke& stroke : strokes_of(overlay.scene, step)) {
    text += places_of(stroke, overlay.scene.origin, s);
  }
  return text + "</g>\n";
}

/// Objects of one kind that can be seen, each with its number.
std::string objects(const std::vector<Polygon>& polygons, const char* kind, const Bounds& seen) {
  std::string text;
  for (std::size_t i = 0; i < std::min(polygons.size(), most_objects); ++i) {
    const Bounds box = bounding_box(polygons[i]);
    if (box.x_min > seen.x_max || box.x_max < seen.x_min) continue;
    if (box.y_min > seen.y_max || box.y_max < seen.y_min) continue;
    text += "<polygon points=\"" + svg_points(polygons[i]) +
            written("\"><title>%s[%zu]</title></polygon>\n", kind, i);
  }
  return text;
}

}  // namespace

std::string with_footprints(const std::string& svg, const Overlay& overlay) {
  const Bounds& seen = overlay.view.visible;
  std::string text = style;
  text += "<g fill=\"transparent\">\n" + objects(overlay.scene.kerbs, "kerbs", seen) +
          objects(overlay.scene.obstacles, "obstacles", seen) + "</g>\n";
  if (overlay.scene.path) text += places_on_path(overlay);
  return laid_over(svg, overlay, {.name = "vandplan-footprints", .metres = text});
}

}  // namespace vandplan::drawing
