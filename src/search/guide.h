// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it to the target, about, for a search that needs to know where to look first?

namespace vandplan::search {

/// Distances to one target around the obstacles, worked out bit by bit: a guide and not a bound.
class Guide {
 public:
  virtual ~Guide() = default;

  /// Some microseconds of work. False when there is no more to do.
  virtual bool step() = 0;

  /// Whether a way between target and root was found.
  [[nodiscard]] virtual bool is_connected() const noexcept = 0;

  /// Distance to the target [m], or what driving it costs; where it is not known, what it must
  /// exceed.
  [[nodiscard]] virtual double at(double x, double y) const noexcept = 0;

  /// How long that way is [m].
  [[nodiscard]] virtual double length_at(double x, double y) const noexcept { return at(x, y); }
};

}  // namespace vandplan::search
