// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which of many polygons are near a place?

#include <cstdint>
#include <span>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan::search {

/// Index of polygons by squares of the plane that their bounding boxes touch. It is built in one
/// pass, fast enough to build it for a single plan. Immutable.
class PolygonSquares {
 public:
  /// The polygons must outlive the index.
  explicit PolygonSquares(std::span<const Polygon> polygons);

  /// Calls `visit(polygon)` for each polygon whose bounding box overlaps `box`. It may also visit
  /// other polygons, and a polygon more than once.
  template <typename Visit>
  void visit_near(const Bounds& box, Visit visit) const {
    for (const std::uint32_t i : large_) visit(polygons_[i]);
    if (begins_.empty()) return;
    const std::int32_t x_end = column(box.x_max);
    const std::int32_t y_end = row(box.y_max);
    for (std::int32_t y = row(box.y_min); y <= y_end; ++y) {
      for (std::int32_t x = column(box.x_min); x <= x_end; ++x) {
        const std::size_t square = index_of(x, y);
        for (std::uint32_t i = begins_[square]; i < begins_[square + 1]; ++i) {
          visit(polygons_[members_[i]]);
        }
      }
    }
  }

 private:
  [[nodiscard]] std::int32_t column(double x) const noexcept;
  [[nodiscard]] std::int32_t row(double y) const noexcept;
  [[nodiscard]] std::size_t index_of(std::int32_t x, std::int32_t y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }

  std::span<const Polygon> polygons_;
  Bounds extent_ = {};
  double side_ = 1.0;  // Side of a square [m].
  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  std::vector<std::uint32_t> begins_;   // First place of each square in `members_`, and the end.
  std::vector<std::uint32_t> members_;  // Numbers of polygons, square by square.
  std::vector<std::uint32_t> large_;    // Numbers of polygons that touch very many squares.
};

}  // namespace vandplan::search
