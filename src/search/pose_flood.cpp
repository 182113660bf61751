// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/pose_flood.h"

#include <algorithm>
#include <limits>

namespace vandplan::search {
namespace {

constexpr double coarsest = 0.25;  // cell of the first lattice [disc radii]
constexpr double finest = 1.0 / 512;
constexpr double finer = 0.5;  // each lattice than the one before
constexpr int boxes_of_step = 16;
constexpr int work_of_step = 32;

}  // namespace

PoseFlood::PoseFlood(const Task& task)
    : task_(task),
      side_(coarsest * (bound_disc(task.vehicle).radius + task.least_margin) / finer) {}

bool PoseFlood::begin(double longest) {
  side_ *= finer;
  const double disc = bound_disc(task_.vehicle).radius + task_.least_margin;
  if (!(side_ > finest * disc) || bound_ >= longest) return false;
  longest_ = longest;
  boxes_ = std::make_unique<PoseBoxes>(task_, side_, longest);
  is_prepared_ = false;
  open_ = {};
  reached_.clear();
  return boxes_->is_usable();
}

void PoseFlood::reach(PoseBoxes::Id box, std::size_t flood) {
  if (reached_.size() < boxes_->size()) reached_.resize(boxes_->size(), 0);
  const auto mark = static_cast<std::uint8_t>(1U << flood);
  if ((reached_[box] & mark) != 0) return;
  reached_[box] = static_cast<std::uint8_t>(reached_[box] | mark);
  const float length = boxes_->least_length(box);
  if (length != std::numeric_limits<float>::infinity()) open_[flood].push({length, box});
}

// To the neighbours of the box of the least length. False when there is no more to be proven here.
bool PoseFlood::spread(std::size_t flood) {
  Queue& open = open_[flood];
  if (open.empty()) {  // no path is as short as the longest
    bound_ = std::max(bound_, longest_);
    return false;
  }
  const Entry entry = open.top();
  open.pop();
  bound_ = std::max(bound_, static_cast<double>(entry.length));
  constexpr std::uint8_t both = 3;
  if (reached_[entry.box] == both || boxes_->is_full()) return false;
  for (const PoseBoxes::Id box : boxes_->neighbours(entry.box)) reach(box, flood);
  return true;
}

bool PoseFlood::step(double longest) {
  if (!boxes_) return begin(longest);
  if (!is_prepared_) {
    is_prepared_ = boxes_->prepare(work_of_step);
    if (!boxes_->is_usable()) return false;
    if (!is_prepared_) return true;
    reach(boxes_->box_of(task_.start), 0);
    reach(boxes_->box_of(task_.goal), 1);
    return true;
  }
  for (int i = 0; i < boxes_of_step; ++i) {
    turn_ = 1 - turn_;
    if (!spread(turn_)) {
      const bool is_full = boxes_->is_full();
      boxes_.reset();
      return !is_full;
    }
  }
  return true;
}

}  // namespace vandplan::search
