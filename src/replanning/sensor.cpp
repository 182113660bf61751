// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "replanning/sensor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/trigonometry.h"

namespace vandplan::replanning {
namespace {

constexpr int rays = 720;
constexpr double slowest = 0.01;       // least speed that counts as moving [m/s]
constexpr double measured_over = 0.1;  // time over which a velocity is measured [s]

/// Distance along a ray to a side of a polygon [m]; infinite if they do not cross.
double crossing(const Point& from, const Point& along, const Point& a, const Point& b) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const double sx = b.x - a.x;
  const double sy = b.y - a.y;
  const double det = along.x * sy - along.y * sx;
  if (det == 0.0) return never;
  const double dx = a.x - from.x;
  const double dy = a.y - from.y;
  const double t = (dx * sy - dy * sx) / det;
  const double u = (dx * along.y - dy * along.x) / det;
  return t >= 0.0 && u >= 0.0 && u <= 1.0 ? t : never;
}

MovingObstacle going_on(const MovingObstacle& obstacle, const Pose& now, double t, double horizon) {
  const Pose before = pose_at(obstacle, t - measured_over).value_or(now);
  const double vx = (now.x - before.x) / measured_over;
  const double vy = (now.y - before.y) / measured_over;
  MovingObstacle predicted{obstacle.outline, {{t, now}}, Afterwards::stays, obstacle.inflate};
  if (std::hypot(vx, vy) < slowest) return predicted;
  predicted.trajectory.push_back(
      {t + horizon, {now.x + vx * horizon, now.y + vy * horizon, now.heading}});
  predicted.after = Afterwards::leaves;
  return predicted;
}

}  // namespace

Scenario unseen(const Scenario& scenario) {
  Scenario blank = scenario;
  blank.obstacles.clear();
  blank.moving.clear();
  if (blank.map) {
    blank.map->cells = std::vector<Cell>(blank.map->cells->size(), Cell::unknown);
  }
  return blank;
}

Sensor::Sensor(const Scenario& scenario, double range)
    : scenario_(scenario), range_(range), is_known_(scenario.obstacles.size(), false) {
  for (std::size_t i = 0; i < scenario.obstacles.size(); ++i) {
    const Polygon& polygon = scenario.obstacles[i];
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      sides_.push_back({polygon[k], polygon[(k + 1) % polygon.size()], i});
    }
  }
  if (scenario.map) known_.assign(scenario.map->cells->size(), Cell::unknown);
}

void Sensor::mark(std::int32_t column, std::int32_t row) {
  const OccupancyGrid& map = *scenario_.map;
  const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
                        static_cast<std::size_t>(column);
  if (known_[i] == (*map.cells)[i]) return;
  known_[i] = (*map.cells)[i];
  if (last_column_ < first_column_) {
    first_column_ = last_column_ = column;
    first_row_ = last_row_ = row;
  }
  first_column_ = std::min(first_column_, column);
  last_column_ = std::max(last_column_, column);
  first_row_ = std::min(first_row_, row);
  last_row_ = std::max(last_row_, row);
}

