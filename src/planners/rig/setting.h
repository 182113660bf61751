// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do all workers for one rig share?

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <span>

#include "planners/commands/shorten_drive.h"
#include "planners/pricing.h"
#include "planners/rig/rig_search.h"
#include "vandplan/plan_options.h"

namespace vandplan::rig {

/// Task, prices, and wheels of one rig. Nothing in it changes while workers work.
struct Setting {
  /// Task, pricing and table outlive the setting.
  Setting(const Task& of, const PlanOptions& with, const planning::Pricing& prices,
          const SiteTable* table = nullptr);

  const Task& task;
  PlanOptions options;
  const planning::Pricing& pricing;
  /// The task, and if time counts copies with softer and softer wheels, whose drives the task
  /// allows, too.
  std::deque<Task> wheels;
  std::optional<Task> bare;  ///< task without its margin; none without a margin
  Task towed;                ///< task of the trailer alone
  const SiteTable* site;     ///< table that may have the goal; null: none
  Guides guides;
  double unit;  ///< unit of the steps of a search [m]
};

}  // namespace vandplan::rig
