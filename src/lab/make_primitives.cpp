// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Which primitives does a lattice need? docs/algorithms/lattice.md, "Primitives".

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>

#include "base/trigonometry.h"
#include "vandplan/graphs.h"
#include "vandplan/input_error.h"
#include "vandplan/steering.h"

namespace vandplan::search {
namespace {

/// Direction of the grid: coordinates without a common divisor.
struct Direction {
  std::int32_t x, y;
  bool operator==(const Direction&) const = default;
};

/// Ends of a primitive for radius 1, driven forward: headings by index, displacement in steps.
struct Ends {
  std::int32_t from, to;
  std::int32_t dx, dy;
  double length;
};

std::vector<Direction> directions_of(std::int32_t largest) {
  std::vector<Direction> all;
  for (std::int32_t x = -largest; x <= largest; ++x) {
    for (std::int32_t y = -largest; y <= largest; ++y) {
      if (std::gcd(x, y) == 1) all.push_back({x, y});
    }
  }
  // Angle from 0 to 2 pi, so that index 0 is along the x axis.
  const auto angle = [](const Direction& d) {
    const double signed_angle = base::atan_2(d.y, d.x);
    return d.y < 0 ? signed_angle + 7.0 : signed_angle;
  };
  std::ranges::sort(all, {}, angle);
  return all;
}

/// Image of a vector under one of the eight symmetries of the grid.
Direction image_of(Direction d, int symmetry) {
  if ((symmetry & 1) != 0) d.y = -d.y;
  for (int turns = symmetry >> 1; turns > 0; --turns) d = {-d.y, d.x};
  return d;
}

/// Chooses primitives for radius 1.
class Chooser {
 public:
  explicit Chooser(const PrimitiveOptions& options)
      : step_(1.0 / options.steps_per_radius),
        longest_(options.longest),
        detour_(options.detour),
        directions_(directions_of(options.largest_coordinate)),
        reach_(static_cast<std::int32_t>(options.longest * options.steps_per_radius)),
        into_(directions_.size()) {}

  [[nodiscard]] std::vector<Ends> chosen();
  [[nodiscard]] double angle(std::int32_t heading) const {
    const Direction& d = directions_[static_cast<std::size_t>(heading)];
    return base::atan_2(d.y, d.x);
  }
  [[nodiscard]] std::int32_t headings() const {
    return static_cast<std::int32_t>(directions_.size());
  }

 private:
  [[nodiscard]] std::vector<Ends> candidates() const;
  [[nodiscard]] std::int32_t index_of(const Direction& d) const;
  [[nodiscard]] bool is_first_octant(std::int32_t heading) const {
    const Direction& d = directions_[static_cast<std::size_t>(heading)];
    return d.y >= 0 && d.x >= d.y;
  }
  [[nodiscard]] double& known(std::int32_t from, std::int32_t dx, std::int32_t dy, std::int32_t to);
  [[nodiscard]] double by_shorter_ones(const Ends& ends);
  void keep_images(const Ends& ends);
  void keep(const Ends& ends);

