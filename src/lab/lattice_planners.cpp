// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/lattice_planners.h"

#include "lab/lattice_a_star.h"
#include "lab/ltba_star.h"

namespace vandplan::lattice {
namespace {

/// A planner over a lattice. LTBA* cannot honour gears: its vehicle drives while the search goes
/// on, and backs out of a way that was wrong.
Planner planner(const char* name, const char* summary, std::vector<OptionInfo> options,
                PlannerAnswer (*function)(const Task&, const PlanOptions&)) {
  Capabilities capabilities = {Capability::primitives};
  if (function != plan_ltba_star) capabilities.add(Capability::gears);
  return {.name = name,
          .summary = summary,
          .properties = {.family = name,
                         .capabilities = capabilities,
                         .anytime = true,
                         .groups = {"family"}},
          .options = std::move(options),
          .function = function};
}

}  // namespace

std::vector<Planner> planners() {
  return {planner("lattice-a-star", "A* over a state lattice of exact primitives", a_star_options(),
                  plan_a_star),
          planner("lattice-ara-star",
                  "ARA* over a state lattice: falling weights, proven suboptimality",
                  ara_star_options(), plan_ara_star),
          planner("ltba-star", "time-bounded A* over a state lattice, while the vehicle drives",
                  ltba_star_options(), plan_ltba_star)};
}

}  // namespace vandplan::lattice
