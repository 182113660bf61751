// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "motions_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "vandplan/files.h"

namespace vandplan::app {
namespace {

/// Time since the start [s] as a stamp of ROS: {sec: 3, nanosec: 250000000}.
std::string stamp(double t) {
  constexpr std::int64_t second = 1'000'000'000;
  const auto nanoseconds = static_cast<std::int64_t>(std::llround(t * 1e9));
  return fmt::format("{{sec: {}, nanosec: {}}}", nanoseconds / second, nanoseconds % second);
}

/// A number as text that YAML readers take for neither an integer nor a string: 3.0, 1.0e-05.
std::string real(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find('.') == std::string::npos) text.insert(std::min(text.find('e'), text.size()), ".0");
  return text;
}

std::string row(const Motion& m) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{}\n", m.t, m.s, m.pose.x, m.pose.y,
                     m.pose.heading, m.curvature, m.steering_angle, direction_of(m.gear), m.v, m.a);
}

/// A std_msgs/Header.
std::string header(double t, const std::string& frame) {
  return fmt::format("header: {{stamp: {}, frame_id: \"{}\"}}\n", stamp(t), frame);
}

/// A geometry_msgs/PoseStamped; the heading is a turn about the axis that points up.
std::string pose_stamped(const Motion& m, const std::string& frame) {
  return fmt::format(
      "  - {}    pose:\n      position: {{x: {}, y: {}, z: 0.0}}\n"
      "      orientation: {{x: 0.0, y: 0.0, z: {}, w: {}}}\n",
      header(m.t, frame), real(m.pose.x), real(m.pose.y), real(std::sin(m.pose.heading / 2)),
      real(std::cos(m.pose.heading / 2)));
}

}  // namespace

void write_motions(const std::string& output, const std::vector<Motion>& motions,
                   const std::string& frame) {
  const bool is_path = has_ending(output, {"", {".yaml", ".yml"}});
  FileWriter writer(output);
  writer.write(is_path ? header(0, frame) + "poses:\n"
                       : "t,s,x,y,heading,curvature,steering_angle,direction,v,a\n");
  std::string piece;
  for (const Motion& motion : motions) {
    piece += is_path ? pose_stamped(motion, frame) : row(motion);
    if (piece.size() < (std::size_t{1} << 20)) continue;
    writer.write(piece);
    piece.clear();
  }
  writer.write(piece);
  writer.commit();
}

}  // namespace vandplan::app
