// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <optional>

#include "planners/anytime/shorten.h"
#include "planners/anytime/workers.h"

namespace vandplan::anytime {
namespace {

class Refiner final : public Worker {
 public:
  Refiner(const Task& task, const CostRule& rule, std::uint64_t seed)
      : connector_(task, rule), seed_(seed) {}

  [[nodiscard]] bool has_work() const override { return true; }
  [[nodiscard]] Found work(std::int64_t iterations, const Told& told,
                           const Budget& budget) override;
  [[nodiscard]] Counts counts() const override { return counts_of(connector_); }

 private:
  Connector connector_;
  std::uint64_t seed_;
  std::uint64_t routes_ = 0;          // routes refined so far; numbers their seeds
  double best_cost_ = 0.0;            // least cost of all routes that the worker knows
  std::optional<Shortener> refined_;  // shortens the best route; none while there is no route
};

Found Refiner::work(std::int64_t iterations, const Told& told, const Budget& budget) {
  if (told.route != nullptr && (!refined_ || told.route->cost < best_cost_)) {
    best_cost_ = told.route->cost;
    refined_.emplace(connector_, *told.route, stream_seed(seed_, ++routes_));
  }
  const auto step = [this]() -> std::optional<double> {
    refined_->step();  // [5]
    if (refined_->cost() >= best_cost_) return std::nullopt;
    return best_cost_ = refined_->cost();
  };
  Found found = work_in_steps(
      iterations, told.enough, budget, [this] { return refined_.has_value(); }, step);
  if (found.improvements.empty()) return found;
  found.route = refined_->route();
  best_cost_ = found.route->cost;
  return found;
}

}  // namespace

std::unique_ptr<Worker> refiner(const Task& task, const CostRule& rule, std::uint64_t seed) {
  return std::make_unique<Refiner>(task, rule, seed);
}

}  // namespace vandplan::anytime
