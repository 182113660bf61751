// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "moving/encounters.h"
#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

// The default truck: from 1.6 m behind the rear axle to 5.9 m before it, 1.275 m to either side.
using std::numbers::pi;

/// A car of 4 m by 2 m.
const Polygon car = box(-2, -1, 2, 1);

/// Crosses the way ahead from the right at 5 m/s: in the truck's way from 1.745 s to 3.055 s.
MovingObstacle crossing() {
  return {.outline = car, .trajectory = {{0, {15, -12, pi / 2}}, {8, {15, 28, pi / 2}}}};
}

/// Twenty metres straight ahead, as fast as it goes.
TimedPath ahead(const Vehicle& vehicle = {}) {
  const Path path{{0, 0, 0}, {{0, 20}}};
  return {path, speed_profile(path, vehicle)};
}

/// The drive, begun so much later.
TimedPath later(TimedPath drive, double by) {
  for (SpeedKnot& knot : drive.speeds.knots) knot.t += by;
  for (Stop& stop : drive.speeds.stops) stop.t += by;
  drive.speeds.knots.insert(drive.speeds.knots.begin(), SpeedKnot{});
  drive.speeds.stops.insert(drive.speeds.stops.begin(), {.pause = by});
  drive.speeds.duration += by;
  drive.speeds.standing += by;
  return drive;
}

Problem problem_among(const TimedPath& drive, const std::vector<MovingObstacle>& moving) {
  return with_moving(problem_of_path({.bounds = wide_bounds}, drive.path), moving);
}

DriveCheck check_among(const TimedPath& drive, const std::vector<MovingObstacle>& moving,
                       double margin = 0) {
  return check_drive(problem_among(drive, moving), drive, {.margin = margin});
}

// ---- where is it when? ----

TEST(MovingObstacle, IsBetweenItsRowsAndTurnsTheShorterWay) {
  const MovingObstacle door{.outline = car, .trajectory = {{1, {0, 0, 3}}, {3, {4, 2, -3}}}};
  const Pose middle = *pose_at(door, 2);
  EXPECT_DOUBLE_EQ(middle.x, 2);
  EXPECT_DOUBLE_EQ(middle.y, 1);
  EXPECT_NEAR(std::remainder(middle.heading - pi, 2 * pi), 0, 1e-12);
  EXPECT_EQ(pose_at(door, 0), (Pose{0, 0, 3}));
}

TEST(MovingObstacle, StaysOrLeavesAfterItsLastRow) {
  MovingObstacle car_there = crossing();
  EXPECT_EQ(pose_at(car_there, 100), (Pose{15, 28, pi / 2}));
  car_there.after = Afterwards::leaves;
  EXPECT_TRUE(pose_at(car_there, 8));
  EXPECT_FALSE(pose_at(car_there, 8.001));
}

TEST(MovingObstacle, GrowsUntilItsLastRow) {
  MovingObstacle guess = crossing();
  guess.inflate = 0.25;
  EXPECT_DOUBLE_EQ(growth_at(guess, 4), 1);
  EXPECT_DOUBLE_EQ(growth_at(guess, 100), 2);
  EXPECT_EQ(end_of_motion(std::vector{guess}), 8);
}

// ---- who is met? ----

TEST(Meeting, IsFoundWhereAndWhenItHappens) {
  // The truck drives 2.5 m/s from 3.125 m and 2.5 s on; its nose is at the car's way (x = 14 to 16)
  // at 8.1 m, which is at 4.49 s.
  const TimedPath drive = ahead();
  EXPECT_FALSE(first_meeting(drive, {}, std::vector{crossing()}, 0));
  MovingObstacle slow = crossing();
  slow.trajectory.back().t = 16;  // 2.5 m/s: there from 3.49 s to 6.11 s
  const auto meeting = first_meeting(drive, {}, std::vector{crossing(), slow}, 0);
  ASSERT_TRUE(meeting);
  EXPECT_EQ(meeting->obstacle, 1U);
  EXPECT_NEAR(meeting->s, 8.1, 2e-3);
  EXPECT_NEAR(meeting->t, 4.49, 1e-3);
}

