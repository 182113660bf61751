// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/goal_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/trigonometry.h"
#include "vandplan/steering.h"

namespace vandplan::search {
namespace {

constexpr double no_way = std::numeric_limits<double>::infinity();
constexpr double fineness = 3.0;           // Cells along a radius of the disc.
constexpr double max_cells = 4e6;          // Cells of a lattice, at most.
constexpr double rounding_near = 1e-6;     // Slack of distances to obstacles [m].
constexpr double rounding_of_sums = 1e-9;  // Relative rounding error of sums of steps.
constexpr int work_of_call = 16384;        // Corners settled by one call.
constexpr int sight_lag = 5;     // Delay of border entries [cells]; no step raises a rank as much.
constexpr double buckets = 4.0;  // Buckets for a cell of rank.
constexpr int border_headings = 64;  // Headings tried at a corner on the border of sight.
constexpr std::int32_t frame = 2;    // Closed cells beside the lattice; as far as steps reach.

const double diagonal = std::sqrt(2.0);
const double knight = std::sqrt(5.0);

/// Largest factor by which ways are too long if steps have directions this far apart [rad].
double excess_of(double apart) { return 1 / std::cos(apart / 2); }

/// Length of the shortest way of eight or sixteen directions on open ground [cells].
double open_way(bool of_eight, double x, double y) {
  const double a = std::max(std::abs(x), std::abs(y));
  const double b = std::min(std::abs(x), std::abs(y));
  if (of_eight) return (a - b) + b * diagonal;
  if (2 * b <= a) return (a - 2 * b) + b * knight;
  return (a - b) * knight + (2 * b - a) * diagonal;
}

}  // namespace

GoalField::GoalField(const Task& task, FieldKind kind)
    : task_(task),
      kind_(kind),
      too_long_(kind == FieldKind::grid ? 1.0 : excess_of(std::atan(0.5)) * (1 + rounding_of_sums)),
      disc_(bound_disc(task.vehicle)),
      stretch_(stretch_of(disc_, task.vehicle.min_turning_radius)) {
  const Bounds& bounds = task.world->local().bounds;
  const double beside = std::abs(disc_.ahead);
  const double width = bounds.x_max - bounds.x_min + 2 * beside;
  const double height = bounds.y_max - bounds.y_min + 2 * beside;
  const double radius = disc_.radius + task.least_margin;
  side_ = std::max({radius / fineness, std::sqrt(width * height / max_cells),
                    std::max(width, height) / max_cells});
  // The goal is a corner, so its distance is not rounded.
  const Point goal = centre_of(disc_, task.goal);
  const auto cells_to = [&](double length) {
    return static_cast<std::int32_t>(std::ceil(std::max(0.0, length) / side_));
  };
  goal_ = {cells_to(goal.x - bounds.x_min + beside), cells_to(goal.y - bounds.y_min + beside)};
  box_ = {goal.x - goal_.x * side_, bounds.x_max + beside, goal.y - goal_.y * side_,
          bounds.y_max + beside};
  const double near = radius - side_ * std::sqrt(0.5) - rounding_near;
  if (!(near > 0)) return;  // No cell would be closed.
  lattice_ = OpenRows(task, box_, side_, near);
  start_ = lattice_.in_cells(centre_of(disc_, task.start));
  closed_.assign(static_cast<std::size_t>(lattice_.columns() + 2 * frame), 0);
  cells_.resize(static_cast<std::size_t>(lattice_.rows()));
  blocks_of_row_ = static_cast<std::size_t>(lattice_.columns()) / block_size + 1;
  blocks_.resize((cells_.size() + 1) * blocks_of_row_);
  label(goal_) = {0.0, kind == FieldKind::choi};
  push({goal_, 0.0, false});
}

/// Cells of a row; the pointer is at column 0.
const std::uint8_t* GoalField::cells(std::int32_t y) {
  if (y < 0 || y >= lattice_.rows()) return closed_.data() + frame;
  Cells& row = cells_[static_cast<std::size_t>(y)];
  if (row.empty()) {
    row = closed_;
    for (const OpenRows::Run& run : lattice_.row(y)) {
      std::fill(row.begin() + frame + run.begin, row.begin() + frame + run.end, 1);
    }
  }
  return row.data() + frame;
}

GoalField::Label& GoalField::label(const Corner& corner) {
  const auto x = static_cast<std::size_t>(corner.x);
  Block& block = blocks_[static_cast<std::size_t>(corner.y) * blocks_of_row_ + x / block_size];
  if (!block) {
    block = std::make_unique<std::array<Label, block_size>>();
    block->fill({no_way, false});
  }
  return (*block)[x % block_size];
}

/// Adds an entry to its bucket, or to the front bucket if that is later.
void GoalField::push(const Entry& entry) {
  const double rank = entry.cost + to_start(entry.corner) + (entry.is_border ? sight_lag : 0);
  const std::size_t bucket = std::max(front_, static_cast<std::size_t>(buckets * rank));
  if (bucket >= open_.size()) open_.resize(bucket + 1);
  open_[bucket].push_back(entry);
}

/// Lower bound on the way to the task's start [cells].
double GoalField::to_start(const Corner& corner) const noexcept {
  return open_way(kind_ == FieldKind::grid, corner.x - start_.x, corner.y - start_.y);
}

double GoalField::on_open_ground(const Corner& corner) const noexcept {
  return open_way(kind_ == FieldKind::grid, corner.x - goal_.x, corner.y - goal_.y);
}

/// Length of the shortest path on open ground from a corner with any heading [cells].
double GoalField::beyond_border(const Corner& corner) const {
  std::array<float, border_headings> x, y, headings, lengths;
  const double to_axle = -disc_.ahead;
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const double heading = 2 * std::numbers::pi * static_cast<double>(i) / border_headings;
    const auto [sin, cos] = base::sin_cos(heading);
    headings[i] = static_cast<float>(wrap_angle(heading));
    x[i] = static_cast<float>(box_.x_min + corner.x * side_ + to_axle * cos - task_.goal.x);
    y[i] = static_cast<float>(box_.y_min + corner.y * side_ + to_axle * sin - task_.goal.y);
  }
  reeds_shepp_lengths({x, y, headings}, {0.0, 0.0, task_.goal.heading},
                      task_.vehicle.min_turning_radius, lengths);
  const double least = *std::min_element(lengths.begin(), lengths.end());
  return std::max(on_open_ground(corner), least * too_long_ / side_);
}

