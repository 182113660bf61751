// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "replanning/judging.h"

#include <utility>

#include "vandplan/drive_check.h"
#include "vandplan/path_check.h"

namespace vandplan::replanning {
namespace {

constexpr double never_met = std::numeric_limits<double>::infinity();

Verdict verdict_of(DriveCheck check) {
  // `clearance` is empty if the check of speeds failed before moving obstacles were checked.
  const double met = check.clearance ? check.t.value_or(never_met) : never_met;
  return {std::move(check.reason), met};
}

}  // namespace

Problem Judging::problem_of(const CutDrive& drive, bool reaches_goal) const {
  const Path& path = drive.drive.path;
  if (reaches_goal) {
    return with_moving(problem_from(scene_, scene_.vehicle, drive.begin), scene_.moving);
  }
  const RigMotion end{{.pose = end_pose(path)},
                      hitch_angle_after(scene_.vehicle, drive.begin.hitch_angle, path.segments)};
  return with_moving(problem_to(scene_, scene_.vehicle, drive.begin, end), scene_.moving);
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
  return check.valid ? never_met : check.t.value_or(0.0);
}

std::string Judging::reason_of_no_way() const {
  if (!scene_.goal_set.empty()) return "no drive to any of the goals was found";
  const RigMotion goal{{.pose = scene_.goal}, scene_.goal_hitch_angle};
  const Problem problem = problem_to(scene_, scene_.vehicle, goal, goal);
  const PathCheck check = check_path(problem, {scene_.goal, {}}, {.clearance = clearance_});
  if (!check.valid) return "the goal cannot be reached: " + check.reason;
  return "no drive to the goal was found";
}

}  // namespace vandplan::replanning
