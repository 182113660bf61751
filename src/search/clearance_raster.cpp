// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/clearance_raster.h"

#include <algorithm>
#include <cmath>

#include "collision/zones.h"

namespace vandplan::search {
namespace {

constexpr double cells_of_width = 4.0;  // Cells across the vehicle's width.
constexpr double max_cells = 160'000.0;
// Largest distance between discs [inner radii]. Halfway between two discs the body sticks out as
// far as the discs stick out beside their middles.
constexpr double spacing = 1.4;
constexpr std::int64_t looks_of_step = 2000;  // Cells beside sides that one call looks at.

}  // namespace

ClearanceRaster::ClearanceRaster(const Task& task, const Bounds& box, double most)
    : ground_(&task.world->local()),
      map_(ground_->map ? task.checker.get() : nullptr),
      margin_(task.least_margin),
      is_trusted_(ground_->kerbs.empty() && task.vehicle.outline.empty()),
      has_rules_(std::ranges::any_of(ground_->zones, collision::has_rules)) {
  const Footprint body = footprint(task.vehicle);
  const double reach = std::hypot((body.front + body.rear) / 2, body.half_width);
  middle_ = static_cast<float>((body.front - body.rear) / 2);
  reach_ = static_cast<float>(reach + margin_);
  const double width = box.x_max - box.x_min;
  const double height = box.y_max - box.y_min;
  const double side =
      std::max({task.vehicle.width / cells_of_width, std::sqrt(width * height / max_cells),
                std::max(width, height) / max_cells});
  raster_ = {{box.x_min, box.y_min}, side};
  per_side_ = static_cast<float>(1 / side);
  most_ = static_cast<float>(most + side);
  furthest_ = most + side + margin_ + reach;
  columns_ = static_cast<std::int32_t>(width / side) + 2;
  rows_ = static_cast<std::int32_t>(height / side) + 2;
  distances_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
                    static_cast<float>(furthest_));
  if (map_ != nullptr) is_asked_.assign(distances_.size(), false);
  for (const Point& corner : body_outline(task.vehicle)) {
    discs_.push_back(
        {static_cast<float>(corner.x), static_cast<float>(corner.y), static_cast<float>(margin_)});
  }
  if (!task.vehicle.outline.empty()) {
    discs_.push_back({0.0F, 0.0F, static_cast<float>(inner_radius(task.vehicle) + margin_)});
    return;
  }
  const double length = body.rear + body.front;
  const double inner = std::min(body.half_width, length / 2);
  const double max_apart = spacing * inner;
  const int gaps = std::max(1, static_cast<int>(std::ceil((length - 2 * inner) / max_apart)));
  const double apart = (length - 2 * inner) / gaps;
  const double radius = (inner + std::hypot(inner, apart / 2)) / 2;
  for (int i = 0; i <= gaps; ++i) {
    discs_.push_back({static_cast<float>(inner - body.rear + i * apart), 0.0F,
                      static_cast<float>(radius + margin_)});
  }
}

/// Stores the distance to a side in the cells around it. Returns the number of cells it looked at.
std::int64_t ClearanceRaster::mark(const Point& a, const Point& b) {
  const RasterCell last{columns_ - 1, rows_ - 1};
  const auto store = [this](const RasterCell& cell, double squared) {
    float& distance = distances_[index_of(cell)];
    distance = std::min(distance, static_cast<float>(std::sqrt(squared)));
  };
  return 1 + raster_.visit_near(a, b, furthest_, {0, 0}, last, store);
}

bool ClearanceRaster::step() {
  const std::vector<Polygon>& obstacles = ground_->obstacles;
  for (std::int64_t looks = 0; looks < looks_of_step && polygon_ < obstacles.size();) {
    const Polygon& polygon = obstacles[polygon_];
    looks += mark(corner_ == 0 ? polygon.back() : polygon[corner_ - 1], polygon[corner_]);
    if (++corner_ < polygon.size()) continue;
    corner_ = 0;
    ++polygon_;
  }
  return polygon_ < obstacles.size();
}

/// Looks up the distance of a cell from what a map blocks. That is done on demand: most cells are
/// never asked for, and looking all up takes long.
void ClearanceRaster::ask_map(RasterCell cell) noexcept {
  const std::size_t index = index_of(cell);
  if (is_asked_[index]) return;
  is_asked_[index] = true;
  const Local<Point> centre(raster_.centre_of(cell));
  float& distance = distances_[index];
  distance = std::min(distance, static_cast<float>(map_->map_distance(centre).most));
}

/// Distance from the centre of a cell [m].
float ClearanceRaster::distance_of(RasterCell cell) noexcept {
  if (map_ != nullptr) ask_map(cell);
  return distances_[index_of(cell)];
}

float ClearanceRaster::distance(float x, float y) noexcept {
  const float column = (x - static_cast<float>(raster_.origin.x)) * per_side_ - 0.5F;
  const float row = (y - static_cast<float>(raster_.origin.y)) * per_side_ - 0.5F;
  const bool is_inside = column >= 0.0F && row >= 0.0F &&
                         column < static_cast<float>(columns_ - 1) &&
                         row < static_cast<float>(rows_ - 1);
  if (!is_inside) return static_cast<float>(furthest_);
  const auto i = static_cast<std::int32_t>(column);
  const auto j = static_cast<std::int32_t>(row);
  const float right = column - static_cast<float>(i);
  const float up = row - static_cast<float>(j);
  const auto along = [&](std::int32_t row_of_two) {
    const float left = distance_of({i, row_of_two});
    return left + right * (distance_of({i + 1, row_of_two}) - left);
  };
  const float below = along(j);
  const float above = along(j + 1);
  return below + up * (above - below);
}

float ClearanceRaster::clearance(float x, float y, float cos, float sin) noexcept {
  float least = most_;
  const float around = distance(x + cos * middle_, y + sin * middle_);
  if (around - reach_ >= least) return least;
  for (const Disc& disc : discs_) {
    const float d =
        distance(x + cos * disc.ahead - sin * disc.aside, y + sin * disc.ahead + cos * disc.aside);
    least = std::min(least, d - disc.radius);
  }
  return least;
}

}  // namespace vandplan::search
