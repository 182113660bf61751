// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/cases.h"
#include "support/naive_check.h"
#include "support/problems.h"
#include "support/radius.h"
#include "vandplan/judge.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using std::numbers::pi;

Path random_path(double length, Rng& rng) {
  Path path{uniform_pose({-5, 5, -5, 5}, rng), {}};
  const int count = 1 + static_cast<int>(uniform(0, 5, rng));
  for (int i = 0; i < count; ++i) {
    const double curvature = std::round(uniform(-1.5, 1.5, rng)) / default_radius;
    const double size = uniform(0.2, 2, rng) * length / count;
    path.segments.push_back({curvature, uniform01(rng) < 0.3 ? -size : size});
  }
  return path;
}

/// A star-shaped polygon, often concave, either way around.
Polygon random_polygon(const Point& centre, double size, Rng& rng) {
  const int corners = 3 + static_cast<int>(uniform(0, 5, rng));
  const double turn = uniform01(rng) < 0.5 ? -2 * pi / corners : 2 * pi / corners;
  const double first = uniform(-pi, pi, rng);
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = first + (i + uniform(-0.3, 0.3, rng)) * turn;
    const double reach = size * uniform(0.4, 1, rng);
    polygon.push_back({centre.x + reach * std::cos(angle), centre.y + reach * std::sin(angle)});
  }
  return polygon;
}

std::vector<Polygon> random_obstacles(int count, double spread, Rng& rng) {
  std::vector<Polygon> obstacles;
  for (int i = 0; i < count; ++i) {
    const Pose centre = uniform_pose({-spread, spread, -spread, spread}, rng);
    obstacles.push_back(random_polygon({centre.x, centre.y}, uniform(0.3, 3, rng), rng));
  }
  return obstacles;
}

std::string check_as_code(const Problem& problem, const Path& path) {
  return vandplan::as_code(path) + "\nto " + vandplan::as_code(problem.goal()) + " among " +
         vandplan::as_code(obstacles_of(problem));
}

TEST(PathCheckLaw, AgreesWithLookingAtEveryMillimetre) {
  int hits = 0;
  int free = 0;
  for_each_case(1, 60, [&](Rng& rng) {
    const Path path = random_path(3, rng);
    const Problem problem = problem_of(path.start, end_pose(path), random_obstacles(2, 14, rng));
    const std::vector<Polygon>& obstacles = obstacles_of(problem);
    SCOPED_TRACE(check_as_code(problem, path));
    const PathCheck check = check_path(problem, path, {});
    ASSERT_TRUE(check.clearance);

    // What lies within a millimetre of touching may be seen either way.
    const Footprint body = footprint(problem.vehicle());
    const std::vector<PathPoint> points = sampled(path, 1e-3);
    if (naive_hit(body, -1e-3, points, obstacles)) {
      EXPECT_EQ(*check.clearance, 0);
    }
    if (*check.clearance == 0) {
      ASSERT_TRUE(check.at);
      EXPECT_TRUE(naive_hit(body, 1e-3, {*check.at}, obstacles));
      ++hits;
    } else {
      EXPECT_TRUE(check.valid) << check.reason;
      EXPECT_FALSE(naive_hit(body, *check.clearance / std::sqrt(2.0) - 2e-3, points, obstacles));
      EXPECT_TRUE(naive_hit(body, *check.clearance + 1e-3, points, obstacles));
      ++free;
    }
  });
  EXPECT_GE(hits, cases(60) / 8);
  EXPECT_GE(free, cases(60) / 8);
}

// ---- A valid path is spoiled in one way ----

struct Case {
  Problem problem;
  Path path;
  PathClaims claims;
};

/// A valid case with obstacles not far from the path.
Case valid_case(Rng& rng) {
  while (true) {
    const Path path = random_path(30, rng);
    Case c{problem_of(path.start, end_pose(path), random_obstacles(4, 40, rng)),
           path,
           {length(path.segments), gear_changes(path.segments)}};
    if (check_path(c.problem, c.path, c.claims).valid) return c;
  }
}

/// Of a size between `least` and 1000 times as much, either sign.
double error(double least, Rng& rng) {
  const double size = least * std::pow(1000, uniform01(rng));
  return uniform01(rng) < 0.5 ? -size : size;
}

Segment& some_segment(Path& path, Rng& rng) {
  return path.segments[static_cast<std::size_t>(
      uniform(0, static_cast<double>(path.segments.size()), rng))];
}

Pose some_pose(const Path& path, Rng& rng) {
  return pose_at(path, uniform(0, length(path.segments), rng));
}

void rebuild(Case& c, std::vector<Polygon> obstacles, const Bounds& bounds) {
  c.problem = problem_of(c.problem.start(), c.problem.goal(), std::move(obstacles), bounds);
}

void aim(Case& c, const Pose& goal) {
  c.problem = make_problem(c.problem.world(), c.problem.vehicle(), c.problem.start(), goal);
}

using Spoil = void (*)(Case&, Rng&);

