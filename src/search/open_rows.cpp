// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/open_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/trigonometry.h"
#include "geometry/boxes.h"
#include "geometry/convex.h"

namespace vandplan::search {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Slack of distances from the map [m]; relative slack of a stretch.
constexpr double rounding = 1e-9;
constexpr double slack_of_areas = 2e-3;  // Slack of places in zones; larger than the judge's [m].
constexpr std::size_t max_bands = 1024;
constexpr double max_bands_of_side = 4;  // Mean number of bands that a side reaches into, at most.
constexpr double max_stretch = 1.02;     // Stretch that is accepted for a wider disc.

/// Extends [low, high] by the places on the line at height `y` within `near` of a point.
void add_disc(const Point& p, double y, double near, double& low, double& high) {
  const double square = near * near - (y - p.y) * (y - p.y);
  if (square < 0) return;
  low = std::min(low, p.x - std::sqrt(square));
  high = std::max(high, p.x + std::sqrt(square));
}

/// Extends [low, high] by the places on the line at height `y` in the box around the line segment
/// from `a` to `b`, `near` wide to each side.
void add_box(const Point& a, const Point& b, double y, double near, double& low, double& high) {
  const double length = std::hypot(a.x - b.x, a.y - b.y);
  if (length == 0.0) return;
  const Point u{(b.x - a.x) / length, (b.y - a.y) / length};
  double first = -infinity;
  double last = infinity;
  const auto clip = [&](double slope, double at_zero, double from, double to) {
    if (slope == 0.0) {
      if (at_zero < from || at_zero > to) last = -infinity;
      return;
    }
    const double one = (from - at_zero) / slope;
    const double other = (to - at_zero) / slope;
    first = std::max(first, std::min(one, other));
    last = std::min(last, std::max(one, other));
  };
  clip(u.x, (y - a.y) * u.y, 0.0, length);   // Place along the segment, as a function of x - a.x.
  clip(-u.y, (y - a.y) * u.x, -near, near);  // Place beside the segment.
  if (first > last) return;
  low = std::min(low, a.x + first);
  high = std::max(high, a.x + last);
}

/// Widest disc on the middle line of an outline. The room around a place is concave along the line,
/// so thirds find the widest place, then bisection the nearest one hardly less wide.
Disc widest_disc_in(const Polygon& outline, const Footprint& box) {
  constexpr double hardly_less = 1e-6;  // Relative loss of radius.
  constexpr int steps = 100;
  const auto room = [&](double ahead) { return -geometry::signed_distance(outline, {ahead, 0.0}); };
  double low = -box.rear;
  double high = box.front;
  for (int i = 0; i < steps; ++i) {
    const double first = low + (high - low) / 3;
    const double second = high - (high - low) / 3;
    (room(first) < room(second) ? low : high) = room(first) < room(second) ? first : second;
  }
  const double widest = (low + high) / 2;
  const double wanted = (1 - hardly_less) * room(widest);
  double near = 0.0;
  double far = widest;
  for (int i = 0; i < steps && room(0.0) < wanted; ++i) {
    const double middle = (near + far) / 2;
    (room(middle) < wanted ? near : far) = middle;
  }
  const double ahead = room(0.0) < wanted ? far : 0.0;
  return {ahead, std::max(0.0, room(ahead))};
}

}  // namespace

Disc widest_disc(const Vehicle& vehicle) {
  const Footprint body = footprint(vehicle);
  if (!vehicle.outline.empty()) return widest_disc_in(body_outline(vehicle), body);
  const double radius = std::min(body.half_width, (body.front + body.rear) / 2);
  return {std::max(radius - body.rear, std::min(0.0, body.front - radius)), radius};
}

double stretch_of(const Disc& disc, double turning_radius) noexcept {
  if (disc.ahead == 0.0) return 1.0;
  return std::hypot(1.0, disc.ahead / turning_radius) * (1 + rounding);
}

