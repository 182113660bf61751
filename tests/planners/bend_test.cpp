// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Drives by commands of vehicles without a trailer: their closing, what makes them cheaper, and
// which routes are bent.
#include "planners/anytime/bend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "planners/anytime/workers.h"
#include "support/cases.h"
#include "support/continuity.h"
#include "support/draws.h"
#include "support/problems.h"
#include "support/radius.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

using anytime::Bender;
using commands::Command, commands::DriveShortener;
using search::CostRule, search::Driven, search::Route;

constexpr std::array kinds = {Steering::reeds_shepp, Steering::continuous_between_stops,
                              Steering::continuous};
constexpr CostRule priced{.reverse_weight = 2, .gear_change_cost = 5, .curvature_change_cost = 50};

Pose end_of(const Path& path) {
  Pose pose = path.start;
  for (const Segment& segment : path.segments) pose = advance(pose, segment);
  return pose;
}

void expect_same_pose(const Pose& a, const Pose& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(std::remainder(a.heading - b.heading, 2 * std::numbers::pi), 0, tolerance);
}

double sharpest(std::span<const Segment> segments) {
  double most = 0.0;
  for (const Segment& segment : segments) {
    most = std::max({most, std::abs(segment.curvature),
                     std::abs(curvature_at(segment, std::abs(segment.length)))});
  }
  return most;
}

auto crumbs(std::span<const Segment> segments) {
  return std::ranges::count_if(segments, [](const Segment& segment) {
    return std::abs(segment.length) < commands::crumb_length(default_radius);
  });
}

double price_of(std::span<const Segment> segments) { return drive_cost(priced, segments); }

std::vector<Command> random_commands(int count, Rng& rng) {
  std::vector<Command> commands;
  for (int i = 0; i < count; ++i) {
    commands.push_back({uniform(-1, 1, rng) / default_radius, any_sign(uniform(0.2, 8, rng), rng)});
  }
  return commands;
}

/// Straight wheels where drives begin with them.
search::DrivenBeside begin_of(Steering steering) {
  return {steering == Steering::continuous ? Driven{0, 0.0} : Driven{}, {}};
}

/// Where the curvature may not jump it does not.
void expect_drivable(const Path& path, const Problem& problem, Steering steering) {
  if (steering != Steering::reeds_shepp) expect_continuous(path, problem, steering);
}

/// The problem of a drive on open ground, or between walls.
Problem problem_along(const Path& path, std::vector<Polygon> obstacles = {}) {
  return problem_of(path.start, end_of(path), std::move(obstacles));
}

// ---- Commands ----

TEST(CloserLaw, ADriveWithoutATrailerIsBentUntilItEndsThere) {
  for (const Steering steering : kinds) {
    const commands::Wheels wheels(Vehicle{}, steering);
    const Vehicle vehicle;
    commands::Closer closer(vehicle, steering);
    int closed = 0, tried = 0;
    for_each_case(1, 300, [&](Rng& rng) {
      std::vector<Command> commands = random_commands(6, rng);
      const Path first{{uniform(-9, 9, rng), 2, uniform(-3, 3, rng)},
                       wheels.driven(commands, begin_of(steering).before)};
      Pose to = end_of(first);
      to.x += uniform(-0.5, 0.5, rng);
      to.y += uniform(-0.5, 0.5, rng);
      to.heading += uniform(-0.1, 0.1, rng);
      ++tried;
      if (!closer.close({first.start, 0}, commands, {to, 0}, begin_of(steering))) return;
      ++closed;
      const Path path{first.start, wheels.driven(commands, begin_of(steering).before)};
      expect_same_pose(end_of(path), to, 1e-9);
      EXPECT_LE(sharpest(path.segments), 1 / default_radius);
    });
    if (!is_sanitized) {
      EXPECT_GE(closed, 0.9 * tried) << name_of(steering);
    }
  }
}

