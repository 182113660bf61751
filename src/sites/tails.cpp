// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "sites/tails.h"

#include <limits>

namespace vandplan::sites {

using search::Connector, search::CostRule, search::Driven;

Tails::Tails(const SiteData& data, const SiteLayer& layer, const LocalPose& goal)
    : data_(data),
      layer_(layer),
      goal_(goal),
      ids_(static_cast<std::size_t>(2 * layer.count), none) {}

Tails::Id Tails::find(SiteState state, std::optional<SiteEntry> entry) {
  struct Unknown {
    Segment step;
    double cost;
    std::size_t place;
  };
  std::vector<Unknown> unknown;
  Id id = none;
  while (true) {
    // A way through as many states as there are goes in a circle, which only an altered table does.
    if (!entry || unknown.size() > ids_.size()) return none;
    const std::size_t place = 2 * entry->place + (state.gear > 0 ? 0 : 1);
    id = ids_[place];
    if (id != none) break;
    if (entry->is_goal) {
      id = ids_[place] = static_cast<Id>(tails_.size());
      tails_.push_back({.pose = goal_, .is_priced = true});
      break;
    }
    unknown.push_back({site_step(data_.grid, state.gear, entry->arc), entry->cost, place});
    state = data_.after(state, *entry);
    entry = data_.find(layer_, state);
  }
  for (; !unknown.empty(); unknown.pop_back()) {
    const auto& [step, cost, place] = unknown.back();
    const LocalPose pose = advance(at(id).pose, Segment{step.curvature, -step.length});
    tails_.push_back({.pose = pose, .step = step, .next = id, .roughly = cost});
    id = ids_[place] = static_cast<Id>(tails_.size() - 1);
  }
  return id;
}

Driven Tails::first(Id tail, const CostRule& rule) const {
  const Tail& all = (*this)[tail];
  if (all.next == none) return rule.final_gear;
  return {search::gear_of(all.step), all.step.curvature};
}

double Tails::cost(Id tail, Connector& connector) {
  const CostRule& rule = connector.rule();
  std::vector<Id> unknown;
  for (Id id = tail; !at(id).is_priced; id = at(id).next) unknown.push_back(id);
  for (; !unknown.empty(); unknown.pop_back()) {
    Tail& priced = at(unknown.back());
    const Tail& next = at(priced.next);
    const LocalState from = Local(State{priced.pose, 0.0});
    priced.is_priced = true;
    priced.cost = std::numeric_limits<double>::infinity();
    if (next.cost == priced.cost || !connector.is_free(from, priced.step)) continue;
    const Driven end = search::last_driven(priced.step);
    priced.cost = next.cost + std::abs(priced.step.length) * rule.weight(end.gear) +
                  search::change_cost(rule, end, first(priced.next, rule)) +
                  connector.clearance_cost(from, {&priced.step, 1});
  }
  return at(tail).cost;
}

}  // namespace vandplan::sites
