// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "support/random_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "vandplan/random.h"

namespace vandplan {
namespace {

constexpr double pi = std::numbers::pi;

/// A world in the making.
struct Draft {
  Bounds bounds;
  std::vector<Polygon> obstacles = {};
  Pose start = {}, goal = {};
};

Polygon box(double x_min, double y_min, double x_max, double y_max) {
  return {{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}};
}

bool happens(Rng& rng, double chance) { return uniform01(rng) < chance; }

/// The truck turned so, its middle at a place.
Pose with_middle_at(double x, double y, double heading) {
  constexpr double ahead = 2.15;  // middle of the body before the rear axle [m]
  return {x - ahead * std::cos(heading), y - ahead * std::sin(heading), heading};
}

double any_heading(Rng& rng) { return uniform(-pi, pi, rng); }

/// Boxes of all sizes, turned at random.
Draft among_boxes(Rng& rng) {
  Draft draft{.bounds = {0, 60, 0, 60}};
  for (int i = 0; i < 22; ++i) {
    const double x = uniform(5, 55, rng), y = uniform(5, 55, rng), turn = any_heading(rng);
    const double a = uniform(0.5, 4, rng), b = uniform(0.5, 3, rng);
    Polygon polygon;
    for (const auto& [u, v] :
         std::array<std::pair<double, double>, 4>{{{-a, -b}, {a, -b}, {a, b}, {-a, b}}}) {
      polygon.push_back({x + u * std::cos(turn) - v * std::sin(turn),
                         y + u * std::sin(turn) + v * std::cos(turn)});
    }
    draft.obstacles.push_back(std::move(polygon));
  }
  draft.start = with_middle_at(uniform(4, 20, rng), uniform(4, 56, rng), any_heading(rng));
  draft.goal = with_middle_at(uniform(40, 56, rng), uniform(4, 56, rng), any_heading(rng));
  return draft;
}

/// Walls one after the other, each with a gap.
Draft through_gates(Rng& rng) {
  Draft draft{.bounds = {0, 90, 0, 50}};
  const double gap = uniform(3.6, 5.5, rng);
  for (double x = 22; x < 80; x += uniform(14, 20, rng)) {
    const double y = uniform(5, 45 - gap, rng);
    draft.obstacles.push_back(box(x, 0, x + 1, y));
    draft.obstacles.push_back(box(x, y + gap, x + 1, 50));
  }
  draft.start = with_middle_at(uniform(6, 12, rng), uniform(8, 42, rng), any_heading(rng));
  draft.goal = with_middle_at(uniform(82, 84, rng), uniform(8, 42, rng),
                              happens(rng, 0.5) ? pi / 2 : -pi / 2);
  return draft;
}

/// Slots to both sides of an aisle, most of them taken.
Draft into_a_slot(Rng& rng) {
  const double aisle = uniform(9, 13, rng), slot = uniform(3.3, 3.9, rng);
  constexpr double deep = 8.5;
  constexpr int count = 14;
  Draft draft{.bounds = {-12, count * slot + 12, -deep - 1, aisle + deep + 1}};
  const int wanted = static_cast<int>(uniform(2, count - 2, rng));
  const bool is_above = happens(rng, 0.5);
  for (int i = 0; i < count; ++i) {
    for (const bool above : {false, true}) {
      if ((i == wanted && above == is_above) || happens(rng, 0.15)) continue;
      const double x = (i + 0.5) * slot + uniform(-0.2, 0.2, rng);
      const double y = above ? aisle + 0.3 : -deep + 0.2;
      draft.obstacles.push_back(box(x - 1.25, y, x + 1.25, y + 7.8));
    }
  }
  const bool in_forward = happens(rng, 0.4);
  const double out = is_above ? -pi / 2 : pi / 2;
  const double y = is_above ? aisle + deep / 2 : -deep / 2;
  draft.goal = with_middle_at((wanted + 0.5) * slot, y, in_forward ? -out : out);
  draft.start = with_middle_at(-6, aisle / 2, happens(rng, 0.8) ? 0.0 : pi);
  return draft;
}

/// A yard with docks, trailers at most of them, and some that stand about.
Draft into_a_dock(Rng& rng) {
  Draft draft{.bounds = {0, 70, 0, uniform(26, 40, rng)}};
  constexpr int docks = 14;
  const int wanted = static_cast<int>(uniform(1, docks - 1, rng));
  for (int i = 0; i < docks; ++i) {
    const double x = 5 + 4.2 * i;
    if (i != wanted && !happens(rng, 0.25)) {
      draft.obstacles.push_back(box(x - 1.3, 0, x + 1.3, 13.6));
    }
  }
  for (int i = 0; i < 2; ++i) {
    const double x = uniform(5, 60, rng);
    draft.obstacles.push_back(box(x, draft.bounds.y_max - 2.6, x + 7, draft.bounds.y_max));
  }
  draft.goal = with_middle_at(5 + 4.2 * wanted, 4.5, pi / 2);
  draft.start = with_middle_at(happens(rng, 0.5) ? 6.0 : 64.0, uniform(18, 22, rng),
                               happens(rng, 0.5) ? 0.0 : pi);
  return draft;
}

/// A yes or no of each room of a square.
class Rooms {
 public:
  explicit Rooms(int side) : side_(side), values_(static_cast<std::size_t>(side * side), 0) {}
  char& operator()(int x, int y) { return values_[static_cast<std::size_t>(x * side_ + y)]; }