// At a stop the wheels may be turned somewhere, and turn back at once.
TEST(Wheels, ACommandComesBeforeAClothoidThatBeginsAtAStop) {
  const Vehicle vehicle;
  const double rate = max_curvature_rate(vehicle);
  const commands::Wheels wheels(vehicle, Steering::continuous_between_stops);
  for (const double gear : {1.0, -1.0}) {
    const std::vector<Segment> segments = {
        {0.1, gear * 0.1 / rate, -rate}, {0, gear * 8}, {-0.05, -gear * 0.05 / rate, rate}};
    const Path path{{0, 0, 0}, segments};
    const Path again{{0, 0, 0}, wheels.driven(wheels.commands(segments, {}), {})};
    expect_same_pose(end_of(again), end_of(path), 0.05);
    EXPECT_NEAR(again.segments[0].curvature, 0.1, 1e-12);
  }
}

// ---- Trials ----

TEST(DriveShortenerLaw, IsNeverDearerNorMoreCrumbly) {
  for (const Steering steering : kinds) {
    for_each_case(2, 12, [&](Rng& rng) {
      const commands::Wheels wheels(Vehicle{}, steering);
      const std::vector<Command> commands = random_commands(7, rng);
      // With `continuous` the wheels are straight at both ends.
      const bool is_free = steering != Steering::continuous;
      std::vector<Command> ended = commands;
      if (!is_free) ended.push_back({0, std::copysign(4, commands.back().length)});
      const Path path{{1, 2, uniform(-3, 3, rng)}, wheels.driven(ended, begin_of(steering).before)};
      const Problem problem = problem_along(path);
      const Task task = task_of(problem, {}, steering);
      const search::DrivenBeside ends = search::driven_at_ends(task);
      commands::Closer closer(task.vehicle, steering);
      if (!closer.close({task.start, 0}, ended, {task.goal, 0}, ends)) return;
      DriveShortener shortener(task, priced, ended, rng());
      double cost = shortener.cost();
      EXPECT_NEAR(cost, price_of(shortener.segments()), 1e-9);
      auto count = crumbs(shortener.segments());
      for (int i = 0; i < 400; ++i) {
        const bool is_cheaper = shortener.step();
        EXPECT_EQ(is_cheaper, shortener.cost() < cost);
        cost = shortener.cost();
        const auto now = crumbs(shortener.segments());
        EXPECT_LE(now, count);
        count = now;
      }
      const Path last{task.start, shortener.segments()};
      EXPECT_NEAR(cost, price_of(last.segments), 1e-9);
      expect_same_pose(end_of(last), task.goal, 1e-9);
      expect_drivable(last, problem, steering);
    });
  }
}

// What is near the commands that a trial left as they were is not looked at again.
TEST(DriveShortenerLaw, KnowsWhatIsNear) {
  int compared = 0;
  const CostRule careful{.gear_change_cost = 5, .clearance_weight = 2, .clearance_distance = 3};
  for_each_case(9, 20, [&](Rng& rng) {
    const commands::Wheels wheels(Vehicle{}, Steering::continuous_between_stops);
    std::vector<Command> commands = random_commands(8, rng);
    const Path path{{1, 2, 0}, wheels.driven(commands, {})};
    double top = path.start.y;
    Pose pose = path.start;
    for (const Segment& segment : path.segments) {
      pose = advance(pose, segment);
      top = std::max(top, pose.y);
    }
    const double wall = top + uniform(2, 8, rng);
    const Problem problem = problem_along(path, {box(-100, wall, 100, wall + 1)});
    const Task task = task_of(problem, {}, Steering::continuous_between_stops);
    commands::Closer closer(task.vehicle, task.steering);
    if (!closer.close({task.start, 0}, commands, {task.goal, 0})) return;
    if (!task.checker->is_free(task.start, wheels.driven(commands, {}))) return;
    for (std::size_t i = 7; i > 0; --i) {
      commands.insert(commands.begin() + static_cast<std::ptrdiff_t>(i),
                      {0.1, 0});  // closing leaves such ones
    }
    DriveShortener shortener(task, careful, commands, rng());
    for (int i = 0; i < 200; ++i) {
      if (!shortener.step()) continue;
      const DriveShortener anew(task, careful, shortener.commands(), 0);
      EXPECT_NEAR(shortener.cost(), anew.cost(), 1e-7);
      // What comes after a stop that is gone is driven in another way.
      expect_same_pose(end_of({task.start, shortener.segments()}), task.goal, 1e-8);
      ++compared;
    }
  });
  EXPECT_GT(compared, cases(20));
}

