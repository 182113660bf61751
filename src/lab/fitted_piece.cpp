// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Which exact piece fits sampled poses? docs/algorithms/lattice.md, "Files of others".

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/trigonometry.h"
#include "geometry/convex.h"
#include "vandplan/graphs.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan::search {
namespace {

constexpr double no_fit = std::numeric_limits<double>::infinity();  // Deviation without a fit.
constexpr double closing = 1e-10;          // Largest error of a piece's end [m, rad].
constexpr int places = 64;                 // Intervals of a piece that poses are compared with.
constexpr int radii = 48;                  // Number of radii tried first.
constexpr int refinements = 40;            // Steps that refine the best radius.
constexpr double heading_rounding = 2e-4;  // Largest error of a heading in a file [rad].
constexpr int largest_direction = 8;       // Largest coordinate of a direction of the grid.

/// Largest distance of the poses from a piece [m].
double deviation(const Pose& begin, const Piece& piece, std::span<const Pose> poses) {
  const Path path{begin, {piece.view().begin(), piece.view().end()}};
  std::vector<Point> line;
  for (int i = 0; i <= places; ++i) {
    const Pose pose = pose_at(path, piece.length * i / places);
    line.push_back({pose.x, pose.y});
  }
  double most = 0.0;
  for (const Pose& pose : poses) {
    double least = no_fit;
    for (std::size_t i = 1; i < line.size(); ++i) {
      least = std::min(least,
                       geometry::squared_distance_to_side({pose.x, pose.y}, line[i - 1], line[i]));
    }
    most = std::max(most, least);
  }
  return std::sqrt(most);
}

void append(Piece& piece, double curvature, double length) {
  if (length <= closing) return;
  piece.segments[piece.count++] = {curvature, length};
  piece.length += length;
}

bool ends_at(const Pose& begin, const Piece& piece, const Pose& end) {
  const Pose last = end_of(begin, piece);
  return piece.count > 0 && std::hypot(last.x - end.x, last.y - end.y) <= closing &&
         std::abs(wrap_angle(last.heading - end.heading)) <= closing;
}

/// A line, an arc of this radius and a line, driven forward. Empty if a line would be driven
/// backwards.
std::optional<Piece> arc_between_lines(const Pose& begin, const Pose& end, double radius) {
  const double turn = wrap_angle(end.heading - begin.heading);
  const auto [sin_a, cos_a] = base::sin_cos(begin.heading);
  const auto [sin_b, cos_b] = base::sin_cos(end.heading);
  const double cross = cos_a * sin_b - sin_a * cos_b;
  if (std::abs(cross) < 1e-6) return std::nullopt;
  const double signed_radius = std::copysign(radius, turn);
  // Displacement left to the two lines.
  const double x = end.x - begin.x - signed_radius * (sin_b - sin_a);
  const double y = end.y - begin.y - signed_radius * (cos_a - cos_b);
  const double first = (x * sin_b - y * cos_b) / cross;
  const double last = (y * cos_a - x * sin_a) / cross;
  if (first < -closing || last < -closing) return std::nullopt;
  Piece piece;
  append(piece, 0.0, first);
  append(piece, 1 / signed_radius, std::abs(turn) * radius);
  append(piece, 0.0, last);
  return piece;
}

/// Straight line between two poses that have one heading.
std::optional<Piece> line(const Pose& begin, const Pose& end) {
  Piece piece;
  append(piece, 0.0, std::hypot(end.x - begin.x, end.y - begin.y));
  return piece;
}

/// Piece with the least deviation from poses, among pieces that radii give.
class Fit {
 public:
  Fit(const Pose& begin, const Pose& end, std::span<const Pose> poses)
      : begin_(begin), end_(end), poses_(poses) {}

  double offer(const std::optional<Piece>& piece) {
    if (!piece || !ends_at(begin_, *piece, end_)) return no_fit;
    const double off = deviation(begin_, *piece, poses_);
    if (off < least_) {
      least_ = off;
      best_ = *piece;
    }
    return off;
  }

