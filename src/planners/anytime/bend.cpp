// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/bend.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "search/wheels.h"

namespace vandplan::anytime {
namespace {

constexpr std::size_t max_challenging = 4;

}  // namespace

Bender::Bender(const Task& task, const CostRule& rule, std::uint64_t seed, Measure measure)
    : task_(task),
      rule_(rule),
      wheels_(task.vehicle, task.steering),
      ends_(driven_at_ends(task)),
      closer_(task.vehicle, task.steering),
      seed_(seed),
      measure_(std::move(measure)),
      follower_(task, ends_, closer_, stream_seed(seed, 1000)),
      known_cost_(std::numeric_limits<double>::infinity()),
      told_cost_(known_cost_) {}

void Bender::offer(const Route& route) {
  has_begun_ = true;
  if (!kinds_.is_new(route, task_.vehicle.min_turning_radius)) return;
  wait({.segments = path_of(route).segments, .cost = route.cost});
}

void Bender::offer_path(std::vector<Segment> segments, double cost) {
  has_begun_ = true;
  wait({.segments = std::move(segments), .cost = cost});
}

std::optional<Drive> Bender::begin_with(const Path& known) {
  offer_path(known.segments);
  if (!step()) return std::nullopt;
  known_cost_ = cost();
  return best();
}

/// Lets a route wait so that the cheapest is next: following a dear one may take long and be in
/// vain.
void Bender::wait(Drive route) {
  const auto is_dearer = [](const Drive& a, const Drive& b) { return a.cost > b.cost; };
  waiting_.insert(std::ranges::upper_bound(waiting_, route, is_dearer), std::move(route));
}

std::vector<Segment> Bender::segments() const {
  commands::DriveShortener neat = *best_;
  neat.drop_crumbs();
  return neat.segments();
}

std::int64_t Bender::checks() const {
  std::int64_t sum = checks_ + follower_.checks() + (best_ ? best_->checks() : 0);
  for (const auto& challenger : challengers_) sum += challenger->checks();
  return sum;
}

/// Makes a challenger that drives along the segments. True if there is one.
bool Bender::drive_along(std::span<const Segment> segments) {
  const auto drive = commands::commands_along(task_, segments);
  ++checks_;
  if (drive) add(*drive);
  return drive.has_value();
}

/// Doubt of a challenger: its relative excess over the best drive, times its trials.
double Bender::doubt(const commands::DriveShortener& challenger) const {
  if (!best_) return 0.0;
  const double excess = challenger.cost() / best_->cost() - 1.0;
  return excess * static_cast<double>(challenger.trials());
}

void Bender::drop(std::size_t i) {
  checks_ += challengers_[i]->checks();
  challengers_.erase(challengers_.begin() + static_cast<std::ptrdiff_t>(i));
}

/// Makes challenger `i` the best drive if it is cheaper. True if so.
bool Bender::challenge(std::size_t i) {
  if (best_ && challengers_[i]->cost() >= best_->cost()) return false;
  if (best_) checks_ += best_->checks();
  best_ = std::move(challengers_[i]);
  challengers_.erase(challengers_.begin() + static_cast<std::ptrdiff_t>(i));
  return true;
}

void Bender::add(std::span<const commands::Command> drive) {
  if (challengers_.size() == max_challenging) {
    std::size_t worst = 0;
    for (std::size_t i = 1; i < challengers_.size(); ++i) {
      if (doubt(*challengers_[i]) > doubt(*challengers_[worst])) worst = i;
    }
    drop(worst);
  }
  challengers_.push_back(std::make_unique<commands::DriveShortener>(
      task_, rule_, drive, stream_seed(seed_, drives_++), measure_));
}

/// Makes a drive of the next waiting route. True if it is cheaper than the best drive.
bool Bender::begin() {
  const Drive route = std::move(waiting_.back());
  waiting_.pop_back();
  if (drive_along(route.segments)) return challenge(challengers_.size() - 1);
  // Following is not worth it for a path that may be blocked, nor if the wheels turn at once.
  if (route.cost == std::numeric_limits<double>::infinity() || wheels_.are_free()) return false;
  follower_.follow(route.segments);
  followed_cost_ = route.cost;
  is_following_ = true;
  return false;
}

/// Goes on following a route. True if that ends with a drive cheaper than the best drive.
bool Bender::follow() {
  if (follower_.step()) return false;
  is_following_ = false;
  const auto drive = follower_.drive();
  if (!drive) return false;
  add(*drive);
  return challenge(challengers_.size() - 1);
}

/// Index of the challenger with the least doubt; the newest of equal ones.
std::size_t Bender::next_challenger() const {
  std::size_t next = challengers_.size() - 1;
  for (std::size_t i = next; i-- > 0;) {
    if (doubt(*challengers_[i]) < doubt(*challengers_[next])) next = i;
  }
  return next;
}

bool Bender::step() {
  if (!waiting_.empty() && !is_following_) return begin();
  if (is_following_ && best_ && followed_cost_ < best_->cost()) return follow();
  is_turn_of_best_ = !is_turn_of_best_;
  if (best_ && is_turn_of_best_) return best_->step();
  if (is_following_) return follow();
  if (challengers_.empty()) return best_ && best_->step();
  const std::size_t i = next_challenger();
  (void)challengers_[i]->step();
  if (challenge(i)) return true;
  if (challengers_[i]->is_stalled() || doubt(*challengers_[i]) > hopeless) drop(i);
  return false;
}

Found Bender::work(std::int64_t iterations, const Told& told, const Budget& budget) {
  if (iterations > 0) has_begun_ = true;
  if (told.route != nullptr) {
    known_cost_ = std::min(known_cost_, told.route->cost);
    if (has_begun_ && told.route->cost < told_cost_) {
      told_cost_ = told.route->cost;
      offer(*told.route);
    }
  }
  const auto trial = [this]() -> std::optional<double> {
    if (!step() || cost() >= known_cost_) return std::nullopt;
    return known_cost_ = cost();
  };
  Found found = work_in_steps(
      iterations, told.enough, budget, [this] { return has_work(); }, trial);
  if (!found.improvements.empty()) found.drive = best();
  return found;
}

}  // namespace vandplan::anytime
