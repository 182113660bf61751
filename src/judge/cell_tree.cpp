// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/cell_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace vandplan::judge {
namespace {

constexpr std::int32_t word_bits = 64;

unsigned bit_of(std::int32_t column) { return static_cast<unsigned>(column % word_bits); }

}  // namespace

std::size_t CellTree::Level::word_of(std::int32_t column, std::int32_t row) const {
  const std::int32_t words = columns / word_bits + 1;
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(words) +
         static_cast<std::size_t>(column / word_bits);
}

CellTree::CellTree(const OccupancyGrid& grid)
    : grid_(grid),
      cos_(std::cos(static_cast<Real>(grid.origin.heading))),
      sin_(std::sin(static_cast<Real>(grid.origin.heading))) {
  std::int32_t columns = grid.columns;
  std::int32_t rows = grid.rows;
  while (columns > 1 || rows > 1) {
    columns = (columns + 1) / 2;
    rows = (rows + 1) / 2;
    Level& level = levels_.emplace_back(Level{columns, rows, {}});
    level.has_blocked.resize(level.word_of(0, rows + 1));
    fill(levels_.size(), {0, 0, columns, rows});
  }
}

void CellTree::update(const CellRange& changed) {
  std::int32_t left = changed.column;
  std::int32_t low = changed.row;
  std::int32_t right = changed.column + changed.columns - 1;
  std::int32_t high = changed.row + changed.rows - 1;
  for (std::size_t level = 1; level <= levels_.size(); ++level) {
    left /= 2;
    low /= 2;
    right /= 2;
    high /= 2;
    fill(level, {left, low, right - left + 1, high - low + 1});
  }
}

void CellTree::fill(std::size_t level, const CellRange& squares) {
  Level& to = levels_[level - 1];
  for (std::int32_t row = squares.row; row < squares.row + squares.rows; ++row) {
    for (std::int32_t column = squares.column; column < squares.column + squares.columns;
         ++column) {
      std::uint64_t& word = to.has_blocked[to.word_of(column, row)];
      const std::uint64_t bit = std::uint64_t{1} << bit_of(column);
      word = blocked_quarters(level, column, row) != 0 ? word | bit : word & ~bit;
    }
  }
}

CellTree::Size CellTree::size_of(std::size_t level) const {
  if (level == 0) return {grid_.columns, grid_.rows};
  return {levels_[level - 1].columns, levels_[level - 1].rows};
}

bool CellTree::has_blocked(std::size_t level, std::int32_t column, std::int32_t row) const {
  const auto [columns, rows] = size_of(level);
  if (column < 0 || row < 0 || column >= columns || row >= rows) return false;
  if (level == 0) return is_blocked(grid_, column, row);
  const Level& squares = levels_[level - 1];
  return (squares.has_blocked[squares.word_of(column, row)] >> bit_of(column) & 1U) != 0;
}

unsigned CellTree::blocked_quarters(std::size_t level, std::int32_t column,
                                    std::int32_t row) const {
  unsigned quarters = 0;
  if (level == 1) {
    for (const int quarter : {0, 1, 2, 3}) {
      const bool is_any = has_blocked(0, 2 * column + quarter % 2, 2 * row + quarter / 2);
      quarters |= is_any ? 1U << quarter : 0U;
    }
    return quarters;
  }
  const Level& below = levels_[level - 2];  // columns 2 i and 2 i + 1 are in one word
  for (const int up : {0, 1}) {
    const std::uint64_t word = below.has_blocked[below.word_of(2 * column, 2 * row + up)];
    quarters |= static_cast<unsigned>(word >> bit_of(2 * column) & 3U) << (2 * up);
  }
  return quarters;
}

// On a passage a square is not refined if its radius is at most this share of the distance from its
// bound to `most`. The passage is halved anyway.
constexpr double fine = 0.125;

/// Search for the nearest blocked cell on one passage. Places are relative to the rear axle in the
/// middle of the passage. Their axes are those of the grid or, if `seen`, those of the vehicle.
class CellTree::Search {
 public:
  Search(const CellTree& tree, const View& view, const Outline& body, double most);

  [[nodiscard]] double least() const { return std::max(0.0, least_); }
  [[nodiscard]] std::size_t visited() const { return visited_; }

  /// Lowers `least` to the clearance of the outside of the grid, which is blocked.
  void look_outside();

  /// Lowers `least` to the clearance of the blocked cells of the grid.
  void look_inside();

 private:
  /// Square of the tree.
  struct Square {
    std::size_t level;
    std::int32_t column, row;
    Point middle;  // middle of the square, in the vehicle's frame
    double half;   // half of a side [m]
  };

  [[nodiscard]] Point seen(Real x, Real y) const;
  [[nodiscard]] Square part_of(const Square& square, int quarter) const;
  [[nodiscard]] double bound_of(const Square& square);
  void look(const Square& square, double bound);
  void look_at_cell(const Square& cell);

  const CellTree& tree_;
  const OccupancyGrid& grid_;
  const Passage& passage_;
  const Outline& body_;
  const double most_;
  double least_;
  std::size_t visited_ = 0;
  // Upper bound of the distance of any point of the body from the axle in the middle [m].
  double reach_;
  Real x_, y_;        // axle in the frame of the grid [m]
  double cos_, sin_;  // cosine and sine of the heading in the frame of the grid
};

