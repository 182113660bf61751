// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/rotation.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace vandplan::anytime {
namespace {

/// Cells, greediness and prices of one search.
struct Style {
  LatticeOptions lattice;
  double price;  // factor on the price of a gear change; 0: by length alone
  double slack;  // a route may cost so many times the best: shortening takes that off
};

constexpr std::array<Style, 10> styles = {{{{12, 0.5, 2.0}, 1.0, 1.15},
                                           {{24, 0.25, 1.5, true}, 1.0, 1.1},
                                           {{36, 0.17, 1.2}, 1.0, 1.1},
                                           {{48, 0.125, 2.0}, 1.0, 1.1},
                                           {{24, 0.25, 1.2}, 4.0, 1.1},
                                           {{24, 0.25, 1.2}, 0.0, 1.1},
                                           {{96, 0.06, 2.0}, 1.0, 1.05},
                                           {{192, 0.03, 3.0}, 1.0, 1.05},
                                           {{384, 0.015, 3.0}, 1.0, 1.05},
                                           {{768, 0.0075, 3.0}, 1.0, 1.05}}};
constexpr std::size_t first_joined = 6;      // styles that take turns from the beginning
constexpr std::int64_t first_turn = 256;     // expansions of a first turn
constexpr std::int64_t first_of_all = 1024;  // expansions of the coarsest search's first turn
constexpr std::int64_t max_nodes = 100'000;  // nodes of one search

/// The rule with another price of gear changes, as in `Style`.
CostRule priced(CostRule rule, double price) {
  if (price == 0.0) {
    CostRule by_length = length_rule(rule);
    by_length.initial_gear = rule.initial_gear;
    return by_length;
  }
  rule.gear_change_cost *= price;
  return rule;
}

}  // namespace

Rotation::Rotation(const Task& task, const CostRule& rule, const LocalPose& root,
                   const LocalPose& target, const DrivenBeside& beside, const Guide& guide)
    : root_(root),
      target_(target),
      beside_(beside),
      guide_(guide),
      joined_(first_joined),
      turn_(first_turn) {
  for (const Style& style : styles) {
    searches_.push_back(std::make_unique<Search>(task, priced(rule, style.price)));
  }
  current_ = joined_ - 1;
}

// Finds the next search that is not done; false if there is none. One more search joins each time
// around.
bool Rotation::begin_turn() {
  for (std::size_t tried = 0; tried < 2 * searches_.size(); ++tried) {
    if (++current_ >= joined_) {
      current_ = 0;
      turn_ = turn_ * 3 / 2;
      joined_ = std::min(joined_ + 1, searches_.size());
    }
    Search& search = *searches_[current_];
    if (search.done) continue;
    left_ = turn_;
    if (!search.lattice) {
      search.lattice = std::make_unique<Lattice>(root_, target_, beside_, styles[current_].lattice,
                                                 guide_, search.connector);
      if (current_ == 0) left_ = first_of_all;
    }
    return true;
  }
  finished_ = true;
  return false;
}

bool Rotation::step(double cutoff) {
  if (left_ == 0 && !begin_turn()) return false;
  --left_;
  Search& search = *searches_[current_];
  Lattice& lattice = *search.lattice;
  if (lattice.is_exhausted() || lattice.size() > max_nodes) {
    search.lattice.reset();
    search.done = true;
    left_ = 0;
    return false;
  }
  // Raised prices make a route dearer than it is.
  const Style& style = styles[current_];
  lattice.set_cutoff(style.slack * std::max(style.price, 1.0) * cutoff);
  return lattice.step();
}

const Route& Rotation::route() const { return searches_[current_]->lattice->route(); }

Counts Rotation::counts() const {
  Counts sum;
  for (const auto& search : searches_) {
    sum += counts_of(search->connector);
    if (search->lattice) sum.nodes += search->lattice->size();
  }
  return sum;
}

}  // namespace vandplan::anytime