Disc bound_disc(const Vehicle& vehicle) {
  const Disc widest = widest_disc(vehicle);
  const double inner = inner_radius(vehicle);
  const bool is_near = stretch_of(widest, vehicle.min_turning_radius) < max_stretch;
  return is_near || inner == 0.0 ? widest : Disc{0.0, inner};
}

Point centre_of(const Disc& disc, const Pose& pose) noexcept {
  const auto [sin, cos] = base::sin_cos(pose.heading);
  return {pose.x + disc.ahead * cos, pose.y + disc.ahead * sin};
}

OpenRows::OpenRows(const Task& task, const Bounds& box, double side, double near,
                   std::vector<ClosedArea> closed)
    : task_(&task),
      box_(box),
      side_(side),
      near_(near),
      columns_(static_cast<std::int32_t>((box.x_max - box.x_min) / side) + 1),
      rows_(static_cast<std::int32_t>((box.y_max - box.y_min) / side) + 1),
      areas_(std::move(closed)) {
  for (ClosedArea& area : areas_) area.near -= side * std::sqrt(0.5) + slack_of_areas;
  const Surroundings& ground = task.world->local();
  for (const Polygon& polygon : ground.obstacles) {
    Point a = polygon.back();
    for (const Point& b : polygon) {
      sides_.push_back({a, b, std::min(a.y, b.y) - near, std::max(a.y, b.y) + near});
      a = b;
    }
  }
  sort_into_bands();
  if (!ground.map) return;
  map_box_ = geometry::widened(bounding_box(outline(*ground.map)), near + side);
}

/// Place in cells from the middle of the first one; places outside the lattice are clamped to it.
double OpenRows::place_of(double x) const noexcept {
  return std::clamp((x - box_.x_min) / side_ - 0.5, -1.0, columns_ + 0.0);
}

/// Closes all cells whose middle lies between two places.
void OpenRows::close(double low, double high) {
  const auto first = std::max(0, static_cast<std::int32_t>(std::ceil(place_of(low))));
  const auto last = static_cast<std::int32_t>(std::floor(place_of(high)));
  if (first <= last) closed_.push_back({first, std::min(last + 1, columns_)});
}

std::size_t OpenRows::band_of(double y) const noexcept {
  const double share = (y - box_.y_min) / (box_.y_max - box_.y_min);
  const double last = static_cast<double>(bands_) - 1;
  return static_cast<std::size_t>(std::clamp(share * static_cast<double>(bands_), 0.0, last));
}

void OpenRows::sort_into_bands() {
  const double height = box_.y_max - box_.y_min;
  if (height > 0.0) {
    double sum = 0.0;  // Sum of the heights of all sides within the box [m].
    for (const Side& side : sides_) {
      sum += std::max(0.0, std::min(side.y_max, box_.y_max) - std::max(side.y_min, box_.y_min));
    }
    const double count = static_cast<double>(sides_.size());
    const double most = sum > 0.0 ? max_bands_of_side * count * height / sum : count;
    bands_ = static_cast<std::size_t>(std::clamp(std::min(most, count / 8), 1.0, 0.0 + max_bands));
  }
  band_begins_.assign(bands_ + 1, 0);
  for (const Side& side : sides_) {
    for (std::size_t i = band_of(side.y_min); i <= band_of(side.y_max); ++i) ++band_begins_[i];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : band_begins_) begin = sum += begin;
  band_sides_.resize(sum);
  for (std::size_t s = sides_.size(); s-- > 0;) {  // Backwards, so that the order is kept.
    const Side& side = sides_[s];
    for (std::size_t i = band_of(side.y_min); i <= band_of(side.y_max); ++i) {
      band_sides_[--band_begins_[i]] = static_cast<std::uint32_t>(s);
    }
  }
}

void OpenRows::close_near_sides(double y) {
  const std::size_t band = band_of(y);
  for (std::uint32_t i = band_begins_[band]; i < band_begins_[band + 1]; ++i) {
    const Side& side = sides_[band_sides_[i]];
    if (y < side.y_min || y > side.y_max) continue;
    double low = infinity;
    double high = -infinity;
    add_disc(side.a, y, near_, low, high);
    add_disc(side.b, y, near_, low, high);
    add_box(side.a, side.b, y, near_, low, high);
    close(low, high);
    ++looks_;
  }
}