TEST(Meeting, MarginAndGrowthAreKept) {
  // A wall on wheels drives beside the truck, 0.5 m away.
  const MovingObstacle beside{.outline = box(-2, 0, 2, 1),
                              .trajectory = {{0, {0, 1.775, 0}}, {12, {24, 1.775, 0}}}};
  const TimedPath drive = ahead();
  EXPECT_FALSE(first_meeting(drive, {}, std::vector{beside}, 0.498));
  EXPECT_EQ(first_meeting(drive, {}, std::vector{beside}, 0.502)->t, 0);
  MovingObstacle guess = beside;
  guess.inflate = 0.1;
  EXPECT_NEAR(first_meeting(drive, {}, std::vector{guess}, 0)->t, 5, 0.02);
}

TEST(Meeting, HappensAfterTheDriveToo) {
  MovingObstacle late = crossing();
  late.trajectory = {{0, {25, -60, pi / 2}}, {30, {25, 0, pi / 2}}};
  const auto meeting = first_meeting(ahead(), {}, std::vector{late}, 0);
  ASSERT_TRUE(meeting);
  EXPECT_NEAR(meeting->t, (60 - 3.275) / 2, 2e-3);
  EXPECT_EQ(meeting->s, 20);
  late.after = Afterwards::leaves;
  late.trajectory.back() = {28, {25, -4, pi / 2}};
  EXPECT_FALSE(first_meeting(ahead(), {}, std::vector{late}, 0));
}

TEST(Meeting, WhatHoldsTheVehicleOrIsInsideItIsMet) {
  const MovingObstacle post{.outline = box(-0.05, -0.05, 0.05, 0.05),
                            .trajectory = {{0, {3, 0, 0}}}};
  const MovingObstacle hall{.outline = box(-90, -90, 90, 90), .trajectory = {{0, {3, 0, 0}}}};
  EXPECT_EQ(first_meeting(ahead(), {}, std::vector{post}, 0)->t, 0);
  EXPECT_EQ(first_meeting(ahead(), {}, std::vector{hall}, 0)->t, 0);
  EXPECT_FALSE(check_among(ahead(), {post}).valid);
  EXPECT_FALSE(check_among(ahead(), {hall}).valid);
}

// ---- the judge ----

TEST(DriveCheck, AFreeDriveIsValidAndItsClearanceKnown) {
  const DriveCheck check = check_among(ahead(), {crossing()});
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_NEAR(check.duration, 2.5 + 2.5 + 13.75 / 2.5, 1e-9);
  EXPECT_GT(*check.clearance, 0);
  EXPECT_EQ(*check_among(ahead(), {}).clearance, std::numeric_limits<double>::infinity());
}

TEST(DriveCheck, NamesWhoIsHitWhereAndWhen) {
  MovingObstacle slow = crossing();
  slow.trajectory.back().t = 16;
  const DriveCheck check = check_among(ahead(), {crossing(), slow});
  EXPECT_EQ(check.reason, "the footprint hits moving[1]");
  EXPECT_NEAR(*check.t, 4.49, 1e-3);
  EXPECT_NEAR(check.at->s, 8.1, 2e-3);
  EXPECT_NEAR(check.at->pose.x, 8.1, 2e-3);
}

TEST(DriveCheck, WaitingLetsItPass) {
  MovingObstacle slow = crossing();
  slow.trajectory.back().t = 16;
  EXPECT_TRUE(check_among(later(ahead(), 3), {slow}).valid);
  EXPECT_FALSE(first_meeting(later(ahead(), 3), {}, std::vector{slow}, 0));
}

TEST(DriveCheck, TheMarginIsHeld) {
  const MovingObstacle parked{.outline = car, .trajectory = {{0, {10, 2.575, 0}}}};
  EXPECT_TRUE(check_among(ahead(), {parked}, 0.3).valid);
  EXPECT_EQ(check_among(ahead(), {parked}, 0.301).reason,
            "the footprint is only 0.301 m from moving[0], the margin is 0.301 m");
}

/// What the judge says of a drive over 20 m that was spoiled.
std::string verdict(const std::function<void(TimedPath&)>& spoil) {
  TimedPath drive = ahead();
  spoil(drive);
  return check_among(drive, {}).reason;
}

