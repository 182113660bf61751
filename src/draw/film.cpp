// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "draw/film.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "vandplan/motion.h"
#include "vandplan/vehicle.h"

namespace vandplan::drawing {
namespace {

constexpr double frame_time = 0.1;  // Time between poses; motion between them is uniform [s].
constexpr double most_frames = 3000;
constexpr double rest_time = 1.5;  // Pause at the end [s].

/// Moving object: its outline, and its pose in each frame, empty once it has left.
struct Actor {
  Polygon outline;
  Colour colour;
  std::vector<std::optional<Pose>> poses;
};

/// SVG animation of one attribute, `duration` seconds long.
std::string animation(const char* type, const std::string& values, double duration) {
  return written("<animateTransform attributeName=\"transform\" type=\"%s\" dur=\"%.3fs\" ", type,
                 duration) +
         "repeatCount=\"indefinite\" values=\"" + values + "\"/>";
}

/// SVG of an actor with its animation, in metres, y upwards.
std::string scene_of_actor(const Actor& actor, double duration) {
  std::string places;
  std::string turns;
  std::string shows;
  Pose last = actor.poses.front().value_or(Pose{});
  double heading = last.heading;
  for (const std::optional<Pose>& pose : actor.poses) {
    const char* const separator = places.empty() ? "" : ";";
    const Pose& now = pose.value_or(last);
    heading += wrap_angle(now.heading - last.heading);
    places += written("%s%.3f,%.3f", separator, now.x, now.y);
    turns += written("%s%.2f", separator, heading * 180 / std::numbers::pi);
    shows += written("%s%d", separator, pose ? 1 : 0);
    last = now;
  }
  const std::string corners = svg_points(actor.outline);
  const std::string colour = svg_colour(actor.colour);
  std::string text = "<g>" + animation("translate", places, duration) + "<g>" +
                     animation("rotate", turns, duration) + "<polygon points=\"" + corners +
                     "\" fill=\"" + colour + "\" fill-opacity=\"0.75\" stroke=\"" + colour +
                     "\" stroke-width=\"0.15\"/></g>";
  if (shows.find('0') != std::string::npos) {
    text += written("<animate attributeName=\"opacity\" calcMode=\"discrete\" dur=\"%.3fs\" ",
                    duration) +
            "repeatCount=\"indefinite\" values=\"" + shows + "\"/>";
  }
  return text + "</g>\n";
}

/// Hitch angle after `s` metres of the path [rad].
double hitch_angle_at(const Scenario& scenario, const Path& path, double s) {
  double angle = scenario.hitch_angles.start;
  for (const Segment& segment : path.segments) {
    const double way = std::min(std::abs(segment.length), s);
    angle = hitch_angle_after(scenario.vehicle, angle, part_of(segment, 0.0, way));
    s -= way;
    if (s <= 0.0) break;
  }
  return angle;
}

/// All moving objects, the vehicle last.
std::vector<Actor> actors_of(const Overlay& film, double step, double count) {
  const Drawing& drawing = film.drawing;
  const Scenario& scenario = *drawing.scenario;
  const Point& origin = film.scene.origin;
  const auto local = [&](const Pose& pose) {
    return Pose{pose.x - origin.x, pose.y - origin.y, pose.heading};
  };
  std::vector<Actor> actors;
  for (const MovingObstacle& obstacle : scenario.moving) {
    Actor& actor = actors.emplace_back(Actor{obstacle.outline, colour::moving, {}});
    for (double i = 0; i <= count; ++i) {
      const std::optional<Pose> pose = pose_at(obstacle, i * step);
      actor.poses.push_back(pose ? std::optional(local(*pose)) : std::nullopt);
    }
  }
  const bool has_trailer = scenario.vehicle.trailer.has_value();
  Actor vehicle{body_outline(scenario.vehicle), colour::start, {}};
  Actor trailer{
      has_trailer ? body_outline(*scenario.vehicle.trailer) : Polygon{}, colour::start, {}};
  for (double i = 0; i <= count; ++i) {
    const auto motion = motion_at(*drawing.path, scenario.vehicle, *drawing.speeds, i * step);
    vehicle.poses.emplace_back(local(motion.pose));
    if (!has_trailer) continue;
    const State state{motion.pose, hitch_angle_at(scenario, *drawing.path, motion.s)};
    trailer.poses.emplace_back(local(trailer_pose(scenario.vehicle, state)));
  }
  if (has_trailer) actors.push_back(std::move(trailer));
  actors.push_back(std::move(vehicle));
  return actors;
}

}  // namespace

std::string played(const std::string& svg, const Overlay& film) {
  const double lasts = rest_time + std::max(film.drawing.speeds->duration,
                                            end_of_motion(film.drawing.scenario->moving));
  const double count = std::min(std::ceil(lasts / frame_time), most_frames);
  const Box& plot = film.view.plot;
  const double k = film.scale;
  Layer layer{.name = "film"};
  for (const Actor& actor : actors_of(film, lasts / count, count)) {
    layer.metres += scene_of_actor(actor, lasts);
  }
  layer.points =
      written("<rect x=\"%.2f\" y=\"%.2f\" width=\"0\" height=\"%.2f\" fill=\"%s\">", k * plot.x,
              k * (plot.y + plot.height) - 4.0, 4.0, svg_colour(colour::faint_ink).c_str()) +
      written("<animate attributeName=\"width\" from=\"0\" to=\"%.2f\" dur=\"%.3fs\" ",
              k * plot.width, lasts) +
      "repeatCount=\"indefinite\"/></rect>";
  return laid_over(svg, film, layer);
}

}  // namespace vandplan::drawing
