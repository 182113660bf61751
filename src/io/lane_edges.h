// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which corners of both edges of a lane face each other?

#include "io/ground.h"
#include "io/roads.h"

namespace vandplan::io {

/// Corners of both edges of a lane that face each other.
struct Cut {
  std::size_t left = 0;   ///< index of a corner of the left edge
  std::size_t right = 0;  ///< index of a corner of the right edge
};

/// The edges of a lane, walked along side by side.
class Edges {
 public:
  explicit Edges(const Lane& lane) : lane_(lane) {}

  [[nodiscard]] bool is_end(const Cut& cut) const {
    return cut.left + 1 == lane_.left.size() && cut.right + 1 == lane_.right.size();
  }
  /// The next cut: a step on one edge, on that where the cut is shorter.
  [[nodiscard]] Cut after(const Cut& cut) const {
    const Cut left = {cut.left + 1, cut.right};
    const Cut right = {cut.left, cut.right + 1};
    if (right.right == lane_.right.size()) return left;
    if (left.left == lane_.left.size()) return right;
    return length(left) <= length(right) ? left : right;
  }
  [[nodiscard]] Point middle(const Cut& cut) const {
    return between(lane_.left[cut.left], lane_.right[cut.right], 0.5);
  }
  /// Outline of the lane between two cuts.
  [[nodiscard]] Polygon outline_between(const Cut& begin, const Cut& end) const {
    Polygon corners;
    for (std::size_t i = begin.left; i <= end.left; ++i) corners.push_back(lane_.left[i]);
    for (std::size_t i = end.right + 1; i > begin.right; --i) {
      corners.push_back(lane_.right[i - 1]);
    }
    return corners;
  }

 private:
  [[nodiscard]] double length(const Cut& cut) const {
    return distance(lane_.left[cut.left], lane_.right[cut.right]);
  }

  const Lane& lane_;
};

}  // namespace vandplan::io