const Spoil spoils[] = {
    [](Case& c, Rng& rng) { c.path.start.x += error(2e-6, rng); },
    [](Case& c, Rng& rng) { c.path.start.heading += error(2e-6, rng); },
    [](Case& c, Rng& rng) {
      Pose goal = c.problem.goal();
      goal.y += error(2e-6, rng);
      aim(c, goal);
    },
    [](Case& c, Rng& rng) {
      Pose goal = c.problem.goal();
      goal.heading += error(2e-6, rng);
      aim(c, goal);
    },
    // Longer or shorter by d: the end is off by d after a line, by d / 7 m radians after an arc.
    [](Case& c, Rng& rng) { some_segment(c.path, rng).length += error(1e-5, rng); },
    [](Case& c, Rng& rng) {
      Segment& segment = some_segment(c.path, rng);
      segment.length = -segment.length;
    },
    [](Case& c, Rng& rng) { some_segment(c.path, rng).curvature -= error(1e-4, rng); },
    // Too tight, and the goal where it leads to.
    [](Case& c, Rng& rng) {
      some_segment(c.path, rng).curvature = (1 + std::abs(error(1e-8, rng))) / default_radius;
      aim(c, end_pose(c.path));
    },
    [](Case& c, Rng& rng) {
      some_segment(c.path, rng).length = std::numeric_limits<double>::quiet_NaN();
    },
    [](Case& c, Rng&) { c.path.segments.pop_back(); },
    [](Case& c, Rng& rng) { c.claims.length = *c.claims.length + error(2e-6, rng); },
    [](Case& c, Rng&) { c.claims.gear_changes = *c.claims.gear_changes + 1; },
    // A pebble under the vehicle, a yard that is all wall, a wall of the bounds across the way.
    [](Case& c, Rng& rng) {
      const Pose pose = some_pose(c.path, rng);
      const Pose p = compose(pose, {uniform(-1.55, 5.85, rng), uniform(-1.22, 1.22, rng), 0});
      std::vector<Polygon> obstacles = obstacles_of(c.problem);
      obstacles.push_back(random_polygon({p.x, p.y}, 0.05, rng));
      rebuild(c, std::move(obstacles), wide_bounds);
    },
    [](Case& c, Rng&) { rebuild(c, {box(-300, -300, 300, 300)}, wide_bounds); },
    [](Case& c, Rng& rng) {
      Bounds bounds = wide_bounds;
      bounds.x_min = some_pose(c.path, rng).x + std::abs(error(1e-8, rng));
      rebuild(c, obstacles_of(c.problem), bounds);
    },
    [](Case& c, Rng& rng) {
      Bounds bounds = wide_bounds;
      bounds.y_max = some_pose(c.path, rng).y - std::abs(error(1e-8, rng));
      rebuild(c, obstacles_of(c.problem), bounds);
    },
};

TEST(PathCheckLaw, SpoiledPathsAreRejected) {
  for (std::size_t kind = 0; kind < std::size(spoils); ++kind) {
    SCOPED_TRACE("spoil " + std::to_string(kind));
    for_each_case(100 + kind, 100, [&](Rng& rng) {
      Case c = valid_case(rng);
      spoils[kind](c, rng);
      const PathCheck check = check_path(c.problem, c.path, c.claims);
      EXPECT_FALSE(check.valid) << check_as_code(c.problem, c.path);
      EXPECT_NE(check.reason, "");
    });
  }
}

// ---- What must not matter ----

TEST(PathCheckLaw, TheWayBackIsJudgedAlike) {
  for_each_case(2, 500, [&](Rng& rng) {
    const Case c = valid_case(rng);
    SCOPED_TRACE(check_as_code(c.problem, c.path));
    Path back{end_pose(c.path), {c.path.segments.rbegin(), c.path.segments.rend()}};
    for (Segment& segment : back.segments) segment.length = -segment.length;
    const Problem problem =
        make_problem(c.problem.world(), c.problem.vehicle(), c.problem.goal(), c.problem.start());
    const PathCheck check = check_path(problem, back, c.claims);
    EXPECT_TRUE(check.valid) << check.reason;
    EXPECT_NEAR(*check.clearance, *check_path(c.problem, c.path, {}).clearance, 2e-3);
  });
}

TEST(PathCheckLaw, MovingEverythingChangesNothing) {
  for_each_case(3, 500, [&](Rng& rng) {
    const Case c = valid_case(rng);
    SCOPED_TRACE(check_as_code(c.problem, c.path));
    const Pose frame = uniform_pose({-50, 50, -50, 50}, rng);
    std::vector<Polygon> obstacles = obstacles_of(c.problem);
    for (Polygon& polygon : obstacles) {
      for (Point& p : polygon) {
        const Pose moved = compose(frame, {p.x, p.y, 0});
        p = {moved.x, moved.y};
      }
    }
    const Problem problem = problem_of(compose(frame, c.problem.start()),
                                       compose(frame, c.problem.goal()), std::move(obstacles));
    const PathCheck check = check_path(problem, {problem.start(), c.path.segments}, c.claims);
    EXPECT_TRUE(check.valid) << check.reason;
    EXPECT_NEAR(*check.clearance, *check_path(c.problem, c.path, {}).clearance, 2e-3);
  });
}

TEST(PathCheckLaw, CuttingSegmentsChangesNothing) {
  for_each_case(4, 500, [&](Rng& rng) {
    const Case c = valid_case(rng);
    SCOPED_TRACE(check_as_code(c.problem, c.path));
    Path cut{c.path.start, {}};
    for (const Segment& segment : c.path.segments) {
      const double part = segment.length * uniform01(rng);
      cut.segments.push_back({segment.curvature, part});
      cut.segments.push_back({segment.curvature, segment.length - part});
    }
    const PathCheck check = check_path(c.problem, cut, c.claims);
    EXPECT_TRUE(check.valid) << check.reason;
    EXPECT_NEAR(*check.clearance, *check_path(c.problem, c.path, {}).clearance, 2e-3);
  });
}

}  // namespace
}  // namespace vandplan
