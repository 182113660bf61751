// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/pose_boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/trigonometry.h"
#include "search/closed_areas.h"
#include "search/geodesic.h"
#include "steering/dubins_bound.h"
#include "steering/words.h"
#include "vandplan/steering.h"

namespace vandplan::search {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double slack = 1e-5;        // Slack of lengths [m]; larger than the judge's and rounding.
constexpr double angle_slack = 2e-6;  // Slack of headings [rad]; larger than the judge's.
constexpr double end_slack = 2e-6;    // Slack of a path's ends [m]; larger than the judge's.
// Headings for a reach of the body as long as a cell's side.
constexpr double headings_of_cell = 4.0;
constexpr double max_headings = 4096.0;
constexpr double max_cells = 2e6;
constexpr int parts = 4;  // Parts of a cell's side; each part is a cell for ways around.
constexpr std::int32_t cells_apart = 2;  // Distance of the places that show how wide the ways are.
constexpr std::size_t max_boxes = 16'000'000;

/// Core of a vehicle: its body and wheels without a border. Removes `along` at front and rear, and
/// `across` at each side; the core's rear axle is `along` ahead of the vehicle's.
Vehicle core_of(Vehicle vehicle, double along, double across) {
  vehicle.wheelbase -= 2 * along;
  vehicle.width -= 2 * across;
  if (vehicle.track_width) *vehicle.track_width -= 2 * across;
  return vehicle;
}

}  // namespace

PoseBoxes::PoseBoxes(const Task& task, double side, double longest, GearSign only)
    : task_(task),
      disc_(bound_disc(task.vehicle)),
      stretch_(stretch_of(disc_, task.vehicle.min_turning_radius)),
      side_(side),
      longest_(longest),
      only_(only),
      box_(box_of_paths(task, disc_, longest)) {
  const double part = side / parts;
  const double near = disc_.radius + task.least_margin - part * std::sqrt(0.5) - slack;
  const double cells = (box_.x_max - box_.x_min) * (box_.y_max - box_.y_min) / (side * side);
  const double extent = std::max(box_.x_max - box_.x_min, box_.y_max - box_.y_min);
  is_usable_ = near > 0 && cells < max_cells && extent < max_cells * side;
  if (!is_usable_) return;

  const Footprint body = footprint(task.vehicle);
  const double length = std::max(body.front - disc_.ahead, body.rear + disc_.ahead);
  const double reach = std::max(length, task.vehicle.min_turning_radius);
  headings_ =
      static_cast<Id>(std::ceil(std::min(max_headings, 8 + headings_of_cell * reach / side)));
  half_turn_ = std::numbers::pi / headings_ + angle_slack;
  const double half_diagonal = side * std::sqrt(0.5) + slack;
  shift_ = half_diagonal + std::abs(disc_.ahead) * half_turn_;
  const auto [sin, cos] = base::sin_cos(std::min(half_turn_, std::numbers::pi / 2));
  const double tolerance = half_diagonal + CollisionChecker::tolerance;
  ahead_ = tolerance + body.half_width * sin + length * (1 - cos);
  const double across = tolerance + length * sin + body.half_width * (1 - cos);
  const double track =
      std::min(task.vehicle.track_width.value_or(task.vehicle.width), task.vehicle.width);
  if (task.vehicle.outline.empty() && task.vehicle.wheelbase > 2.1 * ahead_ &&
      track > 2.1 * across) {
    core_ = task.world->checker_of_obstacles(core_of(task.vehicle, ahead_, across),
                                             {.wanted = task.least_margin});
  }

  one_way_ = OneWay(task.world->local().zones, disc_, task.vehicle.min_turning_radius);
  const OpenRows lattice(task, box_, part, near, closed_areas(task, disc_, only));
  columns_of_row_ = (lattice.columns() + parts - 1) / parts;
  rows_ = (lattice.rows() + parts - 1) / parts;
  const Point start = lattice.in_cells(centre_of(disc_, task.start));
  const Point goal = lattice.in_cells(centre_of(disc_, task.goal));
  // Long enough for all places of a cell.
  const double longest_way = longest * stretch_ / part + 2;
  from_start_ = GeodesicField(lattice, start, goal, longest_way);
  to_goal_ = GeodesicField(lattice, goal, start, longest_way);
  index_.assign(static_cast<std::size_t>(columns_of_row_) * static_cast<std::size_t>(rows_), -1);
}

bool PoseBoxes::prepare(std::int64_t work) {
  if (from_start_.go_on(from_start_.work() + work) || to_goal_.go_on(to_goal_.work() + work)) {
    return false;
  }
  is_usable_ = !from_start_.is_given_up() && !to_goal_.is_given_up();
  return true;
}

bool PoseBoxes::is_full() const noexcept { return length_bounds_.size() > max_boxes; }

/// Range of the disc's way to the places of a part, in metres of the rear axle.
PoseBoxes::Range PoseBoxes::way(GeodesicField& field, const Point& part) const {
  const double side = side_ / parts;
  const double off = side * std::sqrt(0.5) + slack;
  const double way = field.at(part) * side;
  return {std::max(0.0, way - off) / stretch_, (way + off) / stretch_};
}

