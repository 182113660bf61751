// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "support/moving_worlds.h"

#include <cmath>
#include <numbers>

#include "vandplan/random.h"

namespace vandplan {
namespace {

constexpr double pi = std::numbers::pi;

double between(Rng& rng, double low, double high) { return low + (high - low) * uniform01(rng); }

Polygon box(double x_min, double y_min, double x_max, double y_max) {
  return {{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}};
}

const Polygon truck = box(-1.6, -1.27, 5.9, 1.27);

Scenario dock(Rng& rng) {
  Scenario s;
  s.bounds = {-45, 45, -27, 12};
  s.start = {between(rng, -32, -22), between(rng, -15, -10), 0};
  const double x = between(rng, -4, 4);
  s.goal = {x, 7.4, -pi / 2};
  for (const double side : {-1.0, 1.0}) {
    for (double k = 0; k < 2; ++k) {
      const double middle = x + side * (3.9 + 3.9 * k);
      s.obstacles.push_back(box(middle - 1.3, 0, middle + 1.3, 9));
    }
  }
  const double t = between(rng, 2, 18);
  s.moving.push_back({truck,
                      {{t, {x, 7.6, -pi / 2}},
                       {t + 12, {x, -8, -pi / 2}},
                       {t + 18, {x + 8, -15, -0.3}},
                       {t + 30, {45, -18, 0}}},
                      Afterwards::leaves});
  return s;
}

Scenario door(Rng& rng) {
  Scenario s;
  s.bounds = {-20, 75, -25, 25};
  s.start = {0, between(rng, -8, 8), 0};
  s.goal = {55, between(rng, -8, 8), 0};
  s.obstacles = {box(29.6, 3, 30.4, 25), box(29.6, -25, 30.4, -3)};
  const double open = between(rng, 2, 20);
  const double shut = open + between(rng, 15, 30);
  s.moving.push_back({box(-0.3, -3, 0.3, 3),
                      {{open, {30, 0, 0}},
                       {open + 5, {30, 6.2, 0}},
                       {shut, {30, 6.2, 0}},
                       {shut + 5, {30, 0, 0}}}});
  return s;
}

Scenario gate(Rng& rng) {
  Scenario s;
  const double x = between(rng, 25, 35);
  const double half = between(rng, 2.2, 3.5);
  s.bounds = {-25, x + 60, -25, 25};
  s.goal = {x + 40, 0, 0};
  s.obstacles = {box(x, -25, x + 1, -half), box(x, half, x + 1, 25)};
  const double t = between(rng, 0, 8);
  const double slow = between(rng, 14, 26);
  s.moving.push_back(
      {truck,
       {{t, {x + 30, 0, pi}}, {t + slow, {x - 10, 0, pi}}, {t + slow + 6, {x - 20, -9, pi}}},
       Afterwards::leaves});
  return s;
}

Scenario crossing(Rng& rng) {
  Scenario s;
  s.bounds = {-20, 90, -30, 30};
  s.goal = {70, between(rng, -5, 5), 0};
  for (int i = 0; i < 5; ++i) {
    const double x = between(rng, 15, 60);
    const double t = between(rng, 0, 15);
    const double side = i % 2 == 0 ? 1 : -1;
    s.moving.push_back({truck,
                        {{t, {x, -29 * side, side * pi / 2}},
                         {t + between(rng, 8, 25), {x, 29 * side, side * pi / 2}}},
                        Afterwards::leaves});
  }
  return s;
}

Scenario stopped(Rng& rng) {
  Scenario s;
  s.bounds = {-20, 90, -8, 8};
  s.goal = {70, -2, 0};
  const double x = between(rng, 25, 45);
  const double t = between(rng, 4, 12);
  s.moving.push_back({truck, {{0, {x - 15, -1, 0}}, {t, {x, -1, 0}}}});
  s.moving.push_back(
      {truck, {{0, {85, 3, pi}}, {between(rng, 15, 30), {-10, 3, pi}}}, Afterwards::leaves});
  return s;
}

Scenario roundabout(Rng& rng) {
  Scenario s;
  s.bounds = {-45, 45, -25, 25};
  s.start = {-38, between(rng, -3, 3), 0};
  s.goal = {36, between(rng, -3, 3), 0};
  constexpr double corners = 12;  // of the island, and of a round
  Polygon& island = s.obstacles.emplace_back();
  for (double k = 0; k < corners; ++k) {
    const double angle = 2 * pi * k / corners;
    island.push_back({6 * std::cos(angle), 6 * std::sin(angle)});
  }
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0})
      s.obstacles.push_back(box(24 * x - 6, 18 * y - 6, 24 * x + 6, 18 * y + 6));
  }
  const double first = between(rng, 0, 2 * pi);
  const double round = between(rng, 22, 40);  // time of a round
  for (const double ahead : {0.0, between(rng, 2, 4)}) {
    MovingObstacle& mover = s.moving.emplace_back();
    mover.outline = truck;
    mover.after = Afterwards::leaves;
    for (double k = 0; k <= 2 * corners; ++k) {
      const double angle = first + ahead + 2 * pi * k / corners;
      const Pose pose{11 * std::cos(angle), 11 * std::sin(angle), angle + pi / 2};
      mover.trajectory.push_back({round * k / corners, pose});
    }
  }
  return s;
}

