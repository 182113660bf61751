// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/cost_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vandplan::search {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int nodes_per_step = 64;  // nodes settled between two looks at the clock

/// Offsets from a node to its neighbours, counter-clockwise. Even numbers: along a side of a cell;
/// odd numbers: across a cell.
constexpr std::array<std::array<std::int32_t, 2>, 8> ring = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// Offset from a node to the cell between the node and its neighbour `diagonal`, an odd number.
constexpr std::array<std::int32_t, 2> cell_towards(int diagonal) {
  const auto& [x, y] = ring[static_cast<std::size_t>(diagonal)];
  return {std::min(x, 0), std::min(y, 0)};
}

/// Cost of the cheapest way from a corner s of a cell of side 1 through the opposite side s1 - s2.
/// Letters of Ferguson and Stentz 2006: g1 is the cost at s1 beside s, g2 the cost at s2 across the
/// cell. c is the cost of a metre in the cell, b in the cell on the other side of s - s1.
double interpolated(double g1, double g2, double c, double b) {
  if (g1 <= g2) return std::min(c, b) + g1;
  const double f = g1 - g2;
  if (f <= b) {
    if (c <= f) return std::sqrt(2.0) * c + g2;
    const double y = std::min(f / std::sqrt(c * c - f * f), 1.0);
    return c * std::sqrt(1 + y * y) + f * (1 - y) + g2;
  }
  if (c <= b) return std::sqrt(2.0) * c + g2;
  const double x = 1 - std::min(b / std::sqrt(c * c - b * b), 1.0);
  return c * std::sqrt(1 + (1 - x) * (1 - x)) + b * x + g2;
}

double distance(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

}  // namespace

CostField::CostField(CostCells cells, const Point& target, const Point& root)
    : cells_(std::move(cells)),
      target_(target),
      root_(root),
      columns_(static_cast<std::int32_t>((cells_.box.x_max - cells_.box.x_min) / cells_.side) + 2),
      rows_(static_cast<std::int32_t>((cells_.box.y_max - cells_.box.y_min) / cells_.side) + 2) {
  const std::size_t nodes = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  costs_.assign(nodes, infinity);
  is_settled_.assign(nodes, false);
  cell_costs_.assign(nodes, -1.0F);
  for (const Point& end : {target, root}) {
    const Place cell = cell_of(end);
    const double cost = cells_.cost(end);
    cell_costs_[index_of(cell)] = static_cast<float>(cost < infinity ? cost : 1.0);
  }
  const Place cell = cell_of(target);
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
    const Place node{cell.x + x, cell.y + y};
    reach(node, cost_of(cell) * distance(point_of(node), target));
  }
}

bool CostField::holds(const Place& node) const {
  return node.x >= 0 && node.x < columns_ && node.y >= 0 && node.y < rows_;
}

std::size_t CostField::index_of(const Place& node) const {
  return static_cast<std::size_t>(node.y) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(node.x);
}

CostField::Place CostField::place_of(std::size_t index) const {
  const auto columns = static_cast<std::size_t>(columns_);
  return {static_cast<std::int32_t>(index % columns), static_cast<std::int32_t>(index / columns)};
}

Point CostField::point_of(const Place& node) const {
  return {cells_.box.x_min + cells_.side * node.x, cells_.box.y_min + cells_.side * node.y};
}

CostField::Place CostField::cell_of(const Point& point) const {
  const auto along = [&](double value, double least, std::int32_t nodes) {
    return std::clamp(static_cast<std::int32_t>(std::floor((value - least) / cells_.side)), 0,
                      nodes - 2);
  };
  return {along(point.x, cells_.box.x_min, columns_), along(point.y, cells_.box.y_min, rows_)};
}

double CostField::cost_of(const Place& cell) const {
  if (cell.x < 0 || cell.y < 0 || cell.x >= columns_ - 1 || cell.y >= rows_ - 1) return infinity;
  float& known = cell_costs_[index_of(cell)];
  if (known < 0.0F) {
    const Point corner = point_of(cell);
    const double half = cells_.side / 2;
    known = static_cast<float>(cells_.cost({corner.x + half, corner.y + half}));
  }
  return static_cast<double>(known);
}

double CostField::node_cost(const Place& node) const {
  return holds(node) ? costs_[index_of(node)] : infinity;
}

void CostField::reach(const Place& node, double cost) {
  const std::size_t index = index_of(node);
  if (cost >= costs_[index]) return;
  costs_[index] = cost;
  open_.push({cost + distance(point_of(node), root_), static_cast<std::int32_t>(index)});
}