/// Marks the cells along a ray as seen. Returns how far the ray gets [m].
double Sensor::mark_cells(const Ray& ray) {
  if (!scenario_.map) return range_;
  const OccupancyGrid& map = *scenario_.map;
  const auto [sin, cos] = base::sin_cos(map.origin.heading);
  const double dx = ray.from.x - map.origin.x;
  const double dy = ray.from.y - map.origin.y;
  const double side = map.resolution;
  const Point at{(dx * cos + dy * sin) / side, (dy * cos - dx * sin) / side};
  const Point way{(ray.along.x * cos + ray.along.y * sin), (ray.along.y * cos - ray.along.x * sin)};
  constexpr double never = std::numeric_limits<double>::infinity();
  // Distances along the ray from one side of a cell to the next [cells].
  auto column = static_cast<std::int32_t>(std::floor(at.x));
  auto row = static_cast<std::int32_t>(std::floor(at.y));
  const double per_column = way.x != 0.0 ? std::abs(1 / way.x) : never;
  const double per_row = way.y != 0.0 ? std::abs(1 / way.y) : never;
  double next_column = way.x > 0.0   ? (column + 1 - at.x) * per_column
                       : way.x < 0.0 ? (at.x - column) * per_column
                                     : never;
  double next_row = way.y > 0.0   ? (row + 1 - at.y) * per_row
                    : way.y < 0.0 ? (at.y - row) * per_row
                                  : never;
  const double most = range_ / side;
  double driven = 0.0;
  while (driven <= most) {
    if (column >= 0 && row >= 0 && column < map.columns && row < map.rows) {
      mark(column, row);
      const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
                            static_cast<std::size_t>(column);
      if ((*map.cells)[i] != Cell::free) return driven * side;
    }
    if (next_column < next_row) {
      driven = next_column;
      next_column += per_column;
      column += way.x > 0.0 ? 1 : -1;
    } else {
      driven = next_row;
      next_row += per_row;
      row += way.y > 0.0 ? 1 : -1;
    }
  }
  return range_;
}

CellPatch Sensor::new_cells() {
  CellPatch patch{first_column_, first_row_, last_column_ - first_column_ + 1,
                  last_row_ - first_row_ + 1};
  const auto columns = static_cast<std::ptrdiff_t>(scenario_.map->columns);
  for (std::int32_t row = first_row_; row <= last_row_; ++row) {
    const auto from = known_.begin() + row * columns + first_column_;
    patch.cells.insert(patch.cells.end(), from, from + patch.columns);
  }
  first_column_ = 0;
  last_column_ = -1;
  return patch;
}

WorldPatch Sensor::look(const Pose& pose) {
  const Vehicle& vehicle = scenario_.vehicle;
  const Pose middle = advance(
      pose, {0.0, (vehicle.wheelbase + vehicle.front_overhang - vehicle.rear_overhang) / 2});
  const Point eye{middle.x, middle.y};
  std::vector<bool> is_seen(is_known_.size(), false);
  for (int i = 0; i < rays; ++i) {
    const auto [sin, cos] = base::sin_cos(2 * std::numbers::pi * i / rays);
    const Ray ray{eye, {cos, sin}};
    double nearest = mark_cells(ray);
    const Side* hit = nullptr;
    for (const Side& side : sides_) {
      const double far = crossing(ray.from, ray.along, side.from, side.to);
      if (far > nearest) continue;
      nearest = far;
      hit = &side;
    }
    if (hit != nullptr) is_seen[hit->polygon] = true;
  }
  WorldPatch patch;
  for (std::size_t i = 0; i < is_seen.size(); ++i) {
    if (!is_seen[i] || is_known_[i]) continue;
    is_known_[i] = true;
    patch.added.push_back({static_cast<std::int64_t>(i), scenario_.obstacles[i]});
  }
  if (last_column_ >= first_column_) patch.cells.push_back(new_cells());
  return patch;
}

std::vector<MovingObstacle> predicted(const std::vector<MovingObstacle>& moving, const Pose& pose,
                                      double t, const LiveDriveOptions& options) {
  std::vector<MovingObstacle> seen;
  for (const MovingObstacle& obstacle : moving) {
    const std::optional<Pose> now = pose_at(obstacle, t);
    const bool is_near =
        now && (!options.sensor_range ||
                std::hypot(now->x - pose.x, now->y - pose.y) <= *options.sensor_range);
    if (options.prediction == Prediction::known) {
      // Obstacles that have left are kept, so that the prediction stays equal from tick to tick.
      if (is_near || (!options.sensor_range)) seen.push_back(obstacle);
    } else if (is_near) {
      seen.push_back(going_on(obstacle, *now, t, options.horizon));
    }
  }
  return seen;
}

}  // namespace vandplan::replanning
