// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/pose_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "search/open_rows.h"
#include "steering/words.h"
#include "vandplan/steering.h"

namespace vandplan::search {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double slack = 2e-5;        // Slack of lengths [m]; larger than the judge's and rounding.
constexpr double angle_slack = 1e-6;  // Slack of headings in float [rad].
constexpr double float_slack = 1e-6;  // Relative slack of places and lengths in float.
constexpr double length_slack = 1e-5;  // Relative slack of lengths between poses in float.
constexpr double turns_near = 3.0;     // Range of a cut, where it improves bounds [turning radii].
// Least distance of a cut from start and goal [turning radii].
constexpr double turns_of_end = 1.0;
constexpr double cells_of_place = 4.0;  // Width of a bin of distances [cells].
constexpr std::size_t max_boxes = 8192;
constexpr PoseBoxes::Id boxes_of_group = 8;
constexpr int groups_of_step = 4;

}  // namespace

void PoseCut::Poses::add(const Pose& pose) {
  x.push_back(static_cast<float>(pose.x));
  y.push_back(static_cast<float>(pose.y));
  heading.push_back(static_cast<float>(pose.heading));
}

PoseCut::PoseCut(const Task& task, PoseBoxes& boxes)
    : task_(task), boxes_(boxes), radius_(task.vehicle.min_turning_radius) {
  const double half_turn = boxes.half_turn() + angle_slack;
  play_ = {2 * boxes.shift() + float_slack * boxes.longest(), radius_ * 2 * half_turn + slack};
  const double more = (boxes_of_group - 1) * half_turn;
  group_play_ = {play_.shift + std::abs(bound_disc(task.vehicle).ahead) * more,
                 play_.turn + radius_ * more};
  from_boxes_.resize(boxes_of_group);
}

bool PoseCut::prepare() {
  const std::int32_t rows = boxes_.rows();
  for (int i = 0; i < groups_of_step && !cells_.empty(); ++i) {
    add_group(cells_.back(), heading_);
    heading_ += boxes_of_group;
    if (heading_ < boxes_.headings()) continue;
    heading_ = 0;
    cells_.pop_back();
  }
  if (row_ < rows) {
    count(row_++);
  } else if (cells_.empty() && row_ < 2 * rows) {
    if (row_ == rows) choose_distance();
    if (is_usable_) cells_ = boxes_.crossings(row_++ - rows, distance_);
  }
  return !is_usable_ || (row_ == 2 * rows && cells_.empty());
}

void PoseCut::count(std::int32_t row) {
  for (const double distance : boxes_.distances(row)) {
    const auto place = static_cast<std::size_t>(distance / (cells_of_place * boxes_.side()));
    if (places_.size() <= place) places_.resize(place + 1, 0);
    ++places_[place];
  }
}

void PoseCut::choose_distance() {
  const double way = boxes_.box(boxes_.box_of(task_.goal)).way_from_start.least;
  const double end = turns_of_end * radius_;
  std::int32_t fewest = std::numeric_limits<std::int32_t>::max();
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double distance = (static_cast<double>(i) + 0.5) * cells_of_place * boxes_.side();
    if (distance < end || distance > way - end || places_[i] >= fewest) continue;
    fewest = places_[i];
    distance_ = distance;
  }
  is_usable_ = distance_ > 0.0;
}

void PoseCut::add_group(const PoseBoxes::Crossing& cell, PoseBoxes::Id heading) {
  const PoseBoxes::Id first = boxes_.first_of(cell.x, cell.y) + heading;
  const PoseBoxes::Id end = first + std::min(boxes_of_group, boxes_.headings() - heading);
  Group group{needs_.size(), needs_.size(), {infinity, infinity}, cell.way_to_goal};
  for (PoseBoxes::Id id = first; id < end; ++id) {
    if (boxes_.length_lower_bound(id) == std::numeric_limits<float>::infinity()) continue;
    const PoseBoxes::Box box = boxes_.box(id);
    const Needs needs{std::max(distance_ - slack, box.from_start),
                      std::max(cell.way_to_goal.least, box.to_goal)};
    group.needs = {std::min(group.needs.from_start, needs.from_start),
                   std::min(group.needs.to_goal, needs.to_goal)};
    needs_.push_back(needs);
    poses_.add(seen(box.middle));
    group_of_.push_back(static_cast<Index>(groups_.size()));
  }
  group.end = needs_.size();
  if (group.end == group.first) return;
  groups_.push_back(group);
  group_poses_.add(seen(boxes_.between(first, end - 1)));
  from_groups_.resize(groups_.size());
  is_usable_ = needs_.size() <= max_boxes;
}

