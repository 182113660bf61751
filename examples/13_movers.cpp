// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How do I plan among moving obstacles, and where is my truck at which time?

#include <vandplan/planner.h>

#include <cstdio>

int main() {
  vandplan::Scenario gate;  // a wall, with a gate of 7 m in it
  gate.bounds = {-20, 80, -30, 30};
  gate.goal = {60, 0, 0};
  gate.obstacles = {{{25, 3.5}, {26, 3.5}, {26, 30}, {25, 30}},
                    {{25, -30}, {26, -30}, {26, -3.5}, {25, -3.5}}};

  vandplan::PlanOptions options;
  options.budget.max_iterations = 2000;
  options.clearance.margin = 0.5;  // distance from standing and moving obstacles [m]
  const vandplan::PlanResult alone = vandplan::plan(gate, options);
  if (!alone.path) return 1;
  const vandplan::TimedPath fastest{*alone.path,
                                    vandplan::speed_profile(*alone.path, gate.vehicle)};

  // A forklift crosses behind the gate: y from -25 m to 25 m in 25 s. Then it is gone.
  gate.moving = {{.outline = {{-2, -1}, {2, -1}, {2, 1}, {-2, 1}},
                  .trajectory = {{0, {32, -25, 1.5708}}, {25, {32, 25, 1.5708}}},
                  .after = vandplan::Afterwards::leaves}};
  const auto meeting = vandplan::first_meeting(fastest, gate.vehicle, gate.moving, 0.0);
  if (!meeting) return 1;
  std::printf("alone: %.1f s; the forklift would be met after %.1f s, at x %.1f m\n",
              fastest.speeds.duration, meeting->t, meeting->pose.x);

  const vandplan::PlanResult result = vandplan::plan(gate, options);
  if (!result.path || !result.drive_check) return 1;
  std::printf("among others: %.1f s; never nearer to the forklift than %.2f m\n",
              result.speeds->duration, result.drive_check->clearance.value_or(0));
  for (const vandplan::Motion& motion :
       vandplan::sampled(*result.path, gate.vehicle, *result.speeds, 4.0)) {
    // The pose of the forklift; none once it is gone.
    const auto forklift = vandplan::pose_at(gate.moving.front(), motion.t);
    std::printf("t %4.1f  x %5.2f  v %5.2f m/s%s", motion.t, motion.pose.x, motion.v,
                forklift ? "" : "\n");
    if (forklift) std::printf("; the forklift: y %6.2f\n", forklift->y);
  }

  // `plan` has asked the judge already. This call judges a drive that you have timed yourself.
  const auto verdict = vandplan::check_drive(vandplan::make_problem(gate),
                                             {*result.path, *result.speeds}, {.margin = 0.5});
  std::printf("the judge: %s\n", verdict.valid ? "valid" : verdict.reason.c_str());
  return verdict.valid && verdict.duration > fastest.speeds.duration ? 0 : 1;
}
