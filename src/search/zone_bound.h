// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do zones and masks add to every path at least? A proof, on lattices.
//
// The midpoint of the rear axle moves from cell to cell across their sides. A cell is closed if a
// rule closes all of it, or if all of it is nearer to an obstacle than the body allows. Some sides
// cannot be crossed in one sense, and a one-way street is not driven against its middle direction.
// A metre in a cell costs what it costs at the cheapest place there. docs/proofs/anytime_bounds.md.

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <queue>
#include <vector>

#include "collision/mask_cells.h"
#include "search/one_way.h"
#include "search/open_rows.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::search {

/// What a metre costs in a proof. All zero: only whether there is a way counts.
struct MetreCost {
  double anywhere = 0.0;  ///< cost of each metre
  double priced = 0.0;    ///< cost of a metre for each 1 that its factor is above 1
  double second = 0.0;    ///< cost of a second that a metre takes longer than at `top_speed`
  double top_speed = std::numeric_limits<double>::infinity();  ///< [m/s]
  /// Distances from start and goal within which seconds do not count: the vehicle gains and loses
  /// speed there [m].
  std::array<double, 2> ramps = {};
};

/// Floods cells from the start, cheapest first. If only the way counts, another flood goes from the
/// goal against the direction of travel. Where a flood arrives, a lattice of half the cell size
/// follows.
class ZoneBound {
 public:
  /// `only`: gear of all paths, 0 for both. `places`: boxes, in one of which paths end; none: the
  /// task's goal. The task must outlive the object.
  ZoneBound(const Task& task, GearSign only, const MetreCost& cost = {},
            const std::vector<Bounds>& places = {});

  /// Does some ten microseconds of work. False when nothing is left to do.
  bool step();

  /// Whether it is proven that no path leads from the start to the goal.
  [[nodiscard]] bool is_proven() const noexcept { return is_proven_; }
  /// Lower bound of the sum of all metres' costs. It only rises.
  [[nodiscard]] double bound() const noexcept { return bound_; }
  /// Number of cells of the lattice that are held in memory: those near what the floods reached.
  [[nodiscard]] std::int64_t held() const noexcept { return held_; }

 private:
  enum End : std::uint8_t { start, goal };
  struct Cell {
    float metre = -1.0F;       // Cost of a metre; infinite: closed; negative: not known.
    std::int16_t street = -1;  // Number of a one-way street that holds the cell; -1: none.
  };
  /// A corner of a cell that a flood reaches. If only the way counts, corners are all the same.
  struct Entry {
    float cost;
    float along;  // Least place along the street of the cell [m]; infinitely small without one.
    std::int64_t cell;
    int corner;  // Bit 0: on the right; bit 1: above.
    bool operator<(const Entry& other) const {
      return cost != other.cost ? cost > other.cost : along > other.along;
    }
  };
  using Corners = std::array<float, 4>;
  static constexpr float endless = std::numeric_limits<float>::infinity();
  static constexpr Corners unreached = {endless, endless, endless, endless};
  /// What is known of a cell.
  struct Known {
    Cell cell = {};
    /// Least place along its street with which each flood reached each corner.
    std::array<Corners, 2> reached = {unreached, unreached};
  };
  using Row = std::array<Known, 64>;
  /// Entries of a flood, the cheapest first.
  class Front {
   public:
    [[nodiscard]] std::size_t size() const noexcept { return now_.size() + later_.size(); }
    void push(const Entry& entry);
    [[nodiscard]] Entry take();

   private:
    float level_ = 0.0F;      // Cost of the entry taken last.
    std::vector<Entry> now_;  // Entries that cost no more and are on no street.
    std::priority_queue<Entry> later_;
  };
  /// An area with a price or a speed, and the box around it. All of a cell is in it if its middle
  /// is within `near` of it.
  struct PricedArea {
    Bounds box;
    const Zone* zone;
    double near;
  };

  [[nodiscard]] bool is_priced() const noexcept;
  [[nodiscard]] Bounds scene() const;
  [[nodiscard]] double most_cells() const noexcept;
  [[nodiscard]] double cells_of(double side) const noexcept;
  [[nodiscard]] bool next_lattice();
  [[nodiscard]] bool begin(End end, const Bounds& box);
  [[nodiscard]] bool begin_all();
  [[nodiscard]] Point middle_of(std::int64_t cell) const;
  [[nodiscard]] Known& known(std::int64_t cell);
  [[nodiscard]] const Cell& cell_at(std::int64_t cell);
  [[nodiscard]] bool is_open(std::int64_t cell);
  [[nodiscard]] double metre_at(const Point& middle) const;
  [[nodiscard]] bool reach(End end, const Entry& entry);
  [[nodiscard]] static bool meet(const Known& cell);
  [[nodiscard]] bool cross(End end, const Entry& entry, int side);
  [[nodiscard]] bool expand(End end);

  const Task& task_;
  MetreCost cost_;
  std::vector<Bounds> places_;  // Boxes in which paths end.
  Bounds box_ = {};
  double side_ = 0.0;       // Side of a cell [m]; 0: nothing is left to do.
  double clearance_ = 0.0;  // Least distance of the rear axle from obstacles [m].
  std::vector<ClosedArea> closed_;
  std::vector<PricedArea> priced_;
  std::vector<collision::MaskCells> masks_;
  OneWay one_way_;
  std::int64_t columns_ = 0, rows_ = 0;
  bool uses_obstacles_ = false;
  OpenRows open_rows_;
  /// Cells by their numbers, null where none was asked for: floods seldom reach all of a lattice.
  std::vector<std::unique_ptr<Row>> known_;
  std::int64_t held_ = 0;
  std::array<Front, 2> fronts_;
  std::vector<std::int64_t> goals_;  // Cells of the goal.
  bool is_proven_ = false;
  double bound_ = 0.0;
};

}  // namespace vandplan::search
