// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/finish.h"

#include <algorithm>
#include <span>
#include <utility>

#include "planners/anytime/shorten.h"
#include "planners/anytime/strokes.h"
#include "planners/anytime/tidy.h"
#include "planners/commands/shorten_drive.h"
#include "search/wheels.h"

namespace vandplan::anytime {
namespace {

constexpr int trials_for_fewer_changes = 1000;  // trials of `with_fewer_changes`

}  // namespace

search::Route Finisher::with_fewer_changes(const search::Route& best, double shortest,
                                           std::uint64_t seed, search::Budget& budget) const {
  if (rules_.has_prices || best.legs.size() < 2) return best;
  CostRule rule = pricing_.rule();
  rule.gear_change_cost = 1e-8;  // so small that it only breaks ties [m]
  Connector connector(task_, rule);
  Route route = best;
  route.cost = cost_of(rule, route);
  Shortener shortener(connector, std::move(route), seed);
  for (int i = 0; i < trials_for_fewer_changes && !budget.is_interrupted() && budget.next(); ++i) {
    shortener.step();
  }
  Route tidied = shortener.route();
  tidied.cost = cost_of(pricing_.rule(), tidied);
  return tidied.cost <= shortest * (1 + 1e-9) ? tidied : best;
}

std::vector<Segment> Finisher::raw(const Best& best) const {
  if (best.drive == nullptr) return path_of(*best.route).segments;
  if (!best.drive->segments.empty()) return best.drive->segments;
  commands::DriveShortener drive(task_, pricing_.rule(), best.drive->commands, 0);
  if (rules_.is_continuous) drive.drop_crumbs();
  return drive.segments();
}

std::optional<Drive> Finisher::drivable(const Best& best, const std::vector<Segment>& raw) const {
  if (rules_.is_finished) {
    if (rules_.stroke == 0.0) return std::nullopt;
    const double cost = best.drive->cost - planning::price_of_lack(raw, rules_.stroke);
    return Drive{.commands = {}, .segments = raw, .route = {}, .cost = cost};
  }
  const bool is_bent = best.drive != nullptr && !best.drive->commands.empty();
  const double stroke = rules_.stroke;
  const CostRule& rule = pricing_.rule();
  if (stroke == 0.0 && !is_bent && !rules_.has_prices) return std::nullopt;
  Connector connector(task_, rule);
  Drive drivable{.commands = {}, .segments = raw, .route = {}, .cost = 0.0};
  if (stroke > 0.0) {
    const Route& route =
        best.drive != nullptr && best.drive->route ? *best.drive->route : *best.route;
    const bool is_along = path_of(route).segments == raw;
    const Route legs = is_along ? route : legs_along({task_.start, raw}, task_.goal);
    const DrivenBeside beside = driven_at_ends(task_, rule.initial_gear);
    drivable.segments = path_of(with_strokes(connector, beside, legs, stroke)).segments;
  }
  if (!rules_.is_continuous || (rules_.has_prices && !best.is_optimal)) {
    std::vector<Segment> neat = tidied(connector, task_.start, drivable.segments);
    const auto lack = [&](std::span<const Segment> s) {
      return planning::price_of_lack(s, stroke);
    };
    if (lack(neat) <= lack(drivable.segments)) drivable.segments = std::move(neat);
  }
  if (stroke == 0.0 && !is_bent && drivable.segments == raw) return std::nullopt;
  drivable.cost =
      pricing_.cost(drivable.segments, connector.clearance_cost(task_.start, drivable.segments));
  return drivable;
}

std::optional<Drive> Finisher::finished(const Best& best, const std::vector<Segment>& raw) const {
  std::optional<Drive> neat = drivable(best, raw);
  if (!neat || !rules_.slack) return neat;
  return neat->cost > best.drive->cost * (1 + *rules_.slack) ? std::nullopt : std::move(neat);
}

}  // namespace vandplan::anytime
