// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/open_drives.h"

#include <algorithm>
#include <set>
#include <utility>

#include "planners/rig/exact_drive.h"
#include "planners/rig/rig_search.h"

namespace vandplan::rig {
namespace {

/// The gears of a drive, one after the other.
std::vector<search::GearSign> gears_of(std::span<const Segment> segments) {
  std::vector<search::GearSign> gears;
  for (const Segment& segment : segments) {
    const search::GearSign gear = search::gear_of(segment);
    if (gears.empty() || gears.back() != gear) gears.push_back(gear);
  }
  return gears;
}

}  // namespace

std::vector<std::vector<Segment>> open_drives(const Task& task, const search::CostRule& rule) {
  const std::optional<RigSteering> steering = steering_of(task.vehicle);
  if (!steering) return {};
  const RigState from{task.start, task.hitch_angles.start};
  const RigState to{task.goal, task.hitch_angles.goal};
  const RigPrices prices{.reverse_weight = rule.reverse_weight,
                         .gear_change_cost = rule.gear_change_cost};
  std::vector<std::pair<double, Piece>> words;
  for (const Piece& piece : steering->candidates(from, to, prices)) {
    search::Driven driven = rule.initial_gear;
    words.emplace_back(search::drive_cost(rule, piece.view(), driven), piece);
  }
  std::ranges::stable_sort(words, {}, &std::pair<double, Piece>::first);
  ExactDrive exact(task);
  std::set<std::vector<search::GearSign>> known;
  std::vector<std::vector<Segment>> drives;
  for (const auto& [cost, piece] : words) {
    const std::vector<search::GearSign> gears = gears_of(piece.view());
    if (known.contains(gears)) continue;
    if (!task.checker->rig_is_free(from, piece.view())) continue;
    std::optional<std::vector<Segment>> drive = exact.along(piece.view());
    if (!drive) continue;
    known.insert(gears);
    drives.push_back(std::move(*drive));
  }
  return drives;
}

}  // namespace vandplan::rig