PoseBoxes::Id PoseBoxes::column_at(std::int32_t x, std::int32_t y) {
  std::int32_t& index =
      index_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_of_row_) +
             static_cast<std::size_t>(x)];
  if (index >= 0) return static_cast<Id>(index);
  index = static_cast<std::int32_t>(columns_.size());
  Column column{x, y, {infinity, 0.0}, {infinity, 0.0}, infinity, {}, {}};
  for (int i = 0; i < parts * parts; ++i) {
    const int row = i / parts;
    const Point part{parts * x + i % parts + 0.5, parts * y + row + 0.5};
    const Range from_start = way(from_start_, part);
    if (from_start.least == infinity) continue;
    const Range to_goal = way(to_goal_, part);
    const double in_all = from_start.least + to_goal.least;
    column.from_start.least = std::min(column.from_start.least, from_start.least);
    column.to_goal.least = std::min(column.to_goal.least, to_goal.least);
    column.in_all = std::min(column.in_all, in_all);
    if (!(in_all <= longest_)) continue;
    column.from_start.most = std::max(column.from_start.most, from_start.most);
    column.to_goal.most = std::max(column.to_goal.most, to_goal.most);
  }
  if (!one_way_.is_empty()) bar_sides(column);
  columns_.push_back(column);
  length_bounds_.resize(columns_.size() * headings_, -1.0F);
  return static_cast<Id>(index);
}

void PoseBoxes::bar_sides(Column& column) const {
  const Point middle{box_.x_min + (column.x + 0.5) * side_, box_.y_min + (column.y + 0.5) * side_};
  const double half = side_ / 2;
  const std::array<Point, 4> sides = {Point{middle.x + half, middle.y},
                                      {middle.x, middle.y + half},
                                      {middle.x - half, middle.y},
                                      {middle.x, middle.y - half}};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const int sense = static_cast<int>(i);
    column.bars_out[i] = one_way_.bars(sides[i], side_, sense);
    column.bars_in[i] = one_way_.bars(sides[i], side_, (sense + 2) % 4);
  }
}

PoseBoxes::Id PoseBoxes::box_of(const Pose& pose) {
  const Point centre = centre_of(disc_, pose);
  const auto cell = [&](double place, std::int32_t count) {
    return std::clamp(static_cast<std::int32_t>(place / side_), 0, count - 1);
  };
  const Id column =
      column_at(cell(centre.x - box_.x_min, columns_of_row_), cell(centre.y - box_.y_min, rows_));
  const double turns = pose.heading / (2 * std::numbers::pi);
  const auto heading = static_cast<Id>(std::lround((turns - std::floor(turns)) * headings_));
  return column * headings_ + heading % headings_;
}

std::array<PoseBoxes::Id, 4> PoseBoxes::boxes_of_end(const Pose& pose) {
  const double off = one_way_.is_empty() ? 0.0 : end_slack;
  return {box_of({pose.x - off, pose.y - off, pose.heading}),
          box_of({pose.x - off, pose.y + off, pose.heading}),
          box_of({pose.x + off, pose.y - off, pose.heading}),
          box_of({pose.x + off, pose.y + off, pose.heading})};
}

std::array<PoseBoxes::Id, 6> PoseBoxes::neighbours(Id box, bool is_onward) {
  const Id heading = box % headings_;
  const Column column = columns_[box / headings_];
  const std::array<bool, 4>& is_barred = is_onward ? column.bars_out : column.bars_in;
  const Id first = box - heading;
  const auto beside = [&](std::size_t side, std::int32_t to_x, std::int32_t to_y) {
    const bool is_there = to_x >= 0 && to_x < columns_of_row_ && to_y >= 0 && to_y < rows_;
    return is_there && !is_barred[side] ? column_at(to_x, to_y) * headings_ + heading : box;
  };
  return {beside(2, column.x - 1, column.y), beside(0, column.x + 1, column.y),
          beside(3, column.x, column.y - 1), beside(1, column.x, column.y + 1),
          first + (heading + 1) % headings_, first + (heading + headings_ - 1) % headings_};
}

/// Lower bound on a path in the one gear between an end and a pose of the box, on open ground [m].
/// A path to an end is one from it, driven backwards. A path in reverse goes forward if both ends
/// are turned around.
double PoseBoxes::length_in_gear(const Pose& end, const Pose& middle, bool is_start) const {
  const bool is_turned = (only_ > 0) != is_start;
  const auto pose = [&](const Pose& p) {
    return is_turned ? Pose{p.x, p.y, p.heading + std::numbers::pi} : p;
  };
  const double apart = std::hypot(middle.x - end.x, middle.y - end.y) + shift_;
  const steering::Closing off{shift_ + slack + (angle_slack + steering::judged_curvature) * apart,
                              half_turn_};
  return steering::dubins_bound(pose(end), pose(middle), task_.vehicle.min_turning_radius, off) *
         (1 - steering::judged_curvature);
}