TEST(DriveCheck, TimesHaveToFollowFromEachOther) {
  EXPECT_EQ(verdict([](TimedPath&) {}), "");
  EXPECT_EQ(verdict([](TimedPath& d) { d.speeds.knots.clear(); }), "the drive has no knots");
  EXPECT_EQ(verdict([](TimedPath& d) { d.speeds.knots[1].s = NAN; }), "knots[1] is not finite");
  EXPECT_EQ(verdict([](TimedPath& d) { d.speeds.knots[1].t += 0.1; }),
            "knots[1] does not follow from the one before");
  EXPECT_EQ(verdict([](TimedPath& d) { d.speeds.knots[2].t = 2; }),
            "knots[2] is earlier than the one before");
  EXPECT_EQ(verdict([](TimedPath& d) { d.speeds.duration += 1; }),
            "the last knot is at 10.5 s, the stated duration is 11.5 s");
  EXPECT_EQ(verdict([](TimedPath& d) {
              d.path.segments = {{0, 21}};
            }),
            "the drive ends after 20 m, the path is 21 m long");
  EXPECT_EQ(verdict([](TimedPath& d) { d.speeds.knots.front().t = 0.5; }),
            "the drive does not begin at the start at 0 s");
  EXPECT_EQ(verdict([](TimedPath& d) { d.speeds.knots.front().v = 0.5; }),
            "the vehicle does not stand at both ends of the drive");
}

/// What the judge of a truck says of the fastest drive of another one.
std::string verdict_on(std::vector<Segment> segments,
                       const std::function<void(DrivingLimits&)>& relax) {
  Vehicle faster;
  relax(faster.limits);
  const Path path{{0, 0, 0}, std::move(segments)};
  const TimedPath drive{path, speed_profile(path, faster)};
  return check_among(drive, {}).reason;
}

TEST(DriveCheck, EveryLimitIsHeld) {
  const std::vector<Segment> turn = {{0, 5}, {0, 2, 0.05}, {0.1, 4}, {0.1, 2, -0.05}, {0, -8}};
  EXPECT_EQ(verdict_on(turn, [](DrivingLimits&) {}), "");
  // The first place where it is exceeded.
  EXPECT_EQ(verdict_on({{0, 30}}, [](DrivingLimits& l) { l.max_speed.forward = 2.6; }),
            "the speed is 2.50088, the limit is 2.5");
  EXPECT_EQ(verdict_on({{0, -30}}, [](DrivingLimits& l) { l.max_speed.reverse = 1.6; }),
            "the speed is 1.50229, the limit is 1.5");
  EXPECT_EQ(verdict_on({{0, 30}},
                       [](DrivingLimits& l) {
                         l.max_acceleration = 1.1;
                         l.max_braking = 1.0;
                       }),
            "the acceleration is 1.1, the limit is 1");
  EXPECT_EQ(verdict_on({{0, 30}}, [](DrivingLimits& l) { l.max_braking = 1.1; }),
            "the braking is 1.1, the limit is 1");
  EXPECT_NE(verdict_on({{0, 5}, {0, 1, 0.14}}, [](DrivingLimits& l) { l.max_steering_rate = 2; })
                .find("the steering rate is "),
            std::string::npos);
  EXPECT_EQ(verdict_on({{0, 5}, {0.1, 5}}, [](DrivingLimits& l) { l.max_steering_rate = 1; })
                .substr(0, 28),
            "the vehicle stands for 0.422");
  Vehicle gentle;
  gentle.limits.max_lateral_acceleration = 0.5;
  const Path arc{{0, 0, 0}, {{1.0 / 7, 30}}};
  const Problem problem = problem_of_path({.bounds = wide_bounds}, arc, gentle);
  EXPECT_EQ(check_drive(problem, {arc, speed_profile(arc, {})}).reason.substr(0, 27),
            "the lateral acceleration is");
}

TEST(DriveCheck, TheAccelerationJumpsNowhereIfTheJerkIsLimited) {
  const Path path{{0, 0, 0}, {{0, 40}}};
  Vehicle smooth;
  smooth.limits.max_jerk = 5;
  const Problem problem = problem_of_path({.bounds = wide_bounds}, path, smooth);
  EXPECT_TRUE(check_drive(problem, {path, speed_profile(path, smooth)}).valid);
  const TimedPath jumping{path, speed_profile(path, {})};  // its knots have no jerk
  EXPECT_EQ(check_drive(problem, jumping).reason,
            "the acceleration jumps from 0 to 1, the jerk is limited");
}

