// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "tables/rig_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "base/parallel.h"
#include "base/require.h"
#include "base/trigonometry.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

// Largest stored hitch angle, as a share of the limit. Stored angles grow quadratically: half of
// them lie below a quarter of the largest, where most states of a drive are.
constexpr double widest = 0.8;

void check(const RigTableOptions& options) {
  base::require(options.reach >= 1e-3 && options.reach <= 1e6, "reach", options.reach,
                "0.001 to 1000000 m");
  base::require(options.cells >= 1 && options.cells <= 100, "cells", options.cells, "1 to 100");
  base::require(options.headings >= 1 && options.headings <= 360, "headings", options.headings,
                "1 to 360");
  const int angles = options.hitch_angles;
  base::require(angles >= 1 && angles <= 25 && angles % 2 == 1, "hitch_angles", angles,
                "an odd number, 1 to 25");
}

std::uint16_t counted(const std::optional<Piece>& piece, double unit) {
  if (!piece) return RigTable::none;
  return static_cast<std::uint16_t>(
      std::min(std::round(piece->length / unit), double{RigTable::none}));
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
  std::vector<std::uint16_t> lengths(
      static_cast<std::size_t>(2 * cells) * static_cast<std::size_t>(cells) *
      static_cast<std::size_t>(headings) * static_cast<std::size_t>(angles * angles));
  const auto fill = [&](int x, int y, int heading) {
    const Pose pose{side * (x + 0.5) - reach, side * (y + 0.5),
                    heading * (2 * std::numbers::pi / headings)};
    for (int first = 0; first < angles; ++first) {
      for (int last = 0; last < angles; ++last) {
        const auto piece = steering.steer({{}, hitch_angle(first)}, {pose, hitch_angle(last)});
        lengths[index_of({x, y, heading, first, last})] = counted(piece, unit_);
      }
    }
  };
  parallel_for(static_cast<std::size_t>(2 * cells), threads, [&](std::size_t x) {
    for (int y = 0; y < cells; ++y) {
      for (int heading = 0; heading < headings; ++heading) fill(static_cast<int>(x), y, heading);
    }
  });
  storage_ = std::make_shared<const std::vector<std::uint16_t>>(std::move(lengths));
  entries_ = *storage_;
}

RigTable::RigTable(double max_hitch_angle, std::span<const std::uint16_t> entries) noexcept
    : most_hitch_angle_(widest * max_hitch_angle), entries_(entries) {}

RigTable RigTable::scaled(double factor) const {
  base::require(factor > 0.0 && std::isfinite(factor), "factor", factor, "more than 0");
  RigTable result = *this;
  result.options_.reach *= factor;
  result.unit_ *= factor;
  return result;
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

RigTable::Place RigTable::place_of(const State& state) const noexcept {
  const auto [sin, cos] = base::sin_cos(state.pose.heading);
  return {state.pose, sin, cos, hitch_index(state.hitch_angle)};
}

double RigTable::distance(const State& from, const State& to) const noexcept {
  return look_up(place_of(from), place_of(to));
}

double RigTable::look_up(const Place& from, const Place& to) const noexcept {
  const double reach = options_.reach;
  const int cells = options_.cells;
  const int headings = options_.headings;
  const double dx = to.pose.x - from.pose.x;
  const double dy = to.pose.y - from.pose.y;
  const double x = dx * from.cos + dy * from.sin;
  const double left = dy * from.cos - dx * from.sin;
  const bool is_mirrored = left < 0.0;
  const double y = std::abs(left);
  const double turn = wrap_angle(to.pose.heading - from.pose.heading);
  const double far = std::max(std::abs(x), y);
  const double share = far > reach ? reach / far : 1.0;
  const double beyond = far > reach ? (1.0 - share) * std::sqrt(x * x + y * y) : 0.0;
  const double per_metre = cells / reach;
  // Heading in steps of the table, 0 to `headings`; both ends are the same heading.
  const double steps = (is_mirrored ? -turn : turn) * (headings / (2 * std::numbers::pi));
  const int heading = static_cast<int>(steps < 0.0 ? steps + headings + 0.5 : steps + 0.5);
  const int last_angle = options_.hitch_angles - 1;
  const auto mirrored = [&](int angle) { return is_mirrored ? last_angle - angle : angle; };
  const Cell cell{std::min(static_cast<int>((share * x + reach) * per_metre), 2 * cells - 1),
                  std::min(static_cast<int>(share * y * per_metre), cells - 1),
                  heading == headings ? 0 : heading, mirrored(from.hitch_angle),
                  mirrored(to.hitch_angle)};
  const std::uint16_t entry = entries_[index_of(cell)];
  if (entry == none) return std::numeric_limits<double>::infinity();
  return beyond + unit_ * entry;
}

}  // namespace vandplan
