// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "collision/grid_obstacles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/trigonometry.h"
#include "collision/outline_sweep.h"

namespace vandplan::collision {
namespace {

constexpr double block = 0.4;                // Approximate side of blocks of edge cells [m].
constexpr double field_block = 0.8;          // Approximate side of blocks of the coarse field [m].
constexpr double longest_piece = 1.5;        // Longest piece whose cells are searched at once [m].
constexpr double longest_part = 50.0;        // Longest part that is not halved [m].
constexpr std::size_t most_candidates = 32;  // Candidates that wait to be measured.

/// Number of doublings that bring the side of a cell near a wanted length; at least 1.
int doublings(double side, double wanted) {
  int times = 1;
  while (times < 10 && side * (1 << times) < wanted / std::sqrt(2.0)) ++times;
  return times;
}

Sides sides_of(const Bounds& b) {
  return {{b.x_min, b.x_max, b.x_max, b.x_min, b.x_min},
          {b.y_min, b.y_min, b.y_max, b.y_max, b.y_min}};
}

/// Square of the positive part.
double squared_beyond(double beyond) { return beyond > 0 ? beyond * beyond : 0.0; }

CellBox blocks_in(const CellBox& cells, int shift) {
  return {cells.x_min >> shift, cells.x_max >> shift, cells.y_min >> shift, cells.y_max >> shift};
}

/// Cells that may be nearest to the body.
struct Candidate {
  double gap;  // Lower bound on their squared distance [m^2].
  Bounds box;
};

/// Cells of a run of blocks.
CellBox cells_of(std::int32_t y, std::int32_t x_begin, std::int32_t x_end, int shift) {
  return {x_begin << shift, (x_end << shift) - 1, y << shift, ((y + 1) << shift) - 1};
}

}  // namespace

/// Edge cells near a body while one segment is driven, in the frame of the cells.
class GridObstacles::Neighbourhood {
 public:
  Neighbourhood(const GridObstacles& grid, const Shape& shape, double margin,
                const PlacedSegment& placed)
      : grid_(grid),
        shape_(shape),
        body_{shape.box.rear + margin, shape.box.front + margin, shape.box.half_width + margin},
        placed_(placed) {}

  /// Distance of the body, without its margin, from the nearest edge cell at the begin of the
  /// segment, at most `margin` [m].
  [[nodiscard]] double distance(double margin) const {
    const Rectangle near = around(0, 0);
    const Footprint& body = shape_.box;
    const Rectangle slim{near.middle, near.forward, (body.front + body.rear) / 2, body.half_width};
    double least = margin * margin;
    const auto look = [&](const Bounds& box) {
      const double distance = shape_.corners.empty()
                                  ? slim.squared_distance(box)
                                  : squared_distance(shape_, placed_.from, sides_of(box));
      least = std::min(least, distance);
    };
    // The most promising cells are measured first, which rules out nearly all others.
    std::array<Candidate, most_candidates> candidates;
    std::size_t count = 0;
    (void)any_run(near, [&](const CellBox& run) {
      const Bounds box = square(run);
      const double gap = slim.squared_gap(box);
      if (gap >= least) return false;
      if (count == candidates.size()) {
        look(box);
      } else {
        candidates[count++] = {gap, box};
      }
      return least == 0;
    });
    for (; count > 0; --count) {
      std::size_t next = 0;
      for (std::size_t i = 1; i < count; ++i) {
        if (candidates[i].gap < candidates[next].gap) next = i;
      }
      if (candidates[next].gap >= least) break;
      look(candidates[next].box);
      candidates[next] = candidates[count - 1];
    }
    return std::sqrt(least);
  }

  /// Rectangle parallel to the footprint.
  struct Rectangle {
    Point middle;
    Point forward;  // unit vector
    double half_length, half_width;

    [[nodiscard]] Bounds box() const {
      const double x = half_length * std::abs(forward.x) + half_width * std::abs(forward.y);
      const double y = half_length * std::abs(forward.y) + half_width * std::abs(forward.x);
      return {middle.x - x, middle.x + x, middle.y - y, middle.y + y};
    }

