// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/commands/shorten_drive.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vandplan::commands {
namespace {

constexpr double progress = 1e-3;  // relative, that is worth the name
constexpr int patience = 600;      // trials without it
constexpr std::size_t most_segments_of_window = 10;
constexpr std::size_t reach = 3;      // commands on either side that make up for one left out
constexpr double crumb_slack = 1e-4;  // of the cost: 1 cm of 100 m, less than any search leaves

}  // namespace

DriveShortener::DriveShortener(const Task& task, const search::CostRule& rule,
                               std::vector<Segment> commands, std::uint64_t seed, Measure measure)
    : task_(task),
      rule_(rule),
      measure_(std::move(measure)),
      wheels_(task.vehicle, task.steering),
      ends_(wheel_ends(task)),
      closer_(task.vehicle, task.steering),
      crumb_(crumb_length(task.vehicle.min_turning_radius)),
      commands_(std::move(commands)),
      rng_(seed) {
  drive();
  progress_cost_ = cost_;
}

bool DriveShortener::is_stalled() const { return idle_ > patience; }

/// What is near the first `head` commands and the last `tail` ones is as it was.
void DriveShortener::drive(std::size_t head, std::size_t tail) {
  states_.assign(1, {task_.start, task_.hitch_angles.start});
  driven_.assign(1, ends_.before);
  const std::vector<double> known = std::exchange(near_, {});
  cost_ = 0.0;
  search::Driven priced = rule_.initial_gear;
  for (const Segment& command : commands_) {
    RigState state = states_.back();
    search::Driven driven = driven_.back();
    const Obeyed obeyed = wheels_.obey(command, driven);
    cost_ += search::drive_cost(rule_, obeyed.view(), priced);
    const std::size_t i = near_.size();
    const std::size_t left = commands_.size() - i;
    near_.push_back(i < head       ? known[i]
                    : left <= tail ? known[known.size() - left]
                                   : near_cost(state, obeyed.view(), 1e300));
    for (const Segment& segment : obeyed.view()) {
      state = {advance(state.pose, segment),
               hitch_angle_after(task_.vehicle, state.hitch_angle, segment)};
    }
    states_.push_back(state);
    driven_.push_back(driven);
  }
  for (const double near : near_) cost_ += near;
  if (measure_) cost_ = measure_(segments());
  // So that small errors do not add up.
  states_.back() = {task_.goal, task_.hitch_angles.goal};
}

/// What being near things adds, at most `cutoff` or something above it; another measure knows.
double DriveShortener::near_cost(const RigState& from, std::span<const Segment> segments,
                                 double cutoff) const {
  if (measure_) return 0.0;
  return search::rig_clearance_cost(task_, rule_, from, segments, search::Looks::search, cutoff);
}

DriveShortener::Window DriveShortener::any_window() {
  const std::size_t count = commands_.size();
  const std::size_t most = std::min(count, most_segments_of_window);
  const std::size_t least = std::min<std::size_t>(count, 3);
  const std::size_t size = least + static_cast<std::size_t>(rng_() % (most - least + 1));
  const std::size_t first = static_cast<std::size_t>(rng_() % (count - size + 1));
  return {first, first + size};
}

/// Every length a little less or more, every curvature another one.
void DriveShortener::shake(const Window& window) {
  const double size = size_ * std::exp2(uniform(-4.0, 1.0, rng_));
  const double sharpest = 1 / task_.vehicle.min_turning_radius;
  const double some = uniform(0.2, 1.0, rng_);
  const double shrink = uniform(0.0, 1.0, rng_);
  for (std::size_t i = window.first; i < window.last; ++i) {
    Segment& segment = trial_[i - window.first];
    if (uniform01(rng_) > some) continue;
    segment.length *= std::max(0.0, 1 + size * (uniform(-1.0, 1.0, rng_) - shrink));
    segment.curvature = std::clamp(segment.curvature + size * sharpest * uniform(-1.0, 1.0, rng_),
                                   -sharpest, sharpest);
  }
}

/// One segment less, or two around a gear change.
void DriveShortener::leave_out(const Window& window) {
  const std::size_t size = window.last - window.first;
  if (size < 4) return;
  const auto at = static_cast<std::ptrdiff_t>(rng_() % (size - 1));
  const bool is_cusp = trial_[static_cast<std::size_t>(at)].length *
                           trial_[static_cast<std::size_t>(at) + 1].length <
                       0.0;
  const bool both = is_cusp || uniform01(rng_) < 0.3;
  trial_.erase(trial_.begin() + at, trial_.begin() + at + (both ? 2 : 1));
}

/// One segment in two parts, so that its curvature may change on the way.
void DriveShortener::split(const Window& window) {
  const std::size_t size = window.last - window.first;
  const std::size_t at = static_cast<std::size_t>(rng_() % size);
  const double part = uniform(0.2, 0.8, rng_);
  Segment second = trial_[at];
  second.length *= 1 - part;
  trial_[at].length *= part;
  trial_.insert(trial_.begin() + static_cast<std::ptrdiff_t>(at) + 1, second);
}

/// The wheels at both ends of a window. Where the vehicle rolls on they stay as they are, for the
/// sake of what comes next.
WheelEnds DriveShortener::ends_of(const Window& window) const {
  WheelEnds ends{driven_[window.first], {}};
  const search::Driven& last = driven_[window.last];
  if (window.last == commands_.size()) {
    ends.after = ends_.after;
  } else if (!wheels_.may_jump(last, search::gear_of(commands_[window.last]))) {
    ends.after = last.curvature;
  }
  return ends;
}

