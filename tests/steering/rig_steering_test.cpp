// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "support/numbers.h"
#include "vandplan/steering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "steering/hitch_turn.h"
#include "support/cases.h"
#include "support/draws.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using std::numbers::pi;

Vehicle rig(double radius, double wheelbase, double hitch, double most) {
  Vehicle vehicle;
  vehicle.min_turning_radius = radius;
  vehicle.hitch = hitch;
  vehicle.max_hitch_angle = most;
  vehicle.trailer = Trailer{.wheelbase = wheelbase};
  return vehicle;
}

/// It folds up at full lock: its trailer is longer than the turning radius.
Vehicle semitrailer() { return rig(5.9, 8.1, 0.6, 1.2); }

Vehicle any_rig(Rng& rng) {
  const double radius = any_size(0.4, 12, rng);
  const double wheelbase = radius * any_size(0.4, 1.8, rng);
  const double hitch = chance(0.3, rng) ? 0 : wheelbase * uniform(-0.4, 0.15, rng);
  return rig(radius, wheelbase, hitch, uniform(0.5, 1.3, rng));
}

State any_state(const Vehicle& vehicle, double reach, Rng& rng) {
  const double most = vehicle.max_hitch_angle;
  const double angle = chance(0.3, rng) ? 0 : uniform(-most, most, rng);
  return {{uniform(-reach, reach, rng), uniform(-reach, reach, rng), uniform(-pi, pi, rng)}, angle};
}

std::string case_as_code(const Vehicle& v, const State& a, const State& b) {
  return braced({v.min_turning_radius, v.trailer->wheelbase, v.hitch, v.max_hitch_angle}) + " " +
         vandplan::as_code(a.pose) + " " + vandplan::as_code(a.hitch_angle) + " to " +
         vandplan::as_code(b.pose) + " " + vandplan::as_code(b.hitch_angle);
}

/// Whether the path leads from state to state within the limits, by the motion of vehicle.h.
testing::AssertionResult leads(const Vehicle& vehicle, const State& from, const State& to,
                               const Piece& piece) {
  const auto wrong = [&](const std::string& what) {
    return testing::AssertionFailure() << what << ": " << case_as_code(vehicle, from, to) << " by "
                                       << vandplan::as_code(piece.view());
  };
  State end = from;
  double sum = 0;
  for (const Segment& s : piece.view()) {
    if (s.length == 0) return wrong("a segment of no length");
    if (std::abs(s.curvature) * vehicle.min_turning_radius > 1 + 1e-12) return wrong("too sharp");
    if (largest_hitch_angle(vehicle, end.hitch_angle, s) > vehicle.max_hitch_angle + 1e-9) {
      return wrong("folds up");
    }
    end = advance(vehicle, end, s);
    sum += std::abs(s.length);
  }
  const double off = std::max({std::abs(end.pose.x - to.pose.x), std::abs(end.pose.y - to.pose.y),
                               std::abs(wrap_angle(end.pose.heading - to.pose.heading)),
                               std::abs(wrap_angle(end.hitch_angle - to.hitch_angle))});
  if (!(off <= 1e-9)) return wrong("ends " + vandplan::as_code(off) + " off");
  if (std::abs(sum - piece.length) > 1e-9) return wrong("has another length");
  if (piece.length < reeds_shepp_length(from.pose, to.pose, vehicle.min_turning_radius) - 1e-9) {
    return wrong("is shorter than the tractor's");
  }
  return testing::AssertionSuccess();
}

TEST(RigSteering, LeadsFromAnyStateToAnyOther) {
  for_each_case(1, 600, [](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const double reach = vehicle.min_turning_radius * any_size(0.1, 20, rng);
    const State from = any_state(vehicle, reach, rng), to = any_state(vehicle, reach, rng);
    const auto piece = RigSteering(vehicle).steer(from, to);
    ASSERT_TRUE(piece) << case_as_code(vehicle, from, to);
    EXPECT_TRUE(leads(vehicle, from, to, *piece));
  });
}

