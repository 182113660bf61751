// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is a vehicle on its path from moving obstacles, and how fast can that distance change?
//
// A place of the path and a time make a point of a plane. `gap` examines one point. `driven` and
// `moved` bound how the gap changes in a box around that point (docs/algorithms/moving.md).

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "collision/rectangle.h"
#include "speed/way.h"
#include "vandplan/motion.h"
#include "vandplan/vehicle.h"

namespace vandplan::moving {

/// A path and the vehicle that drives it.
struct Course {
  const Path& path;
  const Vehicle& vehicle;
  double hitch_angle = 0.0;  ///< hitch angle at the start of the path [rad]; 0 without a trailer
};

class Encounters {
 public:
  /// All arguments share one frame. `course.vehicle` and `moving` are kept by reference. `margin`
  /// is the distance to keep from obstacles [m].
  Encounters(const Course& course, std::span<const MovingObstacle> moving, double margin);

  [[nodiscard]] std::size_t size() const noexcept { return movers_.size(); }
  [[nodiscard]] double length() const noexcept { return begins_.back().s; }
  /// State of the vehicle after `s` metres of the path; the hitch angle is 0 without a trailer.
  [[nodiscard]] State state_at(double s) const;

  /// Distance of vehicle and trailer from obstacle `i` at time `t`, less the margin and the growth
  /// of the outline [m]. At most 0: they meet. If the distance is `enough` or more, any number
  /// between `enough` and the distance may come back. The obstacle must not have left by `t`.
  [[nodiscard]] double gap(std::size_t i, const State& state, double t,
                           double enough) const noexcept;

  /// Lower bound of the distance that vehicle or obstacle has to move until `gap` is above 0 [m].
  /// At most 0: unknown.
  [[nodiscard]] double depth(std::size_t i, const State& state, double t) const noexcept;

  /// Measure of the path: no point of the vehicle or its trailer moves further than it grows [m].
  [[nodiscard]] double driven(double s) const noexcept;
  /// Measure of the motion of obstacle `i` [m]: no point of its outline moves further than it
  /// grows. The growth of the outline is included.
  [[nodiscard]] double moved(std::size_t i, double t) const noexcept;
  /// Time at which obstacle `i` comes to rest or leaves [s].
  [[nodiscard]] double rests(std::size_t i) const noexcept;
  /// Time at which obstacle `i` leaves [s]; none if it stays.
  [[nodiscard]] std::optional<double> leaves(std::size_t i) const noexcept;

 private:
  struct Mover {
    const MovingObstacle* obstacle;
    Point centre;  // centre of the outline's bounding box, in the frame of the outline
    double reach;  // distance of the furthest corner from `centre` [m]
    double core;   // radius of a circle around `centre` that lies within the outline [m]
    std::vector<double> moved;  // measure of the motion up to each row of the trajectory [m]
    double before;  // growth of the measure before the first row [m/s]: the outline may grow then
  };
  struct Begin {
    double s;
    double driven;
    double hitch_angle;
  };
  /// Shape of the vehicle or of its trailer, in the frame of its axle.
  struct Body {
    collision::Rectangle box;
    Polygon corners;  // corners of the outline; empty if the body is the box
    double reach;     // distance of the furthest point of the box from the axle [m]
  };

  [[nodiscard]] static Mover mover_of(const MovingObstacle& obstacle);
  [[nodiscard]] static Body body_of(const auto& part);
  [[nodiscard]] static double distance_of(const Body& body, const Point& point) noexcept;
  [[nodiscard]] double gap(const Mover& mover, const Body& body, const Pose& pose, double t,
                           double enough) const noexcept;

  const Vehicle& vehicle_;
  speed::Way way_;
  std::vector<Begin> begins_;  // begins of the segments, then the end of the path
  std::vector<Mover> movers_;
  Body body_;
  std::optional<Body> trailer_;
  double margin_;
};

/// First meeting of a vehicle that drives `course` with `speeds`; see `vandplan::first_meeting`.
[[nodiscard]] std::optional<Meeting> first_meeting(const Course& course, const SpeedProfile& speeds,
                                                   std::span<const MovingObstacle> moving,
                                                   double margin);

}  // namespace vandplan::moving
