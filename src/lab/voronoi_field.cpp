// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/voronoi_field.h"

#include <algorithm>
#include <cmath>

namespace vandplan::search {
namespace {

constexpr double most_cells = 250e3;  // largest number of cells
constexpr double nowhere = 1e6;       // distance if there is no obstacle [m]
// Least distance between the nearest obstacles of two neighbouring cells on the middle [cells].
constexpr std::int32_t least_gap = 3;
constexpr std::size_t spots_of_step = 4096;  // cells that spread in one step

std::int64_t square(std::int32_t x, std::int32_t y) {
  return std::int64_t{x} * x + std::int64_t{y} * y;
}

}  // namespace

VoronoiField::VoronoiField(const Task& task, double side)
    : task_(task), box_(task.world->local().bounds) {
  const double width = box_.x_max - box_.x_min;
  const double height = box_.y_max - box_.y_min;
  side_ = std::max(
      {side, std::sqrt(width * height / most_cells), std::max(width, height) / most_cells});
  columns_ = static_cast<std::int32_t>(width / side_) + 1;
  rows_ = static_cast<std::int32_t>(height / side_) + 1;
  const std::size_t cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  obstacles_.spots.assign(cells, {-1, -1});
  middle_.spots.assign(cells, {-1, -1});
  seed_polygons(task.world->local().obstacles);
  seed_polygons(task.world->local().kerbs);
}

VoronoiField::Spot VoronoiField::spot_of(const Point& point) const noexcept {
  const auto place = [this](double offset, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp(std::floor(offset / side_), 0.0, count - 1.0));
  };
  return {place(point.x - box_.x_min, columns_), place(point.y - box_.y_min, rows_)};
}

Point VoronoiField::centre_of(const Spot& spot) const noexcept {
  return {box_.x_min + (spot.x + 0.5) * side_, box_.y_min + (spot.y + 0.5) * side_};
}

void VoronoiField::seed(Nearest& field, const Spot& spot) const {
  Spot& known = field.spots[index(spot)];
  if (known.x >= 0) return;
  known = spot;
  field.ring.push_back(spot);
}

/// Seeds polygons as far as they lie in the box: sides, walked in half cells, and insides.
void VoronoiField::seed_polygons(const std::vector<Polygon>& polygons) {
  for (const Polygon& polygon : polygons) {
    Point a = polygon.back();
    for (const Point& b : polygon) {
      const double steps = std::ceil(2 * std::hypot(b.x - a.x, b.y - a.y) / side_) + 1;
      const double most = 2.0 * (columns_ + rows_);
      const auto count = static_cast<int>(std::min(steps, 4 * most));
      for (int i = 0; i <= count; ++i) {
        const double t = static_cast<double>(i) / count;
        const Point p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
        if (vandplan::contains(box_, p)) seed(obstacles_, spot_of(p));
      }
      a = b;
    }
    seed_inside(polygon);
  }
}

/// Seeds the cells whose centre is inside a polygon, so that the middle does not pass through it.
void VoronoiField::seed_inside(const Polygon& polygon) {
  const Bounds box = bounding_box(polygon);
  const std::int32_t last = spot_of({box_.x_min, box.y_max}).y;
  std::vector<double> crossings;  // x where sides cross a row of centres [cells]
  for (std::int32_t y = spot_of({box_.x_min, box.y_min}).y; y <= last; ++y) {
    const double height = centre_of({0, y}).y;
    crossings.clear();
    Point a = polygon.back();
    for (const Point& b : polygon) {
      if ((a.y > height) != (b.y > height)) {
        const double x = a.x + (height - a.y) / (b.y - a.y) * (b.x - a.x);
        crossings.push_back(std::clamp((x - box_.x_min) / side_ - 0.5, -1.0, columns_ + 0.0));
      }
      a = b;
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 1; i < crossings.size(); i += 2) {
      const auto end = std::min(columns_ - 1, static_cast<std::int32_t>(crossings[i]));
      for (auto x = static_cast<std::int32_t>(std::ceil(crossings[i - 1])); x <= end; ++x) {
        if (x >= 0) seed(obstacles_, {x, y});
      }
    }
  }
}