  /// Tries radii from `low` to `high`, then refines the best one.
  template <typename Make>
  void search(double low, double high, Make make) {
    const double ratio = std::pow(high / low, 1.0 / (radii - 1));
    double best_radius = low;
    double least = no_fit;
    for (int i = 0; i < radii; ++i) {
      const double radius = low * std::pow(ratio, i);
      const double off = offer(make(radius));
      if (off >= least) continue;
      least = off;
      best_radius = radius;
    }
    double a = best_radius / ratio;
    double b = best_radius * ratio;
    for (int i = 0; i < refinements && least < no_fit; ++i) {
      const double third = (b - a) / 3;
      if (offer(make(a + third)) <= offer(make(b - third))) {
        b -= third;
      } else {
        a += third;
      }
    }
  }

  [[nodiscard]] double least() const { return least_; }
  [[nodiscard]] const Piece& best() const { return best_; }

 private:
  const Pose& begin_;
  const Pose& end_;
  std::span<const Pose> poses_;
  double least_ = no_fit;
  Piece best_;
};

/// Gear of a sequence of poses: 1 forward, -1 reverse, 0 if it changes.
GearSign gear_of_poses(std::span<const Pose> poses) {
  GearSign gear = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const auto [sin, cos] = base::sin_cos(poses[i - 1].heading);
    const double ahead = (poses[i].x - poses[i - 1].x) * cos + (poses[i].y - poses[i - 1].y) * sin;
    const GearSign sign = ahead > 0.0 ? 1 : ahead < 0.0 ? -1 : 0;
    if (sign == 0) continue;
    if (sign == -gear) return 0;
    gear = sign;
  }
  return gear;
}

std::optional<Piece> fitted_forward(const Pose& begin, const Pose& end, std::span<const Pose> poses,
                                    double tolerance) {
  const double chord = std::hypot(end.x - begin.x, end.y - begin.y);
  Fit fit(begin, end, poses);
  fit.offer(line(begin, end));
  const double turn = std::abs(wrap_angle(end.heading - begin.heading));
  if (turn > 1e-6) {
    // Largest radius that leaves no line after the arc, or slightly more.
    const double largest = 2 * chord / std::max(turn, 0.01);
    fit.search(chord / 100, largest,
               [&](double radius) { return arc_between_lines(begin, end, radius); });
  }
  if (fit.least() > tolerance) {
    fit.search(chord / 20, 50 * chord,
               [&](double radius) { return std::optional<Piece>(dubins(begin, end, radius)); });
  }
  return fit.least() <= tolerance ? std::optional<Piece>(fit.best()) : std::nullopt;
}

}  // namespace

std::optional<Piece> fitted_piece(const Pose& begin, const Pose& end, std::span<const Pose> poses,
                                  double tolerance) {
  const GearSign gear = gear_of_poses(poses);
  if (gear == 0 || std::hypot(end.x - begin.x, end.y - begin.y) <= closing) return std::nullopt;
  if (gear > 0) return fitted_forward(begin, end, poses, tolerance);
  const std::optional<Piece> back = fitted_forward(end, begin, poses, tolerance);
  return back ? std::optional<Piece>(reversed(*back)) : std::nullopt;
}

std::optional<double> exact_heading(double heading, int count) {
  const auto is_near = [&](double exact) {
    return std::abs(wrap_angle(heading - exact)) <= heading_rounding;
  };
  const double turn = 2 * std::numbers::pi / count;
  const double multiple = wrap_angle(std::round(heading / turn) * turn);
  std::optional<double> best;
  for (int x = -largest_direction; x <= largest_direction; ++x) {
    for (int y = -largest_direction; y <= largest_direction; ++y) {
      if (x == 0 && y == 0) continue;
      const double exact = base::atan_2(y, x);
      if (!is_near(exact)) continue;
      const double off = std::abs(wrap_angle(heading - exact));
      if (!best || off < std::abs(wrap_angle(heading - *best))) best = exact;
    }
  }
  if (best) return best;
  return is_near(multiple) ? std::optional<double>(multiple) : std::nullopt;
}

}  // namespace vandplan::search