TEST(DriveCheck, LimitsAreHeldWithinWhatIsDrivenAtOneSpeed) {
  Vehicle gentle;
  gentle.limits.max_lateral_acceleration = 0.5;
  gentle.limits.max_steering_rate = 10;
  // A bend amidst lines, which asks for 0.625 m/s^2 at 2.5 m/s.
  const Path path{{0, 0, 0}, {{0, 15}, {0, 1, 0.1}, {0.1, 4}, {0.1, 1, -0.1}, {0, 19}}};
  const Problem problem = problem_of_path({.bounds = wide_bounds}, path, gentle);
  const SpeedProfile as_if_straight = speed_profile({{0, 0, 0}, {{0, 40}}}, gentle);
  EXPECT_EQ(check_drive(problem, {path, as_if_straight}).reason.substr(0, 27),
            "the lateral acceleration is");
}

TEST(DriveCheck, StandsWhereTheGearChanges) {
  const Path path{{0, 0, 0}, {{0, 10}, {0, -10}}};
  Vehicle slow;
  slow.limits.max_speed.forward = 1.5;
  const TimedPath drive{path, speed_profile({{0, 0, 0}, {{0, 20}}}, slow)};
  EXPECT_EQ(check_among(drive, {}).reason, "the vehicle drives at 1.5 m/s where the gear changes");
}

TEST(DriveCheck, WorksFarFromTheOrigin) {
  TimedPath drive = ahead();
  MovingObstacle slow = crossing();
  slow.trajectory.back().t = 16;
  for (TimedPose& row : slow.trajectory) row.pose.x += 5e9;
  drive.path.start.x += 5e9;
  Scenario scenario;
  scenario.bounds = {5e9 - 100, 5e9 + 100, -100, 100};
  scenario.start = drive.path.start;
  scenario.goal = end_pose(drive.path);
  scenario.moving = {slow};
  const DriveCheck check = check_drive(make_problem(scenario), drive);
  EXPECT_EQ(check.reason, "the footprint hits moving[0]");
  EXPECT_NEAR(check.at->pose.x - 5e9, 8.1, 2e-3);
}

// ---- a trailer ----

/// A drive of a rig.
struct RigDrive {
  Vehicle rig;
  TimedPath drive;
  double hitch_angle = 0;  // at the start
};

std::optional<Meeting> first_meeting(const RigDrive& rig_drive, const MovingObstacle& mover,
                                     double margin) {
  const auto& [rig, drive, hitch_angle] = rig_drive;
  return moving::first_meeting({drive.path, rig, hitch_angle}, drive.speeds, {&mover, 1}, margin);
}

DriveCheck check_among(const RigDrive& rig_drive, const std::vector<MovingObstacle>& moving,
                       double margin) {
  const auto& [rig, drive, hitch_angle] = rig_drive;
  State state{drive.path.start, hitch_angle};
  for (const Segment& segment : drive.path.segments) state = advance(rig, state, segment);
  const Problem alone = make_problem(world_of({.bounds = wide_bounds}), rig, drive.path.start,
                                     state.pose, {}, {hitch_angle, state.hitch_angle});
  return check_drive(with_moving(alone, moving), drive, {.margin = margin});
}

TEST(TrailerMeeting, WhoDrivesBehindTheTractorHitsTheTrailer) {
  // The tractor's rear is past x = 3 after 3.9 m; the trailer is there for 11.4 m more.
  const Path path{{0, 0, 0}, {{0, 30}}};
  RigDrive rig{semitrailer(), {path, speed_profile(path, semitrailer())}};
  const MovingObstacle behind{.outline = box(-0.5, -0.5, 0.5, 0.5),
                              .trajectory = {{0, {3, -12, pi / 2}}, {8, {3, 12, pi / 2}}}};
  const double at_the_side = (12 - 0.5 - 1.275) / 3;
  const auto meeting = first_meeting(rig, behind, 0);
  ASSERT_TRUE(meeting);
  EXPECT_NEAR(meeting->t, at_the_side, 2e-3);
  const DriveCheck check = check_among(rig, {behind}, 0);
  EXPECT_EQ(check.reason, "the trailer's footprint hits moving[0]");
  EXPECT_NEAR(*check.t, at_the_side, 2e-3);
  rig.rig.trailer.reset();
  EXPECT_FALSE(first_meeting(rig, behind, 0));
}

