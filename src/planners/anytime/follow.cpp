// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/follow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/splice.h"
#include "vandplan/search.h"

namespace vandplan::anytime {
namespace {

using commands::Command;
using search::Driven, search::gear_of;

/// Stages, counted from the last, where a part may begin, and commands on either side of a blocked
/// one that are changed.
constexpr std::size_t nearby = 4;
constexpr int max_idle_trials = 100;  // trials without a gain that end shaking

}  // namespace

Follower::Follower(const Task& task, const search::DrivenBeside& ends, commands::Closer& closer,
                   std::uint64_t seed)
    : task_(task), ends_(ends), wheels_(task.vehicle, task.steering), closer_(closer), rng_(seed) {}

/// Cuts the way at stops, and in the middle of each segment whose curvature the wheels can hold for
/// a while.
void Follower::cut(std::span<const Segment> way) {
  way_.clear();
  cuts_.clear();
  LocalPose pose = task_.start;
  Driven before = ends_.before;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Segment& segment = way[i];
    const Driven last = search::last_driven(segment);
    const bool begins_free = wheels_.may_jump(before, last.gear);
    const bool is_last = i + 1 == way.size();
    const bool is_stop = !is_last && wheels_.may_jump(last, gear_of(way[i + 1]));
    const double ahead = begins_free ? 0.0 : wheels_.way(before.curvature, segment.curvature) / 2;
    const double behind =
        is_last || is_stop ? 0.0 : wheels_.way(last.curvature, way[i + 1].curvature) / 2;
    const double steady = std::abs(segment.length) - ahead - behind;
    Segment rest = segment;
    if (segment.curvature_rate == 0.0 && steady > 0.0) {
      const Segment head{segment.curvature, last.gear * (ahead + steady / 2)};
      way_.push_back(head);
      cuts_.push_back({way_.size(), advance(pose, head), segment.curvature});
      rest.length -= head.length;
    }
    way_.push_back(rest);
    pose = advance(pose, segment);
    if (is_stop) cuts_.push_back({way_.size(), pose, Driven::any});
    before = last;
  }
  cuts_.push_back({way_.size(), task_.goal, ends_.after.curvature});
}

void Follower::follow(std::span<const Segment> way) {
  cut(way);
  drive_.clear();
  stages_.assign(1, {0, 0, task_.start, ends_.before});
  next_ = 0;
  tried_ = 0;
  left_ = std::numeric_limits<double>::infinity();
  idle_ = 0;
}

std::optional<std::vector<Command>> Follower::drive() const {
  if (left_ > 0.0) return std::nullopt;
  return drive_;
}

/// Length of the blocked segments of commands [m]; any larger number above `most`.
double Follower::blocked(std::span<const Command> commands, LocalPose pose, Driven driven,
                         double most) {
  double sum = 0.0;
  for (const Segment& segment : wheels_.driven(commands, driven)) {
    ++checks_;
    if (!task_.checker->is_free(pose, segment)) sum += std::abs(segment.length);
    if (sum > most) break;
    pose = advance(pose, segment);
  }
  return sum;
}

/// Commands from a stage to a cut; empty if no change of them leads there.
std::vector<Command> Follower::part_between(const Stage& from, const Cut& to) {
  const search::DrivenBeside ends{from.driven, {0, to.curvature}};
  std::vector<Command> part =
      wheels_.commands(std::span(way_).subspan(from.segment, to.segment - from.segment), ends);
  commands::hold_curvatures(part, task_.vehicle.min_turning_radius);
  const bool leads_there =
      !part.empty() && closer_.close({from.pose, 0.0}, part, {to.pose, 0.0}, ends);
  return leads_there ? part : std::vector<Command>{};
}

/// Goes on with a part of the drive from a stage to a cut.
void Follower::take(const Stage& from, std::size_t cut, std::span<const Command> part) {
  Driven driven = from.driven;
  for (const Command& command : part) (void)wheels_.obey(command, driven);
  base::splice(drive_, from.commands, drive_.size(), part);
  while (stages_.back().commands > from.commands) stages_.pop_back();
  const Cut& to = cuts_[cut];
  stages_.push_back({to.segment, drive_.size(), to.pose, driven});
  next_ = cut + 1;
  tried_ = 0;
}