void VoronoiField::seed_map_row() {
  for (std::int32_t x = 0; x < columns_; ++x) {
    const Spot spot{x, map_row_};
    if (task_.checker->map_is_within(Local(centre_of(spot)), side_ / 2)) seed(obstacles_, spot);
  }
  ++map_row_;
}

/// Passes the nearest seed of each cell of the ring on to the neighbours. False when all is done.
bool VoronoiField::spread(Nearest& field) const {
  for (std::size_t done = 0; done < spots_of_step; ++done) {
    if (field.ring.empty()) {
      if (field.next_ring.empty()) return false;
      field.ring.swap(field.next_ring);
    }
    const Spot from = field.ring.back();
    field.ring.pop_back();
    const Spot seed = field.spots[index(from)];
    for (const std::int32_t dy : {-1, 0, 1}) {
      for (const std::int32_t dx : {-1, 0, 1}) {
        const Spot to{from.x + dx, from.y + dy};
        if (!contains(to)) continue;
        Spot& known = field.spots[index(to)];
        const bool is_nearer = known.x < 0 || square(to.x - seed.x, to.y - seed.y) <
                                                  square(to.x - known.x, to.y - known.y);
        if (!is_nearer) continue;
        known = seed;
        field.next_ring.push_back(to);
      }
    }
  }
  return true;
}

/// Seeds the cells of a row whose right or upper neighbour has another nearest obstacle. The two
/// obstacles are further apart than the cell is from its own, which means 60 degrees.
void VoronoiField::seed_middle_row() {
  for (std::int32_t x = 0; x < columns_; ++x) {
    const Spot spot{x, middle_row_};
    const Spot own = obstacles_.spots[index(spot)];
    if (own.x < 0) continue;
    const std::int64_t away = square(own.x - spot.x, own.y - spot.y);
    for (const Spot& beside : {Spot{x + 1, middle_row_}, Spot{x, middle_row_ + 1}}) {
      if (!contains(beside)) continue;
      const Spot other = obstacles_.spots[index(beside)];
      const std::int64_t gap = square(own.x - other.x, own.y - other.y);
      if (gap > std::max<std::int64_t>(away, least_gap * least_gap)) seed(middle_, spot);
    }
  }
  ++middle_row_;
}

bool VoronoiField::step() {
  if (task_.world->local().map && map_row_ < rows_) {
    seed_map_row();
    return true;
  }
  if (spread(obstacles_)) return true;
  if (middle_row_ < rows_) {
    seed_middle_row();
    return true;
  }
  return spread(middle_);
}

double VoronoiField::distance(const Nearest& field, const Spot& spot) const noexcept {
  const Spot nearest = field.spots[index(spot)];
  if (nearest.x < 0) return nowhere;
  return side_ * std::hypot(spot.x - nearest.x, spot.y - nearest.y);
}

VoronoiField::Distances VoronoiField::at(const Point& point) const noexcept {
  const Spot spot = spot_of(point);
  return {distance(obstacles_, spot), distance(middle_, spot)};
}

double VoronoiField::potential(const Point& point, const Range& range) const noexcept {
  const auto [obstacle, middle] = at(point);
  if (obstacle >= range.reach) return 0.0;
  const double near = range.falloff / (range.falloff + obstacle);
  const double aside = obstacle + middle > 0.0 ? middle / (obstacle + middle) : 1.0;
  const double left = 1 - obstacle / range.reach;
  return near * aside * left * left;
}

double VoronoiField::along(Pose from, std::span<const Segment> segments,
                           const Range& range) const noexcept {
  double sum = 0.0;
  for (const Segment& segment : segments) {
    const double length = std::abs(segment.length);
    const double looks = std::ceil(length / side_);
    for (double i = 0; i < looks; ++i) {
      const Pose pose = advance(from, part_of(segment, 0.0, (i + 0.5) * length / looks));
      sum += potential({pose.x, pose.y}, range) * length / looks;
    }
    from = advance(from, segment);
  }
  return sum;
}

}  // namespace vandplan::search
