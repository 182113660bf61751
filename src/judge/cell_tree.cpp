// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/cell_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vandplan::judge {
namespace {

std::size_t index_of(std::int32_t column, std::int32_t row, std::int32_t columns) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
         static_cast<std::size_t>(column);
}

}  // namespace

CellTree::CellTree(const OccupancyGrid& grid)
    : grid_(grid),
      cos_(std::cos(static_cast<Real>(grid.origin.heading))),
      sin_(std::sin(static_cast<Real>(grid.origin.heading))) {
  std::int32_t columns = grid.columns;
  std::int32_t rows = grid.rows;
  for (std::size_t below = 0; columns > 1 || rows > 1; ++below) {
    Level level{(columns + 1) / 2, (rows + 1) / 2, {}};
    level.has_blocked.resize(index_of(0, level.rows, level.columns));
    for (std::int32_t row = 0; row < rows; ++row) {
      for (std::int32_t column = 0; column < columns; ++column) {
        if (!has_blocked(below, column, row)) continue;
        level.has_blocked[index_of(column / 2, row / 2, level.columns)] = true;
      }
    }
    columns = level.columns;
    rows = level.rows;
    levels_.push_back(std::move(level));
  }
}

bool CellTree::has_blocked(std::size_t level, std::int32_t column, std::int32_t row) const {
  const std::int32_t columns = level == 0 ? grid_.columns : levels_[level - 1].columns;
  const std::int32_t rows = level == 0 ? grid_.rows : levels_[level - 1].rows;
  if (column >= columns || row >= rows) return false;
  if (level == 0) return is_blocked(grid_, column, row);
  return levels_[level - 1].has_blocked[index_of(column, row, columns)];
}

/// On one passage. Places are told from the rear axle in its middle, along the axes of the grid or,
/// once they are `seen`, along those of the vehicle.
class CellTree::Search {
 public:
  Search(const CellTree& tree, const View& view, const Outline& body, double most);

  [[nodiscard]] double least() const { return std::max(0.0, least_); }
  [[nodiscard]] std::size_t visited() const { return visited_; }

  /// Lowers `least` to the clearance of what is outside of the grid, all of it blocked.
  void look_outside();

  /// The same for the blocked cells in a square of the tree.
  void look(std::size_t level, std::int32_t column, std::int32_t row);

 private:
  [[nodiscard]] Point seen(Real x, Real y) const;
  void look_at_cell(std::int32_t column, std::int32_t row);

  const CellTree& tree_;
  const OccupancyGrid& grid_;
  const Passage& passage_;
  const Outline& body_;
  double least_;
  std::size_t visited_ = 0;
  Real x_, y_;        // of the axle, from the corner of the grid [m]
  double cos_, sin_;  // of the heading, from the axes of the grid
};

CellTree::Search::Search(const CellTree& tree, const View& view, const Outline& body, double most)
    : tree_(tree), grid_(tree.grid_), passage_(view.passage), body_(body), least_(most) {
  const Real dx = passage_.middle.x - grid_.origin.x;
  const Real dy = passage_.middle.y - grid_.origin.y;
  x_ = dx * tree.cos_ + dy * tree.sin_;
  y_ = dy * tree.cos_ - dx * tree.sin_;
  cos_ = static_cast<double>(view.cos * tree.cos_ + view.sin * tree.sin_);
  sin_ = static_cast<double>(view.sin * tree.cos_ - view.cos * tree.sin_);
}

/// The corners of the body come nearer to a border just as the points of the border do to them.
void CellTree::Search::look_outside() {
  const auto right = static_cast<double>(grid_.columns * static_cast<Real>(grid_.resolution) - x_);
  const auto up = static_cast<double>(grid_.rows * static_cast<Real>(grid_.resolution) - y_);
  const auto left = static_cast<double>(x_);
  const auto down = static_cast<double>(y_);
  for_each_corner(body_, [&](const Point& corner) {
    const double x = corner.x * cos_ - corner.y * sin_;
    const double y = corner.x * sin_ + corner.y * cos_;
    const double aside = approach(passage_, corner, {cos_, -sin_});
    const double ahead = approach(passage_, corner, {sin_, cos_});
    least_ =
        std::min({least_, left + x - aside, right - x - aside, down + y - ahead, up - y - ahead});
  });
}

void CellTree::Search::look(std::size_t level, std::int32_t column, std::int32_t row) {
  if (least_ <= 0 || !tree_.has_blocked(level, column, row)) return;
  ++visited_;
  const Real side = grid_.resolution * static_cast<Real>(std::int64_t{1} << level);
  const Real x = (column + Real{0.5}) * side;
  const Real y = (row + Real{0.5}) * side;
  // No point of the square is further from its middle than half a diagonal.
  const auto half_diagonal = static_cast<double>(side) * std::sqrt(0.5);
  if (clearance_of_disc(passage_, body_, seen(x, y), half_diagonal) >= least_) return;
  if (level == 0) return look_at_cell(column, row);
  // The quarter nearest to the axle first: then the others are often too far.
  const int nearest = (x < x_ ? 1 : 0) + (y < y_ ? 2 : 0);
  for (const int other : {0, 1, 2, 3}) {
    const int quarter = nearest ^ other;
    look(level - 1, 2 * column + quarter % 2, 2 * row + quarter / 2);
  }
}

void CellTree::Search::look_at_cell(std::int32_t column, std::int32_t row) {
  const Real side = grid_.resolution;
  const Real left = column * side;
  const Real right = (column + 1) * side;
  const Real low = row * side;
  const Real high = (row + 1) * side;
  const std::array<Point, 4> corners = {seen(left, low), seen(right, low), seen(right, high),
                                        seen(left, high)};
  least_ = clearance_of_seen(passage_, body_, corners, least_);
}

/// From the corner of the grid.
Point CellTree::Search::seen(Real x, Real y) const {
  const auto dx = static_cast<double>(x - x_);
  const auto dy = static_cast<double>(y - y_);
  return {dx * cos_ + dy * sin_, dy * cos_ - dx * sin_};
}

double CellTree::clearance(const View& view, const Outline& body, double most,
                           Effort& effort) const {
  Search search(*this, view, body, most);
  if (!grid_.unknown_is_free) search.look_outside();
  search.look(levels_.size(), 0, 0);
  effort.visited += search.visited();
  return search.least();
}

}  // namespace vandplan::judge
