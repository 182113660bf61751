// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far has a vehicle come, and how far is it bound to go?
//
// It drives along a way of which the first metres are committed: they stay as they are, and it can
// stand still at their end. docs/algorithms/ltba_star.md.

#include <optional>
#include <vector>

#include "lab/lattice_search.h"

namespace vandplan::lattice {

/// A vehicle on its way.
class CommittedDrive {
 public:
  explicit CommittedDrive(const Task& task);

  /// Whether a way is the one that is driven, as far as that is committed.
  [[nodiscard]] bool agrees(const std::vector<Leg>& way) const;
  /// Takes a way that agrees.
  void follow(std::vector<Leg> way);
  /// Commits as much as the vehicle needs to go on for a while as fast as it may [s].
  void commit(double time);
  /// Drives for a while [s].
  void drive(double time);

  /// The cheapest way found that begins with what is committed and ends as a given way does: on to
  /// one of its places by an exact piece, or back to where they part. None if it costs `cutoff` or
  /// more [m].
  [[nodiscard]] std::optional<std::vector<Leg>> joined(const std::vector<Leg>& way, double cutoff,
                                                       Connector& connector) const;

  /// Whether it can come to a standstill before what is committed ends, and before gears change.
  [[nodiscard]] bool can_stop() const;
  /// How much is committed, and how much of that it has driven [m].
  [[nodiscard]] double committed() const { return committed_; }
  [[nodiscard]] double driven() const { return driven_; }
  /// How often it had to stand because nothing more was committed.
  [[nodiscard]] std::int64_t forced_stops() const { return forced_stops_; }

 private:
  [[nodiscard]] double next_stop() const;
  [[nodiscard]] double top_speed() const;
  [[nodiscard]] std::vector<Leg> committed_part() const;

  const Task& task_;
  double braking_;  // [m/s^2]
  std::vector<Leg> way_;
  double committed_ = 0.0;  // [m]
  double driven_ = 0.0;     // [m]
  double speed_ = 0.0;      // [m/s]
  std::int64_t forced_stops_ = 0;
};

}  // namespace vandplan::lattice
