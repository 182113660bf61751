// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/cheapest_drive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vandplan::anytime {

namespace {

/// Shares of the largest curvature rate, in turns. Wheels that turn over a longer way can be turned
/// at a higher speed.
constexpr double sharpnesses[] = {0.5, 0.25, 0.7, 1.0};

constexpr std::uint64_t bending_seeds = 1U << 30;  // seeds above those of shortened routes

}  // namespace

CheapestDrive::CheapestDrive(const Task& task, const CostRule& rule, std::uint64_t seed,
                             Measure measure, const Bender::Measure& measure_of_drive)
    : measure_(std::move(measure)),
      seed_(seed),
      cost_(std::numeric_limits<double>::infinity()),
      bent_cost_(cost_) {
  const double given = std::max(std::abs(task.curvatures.start), std::abs(task.curvatures.goal));
  for (const double sharpness : sharpnesses) {
    Task softer = task;
    softer.vehicle.limits.max_curvature_rate = sharpness * max_curvature_rate(task.vehicle);
    // Slower wheels have a larger least radius. They must reach the curvatures at the ends.
    if (sharpness < 1 && given * continuous_radius(softer.vehicle) > 1) continue;
    const Task& kept = tasks_.emplace_back(std::move(softer));
    const Connector& connector = connectors_.emplace_back(kept, rule);
    if (!measure_of_drive) continue;
    const std::uint64_t bent_seed = stream_seed(seed, bending_seeds + benders_.size());
    benders_.emplace_back(kept, connector.rule(), bent_seed, measure_of_drive);
  }
}

// Goes on with the cheapest route and the next curvature rate.
void CheapestDrive::begin() {
  begin_with(*route_);
  is_challenger_ = false;
}

void CheapestDrive::begin_with(const Route& route) {
  Connector& connector = connectors_[beginnings_ % connectors_.size()];
  shortener_.emplace(connector, route, stream_seed(seed_, ++beginnings_), measure_);
}

bool CheapestDrive::take(Route route) {
  route.cost = measure_(route);
  if (route.cost < guide_leeway * cost_) {
    for (Bender& bender : benders_) bender.offer(route);
  }
  if (route.cost >= cost_) {
    if (route.cost < guide_leeway * cost_) challengers_.push_back(std::move(route));
    return false;
  }
  cost_ = route.cost;
  route_ = std::move(route);
  begin();
  return cost_ < bent_cost_;
}

// Shortens the newest challenger, which may become cheaper than the best route.
void CheapestDrive::challenge() {
  const Route route = std::move(challengers_.back());
  challengers_.pop_back();
  begin_with(route);
  is_challenger_ = true;
  trials_ = 0;
}

// One trial of the next bender. True if it gives the cheapest drive so far.
bool CheapestDrive::bend() {
  const bool is_turn_of_best = bends_ % 2 == 0 && std::isfinite(bent_cost_);
  const std::size_t i = is_turn_of_best ? best_bender_ : bends_ / 2 % benders_.size();
  ++bends_;
  if (!benders_[i].step() || benders_[i].cost() >= cost()) return false;
  bent_cost_ = benders_[i].cost();
  best_bender_ = i;
  return true;
}

std::vector<Segment> CheapestDrive::segments() const {
  if (!(bent_cost_ < cost_)) return path_of(*route_).segments;
  return benders_[best_bender_].segments();
}

bool CheapestDrive::step() {
  if (!shortener_) return false;
  if (!benders_.empty() && ++steps_ % 2 == 0) return bend();
  ++trials_;
  const double excess = shortener_->cost() / cost_ - 1;
  if (shortener_->is_stalled() || (is_challenger_ && excess * trials_ > hopeless)) {
    if (!is_challenger_ && !challengers_.empty()) {
      challenge();
    } else {
      begin();
    }
  }
  if (!shortener_->step() || shortener_->cost() >= cost_) return false;
  is_challenger_ = false;
  route_ = shortener_->route();
  cost_ = route_->cost;
  return cost_ < bent_cost_;
}

Counts CheapestDrive::counts() const {
  Counts sum;
  for (const Connector& connector : connectors_) sum += counts_of(connector);
  for (const Bender& bender : benders_) sum += bender.counts();
  return sum;
}

// [7b] Makes the cheapest route cheaper, judged by the whole drive.
Found CheapestDrive::work(std::int64_t iterations, const Told& told, const Budget& budget) {
  Found found;
  if (told.route == nullptr) return found;
  const double before = cost();
  take(*told.route);
  if (cost() < before) found.improvements.push_back({budget.elapsed(), 0, cost()});
  for (Route& route : std::exchange(offers_, {})) take(std::move(route));
  for (; found.iterations < iterations; ++found.iterations) {
    if (found.iterations % steps_of_look == 0 && budget.is_interrupted()) break;
    if (!step()) continue;
    found.improvements.push_back({budget.elapsed(), found.iterations, cost()});
  }
  found.drive = {.segments = segments(), .route = route_, .cost = cost()};
  return found;
}

}  // namespace vandplan::anytime
