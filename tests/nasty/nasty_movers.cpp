// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Worlds in which something moves.
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <vector>

#include "nasty/naive_drive.h"
#include "nasty/nasty_world.h"
#include "support/draws.h"
#include "support/problems.h"
#include "vandplan/random.h"

namespace vandplan::nasty {
namespace {

constexpr double pi = std::numbers::pi;

/// Where obstacles move, and how large and how fast things are there.
struct Stage {
  const Scenario& scenario;
  double size = 0.0;   ///< length of the vehicle, or its turning radius if that is more [m]
  double speed = 0.0;  ///< typical speed [m/s]
  Rng& rng;

  /// A pose beside the line from start to goal, `part` of the way along it, in its direction.
  Pose on_line(double part, double aside) {
    const Pose& start = scenario.start;
    const Pose& goal = scenario.goal;
    const double heading = std::atan2(goal.y - start.y, goal.x - start.x);
    const Pose at{start.x + part * (goal.x - start.x), start.y + part * (goal.y - start.y),
                  heading};
    return compose(at, {0, aside, 0});
  }

  double any_time(double way) { return way / (speed * any_size(0.1, 4, rng)); }
};

Polygon nasty_outline(Stage& stage) {
  Rng& rng = stage.rng;
  const double length = any_size(0.02, 2, rng) * stage.size;
  const double width = any_size(0.01, 1, rng) * length;
  const double kind = uniform01(rng);
  const double back = chance(0.5, rng) ? length / 2 : uniform(-1, 2, rng) * length;
  if (kind < 0.6) return box(-back, -width / 2, length - back, width / 2);
  if (kind < 0.8) return {{-back, 0}, {length - back, -width}, {length - back, width * 0.1}};
  const double dent = uniform(0.1, 0.9, rng);  // a hook
  return {{-back, 0},
          {length - back, 0},
          {length - back, width},
          {length - back - length * (1 - dent), width},
          {length - back - length * (1 - dent), width / 4},
          {-back, width / 4}};
}

using Rows = std::vector<TimedPose>;

/// Along the line from start to goal, in either direction, from behind one end to behind the other.
Rows along_the_way(Stage& stage) {
  Rng& rng = stage.rng;
  const double aside = chance(0.6, rng) ? 0 : uniform(-1, 1, rng) * stage.size;
  const bool comes = chance(0.6, rng);
  const double first = uniform(-1.5, 0.5, rng), last = uniform(0.5, 2.5, rng);
  Pose from = stage.on_line(comes ? last : first, aside);
  Pose to = stage.on_line(comes ? first : last, aside);
  if (comes) {
    from.heading += pi;
    to.heading += pi;
  }
  const double begin = chance(0.6, rng) ? 0 : any_size(0.01, 30, rng);
  const double way = std::hypot(to.x - from.x, to.y - from.y) + 1e-3 * stage.size;
  return {{begin, from}, {begin + stage.any_time(way), to}};
}

/// Across the line, and perhaps back.
Rows across_the_way(Stage& stage) {
  Rng& rng = stage.rng;
  const double part = uniform(-0.2, 1.2, rng);
  const double far = any_size(0.5, 10, rng) * stage.size;
  Pose from = stage.on_line(part, far);
  Pose to = stage.on_line(part + uniform(-0.3, 0.3, rng), -far);
  from.heading = to.heading = std::atan2(to.y - from.y, to.x - from.x);
  const double begin = chance(0.5, rng) ? 0 : any_size(0.01, 30, rng);
  const double time = stage.any_time(2 * far);
  Rows rows{{begin, from}, {begin + time, to}};
  if (chance(0.4, rng)) rows.push_back({begin + time + stage.any_time(2 * far), from});
  return rows;
}

/// Stands in the way, and goes.
Rows out_of_the_way(Stage& stage) {
  Rng& rng = stage.rng;
  const Pose at = stage.on_line(uniform01(rng), uniform(-1, 1, rng) * stage.size);
  const double until = any_size(0.1, 60, rng);
  const Pose to = compose(at, {any_sign(any_size(0.1, 10, rng) * stage.size, rng), 0, 0});
  return {{until, at}, {until + any_size(0.01, 20, rng), to}};
}

/// Anywhere, with jumps and turns.
Rows wild(Stage& stage) {
  Rng& rng = stage.rng;
  Rows rows;
  double t = chance(0.7, rng) ? 0 : any_size(1e-3, 10, rng);
  for (int i = static_cast<int>(any_size(1, 8, rng)); i >= 0; --i) {
    Pose at = stage.on_line(uniform(-0.5, 1.5, rng), uniform(-2, 2, rng) * stage.size);
    at.heading = uniform(-10, 10, rng);
    rows.push_back({t, at});
    t += any_size(1e-3, 30, rng);
  }
  return rows;
}

/// Turns to and fro about a place, as a gate or a crane.
Rows swing(Stage& stage) {
  Rng& rng = stage.rng;
  Pose at = stage.on_line(uniform01(rng), uniform(-2, 2, rng) * stage.size);
  at.heading = uniform(-pi, pi, rng);
  const double turn = uniform(-0.99, 0.99, rng) * pi;
  Rows rows;
  double t = 0;
  for (int i = 0; i < 12; ++i) {
    rows.push_back({t, at});
    t += any_size(0.5, 20, rng);
    if (i % 2 == 0) at.heading += i % 4 == 0 ? turn : -turn;
  }
  return rows;
}

MovingObstacle nasty_mover(Stage& stage) {
  Rng& rng = stage.rng;
  constexpr Rows (*kinds[])(Stage&) = {along_the_way,  along_the_way, across_the_way,
                                       out_of_the_way, wild,          swing};
  MovingObstacle mover{.outline = nasty_outline(stage)};
  mover.trajectory = kinds[rng() % std::size(kinds)](stage);
  if (chance(0.7, rng)) mover.after = Afterwards::leaves;
  if (chance(0.1, rng)) mover.inflate = any_size(1e-4, 0.05, rng) * stage.size;
  return mover;
}

}  // namespace

Scenario nasty_world_of_movers(std::uint64_t seed) {
  Rng rng(stream_seed(seed, 6));
  const double kind = uniform01(rng);
  Scenario scenario = kind < 0.1    ? nasty_world_of_a_rig(seed)
                      : kind < 0.25 ? nasty_world_of_goals(seed)
                      : kind < 0.35 ? nasty_world_of_zones(seed)
                                    : nasty_world(seed);
  const Vehicle& vehicle = scenario.vehicle;
  Stage stage{scenario, size_of(vehicle), vehicle.limits.max_speed.forward, rng};
  for (int i = static_cast<int>(any_size(1, 5, rng)); i > 0; --i) {
    const MovingObstacle mover = nasty_mover(stage);
    Scenario alone{.vehicle = vehicle,
                   .start = scenario.start,
                   .goal = scenario.goal,
                   .hitch_angles = scenario.hitch_angles,
                   .moving = {mover}};
    // Few touch the vehicle before it can drive.
    const bool is_hit = !naive_meeting_at_start(alone, 0.01 * stage.size).empty();
    if (!is_hit || chance(0.03, rng)) scenario.moving.push_back(mover);
  }
  return scenario;
}

}  // namespace vandplan::nasty