// Whatever the seed: at first a command is left out, then the next one, where that saves a good
// deal.
TEST(DriveShortener, SweepsAFreshDriveFirst) {
  for (const Steering steering : kinds) {
    const commands::Wheels wheels(Vehicle{}, steering);
    std::vector<Command> commands = {{0.1, 15}, {-0.1, 15}, {0.1, 15}, {0, 6}, {0.002, 6}};
    for (const double curvature : {0.08, -0.08, -0.08, 0.08, 0.0}) {
      commands.push_back({curvature, 6});
    }
    const Path path{{0, 0, 0}, wheels.driven(commands, begin_of(steering).before)};
    const Problem problem = problem_along(path);
    const Task task = task_of(problem, {}, steering);
    const search::DrivenBeside ends = search::driven_at_ends(task);
    commands::Closer closer(task.vehicle, steering);
    ASSERT_TRUE(closer.close({task.start, 0}, commands, {task.goal, 0}, ends));
    const double cost = DriveShortener(task, priced, commands, 1).cost();
    std::vector<double> costs;
    for (const std::uint64_t seed : {1U, 2U}) {
      DriveShortener shortener(task, priced, commands, seed);
      for (int i = 0; i < 8; ++i) {
        const double before = shortener.cost();
        const bool fell = shortener.step();
        EXPECT_LE(shortener.cost(), (fell ? 0.99 : 1.0) * before);
      }
      costs.push_back(shortener.cost());
    }
    EXPECT_LT(costs[0], 0.95 * cost) << name_of(steering);
    EXPECT_EQ(costs[0], costs[1]);
  }
}

// Trials are kept by hundreds, and the drive still ends at the goal.
TEST(DriveShortenerLaw, LetsNoErrorsAddUp) {
  int kept = 0;
  for_each_case(4, 3, [&](Rng& rng) {
    const commands::Wheels wheels(Vehicle{}, Steering::continuous_between_stops);
    std::vector<Command> commands;
    for (int i = 0; i < 60; ++i) commands.push_back({uniform(-0.2, 0.2, rng) / default_radius, 15});
    const Path path{{1, 2, 0}, wheels.driven(commands, {})};
    const Problem problem =
        problem_of(path.start, end_of(path), {}, Bounds{-1000, 1000, -1000, 1000});
    const Task task = task_of(problem, {}, Steering::continuous_between_stops);
    DriveShortener shortener(task, priced, commands, rng());
    double most = 0.0;
    for (int i = 0; i < 8000; ++i) {
      if (!shortener.step()) continue;
      ++kept;
      const Pose end = end_of({task.start, shortener.segments()});
      most = std::max({most, std::abs(end.x - task.goal.x), std::abs(end.y - task.goal.y)});
    }
    EXPECT_LT(most, 1e-8);
  });
  EXPECT_GT(kept, 150 * cases(3));
}

TEST(DriveShortener, DropsCrumbs) {
  const commands::Wheels wheels(Vehicle{}, Steering::continuous_between_stops);
  const std::vector<std::vector<Command>> crumbly = {
      {{0.1, 8}, {0.1002, 6}, {-0.05, 9}},            // the wheels turn for some millimetres
      {{0.1, 8}, {0, 7}, {0.1, 0.005}, {-0.05, -6}},  // a command of next to no length
      {{0.05, 5}, {0.0501, 6}, {0.0502, 7}, {-0.03, 9}, {0.02, -8}},  // one after another
  };
  for (const std::vector<Command>& commands : crumbly) {
    const Path path{{0, 0, 0}, wheels.driven(commands, {})};
    ASSERT_GT(crumbs(path.segments), 0);
    const Problem problem = problem_along(path);
    const Task task = task_of(problem, {}, Steering::continuous_between_stops);
    const CostRule rule{.reverse_weight = 2, .gear_change_cost = 5};
    DriveShortener shortener(task, rule, commands, 1);
    const double cost = shortener.cost();
    shortener.drop_crumbs();
    EXPECT_EQ(crumbs(shortener.segments()), 0);
    EXPECT_LE(shortener.cost(), 1.0001 * cost);
    expect_same_pose(end_of({task.start, shortener.segments()}), task.goal, 1e-9);
  }
}

