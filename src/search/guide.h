// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it to the target, approximately, for a search that needs a direction?

namespace vandplan::search {

/// Distances to one target around the obstacles, computed in small steps. An estimate, no bound.
class Guide {
 public:
  virtual ~Guide() = default;

  /// Does some microseconds of work. False when nothing is left to do.
  virtual bool step() = 0;

  /// Whether a way between target and root was found.
  [[nodiscard]] virtual bool is_connected() const noexcept = 0;

  /// Distance to the target [m], or cost of driving there. Where it is not known, a lower bound on
  /// it.
  [[nodiscard]] virtual double at(double x, double y) const noexcept = 0;
};

}  // namespace vandplan::search
