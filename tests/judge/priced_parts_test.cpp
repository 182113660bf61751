// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What a metre costs, and how fast it may be driven, where a path leads along the line between two
// cells of a mask.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "judge/track.h"
#include "judge/zone_prices.h"
#include "support/grids.h"
#include "vandplan/collision.h"

namespace vandplan {
namespace {

/// The only part of a path along y = 0, where a mask has 50 % on the left and nothing on the right.
judge::PricedPart part_along_a_line(const Mask& mask, judge::AtEdge at_edge) {
  const judge::Track track = judge::integrate(Path{{1, 0, 0}, {{0, 8}}});
  const std::vector<judge::PricedPart> parts =
      judge::priced_parts(Surroundings{.masks = {mask}}, Vehicle{}, track, nullptr, at_edge);
  EXPECT_EQ(parts.size(), 1U);
  return parts.empty() ? judge::PricedPart{} : parts[0];
}

Mask with_halves(Mask mask) {
  mask.percents =
      std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{0, 50});
  return mask;
}

TEST(PricedParts, TakeTheDearerCellAtItsLineWhereThatCountsAsInside) {
  const Mask mask = with_halves(cost_mask(grid_of({".", "."}, 10, {0, -10, 0}), 4));
  EXPECT_NEAR(static_cast<double>(part_along_a_line(mask, judge::AtEdge::inside).factor),
              mask.base + 50 * mask.multiplier, 1e-12);
  EXPECT_NEAR(static_cast<double>(part_along_a_line(mask, judge::AtEdge::outside).factor),
              mask.base, 1e-12);
}

TEST(PricedParts, TakeTheSlowerCellAtItsLineWhereThatCountsAsInside) {
  const Mask mask = with_halves(speed_mask(grid_of({".", "."}, 10, {0, -10, 0}), 4));
  EXPECT_NEAR(static_cast<double>(part_along_a_line(mask, judge::AtEdge::inside).max_speed),
              mask.base + 50 * mask.multiplier, 1e-12);
  EXPECT_EQ(part_along_a_line(mask, judge::AtEdge::outside).max_speed,
            std::numeric_limits<judge::Real>::infinity());
}

}  // namespace
}  // namespace vandplan
