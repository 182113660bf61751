// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a drive of a rig bent so that it ends exactly where it should?
//
// Method: docs/algorithms/trailers.md.

#include <array>
#include <span>
#include <vector>

#include "vandplan/rig.h"

namespace vandplan::rig {

/// Changes curvatures and lengths of segments, as little as possible, until they lead from one
/// state to another. One for each thread: it holds its buffers.
class Closer {
 public:
  /// The vehicle has a trailer and outlives the closer.
  explicit Closer(const Vehicle& vehicle);

  /// Whether the segments, arcs and lines, now lead from `from` to `to` within 1e-10 m and rad,
  /// with every curvature and hitch angle in its limit and every gear as it was; else they are of
  /// no use. A segment may be left without length.
  [[nodiscard]] bool close(const RigState& from, std::span<Segment> segments, const RigState& to);

  /// The states before each segment and after the last one, hitch angles not wrapped; of the last
  /// call that succeeded.
  [[nodiscard]] std::span<const RigState> states() const { return states_; }

 private:
  using Vector = std::array<double, 4>;

  /// How the end changes with the curvature and with the length of one segment.
  struct Column {
    Vector curvature, length;
    bool curvature_is_fixed, length_is_fixed;
  };

  void drive(const RigState& from, std::span<const Segment> segments);
  [[nodiscard]] Vector gap(const RigState& to) const;
  void differentiate(std::span<const Segment> segments);
  [[nodiscard]] bool solve(const Vector& gap, Vector& multipliers) const;
  [[nodiscard]] bool step(std::span<Segment> segments, const Vector& gap);

  const Vehicle& vehicle_;
  double most_curvature_;
  double curvature_unit_, length_unit_;  // changes of these sizes count alike
  std::vector<RigState> states_;
  std::vector<Column> columns_;
};

}  // namespace vandplan::rig