/// Closes cells near the map. Where the distance field knows the next obstacle's distance, many
/// cells are decided at once.
void OpenRows::close_near_map(double y) {
  const Surroundings& ground = task_->world->local();
  if (!ground.map) return;
  const bool is_open_outside = ground.map->unknown_is_free;
  if (!is_open_outside && (y < map_box_.y_min || y > map_box_.y_max)) close(-infinity, infinity);
  if (y < map_box_.y_min || y > map_box_.y_max) return;
  const auto begin = static_cast<std::int32_t>(std::max(0.0, std::ceil(place_of(map_box_.x_min))));
  const auto end = static_cast<std::int32_t>(std::floor(place_of(map_box_.x_max))) + 1;
  if (!is_open_outside) {
    closed_.push_back({0, std::min(begin, columns_)});
    closed_.push_back({std::min(end, columns_), columns_});
  }
  for (std::int32_t x = begin; x < std::min(end, columns_);) {
    const Point middle{box_.x_min + (x + 0.5) * side_, y};
    const CollisionChecker::Range range = task_->checker->map_distance(Local(middle));
    const bool is_open = range.least > near_ + rounding;
    const bool is_closed = range.most < near_ - rounding;
    const double sure = is_open     ? range.least - near_ - rounding
                        : is_closed ? near_ - rounding - range.most
                                    : 0.0;
    const double cells = std::min(sure / side_, 1e6);
    const std::int32_t next = x + 1 + static_cast<std::int32_t>(cells);
    if (is_closed || (!is_open && task_->checker->map_is_within(Local(middle), near_))) {
      closed_.push_back({x, std::min(next, columns_)});
    }
    x = next;
    ++looks_;
  }
}

/// Closes all cells of the row whose middle is too near to an area, or too deep in it.
void OpenRows::close_area(const ClosedArea& closed, double y) {
  const auto& [area, near] = closed;
  std::vector<double> crossings;                   // Where the row enters and leaves the area.
  std::vector<std::pair<double, double>> at_edge;  // Stretches of the row near the edge.
  Point a = area.back();
  for (const Point& b : area) {
    if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    double low = infinity, high = -infinity;
    add_disc(a, y, std::abs(near), low, high);
    add_disc(b, y, std::abs(near), low, high);
    add_box(a, b, y, std::abs(near), low, high);
    if (low <= high) at_edge.emplace_back(low, high);
    a = b;
    ++looks_;
  }
  std::ranges::sort(crossings);
  std::ranges::sort(at_edge);
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    double from = crossings[i];
    for (const auto& [low, high] : at_edge) {
      if (near >= 0.0 || low > crossings[i + 1]) break;
      if (low > from) close(from, low);
      from = std::max(from, high);
    }
    if (from < crossings[i + 1]) close(from, crossings[i + 1]);
  }
  if (near < 0.0) return;
  for (const auto& [low, high] : at_edge) close(low, high);
}

const OpenRows::Row& OpenRows::row(std::int32_t y) {
  const auto [found, is_new] = known_.try_emplace(y);
  Row& runs = found->second;
  if (!is_new) return runs;
  closed_.clear();
  const double height = box_.y_min + (y + 0.5) * side_;
  close_near_sides(height);
  close_near_map(height);
  for (const ClosedArea& area : areas_) close_area(area, height);
  std::sort(closed_.begin(), closed_.end(),
            [](const Run& a, const Run& b) { return a.begin < b.begin; });
  std::int32_t begin = 0;
  for (const Run& closed : closed_) {
    if (closed.begin > begin) runs.push_back({begin, closed.begin});
    begin = std::max(begin, closed.end);
  }
  if (begin < columns_) runs.push_back({begin, columns_});
  return runs;
}

}  // namespace vandplan::search
