// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is a vehicle on its path from what moves, and how fast can that change?
//
// A place of the vehicle and a time make a point of a plane. `gap` looks at one point; `driven` and
// `moved` say in which box around it nothing can touch (docs/algorithms/moving.md).

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "collision/rectangle.h"
#include "speed/way.h"
#include "vandplan/moving.h"
#include "vandplan/rig.h"

namespace vandplan::moving {

/// A path and who drives it.
struct Course {
  const Path& path;
  const Vehicle& vehicle;
  double hitch_angle = 0.0;  ///< at the start of the path [rad]; 0 without a trailer
};

class Encounters {
 public:
  /// Everything in one frame. Vehicle and obstacles stay where they are as long as this is used.
  Encounters(const Course& course, std::span<const MovingObstacle> moving, double margin);

  [[nodiscard]] std::size_t size() const noexcept { return movers_.size(); }
  [[nodiscard]] double length() const noexcept { return begins_.back().s; }
  /// Where the vehicle is after `s` metres; the hitch angle is 0 without a trailer.
  [[nodiscard]] RigState state_at(double s) const;

  /// How far the vehicle and its trailer in that state are from obstacle `i` at time `t`, beyond
  /// the margin and the growth of the outline [m]; at most 0: they meet. From `enough` on any
  /// number from it to that will do. Not asked for an obstacle that has left.
  [[nodiscard]] double gap(std::size_t i, const RigState& state, double t,
                           double enough) const noexcept;

  /// How deep the vehicle or its trailer in that state is in what must be free of it, at least: so
  /// far it is from any state without a meeting [m]. At most 0 where nothing is known.
  [[nodiscard]] double depth(std::size_t i, const RigState& state, double t) const noexcept;

  /// A measure of the way: no point of the vehicle or its trailer moves further than it grows [m].
  [[nodiscard]] double driven(double s) const noexcept;
  /// A measure of the motion of obstacle `i`: no point of its outline moves further than it grows,
  /// growth of the outline included [m].
  [[nodiscard]] double moved(std::size_t i, double t) const noexcept;
  /// When obstacle `i` comes to rest or leaves [s].
  [[nodiscard]] double rests(std::size_t i) const noexcept;
  /// When obstacle `i` leaves [s]; none if it stays.
  [[nodiscard]] std::optional<double> leaves(std::size_t i) const noexcept;

 private:
  struct Mover {
    const MovingObstacle* obstacle;
    Point centre;               // of the outline, in its frame
    double reach;               // of the outline from there [m]
    double core;                // radius of a circle around the centre within the outline [m]
    std::vector<double> moved;  // up to each row [m]
    double before;              // per second before the first row: it may grow then [m/s]
  };
  struct Begin {
    double s;
    double driven;
    double hitch_angle;
  };
  /// The vehicle, or its trailer.
  struct Body {
    collision::Rectangle box;
    Polygon corners;  // of the body, if that is not the box
    double reach;     // of the box from the axle [m]
  };

  [[nodiscard]] static Mover mover_of(const MovingObstacle& obstacle);
  [[nodiscard]] static Body body_of(const auto& part);
  [[nodiscard]] static double distance_of(const Body& body, const Point& point) noexcept;
  [[nodiscard]] double gap(const Mover& mover, const Body& body, const Pose& pose, double t,
                           double enough) const noexcept;

  const Vehicle& vehicle_;
  speed::Way way_;
  std::vector<Begin> begins_;  // of the segments, and the end
  std::vector<Mover> movers_;
  Body body_;
  std::optional<Body> trailer_;
  double margin_;
};

/// `vandplan::first_meeting` of a course that is driven so.
[[nodiscard]] std::optional<Meeting> first_meeting(const Course& course, const SpeedProfile& speeds,
                                                   std::span<const MovingObstacle> moving,
                                                   double margin);

}  // namespace vandplan::moving