CellTree::Search::Search(const CellTree& tree, const View& view, const Outline& body, double most)
    : tree_(tree),
      grid_(tree.grid_),
      passage_(view.passage),
      body_(body),
      most_(most),
      least_(most),
      reach_(reach_of(body) + passage_.half) {
  const Real dx = passage_.middle.x - grid_.origin.x;
  const Real dy = passage_.middle.y - grid_.origin.y;
  x_ = dx * tree.cos_ + dy * tree.sin_;
  y_ = dy * tree.cos_ - dx * tree.sin_;
  cos_ = static_cast<double>(view.cos * tree.cos_ + view.sin * tree.sin_);
  sin_ = static_cast<double>(view.sin * tree.cos_ - view.cos * tree.sin_);
}

/// Relative motion is symmetric: a corner approaches a border as a point of the border would
/// approach the corner.
void CellTree::Search::look_outside() {
  const auto right = static_cast<double>(grid_.columns * static_cast<Real>(grid_.resolution) - x_);
  const auto up = static_cast<double>(grid_.rows * static_cast<Real>(grid_.resolution) - y_);
  const auto left = static_cast<double>(x_);
  const auto down = static_cast<double>(y_);
  if (std::min({left, right, down, up}) >= reach_ + least_) return;
  for_each_corner(body_, [&](const Point& corner) {
    const double x = corner.x * cos_ - corner.y * sin_;
    const double y = corner.x * sin_ + corner.y * cos_;
    const double aside = approach(passage_, corner, {cos_, -sin_});
    const double ahead = approach(passage_, corner, {sin_, cos_});
    least_ =
        std::min({least_, left + x - aside, right - x - aside, down + y - ahead, up - y - ahead});
  });
}

/// Cells that matter lie around the axle, in at most four squares of one size.
void CellTree::Search::look_inside() {
  const double around = reach_ + least_;
  std::size_t level = 0;
  double side = grid_.resolution;
  for (; level < tree_.levels_.size() && side < 2 * around; ++level) side *= 2;
  const auto [columns, rows] = tree_.size_of(level);
  const auto index_at = [side](double place, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp(std::floor(place / side), -1.0, 1.0 * count));
  };
  const auto x = static_cast<double>(x_);
  const auto y = static_cast<double>(y_);
  for (std::int32_t row = index_at(y - around, rows); row <= index_at(y + around, rows); ++row) {
    for (std::int32_t column = index_at(x - around, columns);
         column <= index_at(x + around, columns); ++column) {
      if (!tree_.has_blocked(level, column, row)) continue;
      const Point middle = seen((column + Real{0.5}) * side, (row + Real{0.5}) * side);
      const Square square{level, column, row, middle, side / 2};
      const double bound = bound_of(square);
      if (least_ > 0 && bound < least_) look(square, bound);
    }
  }
}

/// Lower bound of the clearance of the cells in a square: they lie in the disc around it [m].
double CellTree::Search::bound_of(const Square& square) {
  ++visited_;
  return clearance_of_disc(passage_, body_, square.middle, square.half * std::numbers::sqrt2);
}

/// Searches the tree below a square, whose `bound` is known.
void CellTree::Search::look(const Square& square, double bound) {
  const double radius = square.half * std::numbers::sqrt2;
  if (passage_.half > 0 && bound > 0 && radius <= fine * (most_ - bound)) {
    least_ = bound;
    return;
  }
  if (square.level == 0) return look_at_cell(square);
  // The nearest quarter is searched first: then the others are often too far.
  const unsigned quarters = tree_.blocked_quarters(square.level, square.column, square.row);
  std::array<std::pair<double, int>, 4> near;
  std::size_t count = 0;
  for (const int quarter : {0, 1, 2, 3}) {
    if ((quarters >> quarter & 1U) == 0) continue;
    const double part_bound = bound_of(part_of(square, quarter));
    if (part_bound >= least_) continue;
    std::size_t place = count++;
    for (; place > 0 && near[place - 1].first > part_bound; --place) near[place] = near[place - 1];
    near[place] = {part_bound, quarter};
  }
  for (std::size_t i = 0; i < count && least_ > 0 && near[i].first < least_; ++i) {
    look(part_of(square, near[i].second), near[i].first);
  }
}

CellTree::Search::Square CellTree::Search::part_of(const Square& square, int quarter) const {
  const double half = square.half / 2;
  const double right = quarter % 2 == 0 ? -half : half;
  const double up = quarter / 2 == 0 ? -half : half;
  return {square.level - 1,
          2 * square.column + quarter % 2,
          2 * square.row + quarter / 2,
          {square.middle.x + right * cos_ + up * sin_, square.middle.y + up * cos_ - right * sin_},
          half};
}

void CellTree::Search::look_at_cell(const Square& cell) {
  const Real side = grid_.resolution;
  const Real left = cell.column * side;
  const Real right = (cell.column + 1) * side;
  const Real low = cell.row * side;
  const Real high = (cell.row + 1) * side;
  const std::array<Point, 4> corners = {seen(left, low), seen(right, low), seen(right, high),
                                        seen(left, high)};
  least_ = clearance_of_seen(passage_, body_, corners, least_);
}

/// A point of the grid's frame in the frame of the vehicle.
Point CellTree::Search::seen(Real x, Real y) const {
  const auto dx = static_cast<double>(x - x_);
  const auto dy = static_cast<double>(y - y_);
  return {dx * cos_ + dy * sin_, dy * cos_ - dx * sin_};
}

double CellTree::clearance(const View& view, const Outline& body, double most,
                           Effort& effort) const {
  Search search(*this, view, body, most);
  if (!grid_.unknown_is_free) search.look_outside();
  search.look_inside();
  effort.visited += search.visited();
  return search.least();
}

}  // namespace vandplan::judge
