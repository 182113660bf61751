// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which pose and speed should a vehicle have between two stops?

#include <vector>

#include "vandplan/motion.h"
#include "vandplan/path.h"

namespace vandplan::driving {

/// Place of a stroke.
struct StrokePlace {
  double s = 0.0;  ///< distance from the begin of the stroke [m]
  Pose pose = {};
  double curvature = 0.0;  ///< curvature of the path at the place [1/m]
};

/// Offset of a pose from a stroke.
struct Offset {
  StrokePlace place;     ///< place of the stroke beside the pose
  double lateral = 0.0;  ///< distance of the pose to the left of the place, seen forward [m]
  double heading = 0.0;  ///< heading of the pose less that of the place, in [-pi, pi) [rad]
};

/// Part of a path that is driven from standstill to standstill in one gear.
class Stroke {
 public:
  /// Stroke without segments that begins at `start`, at `s` metres of its path.
  Stroke(const Pose& start, double s);

  /// Appends a segment.
  void add(const Segment& segment);
  /// Appends a part of the speed profile: a knot that holds for `duration` [s].
  void add(const SpeedKnot& knot, double duration) { knots_.push_back({knot, duration}); }

  [[nodiscard]] int direction() const noexcept { return direction_; }
  [[nodiscard]] double length() const noexcept { return samples_.back().s; }
  [[nodiscard]] double begin() const noexcept { return begin_; }
  [[nodiscard]] const Pose& end() const noexcept { return end_; }
  /// Curvature at the begin of the stroke [1/m].
  [[nodiscard]] double first_curvature() const noexcept { return samples_.front().curvature; }

  /// Place after `s` metres, with an error of at most 0.01 mm. Beyond its ends the stroke goes on
  /// with the curvature of the end.
  [[nodiscard]] StrokePlace at(double s) const noexcept;
  [[nodiscard]] double curvature_at(double s) const noexcept;

  /// Offset of a pose from the stroke. The search for the nearest place begins at `guess` [m].
  [[nodiscard]] Offset offset_of(const Pose& pose, double guess) const noexcept;

  /// Planned speed after `s` metres [m/s]; 0 from the end on.
  [[nodiscard]] double speed_at(double s) const noexcept;

 private:
  struct Sample {
    double s;
    Pose pose;
    double curvature;
    double rate;  // change of the curvature per driven metre after the sample [1/m^2]
  };
  struct Knot {
    SpeedKnot knot;
    double duration;  // time until the next knot [s]
  };
  [[nodiscard]] const Sample& before(double s) const noexcept;

  double begin_;
  Pose end_;
  int direction_ = 1;
  std::vector<Sample> samples_;  // samples of the path; the last one is at the end of the stroke
  std::vector<Knot> knots_;
};

/// Strokes of a path, in the frame of the path. There is at least one, which may have length 0.
[[nodiscard]] std::vector<Stroke> strokes_of(const Path& path, const SpeedProfile& profile);

}  // namespace vandplan::driving
