// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is a route of another kind than those before?

#include <algorithm>
#include <cstddef>
#include <vector>

#include "search/route.h"

namespace vandplan::anytime {

/// Remembers the last routes of different kinds.
class Kinds {
 public:
  /// Whether a route is unlike all remembered routes, or much cheaper than the route that it is
  /// like. Such a route is remembered. `near`: largest distance between routes of one kind [m].
  bool is_new(const search::Route& route, double near) {
    constexpr double much_cheaper = 0.98;
    const auto alike = std::ranges::find_if(
        known_, [&](const search::Route& other) { return are_alike(route, other, near); });
    if (alike != known_.end()) {
      if (route.cost > much_cheaper * alike->cost) return false;
      known_.erase(alike);
    }
    constexpr std::size_t most = 12;
    if (known_.size() == most) known_.erase(known_.begin());
    known_.push_back(route);
    return true;
  }

 private:
  std::vector<search::Route> known_;  // remembered routes, the newest last
};

}  // namespace vandplan::anytime
