// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is driven from the states of a site table to its goal?

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sites/data.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::sites {

/// The ways from the states of one layer to its goal. What was found once is kept, since ways from
/// many starts share their ends.
class Tails {
 public:
  /// Number of a tail.
  using Id = std::int32_t;
  static constexpr Id none = -1;

  /// The way from one state to the goal.
  struct Tail {
    LocalPose pose = {};     ///< pose that the state keeps
    Segment step = {};       ///< what is driven first
    Id next = none;          ///< tail after the step; `none` at the goal
    double roughly = 0.0;    ///< cost of the table [m]
    double cost = 0.0;       ///< cost as `cost` finds it [m]
    bool is_priced = false;  ///< whether that is known
  };

  /// `goal` is the goal of the layer in the world's frame. Data and layer must outlive this.
  Tails(const SiteData& data, const SiteLayer& layer, const LocalPose& goal);

  /// The tail of a state with this entry; `none` if an altered table leads nowhere. Poses follow
  /// from the goal: the steps are driven backwards.
  [[nodiscard]] Id find(SiteState state, std::optional<SiteEntry> entry);
  [[nodiscard]] const Tail& operator[](Id tail) const {
    return tails_[static_cast<std::size_t>(tail)];
  }
  /// Gear and curvature of the first step.
  [[nodiscard]] search::Driven first(Id tail, const search::CostRule& rule) const;
  /// Cost of driving a tail [m]; infinite if it is not free.
  [[nodiscard]] double cost(Id tail, search::Connector& connector);

 private:
  [[nodiscard]] Tail& at(Id tail) { return tails_[static_cast<std::size_t>(tail)]; }

  const SiteData& data_;
  const SiteLayer& layer_;
  LocalPose goal_;
  std::vector<Tail> tails_;
  std::vector<Id> ids_;  // tail of each state
};

}  // namespace vandplan::sites
