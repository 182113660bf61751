// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/refiner.h"

namespace vandplan::anytime {

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

}  // namespace vandplan::anytime