// Where everything else is dearer a crumb stays.
TEST(DriveShortener, LeavesACrumbWhereItIsWorthIt) {
  const std::vector<Command> commands = {{0.1, 8}, {0, 7}, {0.1, 0.05}, {-0.05, -6}};
  const Path path{{0, 0, 0},
                  commands::Wheels(Vehicle{}, Steering::reeds_shepp).driven(commands, {})};
  const Pose end = end_of(path);
  const Problem problem = problem_along(path, {box(end.x - 40, -20, end.x - 39.9, -19.9)});
  const Task task = task_of(problem, {}, Steering::reeds_shepp);
  const CostRule rule{.reverse_weight = 1000, .curvature_change_cost = 1e-9};
  DriveShortener shortener(task, rule, commands, 1);
  const double cost = shortener.cost();
  shortener.drop_crumbs();
  EXPECT_LE(shortener.cost(), 1.0001 * cost);
}

// ---- Routes ----

/// A measure that likes wheels that are turned a little all the way.
double bent_squared(std::span<const Segment> segments) {
  double sum = 0.0;
  for (const Segment& segment : segments) {
    sum += std::abs(segment.length) * (1 + 1e3 * segment.curvature * segment.curvature);
  }
  return sum;
}

/// The best word of words alone, as a route.
Route word_route(const Task& task) {
  search::Connector connector(task, priced);
  Route route{task.start, {{connector.steer(task.start, task.goal).value(), task.goal}}, 0.0};
  price(connector, route);
  return route;
}