bool PoseCut::is_near(PoseBoxes::Id id) const {
  const PoseBoxes::Range way = boxes_.way_from_start(id);
  const double off = std::max(way.least - distance_, distance_ - way.most);
  return off >= 0 && off <= turns_near * radius_;
}

/// Pose relative to the start, since floats are finest near zero.
Pose PoseCut::seen(const Pose& pose) const {
  return {pose.x - task_.start.x, pose.y - task_.start.y, pose.heading};
}

/// Lower bound on a path between poses of two boxes on open ground [m].
double PoseCut::turning_length(const Target& target, const Poses& poses, std::size_t i,
                               float length_of_middles, const Play& play) const {
  const double dx = static_cast<double>(poses.x[i]) - target.middle.x;
  const double dy = static_cast<double>(poses.y[i]) - target.middle.y;
  const auto length = static_cast<double>(length_of_middles);
  const double apart = std::sqrt(dx * dx + dy * dy);
  if (apart < 2 * play.shift) return 0.0;
  const double slope = std::sqrt(length * length + 4 * radius_ * radius_) / (apart - play.shift);
  return length - length_slack * (length + radius_) - slope * play.shift - play.turn;
}

/// Lower bound on a path between an end and the box, through boxes of a group [m].
double PoseCut::length_by(const Target& target, const Group& group, const Needs& needs,
                          double turning) const {
  const double before = target.is_beyond ? needs.from_start : needs.to_goal;
  return before + std::max({turning, target.way, target.way_to_goal.least - group.way_to_goal.most,
                            group.way_to_goal.least - target.way_to_goal.most});
}

/// Least bound through the boxes of a group if it is below `least`, otherwise `least` [m].
double PoseCut::least_of(const Target& target, const Group& group, double least, Index& by) {
  const std::size_t size = group.end - group.first;
  const auto part = [&](const std::vector<float>& all) {
    return std::span<const float>(all).subspan(group.first, size);
  };
  const std::span<float> lengths = std::span<float>(from_boxes_).first(size);
  reeds_shepp_lengths({part(poses_.x), part(poses_.y), part(poses_.heading)}, target.middle,
                      radius_, lengths);
  lengths_ += boxes_of_group;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t box = group.first + i;
    const double turning = turning_length(target, poses_, box, lengths[i], play_);
    const double length = length_by(target, group, needs_[box], turning);
    if (length >= least) continue;
    least = length;
    by = static_cast<Index>(box);
  }
  return least;
}

float PoseCut::length_lower_bound(PoseBoxes::Id id, double enough, Index& by) {
  const PoseBoxes::Box box = boxes_.box(id);
  const bool is_beyond = box.way_from_start.least >= distance_;
  const Target target{
      seen(box.middle), box.way_to_goal,
      is_beyond ? box.way_from_start.least - distance_ : distance_ - box.way_from_start.most,
      is_beyond};
  const double own = is_beyond ? box.from_start : box.to_goal;
  const double rest = is_beyond ? box.to_goal : box.from_start;
  const auto in_all = [&](double length) {
    const double all = (std::max(own, length) + rest) / (1 + steering::judged_curvature);
    return std::nextafter(static_cast<float>(all), 0.0F);
  };
  double least = infinity;
  if (by != none) {
    least = least_of(target, groups_[group_of_[by]], least, by);
    if (least <= own || static_cast<double>(in_all(least)) <= enough) return in_all(least);
  }
  reeds_shepp_lengths({group_poses_.x, group_poses_.y, group_poses_.heading}, target.middle,
                      radius_, from_groups_);
  lengths_ += static_cast<std::int64_t>(groups_.size());
  for (std::size_t i = 0; i < groups_.size() && least > own; ++i) {
    const double turning = turning_length(target, group_poses_, i, from_groups_[i], group_play_);
    if (length_by(target, groups_[i], groups_[i].needs, turning) < least) {
      least = least_of(target, groups_[i], least, by);
    }
  }
  return in_all(least);
}

}  // namespace vandplan::search
