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

/// The closed square cells of a run, in metres.
Sides sides_of(std::int32_t y, std::int32_t x_begin, std::int32_t x_end, double side) {
  const double left = x_begin * side;
  const double right = x_end * side;
  const double low = y * side;
  const double high = (y + 1) * side;
  return {{left, right, right, left, left}, {low, low, high, high, low}};
}

}  // namespace

/// One segment, driven.
class GridObstacles::Drive {
 public:
  Drive(const GridObstacles& grid, const Placement& from, const Segment& segment)
      : grid_(grid),
        segment_(segment),
        placed_(from, segment),
        sweep_(grid.body_, placed_),
        speed_(speed_of(grid.body_, segment.curvature)) {}

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
    const double k = std::abs(curvature);
    return std::hypot(1 + k * body.half_width, k * std::max(body.front, body.rear));
  }

  [[nodiscard]] Placement after(double driven) const {
    const double length = std::copysign(std::min(driven, placed_.length), segment_.length);
    return PlacedSegment(placed_.from, {segment_.curvature, length}).to;
  }

  static Point point_at(const Placement& pose, double x) {
    return {pose.position.x + x * pose.heading.x, pose.position.y + x * pose.heading.y};
  }

  /// How far may be driven both ways without touching anything; below 0 where that is not known,
  /// minus infinity where the footprint is hit.
  [[nodiscard]] double room_at(const Placement& pose) const {
    const auto room_of = [&](const Slice& slice) {
      const auto [least, most] = grid_.distance(point_at(pose, slice.x));
      return most < slice.inner ? -infinity : least - slice.radius - end_margin;
    };
    double room = room_of(grid_.whole_);
    if (room >= grid_.body_.half_width || room == -infinity) return room / speed_;
    room = infinity;
    for (const Slice& slice : grid_.slices_) room = std::min(room, room_of(slice));
    return room / speed_;
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
    const CellBox box = grid_.cells_around(point_at(pose, slice.x), reach);
    return grid_.cells_.any_edge_run(
        box, [&](std::int32_t y, std::int32_t x_begin, std::int32_t x_end) {
          return sweep_.touches(sides_of(y, x_begin, x_end, grid_.side_));
        });
  }

  const GridObstacles& grid_;
  const Segment& segment_;
  PlacedSegment placed_;
  Sweep sweep_;
  double speed_;
};

GridObstacles::GridObstacles(const OccupancyGrid& grid, const Footprint& body)
    : side_(grid.resolution), body_(body), cells_(grid), field_(cells_) {
  const auto [sin, cos] = sin_cos(grid.origin.heading);
  along_ = {cos, sin};
  // The frame is a cell wide.
  origin_ = {grid.origin.x - side_ * (cos - sin), grid.origin.y - side_ * (sin + cos)};
  const double length = body.front + body.rear;
  slices_ = sliced(std::max(2 * body.half_width, length / 8));
  halves_ = sliced(length / static_cast<double>(2 * slices_.size()));
  whole_ = sliced(length).front();
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

Placement GridObstacles::in_frame(const Placement& placement) const noexcept {
  const Point& h = placement.heading;
  return {in_frame(placement.position),
          {h.x * along_.x + h.y * along_.y, h.y * along_.x - h.x * along_.y}};
}

DistanceField::Range GridObstacles::distance(const Point& point) const noexcept {
  const DistanceField::Range range = field_.around({point.x / side_, point.y / side_});
  return {range.least * side_, range.most * side_};
}

CellBox GridObstacles::cells_around(const Point& point, double reach) const noexcept {
  const auto column = [&](double x) {
    return static_cast<std::int32_t>(std::clamp(x / side_, -1.0, cells_.columns() + 1.0));
  };
  const auto row = [&](double y) {
    return static_cast<std::int32_t>(std::clamp(y / side_, -1.0, cells_.rows() + 1.0));
  };
  return {column(point.x - reach), column(point.x + reach), row(point.y - reach),
          row(point.y + reach)};
}

bool GridObstacles::contain(const Point& point) const noexcept {
  const Point p = in_frame(point);
  // Outside of the frame is as its border.
  const double x = std::clamp(p.x / side_, 0.0, cells_.columns() - 0.5);
  const double y = std::clamp(p.y / side_, 0.0, cells_.rows() - 0.5);
  return cells_.is_blocked(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
}

bool GridObstacles::is_clear(const Placement& from, const Segment& segment) const noexcept {
  return Drive(*this, in_frame(from), segment).is_clear();
}

bool GridObstacles::is_within(const Point& point, double distance) const noexcept {
  const Point p = in_frame(point);
  const auto [least, most] = this->distance(p);
  if (least > distance) return false;
  if (most <= distance) return true;
  if (contain(point)) return true;
  const CellBox box = cells_around(p, distance);
  return cells_.any_edge_run(box, [&](std::int32_t y, std::int32_t x_begin, std::int32_t x_end) {
    const double dx = std::max({x_begin * side_ - p.x, p.x - x_end * side_, 0.0});
    const double dy = std::max({y * side_ - p.y, p.y - (y + 1) * side_, 0.0});
    return dx * dx + dy * dy <= distance * distance;
  });
}

}  // namespace vandplan
