// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/vehicle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/cases.h"
#include "support/clothoid_oracle.h"
#include "support/draws.h"

namespace vandplan {
namespace {

using std::numbers::pi;

/// A European semitrailer behind its tractor.
Vehicle semitrailer(double hitch = 0.0) {
  Vehicle vehicle;
  vehicle.hitch = hitch;
  vehicle.trailer = Trailer{.wheelbase = 8.0};
  return vehicle;
}

Vehicle any_rig(Rng& rng) {
  Vehicle vehicle;
  vehicle.trailer = Trailer{.wheelbase = uniform(2.0, 10.0, rng)};
  if (!chance(0.3, rng)) vehicle.hitch = uniform(-2.5, 1.0, rng);
  return vehicle;
}

/// Angles on the way, by Runge and Kutta's method of fourth order in very many steps.
struct SlowAngles {
  long double last = 0;
  long double largest = 0;
};

SlowAngles slow_hitch_angles(const Vehicle& vehicle, double angle, const Segment& segment) {
  using Real = long double;
  const Real wheelbase = vehicle.trailer->wheelbase;
  const Real gear = segment.length < 0 ? -1 : 1;
  const auto rate = [&](Real s, Real a) {
    const Real curvature = segment.curvature + static_cast<Real>(segment.curvature_rate) * s;
    return gear * (curvature - (std::sin(a) + vehicle.hitch * curvature * std::cos(a)) / wheelbase);
  };
  const Real size = std::abs(segment.length);
  const int steps = 200 + static_cast<int>(size * 200);
  const Real h = size / steps;
  SlowAngles result{angle, std::abs(static_cast<Real>(angle))};
  for (int i = 0; i < steps; ++i) {
    const Real s = i * h;
    const Real a = result.last;
    const Real k1 = rate(s, a);
    const Real k2 = rate(s + h / 2, a + h / 2 * k1);
    const Real k3 = rate(s + h / 2, a + h / 2 * k2);
    const Real k4 = rate(s + h, a + h * k3);
    result.last += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    result.largest = std::max(result.largest, std::abs(result.last));
  }
  return result;
}

/// What an error of 1e-16 in the first angle becomes on the way, at least 1: in reverse a trailer
/// runs away from its equilibrium.
double growth(const Vehicle& vehicle, const Segment& segment) {
  const double lever = 1.0 + std::abs(vehicle.hitch) / vehicle.trailer->wheelbase;
  return std::exp(std::max(0.0, -segment.length) * lever / vehicle.trailer->wheelbase);
}

Segment any_arc(Rng& rng) {
  const double curvature = chance(0.2, rng) ? 0.0 : uniform(-0.25, 0.25, rng);
  return {curvature, any_sign(any_size(1e-3, 40, rng), rng)};
}

// ---- Pencil and paper ----

TEST(Rig, TheTrailerStandsBehindTheHitch) {
  const Pose behind = trailer_pose(semitrailer(0.5), {{1, 2, 0}, 0});
  EXPECT_EQ(behind, (Pose{1 + 0.5 - 8, 2, 0}));
  // The tractor points north, the trailer east: the hitch angle is a quarter turn.
  const Pose folded = trailer_pose(semitrailer(0.5), {{0, 0, pi / 2}, pi / 2});
  EXPECT_NEAR(folded.x, -8, 1e-15);
  EXPECT_NEAR(folded.y, 0.5, 1e-15);
  EXPECT_EQ(folded.heading, 0);
}

TEST(Rig, ForwardOnALineTheTangentOfHalfTheAngleDecays) {
  const double start = 1.0;
  const double after = hitch_angle_after(semitrailer(), start, {0, 12});
  EXPECT_NEAR(std::tan(after / 2), std::tan(start / 2) * std::exp(-12.0 / 8.0), 1e-15);
}

TEST(Rig, AnEquilibriumStaysExactlyInBothGears) {
  // 8 m behind an arc of radius 16 m the trailer follows at asin(1 / 2).
  const double curvature = 1.0 / 16;
  double angle = pi / 6;
  if (hitch_rate(semitrailer(), angle, curvature) != 0.0) angle = std::asin(0.5);
  ASSERT_NEAR(hitch_rate(semitrailer(), angle, curvature), 0.0, 1e-17);
  EXPECT_NEAR(hitch_angle_after(semitrailer(), angle, {curvature, 30}), angle, 1e-15);
  EXPECT_EQ(hitch_angle_after(semitrailer(), 0.0, {0, -30}), 0.0);
  EXPECT_EQ(hitch_angle_after(semitrailer(-1), 0.0, {0, -1000}), 0.0);
}

TEST(Rig, ATightCircleFoldsTheTrailerForGood) {
  // No equilibrium: 8 m of trailer on a circle of 4 m. The angle goes round and round.
  const double after = hitch_angle_after(semitrailer(), 0, {0.25, 200});
  EXPECT_GT(after, 4 * pi);
  EXPECT_NEAR(after, static_cast<double>(slow_hitch_angles(semitrailer(), 0, {0.25, 200}).last),
              1e-11);
  const State state = advance(semitrailer(), State{}, {0.25, 200});
  EXPECT_LT(std::abs(state.hitch_angle), pi);
  EXPECT_NEAR(std::remainder(after - state.hitch_angle, 2 * pi), 0, 1e-13);
}

TEST(Rig, TheDoubleEquilibriumIsApproachedLikeOneOverTheWay) {
  // curvature * wheelbase = 1: cot(pi/4 - angle/2) grows by 1 / wheelbase a metre.
  const double angle = 0.3;
  const auto cot = [](double a) { return 1 / std::tan(pi / 4 - a / 2); };
  const double after = hitch_angle_after(semitrailer(), angle, {0.125, 40});
  EXPECT_NEAR(cot(after), cot(angle) + 40.0 / 8.0, 1e-12);
}

// ---- Laws ----

TEST(RigLaw, AnglesAlongSegmentsAreThoseOfManySmallSteps) {
  for_each_case(1, 3000, [&](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const Segment segment = chance(0.5, rng) ? any_arc(rng) : drivable_clothoid(rng);
    const double angle = uniform(-1.5, 1.5, rng);
    SCOPED_TRACE(as_code(segment) + " with " + as_code(angle) + ", hitch " +
                 as_code(vehicle.hitch) + ", wheelbase " + as_code(vehicle.trailer->wheelbase));
    const SlowAngles slow = slow_hitch_angles(vehicle, angle, segment);
    const double tolerance = 1e-11 * growth(vehicle, segment);
    EXPECT_NEAR(hitch_angle_after(vehicle, angle, segment), static_cast<double>(slow.last),
                tolerance);
    EXPECT_NEAR(largest_hitch_angle(vehicle, angle, segment), static_cast<double>(slow.largest),
                1e-5);
    EXPECT_GE(largest_hitch_angle(vehicle, angle, segment) + tolerance,
              static_cast<double>(slow.largest));
  });
}

TEST(RigLaw, TheTrailersAxleRollsWithoutSlip) {
  for_each_case(2, 20000, [&](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const State state{uniform_pose({-9, 9, -9, 9}, rng), uniform(-1.5, 1.5, rng)};
    const double curvature = uniform(-0.25, 0.25, rng);
    constexpr double step = 1e-5;
    const Pose before = trailer_pose(vehicle, advance(vehicle, state, {curvature, -step}));
    const Pose after = trailer_pose(vehicle, advance(vehicle, state, {curvature, step}));
    const double heading = trailer_pose(vehicle, state).heading;
    const double slip =
        -std::sin(heading) * (after.x - before.x) + std::cos(heading) * (after.y - before.y);
    EXPECT_NEAR(slip / (2 * step), 0, 1e-9);
  });
}

TEST(RigLaw, DrivenBackEverythingIsAsBefore) {
  for_each_case(3, 20000, [&](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const State state{uniform_pose({-9, 9, -9, 9}, rng), uniform(-1.0, 1.0, rng)};
    const Segment segment{uniform(-0.2, 0.2, rng), uniform(-8, 8, rng),
                          chance(0.5, rng) ? 0.0 : uniform(-0.05, 0.05, rng)};
    const Segment back{curvature_at(segment, std::abs(segment.length)), -segment.length,
                       -segment.curvature_rate};
    const State after = advance(vehicle, advance(vehicle, state, segment), back);
    EXPECT_NEAR(after.hitch_angle, state.hitch_angle, 1e-11);
    EXPECT_NEAR(std::remainder(after.pose.heading - state.pose.heading, 2 * pi), 0, 1e-13);
  });
}

TEST(RigLaw, CutAnywhereASegmentLeadsToTheSameAngle) {
  for_each_case(4, 20000, [&](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const Segment segment = chance(0.5, rng) ? any_arc(rng) : drivable_clothoid(rng);
    const double angle = uniform(-1.5, 1.5, rng);
    const double size = std::abs(segment.length);
    const double cut = uniform(0, size, rng);
    const double there = hitch_angle_after(vehicle, angle, part_of(segment, 0, cut));
    EXPECT_NEAR(hitch_angle_after(vehicle, there, part_of(segment, cut, size)),
                hitch_angle_after(vehicle, angle, segment), 1e-11 * growth(vehicle, segment));
  });
}

TEST(RigLaw, ThePosesOfBothBodiesSayTheSame) {
  for_each_case(5, 20000, [&](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const State state{uniform_pose({-9, 9, -9, 9}, rng), uniform(-3, 3, rng)};
    const Pose back = tractor_pose(vehicle, trailer_pose(vehicle, state), state.hitch_angle);
    EXPECT_NEAR(back.x, state.pose.x, 1e-14);
    EXPECT_NEAR(back.y, state.pose.y, 1e-14);
    EXPECT_NEAR(std::remainder(back.heading - state.pose.heading, 2 * pi), 0, 1e-14);
  });
}

}  // namespace
}  // namespace vandplan