/// Reaches a corner by a step. A corner is seen by the goal if it is as far as on open ground.
/// Entries of the border spread to corners that are not seen.
void GoalField::reach(const Entry& from, const Corner& to, double step) {
  Label& there = label(to);
  const double cost = from.cost + step;
  if (cost >= there.cost) return;
  if (kind_ == FieldKind::choi && !from.is_border && label(from.corner).is_seen) {
    if (cost > on_open_ground(to) * (1 + rounding_of_sums)) return;
    there = {cost, true};
  } else {
    if (there.is_seen) return;
    there.cost = cost;
  }
  push({to, cost, false});
}

/// Steps along the sides of open cells, across them, and across two that lie side by side.
void GoalField::spread(const Entry& from) {
  const std::int32_t x = from.corner.x;
  const std::int32_t y = from.corner.y;
  const std::uint8_t* const lower = cells(y - 1) + x;
  const std::uint8_t* const upper = cells(y) + x;
  const auto go = [&](bool is_open, int dx, int dy, double step) {
    if (is_open) reach(from, {x + dx, y + dy}, step);
  };
  go(upper[0] | lower[0], 1, 0, 1.0);
  go(upper[-1] | lower[-1], -1, 0, 1.0);
  go(upper[0] | upper[-1], 0, 1, 1.0);
  go(lower[0] | lower[-1], 0, -1, 1.0);
  go(upper[0], 1, 1, diagonal);
  go(upper[-1], -1, 1, diagonal);
  go(lower[0], 1, -1, diagonal);
  go(lower[-1], -1, -1, diagonal);
  if (kind_ == FieldKind::grid) return;
  const std::uint8_t* const lowest = cells(y - 2) + x;
  const std::uint8_t* const uppest = cells(y + 1) + x;
  go(upper[0] & upper[1], 2, 1, knight);
  go(upper[-1] & upper[-2], -2, 1, knight);
  go(lower[0] & lower[1], 2, -1, knight);
  go(lower[-1] & lower[-2], -2, -1, knight);
  go(upper[0] & uppest[0], 1, 2, knight);
  go(upper[-1] & uppest[-1], -1, 2, knight);
  go(lower[0] & lowest[0], 1, -2, knight);
  go(lower[-1] & lowest[-1], -1, -2, knight);
}

/// Settles the rest of one bucket. False if nothing is left to settle, or the work is done.
bool GoalField::settle(int& work) {
  if (front_ >= open_.size()) return false;
  while (!open_[front_].empty()) {
    if (work == 0) return false;
    Entry entry = open_[front_].back();
    open_[front_].pop_back();
    const Label known = label(entry.corner);
    if (entry.cost > known.cost) continue;
    --work;
    ++settled_;
    if (entry.is_border) entry.cost = beyond_border(entry.corner);
    spread(entry);
    if (known.is_seen && !entry.is_border) push({entry.corner, entry.cost, true});
  }
  ++front_;
  return true;
}

/// Distance of a corner to the goal less its distance from a place [cells].
double GoalField::of_corner(const Corner& corner, const Point& place, int& work) {
  const double* const cost = &label(corner).cost;
  const double ahead = to_start(corner);
  const auto front = [&] { return static_cast<double>(front_) / buckets; };
  const auto is_final = [&] { return front() > *cost + ahead; };
  while (!is_final() && settle(work)) {
  }
  const bool is_known = is_final() || front_ >= open_.size();
  const double known = is_known ? *cost : front() - ahead;
  return known / too_long_ - std::hypot(place.x - corner.x, place.y - corner.y);
}

/// Estimate by the best of the four corners of the cell with the disc's centre [m].
double GoalField::around(const Pose& pose, const Point& place) {
  const Corner cell{static_cast<std::int32_t>(place.x), static_cast<std::int32_t>(place.y)};
  if (!(place.x >= 0.0 && place.y >= 0.0) || cell.x >= lattice_.columns() ||
      cell.y >= lattice_.rows() || cells(cell.y)[cell.x] == 0) {
    return 0.0;
  }
  if (kind_ == FieldKind::choi && label(cell).is_seen) {
    return reeds_shepp_length(pose, task_.goal, task_.vehicle.min_turning_radius);
  }
  int work = work_of_call;
  double longest = 0.0;
  for (const Corner& corner : {cell, Corner{cell.x + 1, cell.y}, Corner{cell.x, cell.y + 1},
                               Corner{cell.x + 1, cell.y + 1}}) {
    longest = std::max(longest, of_corner(corner, place, work));
  }
  return longest * side_ / stretch_ * (1 - rounding_of_sums);
}

double GoalField::at(const Pose& pose) {
  const double straight = std::hypot(task_.goal.x - pose.x, task_.goal.y - pose.y);
  return std::max(straight, around(pose, lattice_.in_cells(centre_of(disc_, pose))));
}

}  // namespace vandplan::search
