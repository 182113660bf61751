// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/pose_flood.h"

#include <algorithm>
#include <limits>

namespace vandplan::search {
namespace {

constexpr double coarsest = 0.25;     // Cell of the first lattice [disc radii].
constexpr double finest = 1.0 / 512;  // Cell of the last lattice [disc radii].
constexpr double finer = 0.5;         // Cell of a lattice, as a share of the one before.
constexpr int nodes_of_step = 32;     // Nodes of the ways around, in one call.
// // Work is in units of about 0.1 microseconds.
constexpr std::int64_t work_of_step = 96;
constexpr std::int64_t work_of_look = 4;     // Work of looking at a box.
constexpr std::int64_t lengths_of_work = 6;  // Lengths to boxes of a cut that take one unit.
constexpr std::int64_t turns_of_leader = 3;  // Turns of the leading flood for one of the other.
constexpr double worth_a_cut = 1.004;        // Factor on the bound from which cuts are used again.

}  // namespace

PoseFlood::PoseFlood(const Task& task, GearSign only)
    : task_(task),
      only_(only),
      side_(coarsest * (bound_disc(task.vehicle).radius + task.least_margin) / finer) {}

bool PoseFlood::begin(double longest) {
  side_ *= finer;
  const double disc = bound_disc(task_.vehicle).radius + task_.least_margin;
  if (!(side_ > finest * disc) || bound_ >= longest) return false;
  longest_ = longest;
  boxes_ = std::make_unique<PoseBoxes>(task_, side_, longest, only_);
  is_prepared_ = false;
  return boxes_->is_usable();
}

void PoseFlood::begin_floods() {
  leader_ = levels_[1] > levels_[0] ? 1 : 0;
  levels_ = {};
  open_ = {};
  reached_.clear();
  for (const PoseBoxes::Id box : boxes_->boxes_of_end(task_.start)) reach(box, 0, PoseCut::none);
  for (const PoseBoxes::Id box : boxes_->boxes_of_end(task_.goal)) reach(box, 1, PoseCut::none);
}

void PoseFlood::reach(PoseBoxes::Id box, std::size_t flood, PoseCut::Index by) {
  if (reached_.size() < boxes_->size()) reached_.resize(boxes_->size(), 0);
  const auto mark = static_cast<std::uint8_t>(1U << flood);
  if ((reached_[box] & mark) != 0) return;
  reached_[box] = static_cast<std::uint8_t>(reached_[box] | mark);
  const float length = boxes_->length_lower_bound(box);
  if (length != std::numeric_limits<float>::infinity()) open_[flood].push({length, box, by});
}

// Expands the box of the least length. False when these boxes can prove nothing more.
bool PoseFlood::spread(std::size_t flood) {
  Queue& open = open_[flood];
  if (open.empty()) {  // Every path is longer than the longest of interest.
    bound_ = std::max(bound_, longest_);
    return false;
  }
  Entry entry = open.top();
  open.pop();
  ++visits_;
  levels_[flood] = entry.length;
  bound_ = std::max(bound_, static_cast<double>(entry.length));
  if (cut_ && !entry.knows_cut && cut_->is_near(entry.box)) {
    const float length = cut_->length_lower_bound(entry.box, bound_, entry.by);
    if (static_cast<double>(length) > longest_) return true;
    if (static_cast<double>(length) > bound_) {  // The box is expanded later.
      open.push({length, entry.box, entry.by, true});
      return true;
    }
  }
  constexpr std::uint8_t both = 3;
  if (reached_[entry.box] == both || boxes_->is_full()) return false;
  for (const PoseBoxes::Id box : boxes_->neighbours(entry.box, flood == 0)) {
    reach(box, flood, entry.by);
  }
  return true;
}

// Flood whose turn it is. With a cut, the flood that came further before has most turns.
std::size_t PoseFlood::next_flood() {
  if (!cut_) return static_cast<std::size_t>(visits_ % 2);
  return visits_ % (turns_of_leader + 1) < turns_of_leader ? leader_ : 1 - leader_;
}

void PoseFlood::begin_cut() {
  cut_ = std::make_unique<PoseCut>(task_, *boxes_);
  is_cut_prepared_ = false;
  uncut_bound_ = bound_;
}

// If a cut was of use, the next boxes are flooded only with a cut.
void PoseFlood::prepare() {
  is_prepared_ = boxes_->prepare(nodes_of_step);
  if (!is_prepared_ || !boxes_->is_usable()) return;
  if (use_of_cuts_ == Use::some) {
    begin_cut();
  } else {
    begin_floods();
  }
}

void PoseFlood::prepare_cut() {
  is_cut_prepared_ = cut_->prepare();
  if (!is_cut_prepared_) return;
  if (cut_->is_usable() || use_of_cuts_ == Use::some) begin_floods();
  if (cut_->is_usable()) return;
  cut_.reset();
  if (use_of_cuts_ == Use::unknown) boxes_.reset();
  use_of_cuts_ = Use::none;
}

// Chooses what follows when the floods can prove no more: a cut, or finer boxes. False if boxes are
// full.
bool PoseFlood::next_boxes() {
  const bool is_full = boxes_->is_full();
  if (!is_full && !cut_ && use_of_cuts_ == Use::unknown) {
    begin_cut();
    return true;
  }
  if (cut_) use_of_cuts_ = bound_ > worth_a_cut * uncut_bound_ ? Use::some : Use::none;
  cut_.reset();
  boxes_.reset();
  return !is_full;
}

/// Work done so far, in units of about 0.1 microseconds.
std::int64_t PoseFlood::work() const {
  return visits_ + work_of_look * boxes_->looks() + (cut_ ? cut_->lengths() / lengths_of_work : 0);
}

bool PoseFlood::step(double longest) {
  if (!boxes_) return begin(longest);
  if (!is_prepared_) {
    prepare();
    return boxes_->is_usable();
  }
  if (cut_ && !is_cut_prepared_) {
    prepare_cut();
    return true;
  }
  for (const std::int64_t end = work() + work_of_step; work() < end;) {
    if (!spread(next_flood())) return next_boxes();
  }
  return true;
}

}  // namespace vandplan::search
