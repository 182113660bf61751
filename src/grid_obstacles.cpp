// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "grid_obstacles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trigonometry.h"

namespace vandplan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr double block_side = 2.5;  // about [m]
constexpr double rough_side = 0.4;  // between corners of the coarse field, about [m]

/// How often cells of that side are doubled to come near to a length; at least once.
int coarseness_of(double side, double wanted) {
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

}  // namespace

/// One segment, driven, in the frame of the cells.
class GridObstacles::Drive {
 public:
  Drive(const GridObstacles& grid, const PlacedSegment& placed, const Sweep& sweep)
      : grid_(grid),
        placed_(placed),
        sweep_(sweep),
        gear_(placed.forward.x * placed.from.heading.x + placed.forward.y * placed.from.heading.y),
        speed_(speed_of(grid.body_, placed.curvature)) {}

  /// [1] Goes along as far as the discs are free around the poses.
  [[nodiscard]] bool is_clear() const {
    const double step = grid_.body_.half_width / 2;  // driven both ways before a closer look
    double covered = 0.0;
    double reach = 2 * step;
    do {
      const double half = std::min(reach, placed_.length - covered);
      const double middle = covered + half;
      const Placement pose = after(middle);
      const double room = room_at(pose);
      if (room == -infinity) return false;
      if (room >= half) {
        covered = middle + room;
        reach = std::max(step, room);
      } else if (half > step) {
        reach = std::max(step, std::min(room, half / 2));
      } else {
        if (is_touched({middle, half}, pose)) return false;
        covered = middle + half;
      }
    } while (covered < placed_.length);
    return true;
  }

 private:
  struct Interval {
    double middle, half;  // driven
  };

  /// No point of the body is faster, with the rear axle at speed 1.
  static double speed_of(const Footprint& body, double curvature) {
    const double across = 1 + curvature * body.half_width;
    const double along = curvature * std::max(body.front, body.rear);
    return std::sqrt(across * across + along * along);
  }

  /// Where the vehicle is after that length, no further than the end.
  [[nodiscard]] Placement after(double driven) const {
    const double length = std::min(driven, placed_.length);
    const Point& forward = placed_.forward;
    const Point& left = placed_.left;
    const Point& from = placed_.from.position;
    const double turn = length * placed_.curvature;
    if (turn < 1e-15) {
      return {{from.x + length * forward.x, from.y + length * forward.y}, placed_.from.heading};
    }
    const SinCos half = sin_cos(turn / 2);
    const double sin = 2 * half.sin * half.cos;
    const double cos = 1 - 2 * half.sin * half.sin;
    const double x = sin / placed_.curvature;
    const double y = 2 * half.sin * half.sin / placed_.curvature;
    return {{from.x + x * forward.x + y * left.x, from.y + x * forward.y + y * left.y},
            {gear_ * (cos * forward.x + sin * left.x), gear_ * (cos * forward.y + sin * left.y)}};
  }

  static Point point_at(const Placement& pose, double x) {
    return {pose.position.x + x * pose.heading.x, pose.position.y + x * pose.heading.y};
  }

  /// How far may be driven both ways without touching anything; below 0 where that is not known,
  /// minus infinity where the footprint is hit. The coarse field answers where it is enough.
  [[nodiscard]] double room_at(const Placement& pose) const {
    const double plenty = grid_.body_.half_width;
    const double room = room_of(grid_.whole_, pose, &GridObstacles::rough_distance);
    if (room >= plenty || room == -infinity) return room / speed_;
    const double rough = room_of_slices(pose, &GridObstacles::rough_distance);
    const bool is_answer = rough >= plenty / 2 || rough < -grid_.rough_error_;
    return (is_answer ? rough : room_of_slices(pose, &GridObstacles::distance)) / speed_;
  }

  using Distance = DistanceField::Range (GridObstacles::*)(const Point&) const;

  [[nodiscard]] double room_of(const Slice& slice, const Placement& pose, Distance distance) const {
    const auto [least, most] = (grid_.*distance)(point_at(pose, slice.x));
    return most < slice.inner ? -infinity : least - slice.radius - end_margin;
  }

  [[nodiscard]] double room_of_slices(const Placement& pose, Distance distance) const {
    double room = infinity;
    for (const Slice& slice : grid_.slices_) room = std::min(room, room_of(slice, pose, distance));
    return room;
  }

  /// [2] Looks closer at both halves of an interval, and at the parts of the slices.
  [[nodiscard]] bool is_touched(const Interval& interval, const Placement& pose) const {
    const double half = interval.half / 2;
    const Placement poses[] = {after(interval.middle - half), after(interval.middle + half)};
    const auto is_clear = [&](const Slice& slice, const Placement& at, double driven) {
      const double needed = slice.radius + driven * speed_ + end_margin;
      return grid_.distance(point_at(at, slice.x)).least > needed;
    };
    for (std::size_t i = 0; i < grid_.slices_.size(); ++i) {
      if (is_clear(grid_.slices_[i], pose, interval.half)) continue;
      for (std::size_t part = 2 * i; part < 2 * i + 2; ++part) {
        const Slice& slice = grid_.halves_[part];
        for (const Placement& at : poses) {
          if (!is_clear(slice, at, half) && is_hit(slice, at, half)) return true;
        }
      }
    }
    return false;
  }

