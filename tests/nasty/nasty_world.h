// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which worlds would nobody draw by hand?

#include <cstdint>

#include "vandplan/problem.h"

namespace vandplan::nasty {

/// Size of things in a vehicle's world: its length, or its turning radius if that is more [m].
[[nodiscard]] double size_of(const Vehicle& vehicle);

/// A world of that number, always the same one: needles, combs, stars, nested and touching
/// polygons, walls at 0 to 1 mm from the body, points and repeated corners, kerbs, turned maps, far
/// origins and far bounds, for vehicles from a decimetre to a hundred metres. Some have a flaw that
/// `make_problem` refuses; in some the start or the goal is in collision.
[[nodiscard]] Scenario nasty_world(std::uint64_t seed);

/// The same with a trailer behind the vehicle, short or four times as long, on a drawbar or with
/// its body over the hitch, and with hitch angles at both ends.
[[nodiscard]] Scenario nasty_world_of_a_rig(std::uint64_t seed);

/// One of both whose goal is a set: of one region to four, beside the goal it had, on the start, or
/// anywhere; some so narrow that they are all but poses. Some are inside of an area, and of these
/// some go to a pose.
[[nodiscard]] Scenario nasty_world_of_goals(std::uint64_t seed);

/// One of these three with zones of all kinds, and masks, some of which lie on start or goal.
[[nodiscard]] Scenario nasty_world_of_zones(std::uint64_t seed);

/// One of these four in which one to four obstacles move: along the way to the goal, across it, out
/// of it, to and fro about a place, or wildly; some grow.
[[nodiscard]] Scenario nasty_world_of_movers(std::uint64_t seed);

}  // namespace vandplan::nasty
