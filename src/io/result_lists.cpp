// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/result_lists.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

namespace vandplan::io {
namespace {

/// Key whose value is being read; empty if `node` is no map.
std::string_view open_key(const Node& node) {
  return node.kind == Node::Kind::map && !node.keys.empty() ? node.keys.back().text
                                                            : std::string_view();
}

/// The result that an innermost list belongs to, and the number of nodes around that result.
struct Place {
  std::size_t goal = ListTaker::alone;
  std::size_t depth = 0;
};

std::optional<Place> place_of(const std::vector<Node>& open) {
  if (open.size() == 3) return Place{};
  if (open.size() != 5 || open_key(open[0]) != "goals") return std::nullopt;
  return Place{open[1].items.size(), 2};
}

StatedPose stated_pose(const Document& file) {
  const Node& node = file.root();
  StatedPose stated{.s = file.number(file.at(node, "s")), .pose = pose_from(file, node)};
  if (const Node* const curvature = file.find(node, "curvature")) {
    stated.curvature = file.number(*curvature);
  }
  if (const Node* const direction = file.find(node, "direction")) {
    const std::int64_t sign = file.integer(*direction);
    if (sign != 1 && sign != -1)
      file.fail(*direction, fmt::format("is {}, expected 1 or -1", sign));
    stated.gear = gear_of(static_cast<double>(sign));
  }
  stated.hitch_angle = hitch_angle_from(file, node);
  return stated;
}

Pose node_pose(const Document& file) {
  const std::vector<Node>& items = file.list(file.root(), "a pose [x, y, heading]");
  if (items.size() != 3) {
    file.fail(file.root(),
              fmt::format("has {} elements, expected a pose [x, y, heading]", items.size()));
  }
  return {file.number(items[0]), file.number(items[1]), file.number(items[2])};
}

/// Parent of node number `index`.
std::int32_t parent_from(const Document& file, std::size_t index) {
  const std::int64_t parent = file.integer(file.root());
  if (parent >= static_cast<std::int64_t>(index) || parent < -1) {
    file.fail(file.root(),
              fmt::format("is {}, expected a node before node {}, or -1", parent, index));
  }
  return static_cast<std::int32_t>(parent);
}

void expect_room(const Document& file, std::size_t count, std::size_t most) {
  if (count <= most) return;
  file.fail(file.root(), fmt::format("is one too many, expected at most {} in a file", most));
}

}  // namespace

Pose pose_from(const Document& file, const Node& node) {
  return {file.number(file.at(node, "x")), file.number(file.at(node, "y")),
          file.number(file.at(node, "heading"))};
}

std::optional<double> hitch_angle_from(const Document& file, const Node& node) {
  const Node* const angles = file.find(node, "hitch_angles");
  if (angles == nullptr) return std::nullopt;
  const std::vector<Node>& items = file.list(*angles, "a list with one angle");
  if (items.size() != 1) {
    file.fail(*angles,
              fmt::format("has {} angles, expected 1, one for each trailer", items.size()));
  }
  return file.number(items[0]);
}

bool ListTaker::take(const std::vector<Node>& open, Node& element) {
  const std::optional<Place> place = place_of(open);
  if (!place) return false;
  const std::string_view outer = open_key(open[place->depth]);
  const std::string_view inner = open_key(open[place->depth + 1]);
  const bool is_path = outer == "path" && inner == "poses";
  const bool is_tree = outer == "tree" && (inner == "poses" || inner == "parents");
  if (!is_path && !is_tree) return false;
  ResultLists& lists = of(place->goal);
  const std::size_t index = is_path            ? lists.poses.size()
                            : inner == "poses" ? lists.tree.poses.size()
                                               : lists.tree.parents.size();
  const std::string before = place->goal == alone ? "" : fmt::format("goals[{}].", place->goal);
  const Document file(where_, std::move(element),
                      fmt::format("{}{}.{}[{}]", before, outer, inner, index));
  if (is_path) {
    expect_room(file, ++poses_, most_written_poses);
    lists.poses.push_back(stated_pose(file));
  } else if (inner == "poses") {
    expect_room(file, ++nodes_, most_written_nodes);
    lists.tree.poses.push_back(node_pose(file));
  } else {
    expect_room(file, lists.tree.parents.size() + 1, most_written_nodes);
    lists.tree.parents.push_back(parent_from(file, index));
  }
  return true;
}

}  // namespace vandplan::io
