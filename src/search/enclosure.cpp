// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/enclosure.h"

#include <algorithm>
#include <cmath>

#include "geometry/boxes.h"

namespace vandplan::search {
namespace {

// Cell of the first lattice [disc radii]; no wall is too thin for it.
constexpr double coarsest = 0.5;
constexpr double finest = 1.0 / 64;  // Cell of the last lattice [disc radii].
constexpr double max_cells = 1e8;    // Cells along a side of a lattice.
constexpr double slack = 1e-5;       // Slack of distances and bounds [m]; larger than the judge's.
constexpr int work_of_step = 128;    // Work of one call: runs, and obstacles looked at.
// Obstacles looked at on one lattice; takes about 100 MB.
constexpr std::int64_t max_looks = 10'000'000;

/// Bounding box of all obstacles, the map and all ends.
Bounds scene_of(const Surroundings& ground, const std::array<std::vector<Point>, 2>& ends) {
  Bounds scene = geometry::united(bounding_box(ends[0]), bounding_box(ends[1]));
  for (const Polygon& polygon : ground.obstacles) {
    scene = geometry::united(scene, bounding_box(polygon));
  }
  if (ground.map) scene = geometry::united(scene, bounding_box(outline(*ground.map)));
  return scene;
}

}  // namespace

// The disc lies as near to the rear axle as possible. If a way of its centre leaves the scene, each
// of its places can be moved to the nearest point of a box around the scene, where no obstacle is
// near. So ends that are connected at all are connected in that box, within the bounds.
Enclosure::Enclosure(const Task& task, std::span<const LocalPose> goals) : task_(task) {
  const Disc disc = widest_disc(task.vehicle);
  disc_ = disc.radius + task.least_margin;
  ends_[start] = {centre_of(disc, task.start)};
  for (const LocalPose& pose : goals) ends_[goal].push_back(centre_of(disc, pose));
  if (goals.empty()) ends_[goal] = {centre_of(disc, task.goal)};
  const Surroundings& ground = task.world->local();
  const Bounds within = geometry::widened(ground.bounds, std::abs(disc.ahead) + slack);
  const Bounds scene = geometry::widened(scene_of(ground, ends_), 3 * disc_);
  box_ = geometry::shared(within, scene);
  side_ = 2 * coarsest * disc_;
  if (!next_lattice()) side_ = 0.0;
}

// Takes the next lattice on which start and goal are not in one run. False if there is none.
bool Enclosure::next_lattice() {
  const double extent = std::max(box_.x_max - box_.x_min, box_.y_max - box_.y_min);
  do {
    side_ /= 2;
    const double near = disc_ - side_ * std::sqrt(0.5) - slack;
    if (side_ < finest * disc_ || !(near > 0) || !(extent < max_cells * side_)) return false;
    rows_ = OpenRows(task_, box_, side_, near);
    owners_.clear();
  } while (!begin(start) || !begin(goal));
  return true;
}

/// Begins a flood. False if one of its ends lies in no open cell, or in a run of the other flood.
bool Enclosure::begin(End end) {
  floods_[end] = {rows_.in_cells(ends_[end].front()), 0, {}};
  return std::ranges::all_of(
      ends_[end], [&](const Point& place) { return begin_at(end, rows_.in_cells(place)); });
}

bool Enclosure::begin_at(End end, const Point& root) {
  const auto row = static_cast<std::int32_t>(std::floor(root.y));
  if (row < 0 || row >= rows_.rows()) return false;
  const OpenRows::Row& runs = rows_.row(row);
  const auto run = std::find_if(runs.begin(), runs.end(), [&](const OpenRows::Run& r) {
    return r.begin <= root.x && root.x <= r.end;
  });
  if (run == runs.end()) return false;
  return !reach(end, row, static_cast<std::int32_t>(run - runs.begin()));
}

/// Adds a run to a flood. True if the other flood owns it.
bool Enclosure::reach(End end, std::int32_t row, std::int32_t index) {
  const OpenRows::Row& runs = rows_.row(row);
  const auto place = static_cast<std::size_t>(index);
  std::vector<std::uint8_t>& owners = owners_.try_emplace(row, runs.size(), nobody).first->second;
  if (owners[place] != nobody) return owners[place] != end;
  owners[place] = end;
  const Point& other = floods_[end == start ? goal : start].root;
  const double x = std::clamp<double>(other.x, runs[place].begin, runs[place].end);
  floods_[end].front.push({row, index, std::hypot(other.x - x, other.y - row)});
  return false;
}

/// Expands the run nearest to the other end. True when the floods meet.
bool Enclosure::advance(End end) {
  Flood& flood = floods_[end];
  const Node node = flood.front.top();
  flood.front.pop();
  ++flood.work;
  const OpenRows::Run run = rows_.row(node.row)[static_cast<std::size_t>(node.index)];
  for (const std::int32_t row : {node.row - 1, node.row + 1}) {
    if (row < 0 || row >= rows_.rows()) continue;
    const std::int64_t looks = rows_.looks();
    const OpenRows::Row& runs = rows_.row(row);
    flood.work += rows_.looks() - looks;
    auto other = std::upper_bound(runs.begin(), runs.end(), run.begin,
                                  [](std::int32_t x, const OpenRows::Run& r) { return x < r.end; });
    for (; other != runs.end() && other->begin < run.end; ++other) {
      if (reach(end, row, static_cast<std::int32_t>(other - runs.begin()))) return true;
    }
  }
  return false;
}

bool Enclosure::step() {
  if (rows_.looks() > max_looks) side_ = 0.0;
  if (side_ == 0.0 || is_proven_) return false;
  const std::int64_t last = floods_[start].work + floods_[goal].work + work_of_step;
  while (floods_[start].work + floods_[goal].work < last) {
    const End end = floods_[start].work <= floods_[goal].work ? start : goal;
    if (floods_[end].front.empty()) {
      is_proven_ = true;
      return false;
    }
    if (!advance(end)) continue;
    if (!next_lattice()) side_ = 0.0;
    return side_ != 0.0;
  }
  return true;
}

}  // namespace vandplan::search
