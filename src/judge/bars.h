// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which bar do points fit in?

#include <algorithm>
#include <span>

#include "judge/clearance.h"

namespace vandplan::judge {

/// A box that grows with what is put into it.
struct Box {
  Point low, high;

  static Box of(const Point& p) { return {p, p}; }
  void add(const Point& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  void add(const Box& box) {
    add(box.low);
    add(box.high);
  }
  [[nodiscard]] Point middle() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }
  /// The longer side [m].
  [[nodiscard]] double size() const { return std::max(high.x - low.x, high.y - low.y); }
};

/// The disc around a box.
[[nodiscard]] Bar bar_of(const Box& box);

/// A narrow bar if the points lie along a line, else a disc.
[[nodiscard]] Bar bar_of(std::span<const Point> points);

}  // namespace vandplan::judge