  /// [3] Whether the whole sweep touches an edge cell that a slice may touch in an interval.
  [[nodiscard]] bool is_hit(const Slice& slice, const Placement& pose, double half) const {
    const double reach = slice.radius + half * speed_ + end_margin;
    const auto [x, y] = point_at(pose, slice.x);
    const CellBox box = grid_.cells_in({x - reach, x + reach, y - reach, y + reach});
    return grid_.cells_.edges().any_run(
        box, [&](std::int32_t row, std::int32_t x_begin, std::int32_t x_end) {
          return sweep_.touches(sides_of(row, x_begin, x_end, grid_.side_));
        });
  }

  const GridObstacles& grid_;
  const PlacedSegment& placed_;
  const Sweep& sweep_;
  double gear_;  // 1 forward, -1 reverse
  double speed_;
};

GridObstacles::GridObstacles(const OccupancyGrid& grid, const Footprint& body)
    : side_(grid.resolution),
      body_(body),
      cells_(grid),
      field_(cells_, coarseness_of(side_, rough_side)),
      rough_error_(std::sqrt(2.0) * side_ * (1 << coarseness_of(side_, rough_side))) {
  const auto [sin, cos] = sin_cos(grid.origin.heading);
  along_ = {cos, sin};
  // The frame is a cell wide.
  origin_ = {grid.origin.x - side_ * (cos - sin), grid.origin.y - side_ * (sin + cos)};
  const double length = body.front + body.rear;
  slices_ = sliced(std::max(2 * body.half_width, length / 8));
  halves_ = sliced(length / static_cast<double>(2 * slices_.size()));
  whole_ = sliced(length).front();
  shift_ = coarseness_of(side_, block_side);
  blocks_ = blocks_of(cells_.edges(), shift_);
}

/// Equal slices, none longer than that.
std::vector<GridObstacles::Slice> GridObstacles::sliced(double longest) const {
  const double length = body_.front + body_.rear;
  const double count = std::max(1.0, std::ceil(length / longest - 1e-9));
  const double part = length / count;
  std::vector<Slice> slices;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double x = -body_.rear + (i + 0.5) * part;
    const double inner = std::min({body_.half_width, x + body_.rear, body_.front - x});
    slices.push_back({x, std::hypot(part / 2, body_.half_width), inner});
  }
  return slices;
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

DistanceField::Range GridObstacles::distance(const Point& point) const noexcept {
  const DistanceField::Range range = field_.around({point.x / side_, point.y / side_});
  return {range.least * side_, range.most * side_};
}

DistanceField::Range GridObstacles::rough_distance(const Point& point) const noexcept {
  const DistanceField::Range range = field_.roughly_around({point.x / side_, point.y / side_});
  return {range.least * side_, range.most * side_};
}

/// The cells that meet a box, or more if it reaches beyond the frame.
CellBox GridObstacles::cells_in(const Bounds& box) const noexcept {
  const auto index = [&](double place, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp(place / side_, 0.0, count - 0.5));
  };
  return {index(box.x_min, cells_.columns()), index(box.x_max, cells_.columns()),
          index(box.y_min, cells_.rows()), index(box.y_max, cells_.rows())};
}

/// Whether the sweep from a place on touches a block with edge cells.
bool GridObstacles::is_near(const Point& from, const Sweep& sweep) const noexcept {
  const CellBox first = cells_in({from.x, from.x, from.y, from.y});
  const auto [x_min, x_max, y_min, y_max] = cells_in(sweep.box());
  const CellBox box{x_min >> shift_, x_max >> shift_, y_min >> shift_, y_max >> shift_};
  const double side = side_ * (1 << shift_);
  int tests = 4;  // more of them cost as much as a closer look
  if (blocks_.is_set(first.x_min >> shift_, first.y_min >> shift_)) return true;
  return blocks_.any_run(box, [&](std::int32_t y, std::int32_t x_begin, std::int32_t x_end) {
    return --tests < 0 || sweep.touches(sides_of(y, x_begin, x_end, side));
  });
}

bool GridObstacles::contain(const Point& point) const noexcept {
  const Point p = in_frame(point);
  // Outside of the frame is as its border.
  const double x = std::clamp(p.x / side_, 0.0, cells_.columns() - 0.5);
  const double y = std::clamp(p.y / side_, 0.0, cells_.rows() - 0.5);
  return cells_.is_blocked(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
}

bool GridObstacles::is_clear(const PlacedSegment& placed) const noexcept {
  const PlacedSegment here = in_frame(placed);
  const Sweep sweep(body_, here);
  return !is_near(here.from.position, sweep) || Drive(*this, here, sweep).is_clear();
}

bool GridObstacles::is_within(const Point& point, double distance) const noexcept {
  const Point p = in_frame(point);
  const auto [least, most] = this->distance(p);
  if (least > distance) return false;
  if (most <= distance) return true;
  if (contain(point)) return true;
  const CellBox box = cells_in({p.x - distance, p.x + distance, p.y - distance, p.y + distance});
  return cells_.edges().any_run(box, [&](std::int32_t y, std::int32_t x_begin, std::int32_t x_end) {
    const double dx = std::max({x_begin * side_ - p.x, p.x - x_end * side_, 0.0});
    const double dy = std::max({y * side_ - p.y, p.y - (y + 1) * side_, 0.0});
    return dx * dx + dy * dy <= distance * distance;
  });
}

}  // namespace vandplan
