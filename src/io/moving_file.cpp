// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/moving_file.h"

#include <fmt/format.h>

#include <string_view>

#include "io/polygons.h"

namespace vandplan::io {
namespace {

/// A list of exactly `count` numbers.
std::vector<double> numbers_of_row(const Document& file, const Node& node, std::size_t count,
                                   const std::string& expected) {
  const std::vector<Node>& items = file.list(node, expected);
  if (items.size() != count) {
    file.fail(node, fmt::format("has {} element{}, expected {}", items.size(),
                                items.size() == 1 ? "" : "s", expected));
  }
  std::vector<double> numbers;
  numbers.reserve(items.size());
  for (const Node& item : items) numbers.push_back(file.number(item));
  return numbers;
}

std::vector<TimedPose> rows_from(const Document& file, const Node& node) {
  std::vector<TimedPose> rows;
  for (const Node& item : file.list(node, "rows [[t, x, y, heading], ...]")) {
    const std::vector<double> row = numbers_of_row(file, item, 4, "a row [t, x, y, heading]");
    rows.push_back({row[0], {row[1], row[2], row[3]}});
  }
  return rows;
}

Afterwards after_from(const Document& file, const Node& node) {
  const std::string& text = file.text(node);
  for (const Afterwards after : {Afterwards::stays, Afterwards::leaves}) {
    if (text == name_of(after)) return after;
  }
  file.fail(node, "is \"" + text.substr(0, 40) + "\", expected stays or leaves");
}

MovingObstacle obstacle_from(const Document& file, const Node& node) {
  file.allow_only(node, {"outline", "trajectory", "after", "inflate"});
  MovingObstacle obstacle{.outline = polygon_from(file, file.at(node, "outline")),
                          .trajectory = rows_from(file, file.at(node, "trajectory"))};
  if (const Node* const after = file.find(node, "after")) obstacle.after = after_from(file, *after);
  if (const Node* const inflate = file.find(node, "inflate")) {
    obstacle.inflate = file.number(*inflate);
  }
  return obstacle;
}

}  // namespace

std::vector<MovingObstacle> moving_from(const Document& file, const Node& node) {
  std::vector<MovingObstacle> moving;
  for (const Node& item : file.list(node, "a list of what moves")) {
    moving.push_back(obstacle_from(file, item));
  }
  return moving;
}

std::string moving_to_yaml(const std::vector<MovingObstacle>& moving) {
  std::string text = moving.empty() ? "" : "moving:\n";
  for (const MovingObstacle& obstacle : moving) {
    std::string rows;
    for (const TimedPose& row : obstacle.trajectory) {
      rows += fmt::format("{}[{}, {}, {}, {}]", rows.empty() ? "" : ", ", row.t, row.pose.x,
                          row.pose.y, row.pose.heading);
    }
    text += fmt::format("  - outline: {}\n    trajectory: [{}]\n    after: {}\n",
                        yaml_of(obstacle.outline), rows, name_of(obstacle.after));
    if (obstacle.inflate != 0.0) text += fmt::format("    inflate: {}\n", obstacle.inflate);
  }
  return text;
}

}  // namespace vandplan::io