TEST(TrailerMeeting, DependsOnTheHitchAngleAtTheStart) {
  const Path path{{0, 0, 0}, {}};
  RigDrive stands{semitrailer(), {path, speed_profile(path, semitrailer())}};
  const MovingObstacle post{.outline = box(-0.2, -0.2, 0.2, 0.2), .trajectory = {{0, {-4, 6, 0}}}};
  EXPECT_FALSE(first_meeting(stands, post, 0.5));
  EXPECT_TRUE(check_among(stands, {post}, 0.5).valid);
  stands.hitch_angle = 1.0;
  EXPECT_TRUE(first_meeting(stands, post, 0.5));
  EXPECT_EQ(check_among(stands, {post}, 0.5).reason.substr(0, 23), "the trailer's footprint");
}

TEST(TrailerMeeting, ATailThatSwingsPastIsSeenAtOnce) {
  // A tail of 12 m behind an axle that follows 3 m behind its hitch: while the rig straightens its
  // tip is several times as fast as the tractor, and past the post in a moment.
  Vehicle rig{3.6, 1.4, 0.9, 2.55, 5.9};
  rig.trailer = Trailer{.wheelbase = 3};
  rig.trailer->outline = {{-12, 0}, {2.9, -1.2}, {2.9, 1.2}};
  const Path path{{0, 0, 0}, {{0, 6}}};
  const RigDrive drive{rig, {path, speed_profile(path, rig)}, 1.1};
  // Beside the tip at the start stands another post, 3 mm away: the judge need not look as closely
  // at anything that is further away.
  const Pose tail = trailer_pose(rig, {path.start, drive.hitch_angle});
  const Pose beside = advance(tail, Segment{0, -12.008});
  const MovingObstacle near{.outline = box(-0.005, -0.005, 0.005, 0.005),
                            .trajectory = {{0, beside}}};
  for (const double s : {0.3, 0.6, 0.9}) {
    const State there = advance(rig, {path.start, drive.hitch_angle}, {0, s});
    const Pose tip = advance(trailer_pose(rig, there), Segment{0, -11.95});
    const MovingObstacle post{.outline = box(-0.005, -0.005, 0.005, 0.005),
                              .trajectory = {{0, {tip.x, tip.y, 0}}}};
    const auto meeting = first_meeting(drive, post, 0);
    ASSERT_TRUE(meeting);
    EXPECT_NEAR(meeting->s, s, 0.02);
    const DriveCheck check = check_among(drive, {near, post}, 0);
    EXPECT_EQ(check.reason, "the trailer's footprint hits moving[1]");
    EXPECT_NEAR(check.t.value_or(-1), meeting->t, 0.02);
  }
}

// ---- both agree ----

/// A random drive of a rig that does not fold up, in both gears, with clothoids.
RigDrive any_rig_drive(Rng& rng) {
  RigDrive any{semitrailer(), {}};
  Vehicle& rig = any.rig;
  rig.hitch = uniform(-1.5, 1, rng);
  rig.trailer->wheelbase = uniform(3, 9, rng);
  if (uniform01(rng) < 0.3) {
    rig.trailer->outline = {{-4, -1.2}, {rig.trailer->wheelbase, 0}, {-4, 1.2}};
  }
  any.hitch_angle = uniform(-1, 1, rng);
  Path& path = any.drive.path;
  path.start = {uniform(-5, 5, rng), uniform(-5, 5, rng), uniform(-pi, pi, rng)};
  double angle = any.hitch_angle;
  for (int i = 0; i < 4; ++i) {
    Segment segment{uniform(-0.16, 0.16, rng),
                    uniform(2, 12, rng) * (uniform01(rng) < 0.3 ? -1 : 1)};
    if (uniform01(rng) < 0.3) segment.curvature_rate = uniform(-0.01, 0.01, rng);
    if (largest_hitch_angle(rig, angle, segment) > rig.max_hitch_angle) continue;
    path.segments.push_back(segment);
    angle = hitch_angle_after(rig, angle, segment);
  }
  any.drive.speeds = speed_profile(path, rig);
  return any;
}

