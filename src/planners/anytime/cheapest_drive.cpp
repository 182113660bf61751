// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "planners/anytime/bend.h"
#include "planners/anytime/shorten.h"
#include "planners/anytime/workers.h"

namespace vandplan::anytime {
namespace {

/// Shares of the largest curvature rate, in turns. Wheels that turn over a longer way can be turned
/// at a higher speed.
constexpr double sharpnesses[] = {0.5, 0.25, 0.7, 1.0};

constexpr std::uint64_t bending_seeds = 1U << 30;  // seeds above those of shortened routes

class CheapestDrive final : public Worker {
 public:
  CheapestDrive(const Task& task, const CostRule& rule, std::uint64_t seed,
                std::function<double(const Route&)> measure,
                const Bender::Measure& measure_of_drive);

  [[nodiscard]] bool has_work() const override { return true; }
  [[nodiscard]] Found work(std::int64_t iterations, const Told& told,
                           const Budget& budget) override;
  /// Keeps a route for the next round, where it comes after the best route.
  void offer(const Route& route) override { offers_.push_back(route); }
  [[nodiscard]] Counts counts() const override;

 private:
  void take(Route route);
  bool step();
  /// Segments of the cheapest drive: along the route, or bent if that is cheaper.
  [[nodiscard]] std::vector<Segment> segments() const;
  /// Cost of the cheapest drive by the measure; infinity while there is no route.
  [[nodiscard]] double cost() const { return std::min(cost_, bent_cost_); }
  void begin();
  void begin_with(const Route& route);
  void challenge();
  bool bend();

  std::function<double(const Route&)> measure_;
  std::deque<Task> tasks_;            // copies of the task with different curvature rates
  std::deque<Connector> connectors_;  // one connector for each of `tasks_`
  std::deque<Bender> benders_;        // one bender for each of `tasks_`, if drives are bent
  std::uint64_t seed_;
  std::uint64_t beginnings_ = 0;  // shortened routes so far; numbers their seeds
  std::optional<Route> route_;    // cheapest route
  double cost_;                   // cost of the cheapest route
  std::size_t bends_ = 0;         // trials of bending so far
  std::size_t best_bender_ = 0;   // index of the bender with the cheapest bent drive
  double bent_cost_;              // cost of the cheapest bent drive
  int steps_ = 0;                 // trials so far
  std::vector<Route> offers_;     // routes for the next round
  std::optional<Shortener> shortener_;
  std::vector<Route> challengers_;  // dearer routes that may become the cheapest, the newest last
  bool is_challenger_ = false;      // whether the shortener works on a challenger
  int trials_ = 0;                  // trials spent on the challenger
};

CheapestDrive::CheapestDrive(const Task& task, const CostRule& rule, std::uint64_t seed,
                             std::function<double(const Route&)> measure,
                             const Bender::Measure& measure_of_drive)
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

// Takes a route over if it is cheaper than the one so far. A route that is a little dearer is kept
// and shortened later.
void CheapestDrive::take(Route route) {
  route.cost = measure_(route);
  if (route.cost < guide_leeway * cost_) {
    for (Bender& bender : benders_) bender.offer(route);
  }
  if (route.cost >= cost_) {
    if (route.cost < guide_leeway * cost_) challengers_.push_back(std::move(route));
    return;
  }
  cost_ = route.cost;
  route_ = std::move(route);
  begin();
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

// One trial to make the drive cheaper by the measure. True if the cheapest drive got cheaper.
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

}  // namespace

std::unique_ptr<Worker> cheapest_drive(const Task& task, const CostRule& rule, std::uint64_t seed,
                                       std::function<double(const Route&)> measure,
                                       const Bender::Measure& measure_of_drive) {
  return std::make_unique<CheapestDrive>(task, rule, seed, std::move(measure), measure_of_drive);
}

}  // namespace vandplan::anytime
