// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/rig_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/parallel.h"
#include "base/text.h"
#include "vandplan/input_error.h"
#include "vandplan/rig_steering.h"

namespace vandplan {
namespace {

constexpr double pi = std::numbers::pi;

// The largest stored hitch angle, as a share of the limit: half of it is stored below a quarter of
// that, where most states of a drive are.
constexpr double widest = 0.8;

void require(bool holds, const char* where, double value, const char* expected) {
  if (holds) return;
  throw InputError(where,
                   "is " + base::shortest_text(value) + ", expected " + std::string(expected));
}

void check(const RigTableOptions& options) {
  require(options.reach >= 1e-3 && options.reach <= 1e6, "reach", options.reach,
          "0.001 to 1000000 m");
  require(options.cells >= 1 && options.cells <= 100, "cells", options.cells, "1 to 100");
  require(options.headings >= 1 && options.headings <= 360, "headings", options.headings,
          "1 to 360");
  const int angles = options.hitch_angles;
  require(angles >= 1 && angles <= 25 && angles % 2 == 1, "hitch_angles", angles,
          "an odd number, 1 to 25");
}

}  // namespace

RigTable::RigTable(const Vehicle& vehicle, const RigTableOptions& options, int threads)
    : options_(options), most_hitch_angle_(widest * vehicle.max_hitch_angle) {
  check(options);
  const RigSteering steering(vehicle);
  const double reach = options_.reach;
  const int cells = options_.cells;
  const int headings = options_.headings;
  const int angles = options_.hitch_angles;
  const double side = reach / cells;
  entries_.resize(static_cast<std::size_t>(2 * cells) * static_cast<std::size_t>(cells) *
                  static_cast<std::size_t>(headings) * static_cast<std::size_t>(angles * angles));
  const auto fill = [&](int x, int y, int heading) {
    const Pose pose{side * (x + 0.5) - reach, side * (y + 0.5), heading * (2 * pi / headings)};
    for (int first = 0; first < angles; ++first) {
      for (int last = 0; last < angles; ++last) {
        const auto piece = steering.steer({{}, hitch_angle(first)}, {pose, hitch_angle(last)});
        entries_[index_of({x, y, heading, first, last})] =
            piece ? static_cast<float>(piece->length) : std::numeric_limits<float>::infinity();
      }
    }
  };
  parallel_for(static_cast<std::size_t>(2 * cells), threads, [&](std::size_t x) {
    for (int y = 0; y < cells; ++y) {
      for (int heading = 0; heading < headings; ++heading) fill(static_cast<int>(x), y, heading);
    }
  });
}

std::size_t RigTable::index_of(const Cell& cell) const noexcept {
  const auto& [reach, cells, headings, angles] = options_;
  const int row = (cell.x * cells + cell.y) * headings + cell.heading;
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(angles * angles) +
         static_cast<std::size_t>(cell.first * angles + cell.last);
}

double RigTable::hitch_angle(int index) const noexcept {
  const int half = options_.hitch_angles / 2;
  if (half == 0) return 0.0;
  const double share = static_cast<double>(index - half) / half;
  return most_hitch_angle_ * share * std::abs(share);
}

int RigTable::hitch_index(double angle) const noexcept {
  int best = 0;
  for (int i = 1; i < options_.hitch_angles; ++i) {
    if (std::abs(hitch_angle(i) - angle) < std::abs(hitch_angle(best) - angle)) best = i;
  }
  return best;
}

double RigTable::distance(const RigState& from, const RigState& to) const noexcept {
  const double reach = options_.reach;
  const int cells = options_.cells;
  const int headings = options_.headings;
  auto [x, y, heading] = relative(from.pose, to.pose);
  const double side_of_mirror = y < 0.0 ? -1.0 : 1.0;
  y *= side_of_mirror;
  heading *= side_of_mirror;
  const double far = std::max(std::abs(x), y);
  const double share = far > reach ? reach / far : 1.0;
  const double beyond = (1.0 - share) * std::sqrt(x * x + y * y);
  const auto cell_of = [&](double place, int count) {
    return std::clamp(static_cast<int>(std::floor(place * cells / reach)), 0, count - 1);
  };
  const int turn = static_cast<int>(std::lround(heading * headings / (2 * pi)));
  const Cell cell{cell_of(share * x + reach, 2 * cells), cell_of(share * y, cells),
                  (turn % headings + headings) % headings,
                  hitch_index(side_of_mirror * from.hitch_angle),
                  hitch_index(side_of_mirror * to.hitch_angle)};
  return beyond + static_cast<double>(entries_[index_of(cell)]);
}

}  // namespace vandplan