 private:
  int side_;
  std::vector<char> values_;
};

/// Rooms with doors between some of them: from each room there is a way to every other.
Draft in_a_maze(Rng& rng) {
  constexpr int side = 5;
  constexpr double room = 13;
  Draft draft{.bounds = {0, side * room, 0, side * room}};
  Rooms seen(side), open_right(side), open_up(side);
  std::vector<std::pair<int, int>> way = {{0, 0}};
  seen(0, 0) = true;
  while (!way.empty()) {
    const auto [x, y] = way.back();
    std::vector<std::pair<int, int>> next;
    for (const auto& [dx, dy] :
         std::array<std::pair<int, int>, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
      const int u = x + dx, v = y + dy;
      if (u >= 0 && v >= 0 && u < side && v < side && !seen(u, v)) next.emplace_back(u, v);
    }
    if (next.empty()) {
      way.pop_back();
      continue;
    }
    const auto [u, v] =
        next[static_cast<std::size_t>(uniform(0, static_cast<double>(next.size()), rng))];
    (u != x ? open_right(std::min(x, u), y) : open_up(x, std::min(y, v))) = true;
    seen(u, v) = true;
    way.emplace_back(u, v);
  }
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      const double right = (x + 1) * room, up = (y + 1) * room;
      if (x + 1 < side && !open_right(x, y) && !happens(rng, 0.1)) {
        draft.obstacles.push_back(box(right - 0.3, up - room, right + 0.3, up));
      }
      if (y + 1 < side && !open_up(x, y) && !happens(rng, 0.1)) {
        draft.obstacles.push_back(box(right - room, up - 0.3, right, up + 0.3));
      }
    }
  }
  const auto quarter = [&] { return pi / 2 * std::floor(uniform(0, 4, rng)); };
  draft.start =
      with_middle_at(room / 2, (std::floor(uniform(0, side, rng)) + 0.5) * room, quarter());
  draft.goal = with_middle_at((side - 0.5) * room, (std::floor(uniform(0, side, rng)) + 0.5) * room,
                              quarter());
  return draft;
}

/// A lane along x, from y = 0 on, with a parallel slot on its right from x = 0 on.
Draft along_a_lane(const Vehicle& car, Rng& rng) {
  const double slack = uniform(0.8, 2.2, rng), spare = uniform(0.3, 0.8, rng);
  const double lane = uniform(3.5, 6, rng);
  const double length = car.rear_overhang + car.wheelbase + car.front_overhang + slack;
  const double deep = car.width + spare;
  Draft draft{.bounds = {-16, length + 16, -deep - 1, lane + 1}};
  draft.obstacles = {box(-15, -deep, 0, 0), box(length, -deep, length + 15, 0),
                     box(-15, -deep - 1, length + 15, -deep),
                     box(-15, lane, length + 15, lane + 1)};
  draft.start = {uniform(-10, -6, rng), uniform(1.1, std::min(lane - 1.1, 2.2), rng), 0};
  draft.goal = {car.rear_overhang + slack * uniform(0.3, 0.7, rng),
                spare * uniform(0.3, 0.7, rng) - deep + car.width / 2, uniform(-0.03, 0.03, rng)};
  return draft;
}

/// Draws until start and goal are free.
template <typename Draw>
Problem free_problem(const Vehicle& vehicle, Draw draw) {
  while (true) {
    Draft draft = draw();
    const auto world = std::make_shared<const World>(
        Surroundings{.bounds = draft.bounds, .obstacles = std::move(draft.obstacles)}, Point{});
    Problem problem = make_problem(world, vehicle, draft.start, draft.goal);
    const CollisionChecker& checker = *problem.task().checker;
    if (checker.is_free(problem.task().start) && checker.is_free(problem.task().goal)) {
      return problem;
    }
  }
}

}  // namespace

Problem random_world(std::uint64_t number) {
  constexpr std::array kinds = {among_boxes, through_gates, into_a_slot, into_a_dock, in_a_maze};
  Rng rng(stream_seed(number, 0));
  return free_problem({}, [&] { return kinds[number % kinds.size()](rng); });
}

Problem tight_slot(std::uint64_t number) {
  const Vehicle car{.wheelbase = 2.8,
                    .front_overhang = 0.96,
                    .rear_overhang = 0.929,
                    .width = 1.942,
                    .min_turning_radius = 4.5};
  Rng rng(stream_seed(number, 1));
  return free_problem(car, [&] { return along_a_lane(car, rng); });
}

}  // namespace vandplan
