// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/graphs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "base/nearest_word.h"
#include "lab/goal_field.h"
#include "vandplan/input_error.h"
#include "vandplan/steering.h"
#include "vandplan/tables.h"

namespace vandplan::search {
namespace {

GoalEstimate euclid(const Task& task, const HeuristicTable*) {
  return {.is_admissible = true, .length = [goal = task.goal](const Pose& from) {
            return std::hypot(goal.x - from.x, goal.y - from.y);
          }};
}

/// Estimate from a table. An entry may exceed the length where poses lie between grid points.
GoalEstimate looked_up(const Task& task, const HeuristicTable& table) {
  return {.is_admissible = false,
          .length = [table, goal = task.goal, radius = task.vehicle.min_turning_radius](
                        const Pose& from) { return table.distance(from, goal, radius); }};
}

template <int number>
GoalEstimate of_thesis(const Task& task, const HeuristicTable*) {
  return looked_up(task, thesis_table(number));
}

GoalEstimate of_user(const Task& task, const HeuristicTable* table) {
  if (table == nullptr) throw InputError("estimate", "table needs a table, and there is none");
  return looked_up(task, *table);
}

GoalEstimate of_site(const Task&, const HeuristicTable*) {
  throw InputError("estimate", "site is for planners with a table of the site, PlanOptions::site");
}

template <FieldKind kind>
GoalEstimate field(const Task& task, const HeuristicTable*) {
  return {.is_admissible = kind == FieldKind::any_angle,
          .length = [field = std::make_shared<GoalField>(task, kind)](const Pose& from) {
            return field->at(from);
          }};
}

GoalEstimate bound(const Task& task, const HeuristicTable*) {
  return {.is_admissible = true,
          .length = [goal = task.goal, radius = task.vehicle.min_turning_radius](const Pose& from) {
            return length_bounds(from, goal, radius).low;
          }};
}

GoalEstimate reeds_shepp(const Task& task, const HeuristicTable*) {
  return {.is_admissible = true,
          .length = [goal = task.goal, radius = task.vehicle.min_turning_radius](const Pose& from) {
            return reeds_shepp_length(from, goal, radius);
          }};
}

struct Known {
  std::string_view name;
  GoalEstimate (*make)(const Task&, const HeuristicTable*);
};

constexpr std::array known_estimates = {
    Known{"euclid", euclid},
    Known{"hlut-1", of_thesis<1>},
    Known{"hlut-2", of_thesis<2>},
    Known{"hlut-3", of_thesis<3>},
    Known{"hlut-4", of_thesis<4>},
    Known{user_table, of_user},
    Known{"bound", bound},
    Known{"reeds-shepp", reeds_shepp},
    Known{"grid", field<FieldKind::grid>},
    Known{"any-angle", field<FieldKind::any_angle>},
    Known{"choi", field<FieldKind::choi>},
    Known{site_estimate, of_site},
};

constexpr auto names = [] {
  std::array<std::string_view, known_estimates.size()> all;
  std::ranges::transform(known_estimates, all.begin(), &Known::name);
  return all;
}();

}  // namespace

std::span<const std::string_view> goal_estimate_names() noexcept { return names; }

GoalEstimate make_goal_estimate(std::string_view name, const Task& task) {
  return make_goal_estimate(name, task, nullptr);
}

GoalEstimate make_goal_estimate(std::string_view name, const Task& task,
                                const HeuristicTable* table) {
  const auto found = std::ranges::find(known_estimates, name, &Known::name);
  if (found == known_estimates.end()) {
    throw InputError("estimate", "\"" + std::string(name) + "\" is unknown, " +
                                     base::expected_one_of(name, names));
  }
  GoalEstimate estimate = found->make(task, table);
  estimate.name = name;
  return estimate;
}

GoalEstimate max_of(GoalEstimate a, GoalEstimate b) {
  GoalEstimate larger{.name = "max-" + a.name + "-" + b.name,
                      .is_admissible = a.is_admissible && b.is_admissible};
  larger.length = [first = std::move(a.length), second = std::move(b.length)](
                      const LocalPose& from) { return std::max(first(from), second(from)); };
  return larger;
}

}  // namespace vandplan::search