Scenario dead_end(Rng& rng) {
  Scenario s;
  const double end = between(rng, 45, 60);
  s.bounds = {-40, end, -9, 9};
  s.start = {0, -3, 0};
  s.goal = {between(rng, 22, 30), 3, pi};
  const double t = between(rng, 12, 20);
  const double stays = between(rng, 5, 25);
  const double far = between(rng, 8, 14);
  s.moving.push_back({truck,
                      {{0, {-25, -3, 0}},
                       {t, {far, -3, 0}},
                       {t + stays, {far, -3, 0}},
                       {t + stays + 25, {-35, -3, 0}}},
                      Afterwards::leaves});
  return s;
}

Scenario convoy(Rng& rng) {
  Scenario s;
  s.bounds = {-20, 75, -30, 30};
  s.goal = {55, between(rng, -8, 8), 0};
  const double x = between(rng, 18, 35);
  const double duration = between(rng, 18, 30);  // of the way of each truck
  double t = between(rng, -5, 8);
  for (int i = 0; i < 5; ++i) {
    s.moving.push_back(
        {truck, {{t, {x, 24, -pi / 2}}, {t + duration, {x, -29, -pi / 2}}}, Afterwards::leaves});
    t += between(rng, 4.5, 12);
  }
  return s;
}

Scenario parking(Rng& rng) {
  Scenario s;
  s.bounds = {-20, 90, -7, 7};
  s.goal = {70, 0, 0};
  const double x = between(rng, 20, 40);
  const double t = between(rng, 5, 12);
  const double stays = between(rng, 5, 25);
  s.moving.push_back({truck,
                      {{0, {x - 12, 0, 0}},
                       {t, {x, -3.5, -0.3}},
                       {t + 3, {x + 5, -4.5, 0}},
                       {t + 3 + stays, {x + 5, -4.5, 0}},
                       {t + 7 + stays, {x + 12, -2, 0.5}},
                       {t + 20 + stays, {85, 0, 0}}},
                      Afterwards::leaves});
  return s;
}

Scenario forklifts(Rng& rng) {
  Scenario s;
  s.bounds = {-15, 95, -30, 30};
  s.start = {0, between(rng, -6, 6), 0};
  s.goal = {80, between(rng, -6, 6), 0};
  const Polygon forklift = box(-1.5, -0.8, 2.0, 0.8);
  for (const double row : {25.0, 52.0}) {
    const double x = row + between(rng, -3, 3);
    const double gap = between(rng, -8, 8);  // middle of the gap in the row of stacks
    s.obstacles.push_back(box(x, -30, x + 3, gap - 4.5));
    s.obstacles.push_back(box(x, gap + 4.5, x + 3, 30));
    MovingObstacle& mover = s.moving.emplace_back();
    mover.outline = forklift;
    const double behind = x + between(rng, 6, 9);
    double t = between(rng, -10, 0);
    double side = uniform01(rng) < 0.5 ? 1 : -1;
    while (t < 150) {
      // It stands for a while, and drives to the other side.
      const double leaves = t + between(rng, 1, 4);
      mover.trajectory.push_back({t, {behind, gap + 7 * side, pi / 2}});
      mover.trajectory.push_back({leaves, {behind, gap + 7 * side, pi / 2}});
      t = leaves + between(rng, 6, 8);
      side = -side;
    }
  }
  return s;
}

}  // namespace

Scenario moving_world(std::size_t kind, std::uint64_t number) {
  Rng rng(1000 * kind + number);
  Scenario (*const make[])(Rng&) = {dock,       door,     gate,   crossing, stopped,
                                    roundabout, dead_end, convoy, parking,  forklifts};
  Scenario s = make[kind](rng);
  s.vehicle = {.wheelbase = 4.5,
               .front_overhang = 1.4,
               .rear_overhang = 1.6,
               .width = 2.55,
               .min_turning_radius = 7};
  s.vehicle.limits.max_acceleration = 1;
  s.vehicle.limits.max_steering_rate = 0.5;
  s.vehicle.limits.max_speed = {3, 1.5};
  return s;
}

}  // namespace vandplan
