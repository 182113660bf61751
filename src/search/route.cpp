// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/route.h"

#include <algorithm>

namespace vandplan::search {

double Route::length() const {
  double sum = 0.0;
  for (const Leg& leg : legs) sum += leg.piece.length;
  return sum;
}

Gears gears_around(const CostRule& rule, const Route& route, std::size_t first, std::size_t last) {
  if (rule.is_length()) return {};
  Gears gears{rule.initial_gear, 0};
  for (std::size_t i = first; i > 0 && (i == first || gears.before.gear == 0); --i) {
    gears.before = last_driven(route.legs[i - 1].piece);
  }
  for (std::size_t i = last; i < route.legs.size() && gears.after.gear == 0; ++i) {
    gears.after = first_driven(route.legs[i].piece);
  }
  return gears;
}

double cost_of(const CostRule& rule, const Route& route) {
  Driven driven = rule.initial_gear;
  double sum = 0.0;
  for (const Leg& leg : route.legs) sum += drive_cost(rule, leg.piece.view(), driven);
  return sum;
}

Route reversed(const Route& route) {
  if (route.legs.empty()) return route;
  Route result{route.legs.back().end, {}, route.cost};
  for (std::size_t i = route.legs.size(); i > 0; --i) {
    result.legs.push_back({reversed(route.legs[i - 1].piece), route.begin_of(i - 1)});
  }
  return result;
}

Path path_of(const Route& route) {
  std::vector<Segment> segments;
  for (const Leg& leg : route.legs) {
    segments.insert(segments.end(), leg.piece.view().begin(), leg.piece.view().end());
  }
  return {route.start, merged(segments)};
}

}  // namespace vandplan::search