/// Angles and lengths at which words vanish, rigs hold their angle or stand at the limit.
TEST(RigSteering, LeadsBetweenNastyStates) {
  for_each_case(2, 600, [](Rng& rng) {
    Vehicle vehicle = chance(0.5, rng) ? semitrailer() : any_rig(rng);
    const double radius = vehicle.min_turning_radius, most = vehicle.max_hitch_angle;
    if (chance(0.2, rng)) vehicle = rig(radius, radius, 0, most);
    const auto one_of = [&](const std::vector<double>& list) {
      return list[static_cast<std::size_t>(uniform01(rng) * static_cast<double>(list.size()))];
    };
    const auto angle = [&] {
      const double held = std::asin(std::min(1.0, vehicle.trailer->wheelbase / radius));
      return std::clamp(any_sign(one_of({0, 0, most, 0.3, held, 1e-9, 1e-6}), rng), -most, most);
    };
    const State from{{0, 0, 0}, angle()};
    const State to{{radius * one_of({0, 0, 1, -1, 2, -2, 1e-9, 1e-6, 1e-3, 10, -10}),
                    radius * one_of({0, 0, 1, -1, 2, 1e-9, 1e-6, 1e-3, 4}),
                    one_of({0, 0, pi / 2, -pi / 2, pi, 1e-9, 1e-6, 1e-3})},
                   angle()};
    const auto piece = RigSteering(vehicle).steer(from, to);
    ASSERT_TRUE(piece) << case_as_code(vehicle, from, to);
    EXPECT_TRUE(leads(vehicle, from, to, *piece));
  });
}

TEST(RigSteering, DoesNotMoveBetweenEqualStates) {
  const State state{{3, -2, 1}, 0.7};
  EXPECT_EQ(RigSteering(semitrailer()).steer(state, state)->count, 0);
}

TEST(RigSteering, DrivesStraightWithAStraightRig) {
  const RigSteering steering(semitrailer());
  for (const double way : {40.0, -40.0}) {
    const auto piece = steering.steer({{0, 0, 0}, 0}, {{way, 0, 0}, 0});
    ASSERT_EQ(piece->count, 1);
    EXPECT_EQ(piece->segments[0], (Segment{0, way}));
  }
}

TEST(RigSteering, StaysOnTheCircleThatHoldsTheAngle) {
  const Vehicle vehicle = rig(6, 8, 0, 1.2);
  const double angle = 0.5, curvature = std::sin(angle) / 8;
  for (const double way : {9.0, -9.0}) {
    const State from{{1, 2, 0.3}, angle};
    const State to{advance(from.pose, Segment{curvature, way}), angle};
    const auto piece = RigSteering(vehicle).steer(from, to);
    ASSERT_EQ(piece->count, 1);
    EXPECT_NEAR(piece->segments[0].curvature, curvature, 1e-12);
    EXPECT_NEAR(piece->segments[0].length, way, 1e-9);
  }
}

/// A rig as long as 16.5 m turns round without folding up.
TEST(RigSteering, TurnsRoundWithATrailerThatIsLongerThanTheRadius) {
  const Vehicle vehicle = semitrailer();
  const State from{{0, 0, 0}, 0}, to{{0, 0, pi}, 0};
  const auto piece = RigSteering(vehicle).steer(from, to);
  ASSERT_TRUE(piece);
  EXPECT_TRUE(leads(vehicle, from, to, *piece));
  EXPECT_LT(piece->length, 60);
}

TEST(RigSteering, MovesLittleWhereTheGoalIsNear) {
  for_each_case(3, 400, [](Rng& rng) {
    const Vehicle vehicle = semitrailer();
    const double radius = vehicle.min_turning_radius, most = vehicle.max_hitch_angle;
    const double size = any_size(1e-4, 1, rng);
    const State from = any_state(vehicle, 10, rng);
    State to = from;
    to.pose.x += radius * uniform(-size, size, rng);
    to.pose.y += radius * uniform(-size, size, rng);
    to.pose.heading += uniform(-size, size, rng);
    to.hitch_angle = std::clamp(from.hitch_angle + uniform(-size, size, rng), -most, most);
    const auto piece = RigSteering(vehicle).steer(from, to);
    ASSERT_TRUE(piece) << case_as_code(vehicle, from, to);
    EXPECT_LT(piece->length, 12 * radius * std::cbrt(size)) << case_as_code(vehicle, from, to);
  });
}

TEST(RigSteering, MirrorsThePathOfMirroredStates) {
  for_each_case(4, 200, [](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const double reach = 3 * vehicle.min_turning_radius;
    const State to = any_state(vehicle, reach, rng);
    const double angle = any_state(vehicle, reach, rng).hitch_angle;
    const RigSteering steering(vehicle);
    const auto piece = steering.steer({{0, 0, 0}, angle}, to);
    const auto mirrored = steering.steer(
        {{0, 0, 0}, -angle}, {{to.pose.x, -to.pose.y, -to.pose.heading}, -to.hitch_angle});
    ASSERT_TRUE(piece && mirrored);
    ASSERT_EQ(piece->count, mirrored->count);
    for (std::size_t i = 0; i < piece->count; ++i) {
      EXPECT_EQ(piece->segments[i].curvature, -mirrored->segments[i].curvature);
      EXPECT_EQ(piece->segments[i].length, mirrored->segments[i].length);
    }
  });
}