/// Lower bound on a path between an end and a pose of the box, on open ground [m].
double PoseBoxes::turning_length(const Pose& end, const Pose& middle, bool is_start) const {
  if (only_ != 0) return length_in_gear(end, middle, is_start);
  const double radius = task_.vehicle.min_turning_radius;
  const double apart = std::hypot(middle.x - end.x, middle.y - end.y);
  const double turn = radius * half_turn_ + slack;
  if (apart < 2 * shift_) {
    return radius * std::abs(wrap_angle(middle.heading - end.heading)) - turn;
  }
  const double length = reeds_shepp_length(end, middle, radius);
  const double slope = std::hypot(length, 2 * radius) / (apart - shift_);
  return (length - slope * shift_ - turn) * (1 - steering::judged_curvature);
}

/// Whether the body hits an obstacle at all poses of the box. False outside the bounds, where
/// obstacles are not known.
bool PoseBoxes::is_hit(const Pose& middle) const {
  if (!core_) return false;
  const auto [sin, cos] = base::sin_cos(middle.heading);
  const Pose core{middle.x + ahead_ * cos, middle.y + ahead_ * sin, middle.heading};
  return contains(task_.world->local().bounds, {core.x, core.y}) && !core_->is_free(Local(core));
}

/// Whether one-way streets forbid to move at all poses of the box.
bool PoseBoxes::is_astray(const Pose& middle) const {
  return !one_way_.is_empty() &&
         one_way_.forbids(centre_of(disc_, middle), side_ * std::sqrt(0.5) + slack, middle.heading,
                          half_turn_, only_);
}

Pose PoseBoxes::middle_of(const Column& column, double heading) const {
  const double angle = wrap_angle(2 * std::numbers::pi * heading / headings_);
  const auto [sin, cos] = base::sin_cos(angle);
  return {box_.x_min + (column.x + 0.5) * side_ - disc_.ahead * cos,
          box_.y_min + (column.y + 0.5) * side_ - disc_.ahead * sin, angle};
}

Pose PoseBoxes::between(Id first, Id last) const {
  return middle_of(columns_[first / headings_], 0.5 * (first % headings_ + last % headings_));
}

PoseBoxes::Box PoseBoxes::box(Id id) const {
  const Column& column = columns_[id / headings_];
  const Pose middle = middle_of(column, id % headings_);
  return {middle, column.from_start, column.to_goal,
          std::max(column.from_start.least * (1 + steering::judged_curvature),
                   turning_length(task_.start, middle, true)),
          std::max(column.to_goal.least * (1 + steering::judged_curvature),
                   turning_length(task_.goal, middle, false))};
}

double PoseBoxes::find_least_length(Id id) const {
  if (!(columns_[id / headings_].in_all <= longest_)) return infinity;
  const Box box = this->box(id);
  const double length = (box.from_start + box.to_goal) / (1 + steering::judged_curvature);
  return length > longest_ || is_hit(box.middle) || is_astray(box.middle) ? infinity : length;
}

float PoseBoxes::length_lower_bound(Id box) {
  float& known = length_bounds_[box];
  if (known < 0) {
    ++looks_;
    const double length = find_least_length(box);
    known = std::nextafter(static_cast<float>(length), 0.0F);
    if (length == infinity) known = std::numeric_limits<float>::infinity();
  }
  return known;
}

std::vector<PoseBoxes::Crossing> PoseBoxes::crossings(std::int32_t y, double distance) {
  std::vector<Crossing> found;
  const double part = side_ / parts;
  const double near = std::sqrt(0.5) + slack / part;
  for (std::int32_t line = parts * y; line < parts * (y + 1); ++line) {
    for (const std::int32_t i : from_start_.cells_at(line, distance * stretch_ / part, near)) {
      const Point place{i + 0.5, line + 0.5};
      const Range to_goal = way(to_goal_, place);
      if (!(way(from_start_, place).least + to_goal.least <= longest_)) continue;
      const auto known = std::ranges::find(found, i / parts, &Crossing::x);
      if (known == found.end()) {
        found.push_back({i / parts, y, to_goal});
      } else {
        known->way_to_goal.least = std::min(known->way_to_goal.least, to_goal.least);
        known->way_to_goal.most = std::max(known->way_to_goal.most, to_goal.most);
      }
    }
  }
  return found;
}

std::vector<double> PoseBoxes::distances(std::int32_t y) {
  std::vector<double> distances;
  if (y % cells_apart != 0 || !from_start_.has_row(parts * y)) return distances;
  for (std::int32_t x = 0; x < columns_of_row_; x += cells_apart) {
    const Point place{parts * x + 0.5, parts * y + 0.5};
    const double from_start = way(from_start_, place).least;
    if (from_start > longest_ || from_start + way(to_goal_, place).least > longest_) continue;
    distances.push_back(from_start);
  }
  return distances;
}

}  // namespace vandplan::search
