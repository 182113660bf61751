// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/cheapest_drive_worker.h"

#include <utility>

namespace vandplan::anytime {
namespace {

CheapestDrive::Measure cost_of_route(const planning::Pricing& pricing) {
  return [&pricing](const Route& route) { return pricing.cost(route); };
}

}  // namespace

CheapestDriveWorker::CheapestDriveWorker(const Task& task, const planning::Pricing& pricing,
                                         bool bends, std::uint64_t seed)
    : cheapest_(task, pricing.rule(), seed, cost_of_route(pricing),
                bends ? pricing.measure() : Bender::Measure{}) {}

// [7b] Makes the cheapest route cheaper, judged by the whole drive.
Found CheapestDriveWorker::work(std::int64_t iterations, const Told& told, const Budget& budget) {
  Found found;
  if (told.best == nullptr) return found;
  const double before = cheapest_.cost();
  cheapest_.offer(*told.best);
  if (cheapest_.cost() < before) {
    found.improvements.push_back({budget.elapsed(), 0, cheapest_.cost()});
  }
  for (Route& route : std::exchange(offers_, {})) cheapest_.offer(std::move(route));
  for (; found.iterations < iterations; ++found.iterations) {
    if (found.iterations % steps_of_look == 0 && budget.is_interrupted()) break;
    if (!cheapest_.step()) continue;
    found.improvements.push_back({budget.elapsed(), found.iterations, cheapest_.cost()});
  }
  found.drive = {.commands = {},
                 .segments = cheapest_.segments(),
                 .route = cheapest_.route(),
                 .cost = cheapest_.cost()};
  return found;
}

}  // namespace vandplan::anytime