    /// Gaps between the rectangle and the box along and across the rectangle [m]; negative where
    /// their projections overlap.
    [[nodiscard]] Point beyond(const Bounds& b) const {
      const double dx = (b.x_min + b.x_max) / 2 - middle.x;
      const double dy = (b.y_min + b.y_max) / 2 - middle.y;
      const double half_x = (b.x_max - b.x_min) / 2;
      const double half_y = (b.y_max - b.y_min) / 2;
      const double u = std::abs(forward.x);
      const double v = std::abs(forward.y);
      return {std::abs(dx * forward.x + dy * forward.y) - (half_length + half_x * u + half_y * v),
              std::abs(dy * forward.x - dx * forward.y) - (half_width + half_x * v + half_y * u)};
    }

    /// Lower bound on the squared distance of the box [m^2].
    [[nodiscard]] double squared_gap(const Bounds& b) const {
      const Point gap = beyond(b);
      const double along = std::max(gap.x, 0.0);
      const double aside = std::max(gap.y, 0.0);
      return along * along + aside * aside;
    }

    /// Squared distance of the box [m^2]; 0 if they overlap.
    [[nodiscard]] double squared_distance(const Bounds& b) const {
      const Bounds box = this->box();
      const double apart_x = std::max(b.x_min - box.x_max, box.x_min - b.x_max);
      const double apart_y = std::max(b.y_min - box.y_max, box.y_min - b.y_max);
      if (meets(b) && apart_x <= 0 && apart_y <= 0) return 0;
      double least = std::numeric_limits<double>::infinity();
      for (const double p : {-1.0, 1.0}) {
        for (const double q : {-1.0, 1.0}) {
          // A corner of the box in the rectangle's frame, and a corner of the rectangle.
          const Point to{(p < 0 ? b.x_min : b.x_max) - middle.x,
                         (q < 0 ? b.y_min : b.y_max) - middle.y};
          const Point corner{middle.x + p * half_length * forward.x - q * half_width * forward.y,
                             middle.y + p * half_length * forward.y + q * half_width * forward.x};
          const double along = std::abs(to.x * forward.x + to.y * forward.y) - half_length;
          const double aside = std::abs(to.y * forward.x - to.x * forward.y) - half_width;
          const double x = std::max(b.x_min - corner.x, corner.x - b.x_max);
          const double y = std::max(b.y_min - corner.y, corner.y - b.y_max);
          least = std::min({least, squared_beyond(along) + squared_beyond(aside),
                            squared_beyond(x) + squared_beyond(y)});
        }
      }
      return least;
    }

    /// Whether rectangle and box overlap, provided that the rectangle's bounding box overlaps the
    /// box.
    [[nodiscard]] bool meets(const Bounds& b) const {
      const Point gap = beyond(b);
      return (gap.x <= 0) & (gap.y <= 0);
    }
  };

  /// Rectangle around the footprint at all places up to `reach` before and behind `place` [m].
  [[nodiscard]] Rectangle around(double place, double reach) const {
    const Placement axle = placed_.at(place);
    // In its frame, which turns by k per metre, a point (x, y) moves by (1 - ky, kx) per metre.
    const double x = std::max(body_.front, body_.rear);
    const double turn = placed_.curvature * reach;
    const double across = 1 + placed_.curvature * body_.half_width;
    const double along = reach * across + turn * turn * x / 2;
    const double aside = turn * (x + reach * across / 2);
    const double middle = (body_.front - body_.rear) / 2;
    return {{axle.position.x + middle * axle.heading.x, axle.position.y + middle * axle.heading.y},
            axle.heading,
            (body_.front + body_.rear) / 2 + along + 2 * end_margin,
            body_.half_width + aside + 2 * end_margin};
  }

  /// [3] Calls `look` for runs of edge cells near the rectangle until it returns true. Searches
  /// blocks of cells first.
  template <typename Look>
  [[nodiscard]] bool any_run(const Rectangle& near, Look look) const {
    const CellBox box = grid_.cells_in(near.box());
    return finds(grid_.blocks_, grid_.block_shift_, box, near, [&](const CellBox& cells) {
      return finds(grid_.cells_.edges(), 0, cells, near, look);
    });
  }

