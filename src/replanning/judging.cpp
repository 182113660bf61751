// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "replanning/judging.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "replanning/deviation.h"
#include "vandplan/judge.h"

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
    // On the last stretch the rest of it is asked for.
    Scene scene = scene_;
    for (GoalRegion& region : scene.goal_set) {
      region.straight = std::min(region.straight, length(path));
    }
    return with_moving(problem_from(scene, scene.vehicle, drive.begin), scene.moving);
  }
  const RigMotion end{{.pose = end_pose(path)},
                      hitch_angle_after(scene_.vehicle, drive.begin.hitch_angle, path.segments)};
  return with_moving(problem_to(scene_, scene_.vehicle, drive.begin, end), scene_.moving);
}

/// Fault of a rig that is folded up before the drive; good if it is not. No drive is any better.
Verdict Judging::of_begin(const CutDrive& drive) const {
  const double angle = drive.begin.hitch_angle;
  if (!is_folded_up(scene_.vehicle, angle)) return {};
  return {"the rig is folded up (jackknife): its hitch angle is " + base::shortest_text(angle) +
              " rad, its limit " + base::shortest_text(scene_.vehicle.max_hitch_angle) + " rad",
          0.0};
}

Verdict Judging::of_drive(const CutDrive& drive, bool reaches_goal, double margin) const {
  if (Verdict begin = of_begin(drive); !begin.is_good()) return begin;
  const Problem problem = problem_of(drive, reaches_goal);
  ClearanceOptions clearance = clearance_;
  clearance.margin = margin;
  PathCheck way = check_path(problem, drive.drive.path, {.clearance = clearance});
  if (!way.valid) return {std::move(way.reason)};
  return verdict_of(
      check_drive(problem, drive.drive, {margin, drive.drive.speeds.knots.front().v}));
}

Verdict Judging::of_path(const CutDrive& drive, bool reaches_goal) const {
  if (Verdict begin = of_begin(drive); !begin.is_good()) return begin;
  return {check_path(problem_of(drive, reaches_goal), drive.drive.path, {.clearance = clearance_})
              .reason};
}

Verdict Judging::of_company(const CutDrive& drive, bool reaches_goal) const {
  return verdict_of(
      check_company(problem_of(drive, reaches_goal), drive.drive, {clearance_.margin}));
}

double Judging::met_at(const CutDrive& drive, bool reaches_goal) const {
  const Problem problem = problem_of(drive, reaches_goal);
  if (!of_begin(drive).is_good() || !check_path(problem, drive.drive.path).valid) return 0.0;
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