  double step_;
  double longest_;
  double detour_;
  std::vector<Direction> directions_;
  std::int32_t reach_;         // Reach of a primitive [steps].
  std::vector<double> known_;  // Length of the way from a heading at the origin to a vertex.
  std::vector<std::vector<Ends>> into_;  // Chosen primitives, by the heading at their end.
};

std::int32_t Chooser::index_of(const Direction& d) const {
  return static_cast<std::int32_t>(std::ranges::find(directions_, d) - directions_.begin());
}

double& Chooser::known(std::int32_t from, std::int32_t dx, std::int32_t dy, std::int32_t to) {
  const std::int32_t side = 2 * reach_ + 1;
  const std::int32_t place = ((from * side + dx + reach_) * side + dy + reach_) * headings() + to;
  return known_[static_cast<std::size_t>(place)];
}

// Primitives that begin with a heading of the first octant, shortest first. All others are images
// of these.
std::vector<Ends> Chooser::candidates() const {
  std::vector<Ends> all;
  const auto add_all_to = [&](std::int32_t from, std::int32_t dx, std::int32_t dy) {
    for (std::int32_t to = 0; to < headings(); ++to) {
      const Pose end{dx * step_, dy * step_, angle(to)};
      const double length = dubins_length({0.0, 0.0, angle(from)}, end, 1.0);
      if (length <= longest_) all.push_back({from, to, dx, dy, length});
    }
  };
  for (std::int32_t from = 0; is_first_octant(from); ++from) {
    for (std::int32_t dx = -reach_; dx <= reach_; ++dx) {
      for (std::int32_t dy = -reach_; dy <= reach_; ++dy) {
        if (dx == 0 && dy == 0) continue;
        if (std::hypot(dx, dy) * step_ <= longest_) add_all_to(from, dx, dy);
      }
    }
  }
  std::ranges::sort(all, [](const Ends& a, const Ends& b) {
    return std::tie(a.length, a.from, a.dx, a.dy, a.to) <
           std::tie(b.length, b.from, b.dx, b.dy, b.to);
  });
  return all;
}

// Length of the shortest way made of a known way and a chosen primitive.
double Chooser::by_shorter_ones(const Ends& ends) {
  double least = std::numeric_limits<double>::infinity();
  for (const Ends& last : into_[static_cast<std::size_t>(ends.to)]) {
    const std::int32_t dx = ends.dx - last.dx;
    const std::int32_t dy = ends.dy - last.dy;
    if (std::max(std::abs(dx), std::abs(dy)) > reach_) continue;
    least = std::min(least, known(ends.from, dx, dy, last.from) + last.length);
  }
  return least;
}

void Chooser::keep(const Ends& ends) {
  std::vector<Ends>& into = into_[static_cast<std::size_t>(ends.to)];
  const bool is_there = std::ranges::any_of(into, [&](const Ends& other) {
    return other.from == ends.from && other.dx == ends.dx && other.dy == ends.dy;
  });
  if (!is_there) into.push_back(ends);
}

// Keeps a primitive with its images: all eight symmetries of the grid, and each from end to begin
// with reversed headings.
void Chooser::keep_images(const Ends& ends) {
  for (int symmetry = 0; symmetry < 8; ++symmetry) {
    const Direction a = image_of(directions_[static_cast<std::size_t>(ends.from)], symmetry);
    const Direction b = image_of(directions_[static_cast<std::size_t>(ends.to)], symmetry);
    const Direction d = image_of({ends.dx, ends.dy}, symmetry);
    keep({index_of(a), index_of(b), d.x, d.y, ends.length});
    keep({index_of({-b.x, -b.y}), index_of({-a.x, -a.y}), -d.x, -d.y, ends.length});
  }
}

std::vector<Ends> Chooser::chosen() {
  const auto side = static_cast<std::size_t>(2 * reach_ + 1);
  std::size_t octant = 0;
  while (is_first_octant(static_cast<std::int32_t>(octant))) ++octant;
  known_.assign(octant * side * side * directions_.size(), std::numeric_limits<double>::infinity());
  for (std::int32_t from = 0; is_first_octant(from); ++from) known(from, 0, 0, from) = 0.0;
  constexpr double rounding_of_ways = 1e-9;
  for (const Ends& ends : candidates()) {
    double& way = known(ends.from, ends.dx, ends.dy, ends.to);
    way = by_shorter_ones(ends);
    if (way <= detour_ * ends.length + rounding_of_ways) continue;
    way = ends.length;
    keep_images(ends);
  }
  std::vector<Ends> all;
  for (const std::vector<Ends>& into : into_) all.insert(all.end(), into.begin(), into.end());
  return all;
}

void check(double radius, const PrimitiveOptions& options) {
  const auto expect = [](bool holds, const char* name, const char* range) {
    if (!holds) throw InputError(name, std::string("is out of range, expected ") + range);
  };
  expect(radius > 0.0 && std::isfinite(radius), "radius", "more than 0 m");
  expect(options.steps_per_radius >= 1 && options.steps_per_radius <= 32, "steps_per_radius",
         "1 to 32");
  expect(options.largest_coordinate >= 1 && options.largest_coordinate <= 5, "largest_coordinate",
         "1 to 5");
  expect(options.longest >= 0.5 && options.longest <= 4.0, "longest", "0.5 to 4");
  expect(options.detour >= 1.0 && options.detour <= 2.0, "detour", "1 to 2");
}

}  // namespace

std::shared_ptr<const Primitives> make_primitives(double radius, const PrimitiveOptions& options) {
  check(radius, options);
  Chooser chooser(options);
  const double step = radius / options.steps_per_radius;
  std::vector<double> headings;
  headings.reserve(static_cast<std::size_t>(chooser.headings()));
  for (std::int32_t i = 0; i < chooser.headings(); ++i) headings.push_back(chooser.angle(i));
  std::vector<Primitive> all;
  for (const Ends& ends : chooser.chosen()) {
    const Pose begin{0.0, 0.0, chooser.angle(ends.from)};
    const Pose end{ends.dx * step, ends.dy * step, chooser.angle(ends.to)};
    const Piece piece = dubins(begin, end, radius);
    all.push_back({ends.from, ends.to, ends.dx, ends.dy, piece});
    all.push_back({ends.to, ends.from, -ends.dx, -ends.dy, reversed(piece)});
  }
  return std::make_shared<const Primitives>(step, std::move(headings), std::move(all));
}

}  // namespace vandplan::search
