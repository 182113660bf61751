// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/setting.h"

#include "planners/rig/room_for_margin.h"
#include "planners/rig/softer_wheels.h"
#include "planners/rig/towed.h"

namespace vandplan::rig {
Setting::Setting(const Task& of, const PlanOptions& with, const planning::Pricing& prices,
                 const SiteTable* table)
    : task(of),
      options(with),
      pricing(prices),
      wheels(prices.counts_time() ? with_softer_wheels(of) : std::deque<Task>{of}),
      bare(without_margin(of, with.clearance.margin)),
      towed(towed_task(of)),
      site(table),
      guides(of),
      unit(search_unit(of.vehicle)) {}

}  // namespace vandplan::rig
