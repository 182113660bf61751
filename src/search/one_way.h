// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which sides of a lattice's cells can be crossed in one sense only, which way do streets lead, and
// with which headings is no metre driven?
//
// In a one-way street that none of whose directions has a sense, every metre leads the other way.
// If the street contains all of a side, with some room, no path crosses the side in that sense.
// Where a street allows half of all directions or fewer, its middle direction leads onward: the
// place along it never falls.

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "search/open_rows.h"
#include "vandplan/collision.h"
#include "vandplan/search.h"

namespace vandplan::search {

/// The one-way streets of a ground. Senses: 0 is along x, then quarters of a turn.
class OneWay {
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr Bounds everywhere{-infinite, infinite, -infinite, infinite};

 public:
  OneWay() = default;
  /// For the centre of a disc in a body that turns with `radius` [m] at the tightest. `bounds`: the
  /// centre stays in them.
  OneWay(const std::vector<Zone>& zones, const Disc& disc, double radius,
         const Bounds& bounds = everywhere);

  /// Boxes around the areas of streets that bar a sense of crossing or lead onward.
  [[nodiscard]] std::vector<Bounds> barring() const;
  [[nodiscard]] bool is_empty() const noexcept { return streets_.empty(); }
  /// Whether the disc's centre cannot cross a side of a cell in a sense. `middle`, `length`: of the
  /// side.
  [[nodiscard]] bool bars(const Point& middle, double length, int sense) const;
  /// Whether no path passes a pose with the disc's centre up to `off` [m] from `centre` and a
  /// heading up to `turn` [rad] from `heading`. `only`: gear of all paths; 0: both gears.
  [[nodiscard]] bool forbids(const Point& centre, double off, double heading, double turn,
                             GearSign only) const;

  /// Number of a street that leads onward at all places up to `off` [m] from a point; -1: none.
  [[nodiscard]] int street_of(const Point& middle, double off) const;
  /// Range of the places along a street of a point and all points up to `off` [m] beside it in x or
  /// in y. `is_backward`: along its opposite [m].
  struct Along {
    float least, most;
  };
  [[nodiscard]] Along range_along(int street, const Point& middle, double off,
                                  bool is_backward) const;

 private:
  struct Street {
    Polygon area;
    Bounds box;                   // Around the area.
    HeadingRange direction;       // Directions of travel that are allowed.
    double near;                  // Distance from the area at which the rules surely hold [m].
    std::array<bool, 4> bars;     // Whether it bars each sense.
    std::optional<Point> onward;  // Unit vector of its middle direction, if it leads onward.

    /// Whether its rules surely hold at all places of the bounds up to `off` [m] from a point.
    [[nodiscard]] bool holds(const Bounds& bounds, const Point& middle, double off) const;
  };
  Bounds bounds_ = everywhere;
  std::vector<Street> streets_;
};

}  // namespace vandplan::search