TEST(Bender, TurnsTheWheelsLessWhereThatIsCheaper) {
  const Problem problem = problem_of({0, 0, 0}, {30, 3, 0}, {});
  for (const Steering steering : kinds) {
    const Task task = task_of(problem, {}, steering);
    const Route route = word_route(task);
    Bender bender(task, priced, 1);
    bender.offer(route);
    EXPECT_TRUE(bender.step());
    EXPECT_NEAR(bender.cost(), route.cost, 0.01 * route.cost);
    EXPECT_TRUE(bender.has_work());
    int trials = 0;
    for (; bender.has_work() && trials < 20'000; ++trials) (void)bender.step();
    EXPECT_GE(trials, 600);
    EXPECT_FALSE(bender.has_work());
    EXPECT_LT(bender.cost(), 0.9 * route.cost) << name_of(steering);
    const commands::Wheels wheels(task.vehicle, steering);
    const Path path{task.start,
                    wheels.driven(bender.best().commands, search::driven_at_ends(task).before)};
    EXPECT_LT(sharpest(path.segments), 0.5 / default_radius);
    expect_same_pose(end_of(path), task.goal, 1e-9);
    expect_drivable(path, problem, steering);
  }
}

TEST(Bender, MindsAnotherMeasure) {
  const Problem problem = problem_of({0, 0, 0}, {30, 3, 0}, {});
  for (const Steering steering : kinds) {
    const Task task = task_of(problem, {}, steering);
    Bender bender(task, priced, 1, bent_squared);
    bender.offer(word_route(task));
    EXPECT_TRUE(bender.step());
    const double first = bender.cost();
    for (int i = 0; i < 1000; ++i) (void)bender.step();
    EXPECT_LT(bender.cost(), 0.8 * first) << name_of(steering);
    EXPECT_NEAR(bender.cost(), bent_squared(bender.segments()), 1e-9);
  }
}

TEST(Bender, KeepsTheCheapestOfAll) {
  const Problem problem = problem_of({0, 0, 0}, {30, 3, 0}, {});
  const Task task = task_of(problem, {}, Steering::reeds_shepp);
  const std::vector<Segment> detour = {{0.1, 10 * std::numbers::pi}, {0.1, 10 * std::numbers::pi}};
  const Route route = word_route(task);
  Bender bender(task, priced, 1);
  std::vector<Segment> around = path_of(route).segments;
  around.insert(around.begin(), detour.begin(), detour.end());
  bender.offer_path(around);
  EXPECT_TRUE(bender.step());
  const double dear = bender.cost();
  bender.offer(route);
  EXPECT_TRUE(bender.step());
  EXPECT_LT(bender.cost(), dear - 50);
  const double cheap = bender.cost();
  bender.offer_path(around);
  for (int i = 0; i < 50; ++i) (void)bender.step();
  EXPECT_LE(bender.cost(), cheap);
}

/// By way of a pose.
Route route_by_way_of(const Task& task, const LocalPose& via) {
  search::Connector connector(task, priced);
  Route route{task.start, {{connector.steer(task.start, via).value(), via}}, 0.0};
  route.legs.push_back({connector.steer(via, task.goal).value(), task.goal});
  price(connector, route);
  return route;
}

// A challenger that is hardly dearer than the best drive takes long to be dropped. What comes
// meanwhile does not wait for it.
TEST(Bender, TriesANewRouteAtOnce) {
  const Problem problem = problem_of({-50, 0, 0}, {50, 0, 0}, {box(-5, -10, 5, 30)});
  const Task task = task_of(problem, {}, Steering::reeds_shepp);
  Bender bender(task, priced, 1);
  bender.offer_path(path_of(route_by_way_of(task, LocalPose({0, 40, 0}))).segments);
  EXPECT_TRUE(bender.step());
  bender.offer_path(path_of(route_by_way_of(task, LocalPose({0, 41, 0}))).segments);
  EXPECT_FALSE(bender.step());
  const double dear = bender.cost();
  bender.offer_path(path_of(route_by_way_of(task, LocalPose({0, -20, 0}))).segments);
  EXPECT_TRUE(bender.step());
  EXPECT_LT(bender.cost(), 0.9 * dear);
}

// However many dearer ones came after it: following those may take long, and be in vain.
TEST(Bender, TriesTheCheapestRouteFirst) {
  const Problem problem = problem_of({-50, 0, 0}, {50, 0, 0}, {});
  const Task task = task_of(problem, {}, Steering::reeds_shepp);
  Bender bender(task, priced, 1);
  const Route cheap = route_by_way_of(task, LocalPose({0, -20, 0}));
  bender.offer(cheap);
  for (const double y : {30.0, 45.0, 60.0, -30.0, -45.0, -60.0}) {
    bender.offer(route_by_way_of(task, LocalPose({0, y, 0})));
  }
  EXPECT_TRUE(bender.step());
  EXPECT_LE(bender.cost(), cheap.cost + 1e-9);
}

// The commands of the whole way run into the posts, as what turning the wheels takes at one place
// moves all that comes after it.
TEST(Bender, FollowsAWayPartByPart) {
  std::vector<Segment> way;
  for (int i = 0; i < 6; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    for (const double turn : {side, -side, side}) {
      way.push_back({turn / default_radius, turn == -side ? 16.0 : 8.0});
    }
    way.push_back({0, 9});
  }
  const Path path{{0, 0, 0}, way};
  std::vector<Polygon> posts;
  const double aside = Vehicle{}.width / 2 + 0.3;
  for (double s = 40.5; s < length(path); s += 41.0) {  // beside the straight pieces
    const Pose pose = pose_at(path, s);
    for (const double side : {aside, -aside}) {
      const Pose post = compose(pose, {1.0, side, 0});
      posts.push_back(box(post.x - 0.1, post.y - 0.1, post.x + 0.1, post.y + 0.1));
    }
  }
  const Problem problem = problem_of(path.start, end_of(path), posts, {-50, 400, -200, 200});
  const Task task = task_of(problem, {}, Steering::continuous_between_stops);
  ASSERT_TRUE(task.checker->is_free(task.start, way));
  const Route route = [&] {
    Route result{task.start, {}, 0.0};
    LocalPose pose = task.start;
    for (const Segment& segment : way) {
      pose = advance(pose, segment);
      search::drive_on(result.legs, segment, pose);
    }
    price(search::Connector(task, priced), result);
    return result;
  }();
  Bender bender(task, priced, 1);
  bender.offer(route);
  EXPECT_FALSE(bender.step());  // not as a whole
  EXPECT_TRUE(bender.has_work());
  bool is_driven = false;
  for (int i = 0; i < 500 && !is_driven; ++i) is_driven = bender.step();
  ASSERT_TRUE(is_driven);
  EXPECT_TRUE(task.checker->is_free(task.start, bender.segments()));
  expect_drivable({task.start, bender.segments()}, problem, task.steering);
}

TEST(Bender, LeavesOutWhatIsNotFree) {
  const Problem problem = problem_of({0, 0, 0}, {30, 3, 0}, {box(14, 0, 15, 3)});
  const Task task = task_of(problem, {}, Steering::reeds_shepp);
  Bender bender(task, priced, 1);
  bender.offer(word_route(task));
  EXPECT_TRUE(bender.has_work());
  EXPECT_FALSE(bender.step());
  EXPECT_FALSE(bender.has_work());
}

// A route like one before is no news unless it is much cheaper.
TEST(Bender, TakesARouteOnce) {
  const Problem problem = problem_of({0, 0, 0}, {30, 3, 0}, {box(14, 0, 15, 3)});
  const Task task = task_of(problem, {}, Steering::reeds_shepp);
  Bender bender(task, priced, 1);
  Route route = word_route(task);
  bender.offer(route);
  EXPECT_FALSE(bender.step());
  route.cost *= 0.99;
  bender.offer(route);
  EXPECT_FALSE(bender.has_work());
  route.cost *= 0.97;
  bender.offer(route);
  EXPECT_TRUE(bender.has_work());
}

TEST(Bending, LeavesOutCrumbsThatOtherCommandsMakeUpFor) {
  const Path known{{0, 0, 0}, {{0, 10}, {0.02, 0.05}, {0, 10}}};
  const Problem problem = problem_of(known.start, end_of(known), {});
  const auto of_drive = [](std::span<const Segment> segments) { return length(segments); };
  Bender bender(problem.task(), priced, 1, of_drive);
  ASSERT_TRUE(bender.begin_with(known));
  EXPECT_EQ(crumbs(bender.segments()), 0);
}

// What is made fast by bending is faster than what words alone can be.
TEST(Bending, SavesWhatTheMeasureOfDrivesSays) {
  const Problem problem = problem_of({0, 0, 0}, {30, 3, 0}, {});
  const Task task = task_of(problem, {}, Steering::continuous);
  const auto of_drive = [](std::span<const Segment> segments) { return bent_squared(segments); };
  const auto of_route = [](const Route& route) { return bent_squared(path_of(route).segments); };
  const Route route = word_route(task);
  const search::Budget budget{BudgetOptions{}};
  const auto cheapest = [&](anytime::Worker& worker) {
    double cost = std::numeric_limits<double>::infinity();
    anytime::Found found;
    for (int round = 0; round < 30; ++round) {
      found = worker.work(50, {.route = &route}, budget);
      EXPECT_EQ(found.iterations, 50);
      for (const CostSample& fell : found.improvements) {
        EXPECT_LT(fell.cost, cost);
        cost = fell.cost;
      }
      EXPECT_EQ(found.drive.value().cost, cost);
    }
    EXPECT_NEAR(bent_squared(found.drive->segments), cost, 1e-9);
    expect_continuous({task.start, found.drive->segments}, problem, Steering::continuous);
    return cost;
  };
  const double by_words = cheapest(*anytime::cheapest_drive(task, priced, 1, of_route));
  const double by_drives = cheapest(*anytime::cheapest_drive(task, priced, 1, of_route, of_drive));
  EXPECT_LT(by_drives, 0.95 * by_words);
}

// What the default planner makes of it: a lane change of a driver is gentle.
TEST(Bending, ALaneChangeIsGentle) {
  const Problem problem = problem_of({0, 0, 0}, {30, 3, 0}, {box(-50, 6, 80, 7)});
  PlanOptions options{.budget = {.max_iterations = 4000}, .cost = driver_style};
  for (const Steering steering : kinds) {
    options.steering = steering;
    const PlanResult result = plan(problem, options);
    ASSERT_EQ(result.status, PlanStatus::solved);
    EXPECT_LT(sharpest(result.path->segments), 0.6 / default_radius) << name_of(steering);
    EXPECT_TRUE(check_path(problem, *result.path).valid);
    EXPECT_NEAR(result.anytime.back().cost, result.cost, 1e-2 * result.cost);
  }
}

}  // namespace
}  // namespace vandplan
