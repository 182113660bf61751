// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/goal_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "vandplan/bound_table.h"
#include "vandplan/heuristic_table.h"
#include "vandplan/input_error.h"
#include "vandplan/reeds_shepp.h"

namespace vandplan::search {
namespace {

GoalEstimate euclid(const Task& task) {
  return {.is_admissible = true, .length = [goal = task.goal](const Pose& from) {
            return std::hypot(goal.x - from.x, goal.y - from.y);
          }};
}

/// An entry may be above the length where poses lie between grid points.
template <int number>
GoalEstimate table(const Task& task) {
  return {.is_admissible = false,
          .length = [entries = thesis_table(number), goal = task.goal,
                     radius = task.vehicle.min_turning_radius](const Pose& from) {
            return entries.distance(from, goal, radius);
          }};
}

GoalEstimate bound(const Task& task) {
  return {.is_admissible = true,
          .length = [goal = task.goal, radius = task.vehicle.min_turning_radius](const Pose& from) {
            return length_bounds(from, goal, radius).low;
          }};
}

GoalEstimate reeds_shepp(const Task& task) {
  return {.is_admissible = true,
          .length = [goal = task.goal, radius = task.vehicle.min_turning_radius](const Pose& from) {
            return reeds_shepp_length(from, goal, radius);
          }};
}

struct Known {
  std::string_view name;
  GoalEstimate (*make)(const Task&);
};

constexpr std::array known = {
    Known{"euclid", euclid},           Known{"hlut-1", table<1>}, Known{"hlut-2", table<2>},
    Known{"hlut-3", table<3>},         Known{"hlut-4", table<4>}, Known{"bound", bound},
    Known{"reeds-shepp", reeds_shepp},
};

constexpr auto names = [] {
  std::array<std::string_view, known.size()> all;
  std::ranges::transform(known, all.begin(), &Known::name);
  return all;
}();

}  // namespace

std::span<const std::string_view> goal_estimate_names() noexcept { return names; }

GoalEstimate make_goal_estimate(std::string_view name, const Task& task) {
  const auto found = std::ranges::find(known, name, &Known::name);
  if (found == known.end()) {
    throw InputError("estimate", "\"" + std::string(name) + "\" is unknown, expected one of " +
                                     base::joined(names));
  }
  GoalEstimate estimate = found->make(task);
  estimate.name = name;
  return estimate;
}

GoalEstimate max_of(GoalEstimate a, GoalEstimate b) {
  GoalEstimate larger{.name = "max-" + a.name + "-" + b.name,
                      .is_admissible = a.is_admissible && b.is_admissible};
  larger.length = [first = std::move(a.length), second = std::move(b.length)](const Pose& from) {
    return std::max(first(from), second(from));
  };
  return larger;
}

}  // namespace vandplan::search