TEST(RigSteering, DrivesBackTheWayItCame) {
  for_each_case(5, 200, [](Rng& rng) {
    const Vehicle vehicle = semitrailer();
    const double reach = 1.5 * vehicle.min_turning_radius;
    const State from = any_state(vehicle, reach, rng), to = any_state(vehicle, reach, rng);
    const RigSteering steering(vehicle);
    const auto there = steering.steer(from, to), back = steering.steer(to, from);
    ASSERT_TRUE(there && back);
    const Piece expected = reversed(*back);
    ASSERT_EQ(there->count, expected.count) << case_as_code(vehicle, from, to);
    for (std::size_t i = 0; i < there->count; ++i) {
      EXPECT_EQ(there->segments[i], expected.segments[i]);
    }
  });
}

TEST(RigSteering, ScalesWithTheRig) {
  for_each_case(6, 200, [](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const State from = any_state(vehicle, 10, rng), to = any_state(vehicle, 10, rng);
    const auto twice = [](State state) {
      state.pose.x *= 2;
      state.pose.y *= 2;
      return state;
    };
    const Vehicle large = rig(2 * vehicle.min_turning_radius, 2 * vehicle.trailer->wheelbase,
                              2 * vehicle.hitch, vehicle.max_hitch_angle);
    const auto piece = RigSteering(vehicle).steer(from, to);
    const auto larger = RigSteering(large).steer(twice(from), twice(to));
    ASSERT_TRUE(piece && larger);
    EXPECT_EQ(2 * piece->length, larger->length);
  });
}

TEST(RigSteering, GivesTheCheapestOfItsCandidates) {
  for_each_case(7, 100, [](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const double reach = 4 * vehicle.min_turning_radius;
    const State from = any_state(vehicle, reach, rng), to = any_state(vehicle, reach, rng);
    const RigSteering steering(vehicle);
    RigPrices prices{.reverse_weight = any_size(0.5, 5, rng),
                     .gear_change_cost = chance(0.5, rng) ? 0 : uniform(0, 10, rng)};
    const std::vector<Piece> all = steering.candidates(from, to, prices);
    const auto piece = steering.steer(from, to, prices);
    ASSERT_TRUE(piece && !all.empty());
    for (const Piece& candidate : all) EXPECT_TRUE(leads(vehicle, from, to, candidate));
    const double least = price_of(prices, all[0].view());
    // The search stops where it is within a hundredth of the bound.
    EXPECT_LE(price_of(prices, piece->view()), 1.01 * least + 1e-9)
        << case_as_code(vehicle, from, to);
    prices.cutoff = least * 0.9;
    const auto cheaper = steering.steer(from, to, prices);  // a detour at most
    EXPECT_LE(cheaper ? price_of(prices, cheaper->view()) : 0.0, prices.cutoff);
    prices.cutoff = least * 0.1;
    EXPECT_FALSE(steering.steer(from, to, prices)) << case_as_code(vehicle, from, to);
    EXPECT_TRUE(steering.candidates(from, to, prices).empty());
  });
}

/// By length it looks at few of its guesses.
TEST(RigSteering, LosesLittleToTheBestOfAllGuesses) {
  double sum = 0, least = 0;
  for_each_case(9, 300, [&](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const double radius = vehicle.min_turning_radius, reach = radius * any_size(0.3, 6, rng);
    const State from = any_state(vehicle, reach, rng), to = any_state(vehicle, reach, rng);
    const RigSteering steering(vehicle);
    const auto piece = steering.steer(from, to);
    const auto all = steering.candidates(from, to, {});
    ASSERT_TRUE(piece && !all.empty());
    sum += piece->length / radius;
    least += std::min(piece->length, all[0].length) / radius;
  });
  EXPECT_LT(sum, (is_sanitized ? 1.3 : 1.05) * least);
}