/// Puts the trial in place of the window if it is free and the drive costs less than `limit` then.
/// What is near elsewhere stays.
bool DriveShortener::replace(const Window& window, double limit) {
  std::vector<Segment> whole(commands_.begin(),
                             commands_.begin() + static_cast<std::ptrdiff_t>(window.first));
  whole.insert(whole.end(), trial_.begin(), trial_.end());
  whole.insert(whole.end(), commands_.begin() + static_cast<std::ptrdiff_t>(window.last),
               commands_.end());
  const std::vector<Segment> driven = wheels_.driven(whole, ends_.before);
  double left = limit;
  if (!measure_) {
    search::Driven priced = rule_.initial_gear;
    left -= search::drive_cost(rule_, driven, priced);
    for (std::size_t i = 0; i < commands_.size(); ++i) {
      if (i < window.first || i >= window.last) left -= near_[i];
    }
  }
  if (!(left > 0.0)) return false;
  checks_ += static_cast<std::int64_t>(trial_.size());
  const std::vector<Segment> segments = wheels_.driven(trial_, driven_[window.first]);
  if (!task_.checker->rig_is_free(states_[window.first], segments)) return false;
  if (measure_ && !(measure_(driven) < left)) return false;
  if (!(near_cost(states_[window.first], segments, left) < left)) return false;
  whole = wheels_.tidied(whole, ends_.before);
  const RigState from{task_.start, task_.hitch_angles.start};
  const RigState to{task_.goal, task_.hitch_angles.goal};
  if (!closer_.close(from, whole, to, ends_)) return false;
  if (!task_.checker->rig_is_free(from, wheels_.driven(whole, ends_.before))) return false;
  const std::size_t tail = commands_.size() - window.last;
  const bool is_as_long = whole.size() == window.first + trial_.size() + tail;  // none is joined
  std::swap(commands_, whole);
  drive(is_as_long ? window.first : 0, is_as_long ? tail : 0);
  if (cost_ < limit) return true;
  commands_ = std::move(whole);  // the wheels turn in another way without what was left out
  drive();
  return false;
}

bool DriveShortener::step() {
  ++idle_;
  if (commands_.empty()) return false;
  const Window window = any_window();
  const std::span<const Segment> old = in(window);
  trial_.assign(old.begin(), old.end());
  const double kind = uniform01(rng_);
  if (kind < 0.15) split(window);
  if (kind > 0.8) {
    leave_out(window);
  } else if (kind < 0.15) {
    shake({window.first, window.last + 1});
  } else {
    shake(window);
  }
  if (trial_.size() < 2) return false;
  const bool is_closed =
      closer_.close(states_[window.first], trial_, states_[window.last], ends_of(window));
  const bool is_better = is_closed && more_crumbs(window) <= 0 && replace(window, cost_);
  size_ = std::clamp(size_ * (is_better ? 1.3 : 0.99), 0.02, 1.0);
  if (cost_ < progress_cost_ * (1 - progress)) {
    progress_cost_ = cost_;
    idle_ = 0;
  }
  return is_better;
}

/// How many more segments shorter than a crumb are driven in the trial than in the window.
int DriveShortener::more_crumbs(const Window& window) const {
  const auto crumbs = [&](std::span<const Segment> commands) {
    search::Driven driven = driven_[window.first];
    int count = 0;
    for (const Segment& command : commands) {
      const Obeyed obeyed = wheels_.obey(command, driven);
      for (const Segment& segment : obeyed.view()) count += std::abs(segment.length) < crumb_;
    }
    return count;
  };
  return crumbs(trial_) - crumbs(in(window));
}

/// Joins command `i` and the one before it, or leaves it out, if that leaves no more crumbs.
bool DriveShortener::drop(std::size_t i, double limit) {
  const Window window{i - std::min(i, reach), std::min(commands_.size(), i + 1 + reach)};
  for (const bool joins : {true, false}) {
    const std::span<const Segment> old = in(window);
    trial_.assign(old.begin(), old.end());
    const auto at = trial_.begin() + static_cast<std::ptrdiff_t>(i - window.first);
    if (joins) {
      if (at == trial_.begin() || at->length * (at - 1)->length < 0.0) continue;
      Segment& before = *(at - 1);
      const double whole = before.length + at->length;
      before = {std::lerp(before.curvature, at->curvature, at->length / whole), whole};
    }
    trial_.erase(at);
    const bool is_closed = !trial_.empty() && closer_.close(states_[window.first], trial_,
                                                            states_[window.last], ends_of(window));
    if (is_closed && more_crumbs(window) <= 0 && replace(window, limit)) return true;
  }
  return false;
}

// The shortest one first, until none can go.
void DriveShortener::drop_crumbs() {
  const double limit = (1 + crumb_slack) * cost_;
  bool dropped = true;
  while (dropped) {
    std::vector<std::pair<double, std::size_t>> crumbs;
    search::Driven driven = ends_.before;
    for (std::size_t i = 0; i < commands_.size(); ++i) {
      double shortest = crumb_;
      const Obeyed obeyed = wheels_.obey(commands_[i], driven);
      for (const Segment& segment : obeyed.view()) {
        shortest = std::min(shortest, std::abs(segment.length));
      }
      if (shortest < crumb_) crumbs.push_back({shortest, i});
    }
    std::ranges::sort(crumbs);
    dropped = std::ranges::any_of(
        crumbs, [&](const auto& shortest) { return drop(shortest.second, limit); });
  }
}

}  // namespace vandplan::commands
