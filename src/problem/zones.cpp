// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "problem/zones.h"

#include <cstddef>
#include <string>

#include "base/text.h"
#include "problem/checks.h"
#include "vandplan/input_error.h"

namespace vandplan::problem {
namespace {

constexpr double most_cost = 1000.0;

void check_zone(const Zone& zone, const std::string& where) {
  if (zone.direction) check_headings(*zone.direction, where + ".direction");
  if (!(zone.cost >= 1.0 && zone.cost <= most_cost)) {
    throw InputError(where + ".cost",
                     "is " + base::shortest_text(zone.cost) + ", expected 1 to 1000");
  }
  const bool has_rule = zone.closed || zone.direction || zone.gears != AllowedGears::both;
  if (has_rule || zone.cost != 1.0) return;
  throw InputError(where, "has no rule, expected closed, gears, direction or cost");
}

}  // namespace

std::vector<Zone> local_zones(const std::vector<Zone>& zones, const Point& origin) {
  std::vector<Zone> local = zones;
  for (std::size_t i = 0; i < local.size(); ++i) {
    const std::string where = "zones[" + std::to_string(i) + "]";
    check_zone(local[i], where);
    local[i].area = local_polygon(local[i].area, origin, where + ".area");
  }
  return local;
}

}  // namespace vandplan::problem
