// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/geodesic_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace vandplan::search {
namespace {

constexpr std::size_t max_kept = 400000;

std::int64_t key_of(const TautWays::RunId& run) {
  return static_cast<std::int64_t>(run.row) << 32 | run.index;
}

}  // namespace

GeodesicField::GeodesicField(OpenRows lattice, const Point& start, const Point& goal,
                             double longest)
    : ways_(std::move(lattice), start, goal, longest) {}

bool GeodesicField::go_on(std::int64_t work) {
  while (ways_.work() < work) {
    const std::optional<TautWays::Node> node = ways_.take();
    is_given_up_ = ways_.is_full() || count_ > max_kept;
    if (!node || is_given_up_) return false;
    if (!ways_.is_current(*node)) continue;
    into_[key_of(node->into)].push_back(*node);
    ++count_;
    ways_.expand(*node);
  }
  return true;
}

double GeodesicField::at(const Point& point) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::optional<TautWays::RunId> run = ways_.run_at(point);
  if (!run) return infinity;
  double least = infinity;
  if (*run == ways_.start_run()) {
    least = std::hypot(point.x - ways_.start().x, point.y - ways_.start().y);
  }
  const auto nodes = into_.find(key_of(*run));
  if (nodes == into_.end()) return least;
  for (const TautWays::Node& node : nodes->second) {
    if (node.rank > least) break;  // Nodes are kept in the order of their rank.
    least = std::min(least, node.way_to(point));
  }
  return least;
}

// Along a run the distance changes at most by as much as the place.
std::vector<std::int32_t> GeodesicField::cells_at(std::int32_t row, double distance, double near) {
  std::vector<std::int32_t> cells;
  if (!has_row(row)) return cells;
  for (const OpenRows::Run& run : ways_.lattice().row(row)) {
    for (std::int32_t x = run.begin; x < run.end;) {
      const double off = std::abs(at({x + 0.5, row + 0.5}) - distance) - near;
      if (off > run.end - x) break;
      if (off <= 0) cells.push_back(x);
      x += std::max(1, static_cast<std::int32_t>(off));
    }
  }
  return cells;
}

}  // namespace vandplan::search