  [[nodiscard]] Bounds square(const CellBox& run) const {
    const double side = grid_.side_;
    return {run.x_min * side, (run.x_max + 1) * side, run.y_min * side, (run.y_max + 1) * side};
  }

  [[nodiscard]] double side() const { return grid_.side_; }
  [[nodiscard]] bool is_beside_frame(const Bounds& box) const {
    return box.x_max < 0 || box.x_min > grid_.cells_.columns() * grid_.side_ || box.y_max < 0 ||
           box.y_min > grid_.cells_.rows() * grid_.side_;
  }

 private:
  /// Calls `look` for cells of the box in blocks near the rectangle, until it returns true.
  template <typename Look>
  [[nodiscard]] bool finds(const BitGrid& blocks, int shift, const CellBox& box,
                           const Rectangle& near, Look look) const {
    return blocks.any_run(blocks_in(box, shift),
                          [&](std::int32_t y, std::int32_t x_begin, std::int32_t x_end) {
                            const CellBox run = cells_of(y, x_begin, x_end, shift);
                            return near.meets(square(run)) && look(shared(run, box));
                          });
  }

  const GridObstacles& grid_;
  const Shape& shape_;
  Footprint body_;  // Box around the body with its margin.
  const PlacedSegment& placed_;
};

/// Search for an edge cell in the way of one segment.
class GridObstacles::Search {
 public:
  Search(const GridObstacles& grid, const Shape& shape, double margin, const PlacedSegment& placed)
      : cells_(grid, shape, margin, placed), sweep_(shape.box, placed, margin) {
    if (!shape.corners.empty()) outline_.emplace(shape.corners, placed, margin);
  }

  /// [2] Halves long parts, and skips parts that stay outside the frame.
  [[nodiscard]] bool finds_any(const Part& part) const {
    const double length = part.end - part.begin;
    if (length <= longest_part) return finds_in_pieces(part);
    const double middle = part.begin + length / 2;
    if (cells_.is_beside_frame(cells_.around(middle, length / 2).box())) return false;
    return finds_any({part.begin, middle}) || finds_any({middle, part.end});
  }

 private:
  /// Searches pieces so short that the rectangles around them contain few cells that are not near.
  [[nodiscard]] bool finds_in_pieces(const Part& part) const {
    const double piece = std::max(longest_piece, 2 * cells_.side());
    const double count = std::max(1.0, std::ceil((part.end - part.begin) / piece));
    const double length = (part.end - part.begin) / count;
    for (double i = 0; i < count; ++i) {
      if (finds_in(cells_.around(part.begin + (i + 0.5) * length, length / 2))) return true;
    }
    return false;
  }

  [[nodiscard]] bool finds_in(const Neighbourhood::Rectangle& near) const {
    return cells_.any_run(near, [&](const CellBox& run) {
      const Sides sides = sides_of(cells_.square(run));
      return sweep_.touches(sides) && (!outline_ || outline_->touches(sides));
    });
  }

  Neighbourhood cells_;
  Sweep sweep_;
  std::optional<OutlineSweep> outline_ = {};
};

GridObstacles::GridObstacles(const OccupancyGrid& grid)
    : side_(grid.resolution),
      cells_(grid),
      field_(cells_, doublings(grid.resolution, field_block),
             geometry::field_shift(std::int64_t{grid.columns} * grid.rows)),
      block_shift_(doublings(grid.resolution, block)),
      blocks_(geometry::blocks_of(cells_.edges(), block_shift_)) {
  const auto [sin, cos] = base::sin_cos(grid.origin.heading);
  along_ = {cos, sin};
  // The frame adds one cell on each side.
  origin_ = {grid.origin.x - side_ * (cos - sin), grid.origin.y - side_ * (sin + cos)};
}

void GridObstacles::update(const OccupancyGrid& grid, const CellRange& changed) {
  const CellBox box = geometry::in_frame(changed);
  cells_.update(grid, box);
  field_.update(cells_, box);
  geometry::update_blocks(cells_.edges(), block_shift_, widened(box, 1), blocks_);
}

Point GridObstacles::in_frame(const Point& point) const noexcept {
  const double dx = point.x - origin_.x;
  const double dy = point.y - origin_.y;
  return {dx * along_.x + dy * along_.y, dy * along_.x - dx * along_.y};
}

PlacedSegment GridObstacles::in_frame(const PlacedSegment& placed) const noexcept {
  const auto turned = [&](const Point& v) {
    return Point{v.x * along_.x + v.y * along_.y, v.y * along_.x - v.x * along_.y};
  };
  PlacedSegment result = placed;
  result.from = {in_frame(placed.from.position), turned(placed.from.heading)};
  result.to = {in_frame(placed.to.position), turned(placed.to.heading)};
  result.forward = turned(placed.forward);
  result.left = turned(placed.left);
  return result;
}

/// Cells that meet a box, or more if the box reaches beyond the frame.
CellBox GridObstacles::cells_in(const Bounds& box) const noexcept {
  const auto index = [&](double place, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp(place / side_, 0.0, count - 0.5));
  };
  return {index(box.x_min, cells_.columns()), index(box.x_max, cells_.columns()),
          index(box.y_min, cells_.rows()), index(box.y_max, cells_.rows())};
}

