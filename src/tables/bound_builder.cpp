// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "tables/bound_builder.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

#include "tables/excess.h"

namespace vandplan::tables {
namespace {

constexpr double unit = simd::bound_unit;
// Largest distance of the excess from the cell's plane in a box [turning radii]. A box with more is
// cut in eight.
constexpr double good_spread = 0.003;
constexpr int most_cuts = 2;

using Numbers = std::array<double, 3>;

/// Cube within a cell; the cell's coordinates run from 0 to 1.
struct CellCube {
  Numbers corner;
  double size;
};

/// Bounds on the excess (length - distance) without slopes. The upper bound holds for poses that
/// nearly agree: turn on the spot, then move along and across the heading, across in an S and
/// straight back.
Interval coarse_excess(const PairBox& box) {
  const double distance = distance_at(box.radial.high);
  if (distance > 1.0) return {0.0, infinity};
  return {0.0, box.turn.high * std::numbers::pi + 4 * twice_arc_sine(std::sqrt(distance) / 2)};
}

/// Cell of the table for which planes are computed.
class BoundCell {
 public:
  BoundCell(int radial, int side, int turn)
      : size_{1.0 / simd::radial_cells, 1.0 / simd::side_cells, 1.0 / simd::turn_cells},
        corner_{radial * size_[0], side * size_[1], turn * size_[2]} {}

  /// Slopes of the least-squares plane through the excess at the middles of the cell's eight parts.
  Numbers fitted_slopes() const {
    Numbers slopes{};
    for (int i = 0; i < 8; ++i) {
      const Numbers side{i & 1 ? 0.25 : -0.25, i & 2 ? 0.25 : -0.25, i & 4 ? 0.25 : -0.25};
      Numbers at;
      for (std::size_t k = 0; k < 3; ++k) at[k] = corner_[k] + size_[k] * (0.5 + side[k]);
      const double excess = excess_at(at[0], at[1], at[2]);
      for (std::size_t k = 0; k < 3; ++k) slopes[k] += side[k] * excess * 2;
    }
    return slopes;
  }

  /// Range of the excess (length - distance) minus a plane through the cell's corner, over `part`.
  Interval residual(const Numbers& slopes, const CellCube& part, const WordSet& among,
                    int cuts) const {
    std::array<Interval, 3> range;
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = corner_[k] + size_[k] * part.corner[k];
      range[k] = {low, low + size_[k] * part.size};
    }
    const PairBox box{range[0], range[1], range[2]};
    const Excess excess = excess_over(box, among);
    double plane = 0.0;
    double half = 0.0;    // How far the plane rises from the middle of the part to its border.
    double spread = 0.0;  // Largest change of excess - plane from the middle of the part.
    for (std::size_t k = 0; k < 3; ++k) {
      plane += slopes[k] * (part.corner[k] + part.size / 2);
      half += std::abs(slopes[k]) * part.size / 2;
      const Interval stray = excess.slopes[k] * size_[k] - slopes[k];
      spread += std::max(stray.high, -stray.low) * part.size / 2;
    }
    if ((!excess.bounded || spread > good_spread) && cuts > 0) {
      Interval all{infinity, -infinity};
      for (int i = 0; i < 8; ++i) {
        CellCube child{part.corner, part.size / 2};
        for (std::size_t k = 0; k < 3; ++k) child.corner[k] += i >> k & 1 ? child.size : 0.0;
        all = hull(all, residual(slopes, child, excess.words, cuts - 1));
      }
      return all;
    }
    const Interval coarse = coarse_excess(box) - Interval{plane - half, plane + half};
    const double centre = excess.at_centre - plane;
    return excess.bounded ? meet(coarse, {centre - spread, centre + spread}) : coarse;
  }

 private:
  Numbers size_;
  Numbers corner_;
};

std::uint32_t bits(double value, int count) {
  assert(std::abs(value) < static_cast<double>(1 << (count - 1)));
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(value)) & ((1U << count) - 1U);
}

}  // namespace

simd::BoundEntry bound_entry(int radial, int side, int turn) {
  constexpr Numbers steps{simd::slope_step * unit, simd::slope_step * unit, unit};
  constexpr std::array<int, 3> slope_bits{11, 11, 10};
  const BoundCell cell(radial, side, turn);
  Numbers slopes = cell.fitted_slopes();
  std::array<std::uint32_t, 3> packed;
  for (std::size_t k = 0; k < 3; ++k) {
    const double limit = (1 << (slope_bits[k] - 1)) - 1;
    const double whole = std::clamp(std::nearbyint(slopes[k] / steps[k]), -limit, limit);
    packed[k] = bits(whole, slope_bits[k]);
    slopes[k] = whole * steps[k];
  }
  const Interval residual =
      cell.residual(slopes, {{0.0, 0.0, 0.0}, 1.0}, WordSet().set(), most_cuts);
  const double base = std::floor((residual.low - rounding) / unit);
  const double width = std::ceil((residual.high + rounding) / unit - base);
  assert(width < 0x1p16);
  return {bits(base, 16) << 16 | static_cast<std::uint32_t>(width),
          packed[0] << 21 | packed[1] << 10 | packed[2]};
}

}  // namespace vandplan::tables
