// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How are the primitives of Nav2's lattice planner read?
//
// JSON of its lattice_primitives: `lattice_metadata` with `grid_resolution` and `heading_angles`,
// and `primitives`, each with the indices of its headings and `poses`, [x, y, heading].

#include <fmt/format.h>

#include "io/document.h"
#include "io/primitives_reader.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

constexpr double largest_angle = 100.0;  // Largest heading that is taken for radians [rad].

std::vector<double> headings_from(const Document& file, const Node& node) {
  const std::vector<Node>& list = file.list(node, "a list of angles");
  std::vector<double> headings;
  for (const Node& item : list) {
    const double angle = file.number(item);
    if (!(std::abs(angle) <= largest_angle)) {
      file.fail(item, fmt::format("is {:g}, expected an angle in radians", angle));
    }
    const int count = static_cast<int>(std::min<std::size_t>(list.size(), 1000));
    headings.push_back(search::exact_heading(angle, count).value_or(angle));
  }
  return headings;
}

std::int32_t heading_index(const Document& file, const Node& node, std::size_t count) {
  const std::int64_t index = file.integer(node);
  if (index < 0 || index >= static_cast<std::int64_t>(count)) {
    file.fail(node, fmt::format("is {}, expected the index of one of {} headings", index, count));
  }
  return static_cast<std::int32_t>(index);
}

std::vector<Pose> poses_from(const Document& file, const Node& node, double heading) {
  std::vector<Pose> poses = {{0.0, 0.0, heading}};  // The first pose, which the files leave out.
  for (const Node& item : file.list(node, "a list of poses")) {
    const std::vector<Node>& numbers = file.list(item, "[x, y, heading]");
    if (numbers.size() != 3) {
      file.fail(item, fmt::format("has {} elements, expected [x, y, heading]", numbers.size()));
    }
    poses.push_back({file.number(numbers[0]), file.number(numbers[1]), file.number(numbers[2])});
  }
  return poses;
}

}  // namespace

std::shared_ptr<const search::Primitives> read_nav2_primitives(const std::string& name) {
  const Document file = parse_json(read_file(name, largest_text), name, 1, {});
  const Node& about = file.at(file.root(), "lattice_metadata");
  SampledPrimitives sampled;
  sampled.in_reverse_too = true;
  const Node& resolution = file.at(about, "grid_resolution");
  sampled.step = file.number(resolution);
  if (!(sampled.step > 0.0)) file.fail(resolution, "is not above 0, expected metres");
  sampled.headings = headings_from(file, file.at(about, "heading_angles"));
  for (const Node& item : file.list(file.at(file.root(), "primitives"), "a list of primitives")) {
    SampledPrimitive one;
    one.line = item.line;
    const std::size_t count = sampled.headings.size();
    one.from = heading_index(file, file.at(item, "start_angle_index"), count);
    one.to = heading_index(file, file.at(item, "end_angle_index"), count);
    one.poses = poses_from(file, file.at(item, "poses"),
                           sampled.headings[static_cast<std::size_t>(one.from)]);
    sampled.all.push_back(std::move(one));
  }
  return exact(sampled, [&](int line, const std::string& problem) {
    throw InputError(fmt::format("{}:{}", name, line), problem);
  });
}

}  // namespace vandplan::io
