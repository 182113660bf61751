// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/fastest_worker.h"

#include <span>
#include <utility>

namespace vandplan::anytime {
namespace {

Fastest::Measure cost_of_route(const planning::Pricing& pricing) {
  return [&pricing](const Route& route) {
    double clearance_cost = 0.0;
    for (const Leg& leg : route.legs) clearance_cost += leg.clearance_cost;
    return pricing.cost(path_of(route).segments, clearance_cost);
  };
}

Bender::Measure cost_of_drive(const planning::Pricing& pricing) {
  return [&pricing](std::span<const Segment> segments) { return pricing.cost(segments, 0.0); };
}

}  // namespace

FastestWorker::FastestWorker(const Task& task, const planning::Pricing& pricing, bool bends,
                             std::uint64_t seed)
    : fastest_(task, pricing.rule(), seed, cost_of_route(pricing),
               bends ? cost_of_drive(pricing) : Bender::Measure{}) {}

// [8b] Makes the cheapest route cheaper, judged by the whole drive.
Found FastestWorker::work(std::int64_t iterations, const Told& told, const Budget& budget) {
  Found found;
  if (told.best == nullptr) return found;
  const double before = fastest_.cost();
  fastest_.offer(*told.best);
  if (fastest_.cost() < before) {
    found.improvements.push_back({budget.elapsed(), 0, fastest_.cost()});
  }
  for (Route& route : std::exchange(offers_, {})) fastest_.offer(std::move(route));
  for (; found.iterations < iterations; ++found.iterations) {
    if (found.iterations % steps_of_look == 0 && budget.is_interrupted()) break;
    if (!fastest_.step()) continue;
    found.improvements.push_back({budget.elapsed(), found.iterations, fastest_.cost()});
  }
  found.drive = {.commands = {},
                 .segments = fastest_.segments(),
                 .route = fastest_.route(),
                 .cost = fastest_.cost()};
  return found;
}

}  // namespace vandplan::anytime
