// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which bar do points fit in?

#include <span>

#include "judge/clearance.h"

namespace vandplan::judge {

/// A box that grows with what is put into it.
struct Box {
  Point low, high;

  static Box of(const Point& p) { return {p, p}; }
  void add(const Point& p);
  void add(const Box& box);
  [[nodiscard]] Point middle() const;
  /// The longer side [m].
  [[nodiscard]] double size() const;
};

/// The disc around a box.
[[nodiscard]] Bar bar_of(const Box& box);

/// A narrow bar if the points lie along a line, else a disc.
[[nodiscard]] Bar bar_of(std::span<const Point> points);

}  // namespace vandplan::judge
