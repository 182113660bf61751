// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/mask_look.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vandplan::judge {
namespace {

constexpr Real at_line = 1e-6;  // distance from another cell at which it may count [m]
// Part of which only the ends are looked at: so short that its price does not matter [m].
constexpr Real longest_part_unseen = 1e-3, price_of_part_unseen = 2e-3;
constexpr int halvings_of_part = 50;
constexpr std::int64_t most_cells = 4;  // cells along a side of a box that are looked at, at once

}  // namespace

MaskLook::MaskLook(const Mask& mask, const Track& track, AtEdge at_edge)
    : mask_(mask), track_(track), at_edge_(at_edge), last_part_(longest_part_unseen) {
  if (mask.use != MaskUse::cost || mask.multiplier == 0) return;
  const Real dearest = 100 * std::abs(static_cast<Real>(mask.multiplier));
  last_part_ = std::clamp<Real>(price_of_part_unseen / dearest, 1e-6, longest_part_unseen);
}

bool is_graded(const Mask& mask) { return mask.use != MaskUse::obstacles; }

/// Factor or largest speed of a cell; neutral outside of the map.
Real MaskLook::value_of(std::int64_t column, std::int64_t row) const {
  const bool is_cost = mask_.use == MaskUse::cost;
  const Real neutral = is_cost ? 1 : std::numeric_limits<Real>::infinity();
  if (column < 0 || row < 0 || column >= mask_.map.columns || row >= mask_.map.rows) return neutral;
  const auto index = static_cast<std::size_t>(row * mask_.map.columns + column);
  int percent = Mask::unknown;
  if (mask_.percents) {
    percent = (*mask_.percents)[index];
  } else if ((*mask_.map.cells)[index] != Cell::unknown) {
    percent = (*mask_.map.cells)[index] == Cell::occupied ? 100 : 0;
  }
  if (percent == Mask::unknown || (percent == 0 && !is_cost)) return neutral;
  return mask_.base + static_cast<Real>(mask_.multiplier) * percent;
}

/// Values of all cells within a distance of a place; all there may be if they are many.
MaskLook::Values MaskLook::around(const Place& place, Real distance) const {
  const Position axle = after(track_.stretches[place.stretch], place.t);
  const Pose& origin = mask_.map.origin;
  const Real cosine = std::cos(static_cast<Real>(origin.heading));
  const Real sine = std::sin(static_cast<Real>(origin.heading));
  const Real side = mask_.map.resolution;
  const Real dx = axle.x - origin.x, dy = axle.y - origin.y;
  const Real along = (cosine * dx + sine * dy) / side, across = (cosine * dy - sine * dx) / side;
  const Real far = distance / side;
  constexpr Real endless = std::numeric_limits<Real>::infinity();
  Values values{endless, -endless};
  if (along + far < 0 || across + far < 0 || along - far > mask_.map.columns ||
      across - far > mask_.map.rows) {
    const Real outside = value_of(-1, -1);
    return {outside, outside};
  }
  if (2 * far > most_cells) return {-endless, endless};
  const auto cell = [](Real at) { return static_cast<std::int64_t>(std::floor(at)); };
  for (std::int64_t row = cell(across - far); row <= cell(across + far); ++row) {
    for (std::int64_t column = cell(along - far); column <= cell(along + far); ++column) {
      const Real value = value_of(column, row);
      values = {std::min(values.least, value), std::max(values.most, value)};
    }
  }
  return values;
}

/// The value that counts at a place.
Real MaskLook::at(const Place& place) const {
  const auto [least, most] = around(place, at_line);
  const bool takes_most = (mask_.use == MaskUse::cost) == (at_edge_ == AtEdge::inside);
  return takes_most ? most : least;
}

void MaskLook::add_changes(std::size_t stretch, Real begin, Real end,
                           std::vector<Real>& places) const {
  const Real middle = (begin + end) / 2;
  const auto [least, most] = around({stretch, middle}, (end - begin) / 2 + at_line);
  if (least == most) return;
  if (end - begin > last_part_) {
    add_changes(stretch, begin, middle, places);
    add_changes(stretch, middle, end, places);
    return;
  }
  const Real first = at({stretch, begin});
  if (first == at({stretch, end})) return;
  for (int i = 0; i < halvings_of_part; ++i) {
    const Real half = (begin + end) / 2;
    (at({stretch, half}) == first ? begin : end) = half;
  }
  places.push_back(end);
}

void MaskLook::apply_to(PricedPart& part, const Place& place) const {
  const Real value = at(place);
  if (mask_.use == MaskUse::cost) {
    part.factor *= value;
  } else {
    part.max_speed = std::min(part.max_speed, value);
  }
}

}  // namespace vandplan::judge
