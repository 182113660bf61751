// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "anytime_sources.h"

#include <array>
#include <limits>
#include <utility>

namespace vandplan {
namespace {

// Each search is twice as fine as the one before it but one. The first ones are greedy: they find
// a first route; the last of a kind looks for the best.
constexpr std::array<LatticeOptions, 6> searches = {
    LatticeOptions{12, 0.5, 2.0},   LatticeOptions{24, 0.25, 1.5}, LatticeOptions{36, 0.17, 1.2},
    LatticeOptions{48, 0.125, 2.0}, LatticeOptions{96, 0.06, 2.0}, LatticeOptions{192, 0.03, 3.0},
};
constexpr std::size_t most_nodes = 300'000;  // of one search: some 30 MB
constexpr double slack = 1.05;               // what shortening may yet take off a route
constexpr std::size_t first_patience = 256;

// Driven backwards the gears change places, and the initial one is not the first.
CostRule rule_from(const CostRule& rule, Root root) {
  if (root == Root::start) return rule;
  return {rule.reverse_weight, rule.forward_weight, rule.gear_change_cost, 0};
}

}  // namespace

Ladder::Ladder(const Problem& problem, const CostRule& rule, const Bounds& region, Root root)
    : from_(root == Root::start ? problem.start : problem.goal),
      to_(root == Root::start ? problem.goal : problem.start),
      root_(root),
      rule_(rule),
      edges_(*problem.world, rule_from(rule, root)),
      guide_(*problem.world, region, to_, from_),
      bound_(std::numeric_limits<double>::infinity()) {}

void Ladder::next_search() {
  lattice_.reset();
  if (level_ == searches.size()) {
    finished_ = true;
    return;
  }
  lattice_.emplace(from_, to_, searches[level_], guide_, edges_);
  ++level_;
}

bool Ladder::step() {
  if (!guided_) {
    guided_ = !guide_.step();
    return false;
  }
  if (!lattice_ || lattice_->is_exhausted() || lattice_->size() > most_nodes) next_search();
  if (finished_) return false;
  lattice_->set_bound(slack * bound_);
  return !lattice_->is_exhausted() && lattice_->step();
}

Route Ladder::route() const {
  if (root_ == Root::start) return lattice_->route();
  Route route = reversed(lattice_->route());
  route.cost = cost_of(rule_, route);
  return route;
}

Attempts::Attempts(const Problem& problem, const CostRule& rule, const Bounds& region,
                   std::uint64_t seed)
    : problem_(problem),
      region_(region),
      edges_(*problem.world, rule),
      seed_(seed),
      patience_(first_patience) {
  next_attempt();
}

void Attempts::next_attempt() {
  trees_.emplace(problem_, region_, edges_, stream_seed(seed_, attempt_++));
  met_ = false;
}

bool Attempts::step() {
  if (trees_->size() > patience_) {
    patience_ *= 2;
    next_attempt();
  } else if (met_) {
    next_attempt();
  }
  met_ = trees_->step();
  return met_;
}

}  // namespace vandplan
