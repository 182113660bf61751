// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a costmap of ROS say about the ground, and what of it has changed?

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "vandplan/collision.h"
#include "vandplan/geometry.h"

namespace vandplan::ros {

/// Cost of a cell about which nothing is known: Nav2's 255, and -1 in an OccupancyGrid.
inline constexpr std::uint8_t unknown_cost = 255;
/// Cost of an obstacle in Nav2. Cells whose centre is too near to one for any heading have 253.
inline constexpr std::uint8_t nav2_lethal_cost = 254;

/// A costmap that somebody else owns: Nav2's costs, or the bytes of an OccupancyGrid.
struct Costmap {
  /// All costs, row by row: columns * rows of them. Cell (column, row) has the index
  /// row * columns + column.
  std::span<const std::uint8_t> costs = {};
  std::int32_t columns = 0;  ///< number of columns
  std::int32_t rows = 0;     ///< number of rows
  double resolution = 0.0;   ///< side of a cell [m]
  /// Corner of cell (0, 0) [m] and direction of the rows [rad], in the frame in which one plans.
  Pose origin = {};
};

/// Highest graded cost in Nav2, where an obstacle is as near as it may be for one heading at least.
inline constexpr int nav2_highest_cost = 252;

/// Which costs are obstacles for the body, and how much the others cost.
struct CostRule {
  int lethal_cost = nav2_lethal_cost;  ///< least cost of an obstacle; 1 to 254
  bool allow_unknown = true;  ///< whether unknown cells are free; ground outside the map never is
  /// Price of a metre with the midpoint of the rear axle in a cell of the highest graded cost, on
  /// top of its length; in proportion below, in whole percents. That cost is 252 in Nav2, or the
  /// one below `lethal_cost`. 0 to 999; 0: costs have no price. Unknown cells never have one.
  double cost_penalty = 2.0;
  bool operator==(const CostRule&) const = default;
};

/// What the planner knows of a cell with that cost.
[[nodiscard]] Cell cell_of(std::uint8_t cost, const CostRule& rule) noexcept;

/// The cells of a costmap in a range of it, row by row.
[[nodiscard]] std::vector<Cell> cells_of(const Costmap& costmap, const CostRule& rule,
                                         const CellRange& range);

/// The percentages of a mask of costs in a range of a costmap, row by row.
[[nodiscard]] std::vector<std::uint8_t> percents_of(const Costmap& costmap, const CostRule& rule,
                                                    const CellRange& range);

/// The map of a whole costmap, and a mask of its graded costs if they have a price.
[[nodiscard]] Surroundings ground_of(const Costmap& costmap, const CostRule& rule);

/// Keeps a copy of the last costmap, and knows where it differs from the one before.
class KnownCostmap {
 public:
  /// Takes a costmap: compares it with the copy, and copies what differs. That takes about a
  /// millisecond for 2000 x 2000 cells, so the costmap's owner waits no longer. Throws InputError
  /// naming "costmap" if the number of costs is wrong, or as `check_map`; the copy then stays.
  void take(const Costmap& costmap);

  /// The copy; it is empty before the first `take`.
  [[nodiscard]] Costmap now() const noexcept;

  /// Disjoint ranges that hold every cost that has changed since the last call, in tiles of 64 x 64
  /// cells. None: size, resolution or origin are others, or this is the first call.
  [[nodiscard]] std::optional<std::vector<CellRange>> changes();

 private:
  void start_anew(const Costmap& costmap);

  std::vector<std::uint8_t> costs_;
  Costmap shape_;               // without costs
  std::vector<bool> is_dirty_;  // tiles with changes, row by row
  std::int32_t tile_columns_ = 0;
  bool is_new_ = true;
};

}  // namespace vandplan::ros