TEST(MeetingLaw, TheJudgeFindsTheSameMeetingsOfTrailers) {
  int met = 0, by_trailer = 0;
  for_each_case(2, 1000, [&](Rng& rng) {
    const RigDrive drive = any_rig_drive(rng);
    MovingObstacle mover{.outline = {{-2, -1}, {2, -1}, {0.5, 0}, {2, 1}, {-2, 1}}};
    double t = uniform(-2, 3, rng);
    for (int i = 0; i < 4; ++i) {
      mover.trajectory.push_back(
          {t, {uniform(-25, 25, rng), uniform(-25, 25, rng), uniform(-pi, pi, rng)}});
      t += uniform(1, 8, rng);
    }
    if (uniform01(rng) < 0.5) mover.after = Afterwards::leaves;
    if (uniform01(rng) < 0.3) mover.inflate = uniform(0, 0.3, rng);
    const double margin = uniform01(rng) < 0.5 ? 0.0 : uniform(0, 1, rng);
    const auto meeting = first_meeting(drive, mover, margin);
    const DriveCheck check = check_among(drive, {mover}, margin);
    if (!meeting) {
      EXPECT_TRUE(check.valid) << check.reason;
      return;
    }
    ++met;
    EXPECT_LE(*check.clearance, 1.06 * margin + 2 * meeting_tolerance);
    if (check.valid) return;
    by_trailer += check.reason.starts_with("the trailer's footprint");
    EXPECT_LE(meeting->t, *check.t + 1e-9);
    EXPECT_GE(meeting->t, *check.t - 0.5);
  });
  EXPECT_GT(met, cases(1000) / 10);
  EXPECT_GT(by_trailer, cases(1000) / 50);
}

TEST(MeetingLaw, TheJudgeFindsTheSameMeetings) {
  int met = 0;
  for_each_case(1, 1500, [&](Rng& rng) {
    std::vector<Segment> segments;
    for (int i = 0; i < 3; ++i) {
      segments.push_back(
          {uniform(-0.14, 0.14, rng), uniform(2, 12, rng) * (uniform(0, 1, rng) < 0.3 ? -1 : 1)});
    }
    const Path path{{uniform(-5, 5, rng), uniform(-5, 5, rng), uniform(-pi, pi, rng)}, segments};
    const TimedPath drive{path, speed_profile(path, {})};
    MovingObstacle mover{.outline = {{-2, -1}, {2, -1}, {0.5, 0}, {2, 1}, {-2, 1}}};
    double t = uniform(-2, 3, rng);
    for (int i = 0; i < 4; ++i) {
      mover.trajectory.push_back(
          {t, {uniform(-25, 25, rng), uniform(-25, 25, rng), uniform(-pi, pi, rng)}});
      t += uniform(1, 8, rng);
    }
    if (uniform(0, 1, rng) < 0.5) mover.after = Afterwards::leaves;
    if (uniform(0, 1, rng) < 0.3) mover.inflate = uniform(0, 0.3, rng);
    const double margin = uniform(0, 1, rng) < 0.5 ? 0.0 : uniform(0, 1, rng);
    const auto meeting = first_meeting(drive, {}, std::vector{mover}, margin);
    const DriveCheck check = check_among(drive, {mover}, margin);
    if (!meeting) {
      // What is accepted is good.
      EXPECT_TRUE(check.valid) << check.reason;
    } else {
      ++met;
      // What is refused is nearer than margin and tolerance, and at the same time.
      EXPECT_LE(*check.clearance, 1.06 * margin + 2 * meeting_tolerance);
      if (!check.valid) {
        EXPECT_LE(meeting->t, *check.t + 1e-9);
      }
    }
  });
  EXPECT_GT(met, cases(1500) / 10);
}

// ---- what a user hands in ----

std::string refusal(const MovingObstacle& mover) {
  try {
    (void)with_moving(problem_of({0, 0, 0}, {20, 0, 0}, {}), std::vector{crossing(), mover});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Moving, IsCheckedOnceAtTheDoor) {
  MovingObstacle mover = crossing();
  mover.outline = {{0, 0}, {1, 0}};
  EXPECT_EQ(refusal(mover), "moving[1].outline: has 2 corners, expected at least 3");
  mover = crossing();
  mover.trajectory[1].t = 0;
  EXPECT_EQ(
      refusal(mover),
      "moving[1].trajectory[1]: has the time 0, expected more than that of the row before, 0");
  mover = crossing();
  mover.trajectory.clear();
  EXPECT_EQ(refusal(mover), "moving[1].trajectory: is empty, expected at least one row");
  mover = crossing();
  mover.inflate = -1;
  EXPECT_EQ(refusal(mover), "moving[1].inflate: is -1, expected 0 to 10 m/s");
  mover = crossing();
  mover.outline[0].x = -1e4;
  EXPECT_EQ(refusal(mover),
            "moving[1].outline: is -10000, expected a number between -1000 and 1000");
}

}  // namespace
}  // namespace vandplan
