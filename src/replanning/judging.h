// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the judge say of a drive that begins now?

#include <limits>
#include <string>

#include "replanning/ways.h"

namespace vandplan::replanning {

/// Verdict of the judge on a drive.
struct Verdict {
  std::string fault = {};  ///< first fault of the drive; empty if there is none
  /// Time of the meeting, if the fault is a moving obstacle [s]; 0 if the rig is folded up;
  /// otherwise infinite.
  double met = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool is_good() const noexcept { return fault.empty(); }
};

/// Judges drives of a scene, which begin now, in the frame of the known ground.
class Judging {
 public:
  /// Both are kept by reference.
  Judging(const Scene& scene, const ClearanceOptions& clearance)
      : scene_(scene), clearance_(clearance) {}

  /// Verdict on path and times of a drive that keeps `margin` metres.
  [[nodiscard]] Verdict of_drive(const CutDrive& drive, bool reaches_goal, double margin) const;
  /// Verdict on the path alone, among standing obstacles.
  [[nodiscard]] Verdict of_path(const CutDrive& drive, bool reaches_goal) const;
  /// Verdict on the meetings with moving obstacles alone.
  [[nodiscard]] Verdict of_company(const CutDrive& drive, bool reaches_goal) const;
  /// Time of the first contact on a drive [s]: 0 if its path hits an obstacle, infinite without a
  /// contact.
  [[nodiscard]] double met_at(const CutDrive& drive, bool reaches_goal) const;
  /// Reason why no drive reaches the goal.
  [[nodiscard]] std::string reason_of_no_way() const;

 private:
  /// Problem of a drive among the moving obstacles from now on.
  [[nodiscard]] Problem problem_of(const CutDrive& drive, bool reaches_goal) const;
  [[nodiscard]] Verdict of_begin(const CutDrive& drive) const;

  const Scene& scene_;
  const ClearanceOptions& clearance_;
};

}  // namespace vandplan::replanning
