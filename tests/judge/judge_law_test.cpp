// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The judge leaves out what it knows to be no nearer. Whatever it says must be what looking
// everywhere says: on maps that are turned, crowded, empty or closed, with obstacles that are
// grazed or tens of metres away.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "judge/ground.h"
#include "support/cases.h"
#include "support/judge_oracle.h"
#include "support/map_cases.h"
#include "support/numbers.h"
#include "support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using std::numbers::pi;
constexpr Bounds wide_ground{-1e4, 1e4, -1e4, 1e4};

/// Around the origin, with blocked cells wherever one looks, and walls around it at times.
OccupancyGrid crowded_grid(Rng& rng) {
  const auto side = [&] { return static_cast<std::int32_t>(uniform(5, 30, rng)); };
  OccupancyGrid grid = random_grid(side(), side(), any_size(1e-3, 0.1, rng), rng);
  grid.unknown_is_free = chance(0.3, rng);
  grid.resolution = uniform(1, 3, rng);
  const Pose turned{uniform(-5, 5, rng), uniform(-5, 5, rng), uniform(-pi, pi, rng)};
  grid.origin =
      compose(turned, {-grid.columns * grid.resolution / 2, -grid.rows * grid.resolution / 2, 0});
  return grid;
}

// ---- One passage ----

judge::Position position_of(const Pose& pose) { return {pose.x, pose.y, pose.heading}; }

struct Counts {
  int proven = 0;  // what is said of a passage is not 0, ...
  int close = 0;   // and nearly what is true
  int touched = 0;
  int cut_off = 0;  // at the most that was asked for
};

/// What the judge says of one passage, of cells or of polygons.
template <typename Clearance>
void expect_passage(const Clearance& clearance, const OracleBody& body,
                    const std::vector<Polygon>& squares, Rng& rng, Counts& counts) {
  const Pose pose = uniform_pose({-8, 8, -8, 8}, rng);
  const double curvature = chance(0.3, rng) ? 0 : any_sign(any_size(1e-6, 5, rng), rng);
  const double half = any_size(1e-4, 20, rng);
  const double rate = chance(0.5, rng) ? 0 : any_sign(any_size(1e-6, 2, rng) / half, rng);
  const double most = chance(0.5, rng) ? infinity : any_size(1e-3, 10, rng);
  const double exact = gap_at(body, squares, pose).distance;
  const double here = clearance(judge::Passage{position_of(pose)}, most);
  if (exact < most) {
    EXPECT_NEAR(here, exact, 1e-9);
  } else {
    EXPECT_EQ(here, most);
    ++counts.cut_off;
  }
  counts.touched += exact == 0;
  const double bound = clearance(judge::Passage{position_of(pose), curvature, half, rate}, most);
  EXPECT_LE(bound, most);
  double least = exact;
  for (int i = 0; i < 40; ++i) {
    const double s = i < 2 ? any_sign(half, rng) : uniform(-half, half, rng);
    const Pose there = advance(pose, {curvature, s, std::copysign(1.0, s) * rate});
    least = std::min(least, gap_at(body, squares, there).distance);
  }
  EXPECT_LE(bound, least + 1e-9) << as_code(pose) << " curvature " << as_code(curvature) << " rate "
                                 << as_code(rate) << " half " << as_code(half) << ": "
                                 << as_code(squares);
  counts.proven += bound > 0 && bound < most;
  counts.close += bound > 0.8 * std::min(least, most) && least < infinity;
}

TEST(JudgeLaw, NothingOnAPassageIsNearerThanTheJudgeSays) {
  constexpr int count = 20000;
  Counts cells;
  Counts polygons;
  for_each_case(1, count, [&](Rng& rng) {
    const Vehicle vehicle = any_body(rng);
    const OracleBody body(vehicle);
    const judge::Outline outline = judge::outlines_of(vehicle).body;
    const OccupancyGrid grid = chance(0.8, rng) ? any_grid(rng) : crowded_grid(rng);
    const std::vector<Polygon> squares = squares_of(grid);
    const auto clearance_in = [&](const judge::Ground& ground) {
      return [&](const judge::Passage& passage, double most) {
        judge::Effort effort;
        return ground.clearance(judge::view_of(passage), {outline, outline}, most, effort);
      };
    };
    const Surroundings map{.map = grid};
    expect_passage(clearance_in(judge::Ground(map)), body, squares, rng, cells);
    if (squares.empty()) return;
    const Surroundings square{.obstacles = {squares.front()}};
    expect_passage(clearance_in(judge::Ground(square)), body, square.obstacles, rng, polygons);
  });
  for (const Counts& counts : {cells, polygons}) {
    EXPECT_GT(counts.proven, cases(count) / 8);
    EXPECT_GT(counts.close, cases(count) / 8);
    EXPECT_GT(counts.touched, cases(count) / 128);
    EXPECT_GT(counts.cut_off, cases(count) / 8);
  }
}

// ---- Whole paths ----

struct LawVerdicts {
  int valid = 0;
  int grazing = 0;  // valid by less than 5 mm
  int far = 0;      // valid by more than 10 m
  int alone = 0;    // without obstacles
  int invalid = 0;
};

void expect_verdict(const Vehicle& vehicle, const OccupancyGrid& grid, const Path& path,
                    LawVerdicts& verdicts) {
  const std::vector<Polygon> squares = squares_of(grid);
  SCOPED_TRACE(as_code(path) + " on cells of " + as_code(grid.resolution) + " m at " +
               as_code(grid.origin) + ": " + as_code(squares));
  for (const Surroundings& surroundings : {Surroundings{.bounds = wide_ground, .map = grid},
                                           {.bounds = wide_ground, .obstacles = squares}}) {
    const PathCheck check = check_path(problem_of_path(surroundings, path, vehicle), path);
    ASSERT_TRUE(check.clearance);
    const std::vector<Foes> foes = {{footprint(vehicle), squares}};
    expect_as_seen(check, foes, path);
    if (testing::Test::HasFatalFailure()) return;
    ++(check.valid ? verdicts.valid : verdicts.invalid);
    verdicts.grazing += check.valid && check.clearance < 5e-3;
    verdicts.far += check.valid && check.clearance > 10 && check.clearance < infinity;
    verdicts.alone += check.clearance == infinity;
  }
}

TEST(JudgeLaw, VerdictAndClearanceAreThoseOfLookingEverywhere) {
  constexpr int count = 1000;
  LawVerdicts verdicts;
  for_each_case(2, count, [&](Rng& rng) {
    const Vehicle vehicle = any_vehicle(rng);
    const Path path = any_edge(rng);
    if (chance(0.2, rng)) return expect_verdict(vehicle, crowded_grid(rng), path, verdicts);
    OccupancyGrid grid = any_grid(rng);
    if (chance(0.1, rng)) grid.origin = compose({uniform(10, 60, rng), 0, 0}, grid.origin);
    if (chance(0.6, rng)) graze(grid, footprint(vehicle), path, rng);
    expect_verdict(vehicle, grid, path, verdicts);
  });
  EXPECT_GT(verdicts.valid, cases(count) / 2);
  EXPECT_GT(verdicts.grazing, cases(count) / 8);
  EXPECT_GT(verdicts.far, cases(count) / 32);
  EXPECT_GT(verdicts.alone, cases(count) / 64);
  EXPECT_GT(verdicts.invalid, cases(count) / 8);
}

}  // namespace
}  // namespace vandplan
