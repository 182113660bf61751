// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "replanning/judging.h"

#include <algorithm>
#include <utility>

#include "vandplan/drive_check.h"
#include "vandplan/path_check.h"

namespace vandplan::replanning {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

Verdict verdict_of(DriveCheck check) {
  // `clearance` is empty if the check of speeds failed before moving obstacles were checked.
  const double met = check.clearance ? check.t.value_or(never) : never;
  return {std::move(check.reason), met};
}

}  // namespace

Problem Judging::problem_of(const CutDrive& drive, bool reaches_goal) const {
  const double sharpest = 1.0 / scene_.vehicle.min_turning_radius;
  const Path& path = drive.drive.path;
  if (reaches_goal && !scene_.goal_set.empty()) {
    return with_moving(problem_from(scene_, scene_.vehicle, path.start, drive.begin.curvature),
                       scene_.moving);
  }
  const Pose end = reaches_goal ? scene_.goal : end_pose(path);
  const double curvature = std::clamp(drive.begin.curvature, -sharpest, sharpest);
  return with_moving(make_problem(scene_.world, scene_.vehicle, path.start, end, {curvature, 0.0}),
                     scene_.moving);
}

Verdict Judging::of_drive(const CutDrive& drive, bool reaches_goal, double margin) const {
  const Problem problem = problem_of(drive, reaches_goal);
  ClearanceOptions clearance = clearance_;
  clearance.margin = margin;
  PathCheck way = check_path(problem, drive.drive.path, {.clearance = clearance});
  if (!way.valid) return {std::move(way.reason)};
  return verdict_of(
      check_drive(problem, drive.drive, {margin, drive.drive.speeds.knots.front().v}));
}

Verdict Judging::of_path(const CutDrive& drive, bool reaches_goal) const {
  return {check_path(problem_of(drive, reaches_goal), drive.drive.path, {.clearance = clearance_})
              .reason};
}

Verdict Judging::of_company(const CutDrive& drive, bool reaches_goal) const {
  return verdict_of(
      check_company(problem_of(drive, reaches_goal), drive.drive, {clearance_.margin}));
}

double Judging::met_at(const CutDrive& drive, bool reaches_goal) const {
  const Problem problem = problem_of(drive, reaches_goal);
  if (!check_path(problem, drive.drive.path).valid) return 0.0;
  const DriveCheck check = check_company(problem, drive.drive);
  return check.valid ? never : check.t.value_or(0.0);
}

std::string Judging::reason_of_no_way() const {
  if (!scene_.goal_set.empty()) return "no drive to any of the goals was found";
  const Problem problem = make_problem(scene_.world, scene_.vehicle, scene_.goal, scene_.goal);
  const PathCheck check = check_path(problem, {scene_.goal, {}}, {.clearance = clearance_});
  if (!check.valid) return "the goal cannot be reached: " + check.reason;
  return "no drive to the goal was found";
}

}  // namespace vandplan::replanning
