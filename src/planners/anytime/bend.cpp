// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/bend.h"

#include <algorithm>
#include <utility>

namespace vandplan::anytime {
namespace {

constexpr std::size_t most_waiting = 6;
constexpr double hopeless_drive = 6.0;  // excess over the cheapest drive, times the trials

}  // namespace

Bender::Bender(const Task& task, const CostRule& rule, std::uint64_t seed, Measure measure)
    : task_(task),
      rule_(rule),
      wheels_(task.vehicle, task.steering),
      ends_(commands::wheel_ends(task)),
      closer_(task.vehicle, task.steering),
      seed_(seed),
      measure_(std::move(measure)) {}

void Bender::offer(const Route& route) {
  if (!kinds_.is_new(route, task_.vehicle.min_turning_radius)) return;
  offer(path_of(route).segments);
}

void Bender::offer(std::vector<Segment> segments) {
  if (waiting_.size() == most_waiting) waiting_.erase(waiting_.begin());
  waiting_.push_back(std::move(segments));
}

std::int64_t Bender::checks() const {
  return checks_ + (best_ ? best_->checks() : 0) + (challenger_ ? challenger_->checks() : 0);
}

/// Null if it cannot be driven by commands from start to goal.
Bender::Drive Bender::drive_along(std::span<const Segment> segments) {
  std::vector<Segment> drive = wheels_.commands(segments, ends_);
  const double sharpest = 1 / task_.vehicle.min_turning_radius;
  for (Segment& command : drive) {
    command.curvature = std::clamp(command.curvature, -sharpest, sharpest);
  }
  const RigState from{task_.start, task_.hitch_angles.start};
  const RigState to{task_.goal, task_.hitch_angles.goal};
  if (drive.empty() || !closer_.close(from, drive, to, ends_)) return nullptr;
  ++checks_;
  if (!task_.checker->is_free(task_.start, wheels_.driven(drive, ends_.before))) return nullptr;
  return std::make_unique<commands::DriveShortener>(task_, rule_, drive,
                                                    stream_seed(seed_, drives_++), measure_);
}

bool Bender::is_hopeless() const {
  const double excess = challenger_->cost() / best_->cost() - 1.0;
  return challenger_->is_stalled() || excess * static_cast<double>(trials_) > hopeless_drive;
}

/// The challenger becomes the best drive if it is cheaper now.
bool Bender::challenge() {
  if (best_ && challenger_->cost() >= best_->cost()) return false;
  if (best_) checks_ += best_->checks();
  best_ = std::move(challenger_);
  return true;
}

bool Bender::step() {
  if (!challenger_ && !waiting_.empty()) {
    challenger_ = drive_along(waiting_.back());
    waiting_.pop_back();
    trials_ = 0;
    return challenger_ && challenge();
  }
  if (!best_) return false;
  is_turn_of_best_ = !is_turn_of_best_;
  if (!challenger_ || is_turn_of_best_) return best_->step();
  challenger_->step();
  ++trials_;
  if (challenge()) return true;
  if (is_hopeless()) {
    checks_ += challenger_->checks();
    challenger_.reset();
  }
  return false;
}

}  // namespace vandplan::anytime