/// [0] The begin of a segment is tested.
bool GridObstacles::contain(const Point& point) const noexcept {
  const Point p = in_frame(point);
  if (field_.at_least({p.x / side_, p.y / side_}) > 0) return false;
  // Outside the frame counts as its border.
  const double x = std::clamp(p.x / side_, 0.0, cells_.columns() - 0.5);
  const double y = std::clamp(p.y / side_, 0.0, cells_.rows() - 0.5);
  return cells_.is_blocked(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
}

bool GridObstacles::is_clear(const Shape& body, double margin, const DiscRows& discs,
                             const PlacedSegment& segment) const noexcept {
  const PlacedSegment placed = in_frame(segment);
  const DiscTrace trace = trace_discs(field_, side_, discs, placed);  // [1]
  if (trace.is_hit) return false;
  if (trace.in_doubt().empty()) return true;
  const Search search(*this, body, margin, placed);
  for (const Part& part : trace.in_doubt()) {
    if (search.finds_any(part)) return false;
  }
  return true;
}

double GridObstacles::clearance(const CoveredShape& body, const Placement& placement, double most,
                                double enough) const noexcept {
  const PlacedSegment placed = in_frame(PlacedSegment(placement, Segment{}));
  const auto& [position, heading] = placed.from;
  const DiscRow& row = body.slim;
  double nearest = most;
  double proven = most;  // Lower bound on the clearance by the discs [m].
  for (int i = 0; i < row.count; ++i) {
    const double ahead = row.first + i * row.step;
    const auto [least, highest] = field_.around(
        {(position.x + ahead * heading.x) / side_, (position.y + ahead * heading.y) / side_});
    proven = std::min(proven, least * side_ - row.outer);
    nearest = std::min(nearest, highest * side_ - row.inner);
  }
  if (proven >= std::min(most, enough)) return proven;
  if (nearest <= 0) return 0;
  return Neighbourhood(*this, body.shape, nearest, placed).distance(nearest);
}

DistanceField::Range GridObstacles::distance(const Point& point) const noexcept {
  const Point p = in_frame(point);
  const auto [least, most] = field_.around({p.x / side_, p.y / side_});
  return {least * side_, most * side_};
}

bool GridObstacles::is_within(const Point& point, double distance) const noexcept {
  const Point p = in_frame(point);
  const auto [least, most] = field_.around({p.x / side_, p.y / side_});
  if (least * side_ > distance) return false;
  if (most * side_ <= distance || contain(point)) return true;
  const CellBox box = cells_in({p.x - distance, p.x + distance, p.y - distance, p.y + distance});
  return cells_.edges().any_run(box, [&](std::int32_t y, std::int32_t x_begin, std::int32_t x_end) {
    const double dx = std::max({x_begin * side_ - p.x, p.x - x_end * side_, 0.0});
    const double dy = std::max({y * side_ - p.y, p.y - (y + 1) * side_, 0.0});
    return dx * dx + dy * dy <= distance * distance;
  });
}

}  // namespace vandplan::collision
