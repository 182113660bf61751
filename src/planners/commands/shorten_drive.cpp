// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/commands/shorten_drive.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/splice.h"
#include "search/route.h"

namespace vandplan::commands {
namespace {

constexpr int patience = 600;                        // trials without progress that stall a drive
constexpr std::size_t most_segments_of_window = 10;  // commands of a random window
constexpr std::size_t reach = 3;           // commands on either side that make up for one left out
constexpr double swept_gain = 0.01;        // least relative gain of a command left out by a sweep
constexpr std::size_t reach_of_sweep = 2;  // commands on either side that a sweep changes

double sum(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

template <class T>
bool are_equal(std::span<const T> a, std::span<const T> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace

DriveShortener::DriveShortener(const Task& task, const search::CostRule& rule,
                               std::span<const Command> commands, std::uint64_t seed,
                               Measure measure)
    : task_(task),
      rule_(rule),
      measure_(std::move(measure)),
      wheels_(task.vehicle, task.steering),
      ends_(search::driven_at_ends(task)),
      closer_(task.vehicle, task.steering),
      crumb_(crumb_length(task.vehicle.min_turning_radius)),
      commands_(wheels_.tidied(commands, ends_.before)),
      rng_(seed) {
  drive({});
  progress_cost_ = cost_;
}

bool DriveShortener::is_stalled() const { return idle_ > patience; }

/// Computes states and costs along the commands. `near`: known clearance costs of all commands, or
/// empty.
void DriveShortener::drive(std::vector<double> near) {
  const bool is_known = near.size() == commands_.size();
  driving_ = {.states = {start_state(task_)},
              .driven = {ends_.before},
              .prices = {},
              .near = std::move(near)};
  if (!is_known) driving_.near.clear();
  search::Driven priced = rule_.initial_gear;
  for (const Command& command : commands_) {
    State state = driving_.states.back();
    search::Driven driven = driving_.driven.back();
    const Obeyed obeyed = wheels_.obey(command, driven);
    driving_.prices.push_back(search::drive_cost(rule_, obeyed.view(), priced));
    if (!is_known) driving_.near.push_back(near_cost(state, obeyed.view(), 1e300));
    for (const Segment& segment : obeyed.view()) {
      state = {advance(state.pose, segment),
               hitch_angle_after(task_.vehicle, state.hitch_angle, segment)};
    }
    driving_.states.push_back(state);
    driving_.driven.push_back(driven);
  }
  if (!commands_.empty()) {
    driving_.prices.back() += search::change_cost(rule_, priced, rule_.final_gear);
  }
  cost_ = measure_ ? measure_(segments()) : sum(driving_.prices) + sum(driving_.near);
  // The exact state at the end keeps small errors from adding up.
  driving_.states.back() = goal_state(task_);
}

/// Clearance cost of segments; above `cutoff` it is any number above it. 0 with a measure, which
/// includes clearance.
double DriveShortener::near_cost(const State& from, std::span<const Segment> segments,
                                 double cutoff) const {
  if (measure_) return 0.0;
  return search::clearance_cost(task_, rule_, Local(from), segments,
                                search::ClearanceSampling::search, cutoff);
}

/// A random window; small ones are more frequent.
DriveShortener::Window DriveShortener::any_window() {
  const std::size_t count = commands_.size();
  const std::size_t most = std::min(count, most_segments_of_window);
  const std::size_t least = std::min<std::size_t>(count, 3);
  const auto more = [&] { return static_cast<std::size_t>(rng_() % (most - least + 1)); };
  const std::size_t size = least + std::min(more(), more());
  const std::size_t first = static_cast<std::size_t>(rng_() % (count - size + 1));
  return {first, first + size};
}

/// Random relative size of what a trial changes.
double DriveShortener::any_size() { return size_ * std::exp2(uniform(-3.0, 2.0, rng_)); }

/// Changes lengths and curvatures of some commands of the trial.
void DriveShortener::shake(const Window& window) {
  const double size = any_size();
  const double sharpest = 1 / task_.vehicle.min_turning_radius;
  const double some = uniform(0.2, 1.0, rng_);
  const double shrink = uniform(0.0, 1.0, rng_);
  for (std::size_t i = window.first; i < window.last; ++i) {
    Command& command = trial_[i - window.first];
    if (uniform01(rng_) > some) continue;
    command.length *= std::max(0.0, 1 + size * (uniform(-1.0, 1.0, rng_) - shrink));
    command.curvature = std::clamp(command.curvature + size * sharpest * uniform(-1.0, 1.0, rng_),
                                   -sharpest, sharpest);
  }
}

/// Leaves one command of the trial out, or two, mostly around a gear change.
void DriveShortener::leave_out(const Window& window) {
  const std::size_t size = window.last - window.first;
  if (size < 3) return;
  const auto at = static_cast<std::ptrdiff_t>(rng_() % (size - 1));
  const bool is_cusp = trial_[static_cast<std::size_t>(at)].length *
                           trial_[static_cast<std::size_t>(at) + 1].length <
                       0.0;
  const bool both = size > 3 && (is_cusp || uniform01(rng_) < 0.3);
  trial_.erase(trial_.begin() + at, trial_.begin() + at + (both ? 2 : 1));
}

/// Splits a command of the trial in two with curvatures a little apart.
void DriveShortener::split(const Window& window) {
  const std::size_t size = window.last - window.first;
  const std::size_t at = static_cast<std::size_t>(rng_() % size);
  const double part = uniform01(rng_);
  const double sharpest = 1 / task_.vehicle.min_turning_radius;
  const double apart = any_size() * sharpest * (uniform01(rng_) < 0.5 ? -1 : 1);
  Command& first = trial_[at];
  Command second = first;
  first.length *= part;
  first.curvature = std::clamp(first.curvature - apart * (1 - part), -sharpest, sharpest);
  second.length *= 1 - part;
  second.curvature = std::clamp(second.curvature + apart * part, -sharpest, sharpest);
  trial_.insert(trial_.begin() + static_cast<std::ptrdiff_t>(at) + 1, second);
}

/// Changes the trial so that it ends where the window ends. False if that fails.
bool DriveShortener::closes(const Window& window) {
  return closer_.close(
      driving_.states[window.first], trial_, driving_.states[window.last],
      wheels_.ends_of_part(commands_, driving_.driven, window.first, window.last, ends_));
}

/// Computes gears, segments and costs of the trial, and of the command behind it.
void DriveShortener::price_trial(const Window& window) {
  search::Driven driven = driving_.driven[window.first];
  search::Driven priced = window.first == 0 ? search::Driven(rule_.initial_gear) : driven;
  tried_.driven.assign(1, driven);
  tried_.prices.clear();
  segments_.clear();
  segments_at_.clear();
  for (const Command& command : trial_) {
    const Obeyed obeyed = wheels_.obey(command, driven);
    tried_.prices.push_back(search::drive_cost(rule_, obeyed.view(), priced));
    tried_.driven.push_back(driven);
    segments_.insert(segments_.end(), obeyed.view().begin(), obeyed.view().end());
    segments_at_.push_back(obeyed.count);
  }
  goes_on_ = true;
  if (window.last == commands_.size()) {
    const double change = search::change_cost(rule_, priced, rule_.final_gear);
    if (!trial_.empty()) tried_.prices.back() += change;
    return;
  }
  const Command& next = commands_[window.last];
  search::Driven as_ever = driving_.driven[window.last];
  const Obeyed obeyed = wheels_.obey(next, driven);
  const Obeyed as_before = wheels_.obey(next, as_ever);
  goes_on_ = are_equal(obeyed.view(), as_before.view());
  next_price_ = search::drive_cost(rule_, obeyed.view(), priced);
}

/// Most clearance cost of the trial for which the drive costs less than `limit`.
double DriveShortener::left_for_near(const Window& window, double limit) const {
  double left = limit * (1 - search::rounding_of_cost) - cost_ - sum(tried_.prices);
  for (std::size_t i = window.first; i < window.last; ++i) {
    left += driving_.prices[i] + driving_.near[i];
  }
  if (window.last < commands_.size()) left += driving_.prices[window.last] - next_price_;
  return left;
}

/// Computes clearance costs of the trial. False if they are not below `left`.
bool DriveShortener::looks_at_near(const Window& window, double left) {
  tried_.states.clear();
  tried_.near.clear();
  std::span<const Segment> segments = segments_;
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    tried_.states.push_back(i == 0 ? driving_.states[window.first] : closer_.state_before(i));
    tried_.near.push_back(near_cost(tried_.states[i], segments.first(segments_at_[i]), left));
    segments = segments.subspan(segments_at_[i]);
    left -= tried_.near.back();
    if (!measure_ && !(left > 0.0)) return false;
  }
  tried_.states.push_back(driving_.states[window.last]);
  return true;
}

/// Replaces the window by the trial if that is free and the drive then costs less than `limit`.
/// Without a trailer, states elsewhere stay, as the trial ends where the window does: hundreds of
/// trials add up to less than a micrometre. With a trailer errors grow on the way, so the whole
/// chain is closed.
bool DriveShortener::replace(const Window& window, double limit) {
  const auto is_cheap = [&] { return measure_ || left_for_near(window, limit) > 0.0; };
  price_trial(window);
  if (!is_cheap()) return false;
  const std::size_t size = trial_.size();
  trial_ = wheels_.tidied(trial_, driving_.driven[window.first]);
  if (trial_.size() != size) {
    if (trial_.empty() || !closes(window)) return false;
    price_trial(window);
    if (!is_cheap()) return false;
  }
  checks_ += static_cast<std::int64_t>(trial_.size());
  if (!task_.checker->is_free(Local(driving_.states[window.first]), segments_)) return false;
  if (!looks_at_near(window, left_for_near(window, limit))) return false;
  const auto [first, last] = window;
  if (measure_ || task_.vehicle.trailer || !goes_on_) {
    std::vector<Command> whole = commands_;
    std::vector<double> near = driving_.near;
    base::splice(whole, first, last, trial_);
    base::splice(near, first, last, tried_.near);
    return settle(std::move(whole), std::move(near), limit);
  }
  if (last < commands_.size()) driving_.prices[last] = next_price_;
  base::splice(commands_, first, last, trial_);
  base::splice(driving_.states, first, last + 1, tried_.states);
  base::splice(driving_.driven, first, last + 1, tried_.driven);
  base::splice(driving_.prices, first, last, tried_.prices);
  base::splice(driving_.near, first, last, tried_.near);
  cost_ = sum(driving_.prices) + sum(driving_.near);
  return true;
}

/// Closes a whole chain and takes it if it is free and costs less than `limit`.
bool DriveShortener::settle(std::vector<Command> whole, std::vector<double> near, double limit) {
  const LocalState from = start_state(task_);
  const State to = goal_state(task_);
  whole = wheels_.tidied(whole, ends_.before);
  if (!closer_.close(from, whole, to, ends_)) return false;
  const std::vector<Segment> driven = wheels_.driven(whole, ends_.before);
  if (measure_ && !(measure_(driven) < limit)) return false;
  if (!task_.checker->is_free(from, driven)) return false;
  const double cost = cost_;
  Driving as_ever = driving_;
  std::swap(commands_, whole);
  drive(goes_on_ ? std::move(near) : std::vector<double>{});
  if (cost_ < limit) return true;
  commands_ = std::move(whole);  // too dear: behind the trial the wheels turn in another way
  driving_ = std::move(as_ever);
  cost_ = cost;
  return false;
}

/// Puts the trial in place of the window if it can be closed, is free, has no more crumbs, and the
/// drive costs less than `limit` then.
bool DriveShortener::try_trial(const Window& window, double limit) {
  return closes(window) && more_crumbs(window) <= 0 && replace(window, limit);
}

bool DriveShortener::step() {
  ++trials_;
  ++idle_;
  if (commands_.empty()) return false;
  const bool is_better = sweeps() ? sweep() : try_anything();
  if (cost_ < progress_cost_ * (1 - search::progress)) {
    progress_cost_ = cost_;
    idle_ = 0;
  }
  return is_better;
}

/// Whether the sweep goes on: some command was not left out in vain yet.
bool DriveShortener::sweeps() const { return commands_.size() > 3 && in_vain_ < commands_.size(); }

/// Leaves the next command out, if that gains much. A fresh drive is crooked, and no other trial
/// gains as much in as little time.
bool DriveShortener::sweep() {
  if (swept_ >= commands_.size()) swept_ = 0;
  const Window window{swept_ - std::min(swept_, reach_of_sweep),
                      std::min(commands_.size(), swept_ + 1 + reach_of_sweep)};
  const std::span<const Command> old = in(window);
  trial_.assign(old.begin(), old.end());
  trial_.erase(trial_.begin() + static_cast<std::ptrdiff_t>(swept_ - window.first));
  const bool is_better = try_trial(window, cost_ * (1 - swept_gain));
  in_vain_ = is_better ? 0 : in_vain_ + 1;
  if (!is_better) ++swept_;
  return is_better;
}

/// Changes some commands at random.
bool DriveShortener::try_anything() {
  const Window window = any_window();
  const std::span<const Command> old = in(window);
  trial_.assign(old.begin(), old.end());
  const double kind = uniform01(rng_);
  const bool leaves_out = kind > 0.8;
  if (leaves_out) {
    leave_out(window);
  } else if (kind < 0.15) {
    split(window);
  } else {
    shake(window);
  }
  if (trial_.size() < 2 || are_equal<Command>(trial_, old)) return false;
  const bool is_better = try_trial(window, cost_);
  if (!leaves_out) size_ = std::clamp(size_ * (is_better ? 1.3 : 0.99), 0.02, 1.0);
  return is_better;
}

/// Number of segments shorter than a crumb in the trial, less that in the window.
int DriveShortener::more_crumbs(const Window& window) const {
  const auto crumbs = [&](std::span<const Command> commands) {
    search::Driven driven = driving_.driven[window.first];
    int count = 0;
    for (const Command& command : commands) {
      const Obeyed obeyed = wheels_.obey(command, driven);
      for (const Segment& segment : obeyed.view()) count += std::abs(segment.length) < crumb_;
    }
    return count;
  };
  return crumbs(trial_) - crumbs(in(window));
}

/// Joins command `i` with the one before it, or leaves it out. True if that is free, adds no crumbs
/// and costs less than `limit`.
bool DriveShortener::drop(std::size_t i, double limit) {
  const Window window{i - std::min(i, reach), std::min(commands_.size(), i + 1 + reach)};
  for (const bool joins : {true, false}) {
    const std::span<const Command> old = in(window);
    trial_.assign(old.begin(), old.end());
    const auto at = trial_.begin() + static_cast<std::ptrdiff_t>(i - window.first);
    if (joins) {
      if (at == trial_.begin() || at->length * (at - 1)->length < 0.0) continue;
      Command& before = *(at - 1);
      const double whole = before.length + at->length;
      before = {std::lerp(before.curvature, at->curvature, at->length / whole), whole};
    }
    trial_.erase(at);
    if (!trial_.empty() && try_trial(window, limit)) return true;
  }
  return false;
}

// Leaves out crumbs, the shortest first, until none can go.
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
