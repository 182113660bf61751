// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far has a vehicle driven, and which part of its way can no longer change?
//
// The first metres of a way are committed: they stay as they are, and the vehicle can stop at the
// end of this part. Method: docs/algorithms/ltba_star.md.

#include <optional>
#include <vector>

#include "lab/lattice_search.h"

namespace vandplan::lattice {

/// A simulated vehicle that drives along the committed part of its way.
class CommittedDrive {
 public:
  /// The task outlives the drive.
  explicit CommittedDrive(const Task& task);

  /// Whether `way` begins with the committed part.
  [[nodiscard]] bool agrees(const std::vector<Leg>& way) const;
  /// Takes `way`, which must begin with the committed part.
  void follow(std::vector<Leg> way);
  /// Commits as much of the way as the vehicle needs to accelerate for `time` [s] and then stop.
  void commit(double time);
  /// Moves the vehicle along the committed part for `time` [s].
  void drive(double time);

  /// The cheapest way that begins with the committed part and ends as `way` does. An exact piece
  /// joins both, or the vehicle drives back to where `way` leaves the committed part. None if the
  /// cost is `cutoff` or more [m].
  [[nodiscard]] std::optional<std::vector<Leg>> joined(const std::vector<Leg>& way, double cutoff,
                                                       Connector& connector) const;

  /// Whether the vehicle can stop before the committed part ends and before the gear changes.
  [[nodiscard]] bool can_stop() const;
  /// Length of the committed part [m].
  [[nodiscard]] double committed() const { return committed_; }
  /// Length that the vehicle has driven [m].
  [[nodiscard]] double driven() const { return driven_; }
  /// Number of stops because nothing more was committed.
  [[nodiscard]] std::int64_t forced_stops() const { return forced_stops_; }

 private:
  [[nodiscard]] double next_stop() const;
  [[nodiscard]] double top_speed() const;
  [[nodiscard]] std::vector<Leg> committed_part() const;

  const Task& task_;
  double braking_;          // largest braking of the vehicle [m/s^2]
  std::vector<Leg> way_;    // way of the vehicle, from the start
  double committed_ = 0.0;  // length of the committed part [m]
  double driven_ = 0.0;     // driven length [m]
  double speed_ = 0.0;      // current speed [m/s]
  std::int64_t forced_stops_ = 0;
};

}  // namespace vandplan::lattice