TEST(RigSteering, LeadsQuicklyBetweenMostStates) {
  int found = 0, all = 0;
  double quick = 0, least = 0;
  for_each_case(10, 1000, [&](Rng& rng) {
    const Vehicle vehicle = any_rig(rng);
    const double reach = vehicle.min_turning_radius * any_size(0.3, 6, rng);
    const State from = any_state(vehicle, reach, rng), to = any_state(vehicle, reach, rng);
    const RigSteering steering(vehicle);
    const auto piece = steering.steer_quickly(from, to);
    ++all;
    if (!piece) return;
    ++found;
    EXPECT_TRUE(leads(vehicle, from, to, *piece));
    const double by_all = steering.steer(from, to)->length;
    EXPECT_LE(by_all, piece->length * (1 + 1e-9));
    quick += piece->length / vehicle.min_turning_radius;
    least += by_all / vehicle.min_turning_radius;
  });
  EXPECT_GE(found, 0.95 * all) << found << " of " << all;
  EXPECT_LT(quick, 1.05 * least);
  EXPECT_THROW((void)RigSteering(semitrailer()).steer_quickly({}, {{nan, 0, 0}, 0}), InputError);
}

TEST(RigSteering, AvoidsWhatIsDear) {
  const RigSteering steering(semitrailer());
  const State from{{0, 0, 0}, 0}, to{{-5, 3, 0}, 0};
  const auto reverse = [&](double weight) {
    double sum = 0;
    const std::optional<Piece> piece = steering.steer(from, to, {.reverse_weight = weight});
    for (const Segment& s : piece->view()) {
      sum += std::max(0.0, -s.length);
    }
    return sum;
  };
  EXPECT_LT(reverse(20), 0.8 * reverse(0.2));
}

TEST(RigSteering, RefusesWhatItCannotSteer) {
  Vehicle alone = semitrailer();
  alone.trailer.reset();
  EXPECT_THROW(RigSteering{alone}, InputError);
  EXPECT_THROW(RigSteering{rig(6, 0, 0, 1)}, InputError);
  EXPECT_THROW(RigSteering{rig(6, 2, -2, 1)}, InputError);
  EXPECT_THROW(RigSteering{rig(6, 8, 0, 3.1)}, InputError);
  const RigSteering steering(semitrailer());
  const State state{{0, 0, 0}, 0};
  EXPECT_THROW((void)steering.steer(state, {{0, 0, 0}, 1.3}), InputError);
  EXPECT_THROW((void)steering.steer(state, {{nan, 0, 0}, 0}), InputError);
  EXPECT_THROW((void)steering.steer(state, {{0, 0, 0}, nan}), InputError);
  EXPECT_THROW((void)steering.steer(state, state, {.reverse_weight = 0}), InputError);
  EXPECT_THROW((void)steering.steer(state, state, {.gear_change_cost = -1}), InputError);
  EXPECT_THROW((void)steering.candidates(state, state, {.cutoff = nan}), InputError);
}

TEST(HitchTurn, AgreesWithTheMotionOfTheRig) {
  for_each_case(8, 500, [](Rng& rng) {
    const Vehicle vehicle = rig(1, any_size(0.3, 3, rng), uniform(-0.2, 0.2, rng), 1.5);
    const steering::HitchTurn hitch(vehicle.trailer->wheelbase, vehicle.hitch, std::tan(0.75));
    const int turn = static_cast<int>(uniform(0, 3, rng)) - 1;
    const double angle = uniform(-1, 1, rng), way = uniform(-1, 1, rng);
    const double end = hitch_angle_after(vehicle, angle, {double(turn), way});
    const auto after = hitch.after(turn, std::tan(angle / 2), way);
    if (std::abs(end) > 3) return;
    EXPECT_NEAR(2 * std::atan(after.u), end, 1e-12);
    EXPECT_NEAR(hitch.after_arc(turn, std::tan(angle / 2), way).u, after.u, 1e-13);
    constexpr double step = 1e-6;
    const double more = hitch.after(turn, std::tan(angle / 2) + step, way).u;
    const double less = hitch.after(turn, std::tan(angle / 2) - step, way).u;
    EXPECT_NEAR((more - less) / (2 * step), after.slope, 1e-6 * (1 + after.slope * after.slope));
    if (turn == 0 || std::abs(end) > 2) return;
    if (std::abs(hitch.rate(turn, std::tan(angle / 2))) < 1e-3) return;
    EXPECT_NEAR(hitch.way_between(turn, std::tan(angle / 2), after.u), way, 1e-9);
  });
}

TEST(HitchTurn, HoldsTheAngleOnItsCircle) {
  const steering::HitchTurn hitch(1.4, 0.1, 1);
  for (const double u : {-0.7, 0.0, 0.2, 0.9}) {
    EXPECT_NEAR(hitch.after_arc(hitch.hold_curvature(u), u, 1).u, u, 1e-15);
  }
}

}  // namespace
}  // namespace vandplan
