// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
//
// What a plugin offers to its host: a function that the library inside it carries out.
#include <vandplan/steering.h>

extern "C" double shortest_length(double x, double y, double heading) {
  return vandplan::reeds_shepp_length({0, 0, 0}, {x, y, heading}, 5.0);
}