bool CostField::step() {
  for (int work = 0; work < nodes_per_step;) {
    if (open_.empty() || missing_ == 0) return false;
    const auto index = static_cast<std::size_t>(open_.top().index);
    open_.pop();
    if (is_settled_[index]) continue;
    is_settled_[index] = true;
    ++settled_;
    ++work;
    const Place node = place_of(index);
    const Place end = cell_of(root_);
    const auto is_corner = [](std::int32_t at, std::int32_t cell) {
      return at == cell || at == cell + 1;
    };
    if (is_corner(node.x, end.x) && is_corner(node.y, end.y)) --missing_;
    for (int i = 0; i < 8; ++i) {
      const auto& [x, y] = ring[static_cast<std::size_t>(i)];
      const Place neighbour{node.x + x, node.y + y};
      if (holds(neighbour) && !is_settled_[index_of(neighbour)]) update(neighbour, (i + 4) % 8);
    }
  }
  return true;
}

// Lowers the cost of a node by ways through the two sides that end at its neighbour `towards`.
void CostField::update(const Place& node, int towards) {
  const auto beside = [&](int i) {
    const auto& [x, y] = ring[static_cast<std::size_t>((i + 8) % 8)];
    return Place{node.x + x, node.y + y};
  };
  const auto cell = [&](int diagonal) {
    const auto [x, y] = cell_towards((diagonal + 8) % 8);
    return cost_of({node.x + x, node.y + y}) * cells_.side;
  };
  const bool is_diagonal = towards % 2 == 1;
  for (const int turn : {1, -1}) {
    const int straight = is_diagonal ? towards + turn : towards;
    const int diagonal = is_diagonal ? towards : towards + turn;
    const double c = cell(diagonal);
    const double b = cell(2 * straight - diagonal);
    reach(node, interpolated(node_cost(beside(straight)), node_cost(beside(diagonal)), c, b));
  }
}

// Along each side of the cell the cost is linear: a + k t at t metres from one end. The way to this
// place costs c sqrt(h^2 + (t - t0)^2). The sum is least where its derivative by t is 0.
void CostField::consider(const Point& from, const Place& cell, Step& best) const {
  const double c = cost_of(cell);
  if (c == infinity) return;
  const double side = cells_.side;
  const auto take = [&](const Point& to, double value) {
    const double length = distance(from, to);
    if (length > 1e-9 * side && c * length + value < best.cost) best = {to, c * length + value};
  };
  const Place own = cell_of(target_);
  if (cell.x == own.x && cell.y == own.y) take(target_, 0.0);
  constexpr std::array<std::array<std::int32_t, 4>, 4> sides = {
      {{0, 0, 1, 0}, {0, 1, 1, 1}, {0, 0, 0, 1}, {1, 0, 1, 1}}};
  for (const auto& [x1, y1, x2, y2] : sides) {
    const Place first{cell.x + x1, cell.y + y1};
    const Place second{cell.x + x2, cell.y + y2};
    const double a = node_cost(first);
    const double z = node_cost(second);
    const Point p = point_of(first);
    const Point q = point_of(second);
    if (a < infinity) take(p, a);
    if (z < infinity) take(q, z);
    if (a == infinity || z == infinity) continue;
    const double k = (z - a) / side;
    if (std::abs(k) >= c) continue;
    const bool is_level = y1 == y2;
    const double h = is_level ? from.y - p.y : from.x - p.x;
    const double t0 = is_level ? from.x - p.x : from.y - p.y;
    const double t = t0 - k * std::abs(h) / std::sqrt(c * c - k * k);
    if (t <= 0.0 || t >= side) continue;
    take(is_level ? Point{p.x + t, p.y} : Point{p.x, p.y + t}, a + k * t);
  }
}

CostField::Step CostField::best_step(const Point& from) const {
  Step best;
  const Place cell = cell_of(from);
  const Point corner = point_of(cell);
  // Distance to a grid line below which the cells on both sides count [m].
  const double near = 1e-6 * cells_.side;
  for (const std::int32_t y : {0, -1, 1}) {
    if (y == -1 && from.y - corner.y > near) continue;
    if (y == 1 && corner.y + cells_.side - from.y > near) continue;
    for (const std::int32_t x : {0, -1, 1}) {
      if (x == -1 && from.x - corner.x > near) continue;
      if (x == 1 && corner.x + cells_.side - from.x > near) continue;
      consider(from, {cell.x + x, cell.y + y}, best);
    }
  }
  return best;
}

double CostField::at(const Point& point) const {
  if (point == target_) return 0.0;
  const Place cell = cell_of(point);
  const double cost = best_step(point).cost;
  return point == point_of(cell) ? std::min(cost, node_cost(cell)) : cost;
}

std::vector<Point> CostField::route() const {
  std::vector<Point> points = {root_};
  while (points.back() != target_) {
    const Step step = best_step(points.back());
    if (step.cost == infinity || points.size() > costs_.size()) return {};
    points.push_back(step.to);
  }
  return points;
}

}  // namespace vandplan::search