/// Drives to the next cut, from the last stage or from one before, on the part that is blocked
/// least. Goes for a later cut if no commands lead there. False if no cut was reached.
bool Follower::go_on() {
  if (next_ + tried_ == cuts_.size()) return false;
  const std::size_t to = next_ + tried_++;
  double least = std::numeric_limits<double>::infinity();  // blocked length of the best part [m]
  std::vector<Command> best;
  Stage from{};
  for (std::size_t back = 1; back <= std::min(nearby, stages_.size()); ++back) {
    const Stage& stage = stages_[stages_.size() - back];
    std::vector<Command> part = part_between(stage, cuts_[to]);
    if (part.empty()) continue;
    const double length = blocked(part, stage.pose, stage.driven, least);
    if (length >= least) continue;
    least = length;
    best = std::move(part);
    from = stage;
    if (least == 0.0) break;
  }
  if (!best.empty()) take(from, to, best);
  return true;
}

/// Computes poses and blocked lengths of the commands [first, last).
void Follower::measure(std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    blocked_[i] = blocked(std::span(drive_).subspan(i, 1), poses_[i], driven_[i]);
    Driven driven = driven_[i];
    LocalPose pose = poses_[i];
    const commands::Obeyed obeyed = wheels_.obey(drive_[i], driven);
    for (const Segment& segment : obeyed.view()) pose = advance(pose, segment);
    // Poses behind the commands stay as they were.
    if (i + 1 == last && last < drive_.size()) break;
    poses_[i + 1] = pose;
    driven_[i + 1] = driven;
  }
  left_ = std::accumulate(blocked_.begin(), blocked_.end(), 0.0);
}

/// A random range [first, last) of commands around a blocked one.
std::pair<std::size_t, std::size_t> Follower::any_window() {
  std::size_t middle = rng_() % drive_.size();
  while (blocked_[middle] == 0.0) middle = (middle + 1) % drive_.size();
  const std::size_t before = 1 + rng_() % nearby;
  const std::size_t after = 1 + rng_() % nearby;
  return {middle - std::min(middle, before), std::min(middle + 1 + after, drive_.size())};
}

/// Changes some commands at random, and keeps that if no more metres are blocked.
void Follower::shake() {
  const auto [first, last] = any_window();
  const std::span<Command> old = std::span(drive_).subspan(first, last - first);
  std::vector<Command> trial(old.begin(), old.end());
  const double scale = std::exp2(uniform(-6.0, -1.0, rng_));
  const double radius = task_.vehicle.min_turning_radius;
  for (Command& command : trial) {
    const double curvature = command.curvature + scale * uniform(-1.0, 1.0, rng_) / radius;
    command.curvature = std::clamp(curvature, -1 / radius, 1 / radius);
    const double longer = std::abs(command.length) + scale * uniform(-1.0, 1.0, rng_) * radius;
    command.length = gear_of(command) * std::max(longer, std::abs(command.length) / 2);
  }
  const search::DrivenBeside ends = wheels_.ends_of_part(drive_, driven_, first, last, ends_);
  if (!closer_.close({poses_[first], 0.0}, trial, {poses_[last], 0.0}, ends)) return;
  Driven behind = driven_[first];
  for (const Command& command : trial) (void)wheels_.obey(command, behind);
  // A stroke is gone: the wheels may not turn there any more.
  if (behind.gear != driven_[last].gear) return;
  const auto of_window = std::span(blocked_).subspan(first, last - first);
  const double before = std::accumulate(of_window.begin(), of_window.end(), 0.0);
  if (blocked(trial, poses_[first], driven_[first], before) > before) return;
  std::ranges::copy(trial, old.begin());
  const double left_before = left_;
  measure(first, last);
  if (left_ < left_before) idle_ = 0;
}

bool Follower::step() {
  if (next_ < cuts_.size()) {
    if (!go_on()) return false;
    if (next_ < cuts_.size()) return true;
    poses_.assign(drive_.size() + 1, task_.start);
    driven_.assign(drive_.size() + 1, ends_.before);
    blocked_.assign(drive_.size(), 0.0);
    measure(0, drive_.size());
    return true;
  }
  if (left_ == 0.0 || idle_ == max_idle_trials) return false;
  ++idle_;
  shake();
  return true;
}

}  // namespace vandplan::anytime
