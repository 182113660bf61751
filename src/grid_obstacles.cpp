// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "grid_obstacles.h"

#include <algorithm>
#include <cmath>

#include "trigonometry.h"

namespace vandplan {
namespace {

constexpr double small_block = 0.4;    // side, about [m]
constexpr int large_shift = 3;         // a large block is 2^3 small ones wide
constexpr double longest_part = 12.0;  // of a segment whose cells are looked for at once [m]

/// How often cells of that side are doubled to come near to a length; at least once.
int doublings(double side, double wanted) {
  int times = 1;
  while (times < 10 && side * (1 << times) < wanted / std::sqrt(2.0)) ++times;
  return times;
}

/// A run of squares with sides of that length.
Sides sides_of(std::int32_t y, std::int32_t x_begin, std::int32_t x_end, double side) {
  const double left = x_begin * side;
  const double right = x_end * side;
  const double low = y * side;
  const double high = (y + 1) * side;
  return {{left, right, right, left, left}, {low, low, high, high, low}};
}

CellBox blocks_in(const CellBox& cells, int shift) {
  return {cells.x_min >> shift, cells.x_max >> shift, cells.y_min >> shift, cells.y_max >> shift};
}

/// The cells of a run of blocks that are in a box, too.
CellBox cells_of(std::int32_t y, std::int32_t x_begin, std::int32_t x_end, int shift,
                 const CellBox& box) {
  return {std::max(x_begin << shift, box.x_min), std::min((x_end << shift) - 1, box.x_max),
          std::max(y << shift, box.y_min), std::min(((y + 1) << shift) - 1, box.y_max)};
}

}  // namespace

/// For an edge cell in the way of one segment, in the frame of the cells.
class GridObstacles::Search {
 public:
  Search(const GridObstacles& grid, const PlacedSegment& placed)
      : grid_(grid), placed_(placed), sweep_(grid.body_, placed) {
    const Point& start = placed.from.position;
    const CellBox cell = grid.cells_in({start.x, start.x, start.y, start.y});
    start_x_ = cell.x_min;
    start_y_ = cell.y_min;
  }

  /// [2] Part by part, so that the boxes around them hold little that is not near.
  [[nodiscard]] bool finds_any() const {
    const Bounds whole = sweep_.box();
    if (placed_.length <= longest_part) return finds_in(grid_.cells_in(whole));
    const double parts = std::ceil(placed_.length / longest_part);
    for (double i = 0; i < parts; ++i) {
      const Point from = at(placed_.length * i / parts);
      const Point to = at(placed_.length * (i + 1) / parts);
      const double bulge = placed_.curvature * longest_part * longest_part / 8;
      const double margin = std::min(bulge, longest_part / 2) + grid_.reach_ + 2 * end_margin;
      const Bounds box{std::max(whole.x_min, std::min(from.x, to.x) - margin),
                       std::min(whole.x_max, std::max(from.x, to.x) + margin),
                       std::max(whole.y_min, std::min(from.y, to.y) - margin),
                       std::min(whole.y_max, std::max(from.y, to.y) + margin)};
      if (finds_in(grid_.cells_in(box))) return true;
    }
    return false;
  }

 private:
  /// Where the rear axle is after that length.
  [[nodiscard]] Point at(double length) const {
    const Point& from = placed_.from.position;
    const double turn = length * placed_.curvature;
    double x = length;
    double y = 0.0;
    if (turn > 1e-15) {
      const SinCos half = sin_cos(turn / 2);
      x = 2 * half.sin * half.cos / placed_.curvature;
      y = 2 * half.sin * half.sin / placed_.curvature;
    }
    return {from.x + x * placed_.forward.x + y * placed_.left.x,
            from.y + x * placed_.forward.y + y * placed_.left.y};
  }

