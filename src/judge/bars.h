// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which bar contains a set of points?

#include <algorithm>
#include <span>

#include "judge/clearance.h"

namespace vandplan::judge {

/// Bounding box of the points that are added to it.
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
  /// Length of the longer side [m].
  [[nodiscard]] double size() const { return std::max(high.x - low.x, high.y - low.y); }
};

/// Disc that contains a box.
[[nodiscard]] Bar bar_of(const Box& box);

/// Bar that contains the points: narrow if they lie along a line, otherwise a disc.
[[nodiscard]] Bar bar_of(std::span<const Point> points);

}  // namespace vandplan::judge