  /// [3] Among the cells of a box, through large blocks and small ones.
  [[nodiscard]] bool finds_in(const CellBox& box) const {
    const int small = grid_.small_shift_;
    return finds(grid_.large_blocks_, small + large_shift, box, [&](const CellBox& large) {
      return finds(grid_.small_blocks_, small, large, [&](const CellBox& cells) {
        return grid_.cells_.edges().any_run(
            cells, [&](std::int32_t y, std::int32_t x_begin, std::int32_t x_end) {
              return sweep_.touches(sides_of(y, x_begin, x_end, grid_.side_));
            });
      });
    });
  }

  /// Calls `look` for the cells of blocks that are touched, until it returns true. A block that the
  /// vehicle starts in may hold all of its way.
  template <typename Look>
  [[nodiscard]] bool finds(const BitGrid& blocks, int shift, const CellBox& box, Look look) const {
    const double side = grid_.side_ * (1 << shift);
    return blocks.any_run(
        blocks_in(box, shift), [&](std::int32_t y, std::int32_t x_begin, std::int32_t x_end) {
          const CellBox cells = cells_of(y, x_begin, x_end, shift, box);
          const bool starts_in =
              y == start_y_ >> shift && x_begin <= start_x_ >> shift && start_x_ >> shift < x_end;
          const bool is_touched = starts_in || sweep_.touches(sides_of(y, x_begin, x_end, side));
          return is_touched && look(cells);
        });
  }

  const GridObstacles& grid_;
  const PlacedSegment& placed_;
  Sweep sweep_;
  std::int32_t start_x_;  // cell of the rear axle at the start
  std::int32_t start_y_;
};

GridObstacles::GridObstacles(const OccupancyGrid& grid, const Footprint& body)
    : side_(grid.resolution),
      body_(body),
      middle_((body.front - body.rear) / 2),
      radius_(std::hypot((body.front + body.rear) / 2, body.half_width)),
      reach_(std::hypot(std::max(body.front, body.rear), body.half_width)),
      cells_(grid),
      field_(cells_, doublings(grid.resolution, small_block)),
      small_shift_(doublings(grid.resolution, small_block)),
      small_blocks_(blocks_of(cells_.edges(), small_shift_)),
      large_blocks_(blocks_of(cells_.edges(), small_shift_ + large_shift)) {
  const auto [sin, cos] = sin_cos(grid.origin.heading);
  along_ = {cos, sin};
  // The frame is a cell wide.
  origin_ = {grid.origin.x - side_ * (cos - sin), grid.origin.y - side_ * (sin + cos)};
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

/// The cells that meet a box, or more if it reaches beyond the frame.
CellBox GridObstacles::cells_in(const Bounds& box) const noexcept {
  const auto index = [&](double place, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp(place / side_, 0.0, count - 0.5));
  };
  return {index(box.x_min, cells_.columns()), index(box.x_max, cells_.columns()),
          index(box.y_min, cells_.rows()), index(box.y_max, cells_.rows())};
}

bool GridObstacles::contain(const Point& point) const noexcept {
  const Point p = in_frame(point);
  // Outside of the frame is as its border.
  const double x = std::clamp(p.x / side_, 0.0, cells_.columns() - 0.5);
  const double y = std::clamp(p.y / side_, 0.0, cells_.rows() - 0.5);
  return cells_.is_blocked(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
}

/// [1] Whether the field alone tells that nothing is touched: no point of the footprint gets
/// further from its middle at the start than that and what is driven, times its greatest speed.
bool GridObstacles::is_far(const PlacedSegment& placed) const noexcept {
  const double across = 1 + placed.curvature * body_.half_width;
  const double along = placed.curvature * std::max(body_.front, body_.rear);
  const double moved = placed.length * std::sqrt(across * across + along * along);
  const double needed = radius_ + moved + end_margin;
  if (needed > DistanceField::furthest * side_) return false;
  const auto& [position, heading] = placed.from;
  const Point middle =
      in_frame({position.x + middle_ * heading.x, position.y + middle_ * heading.y});
  return field_.roughly_around({middle.x / side_, middle.y / side_}).least * side_ > needed;
}

bool GridObstacles::is_clear(const PlacedSegment& placed) const noexcept {
  return is_far(placed) || !Search(*this, in_frame(placed)).finds_any();
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

}  // namespace vandplan
