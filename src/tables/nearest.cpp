// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/nearest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "bound_entries.h"
#include "simd/bound_kernels.h"
#include "vandplan/reeds_shepp.h"

namespace vandplan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Measured: 3 and 10 nodes in a cell are slower.
constexpr double nodes_per_cell = 6.0;
constexpr std::size_t fewest_nodes_for_a_grid = 32;

/// Column and row of the grid; beyond its edge the outermost cells go on for ever.
struct GridCell {
  std::int32_t x, y;
};

/// Some nodes of a cell, and where there are more.
struct Block {
  static constexpr std::size_t capacity = 8;
  double x[capacity], y[capacity];
  float heading[capacity];
  std::int32_t node[capacity];
  std::size_t count = 0;
  std::int32_t next = -1;
};

}  // namespace

struct NearestNodes::Grid {
  class Search;

  [[nodiscard]] GridCell cell_of(const Pose& pose) const noexcept;
  [[nodiscard]] std::size_t index_of(GridCell cell) const noexcept;
  void add(const Pose& pose);
  void remake();
  void put(std::int32_t node);

  double radius;  // of turning [m]
  std::vector<Pose> poses = {};
  std::size_t limit = 0;  // number of nodes from which on it is too coarse
  double x_min = 0.0, y_min = 0.0, cell_size = 1.0;  // [m]
  std::int32_t columns = 0, rows = 0;
  std::vector<std::int32_t> first_block = {};  // of each cell, or -1
  std::vector<Block> blocks = {};
};

GridCell NearestNodes::Grid::cell_of(const Pose& pose) const noexcept {
  const double x = std::clamp((pose.x - x_min) / cell_size, 0.0, columns - 0.5);
  const double y = std::clamp((pose.y - y_min) / cell_size, 0.0, rows - 0.5);
  return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
}

std::size_t NearestNodes::Grid::index_of(GridCell cell) const noexcept {
  return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns) +
         static_cast<std::size_t>(cell.x);
}

void NearestNodes::Grid::add(const Pose& pose) {
  poses.push_back(pose);
  if (poses.size() > limit) {
    remake();
  } else {
    put(static_cast<std::int32_t>(poses.size()) - 1);
  }
}

void NearestNodes::Grid::remake() {
  limit = std::max(fewest_nodes_for_a_grid, 2 * poses.size());
  x_min = y_min = infinity;
  double x_max = -infinity;
  double y_max = -infinity;
  for (const Pose& pose : poses) {
    x_min = std::min(x_min, pose.x);
    y_min = std::min(y_min, pose.y);
    x_max = std::max(x_max, pose.x);
    y_max = std::max(y_max, pose.y);
  }
  const double width = x_max - x_min;
  const double height = y_max - y_min;
  const double cells = 0.75 * static_cast<double>(limit) / nodes_per_cell;
  cell_size = std::max(std::sqrt(width / cells) * std::sqrt(height), width / cells);
  cell_size = std::max(cell_size, height / cells);
  if (cell_size == 0.0) cell_size = 1.0;
  columns = static_cast<std::int32_t>(width / cell_size) + 1;
  rows = static_cast<std::int32_t>(height / cell_size) + 1;
  first_block.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), -1);
  blocks.clear();
  for (std::size_t i = 0; i < poses.size(); ++i) put(static_cast<std::int32_t>(i));
}

void NearestNodes::Grid::put(std::int32_t node) {
  const Pose& pose = poses[static_cast<std::size_t>(node)];
  std::int32_t& first = first_block[index_of(cell_of(pose))];
  if (first < 0 || blocks[static_cast<std::size_t>(first)].count == Block::capacity) {
    blocks.emplace_back().next = first;
    first = static_cast<std::int32_t>(blocks.size()) - 1;
  }
  Block& block = blocks[static_cast<std::size_t>(first)];
  block.x[block.count] = pose.x;
  block.y[block.count] = pose.y;
  block.heading[block.count] = static_cast<float>(wrap_angle(pose.heading));
  block.node[block.count] = node;
  ++block.count;
}

// One query.
//
//   limit := infinity, which the least length is never above
//   for the sample's cell, then ring by ring of cells around it:
//   [1]   collect the nodes whose distance is no more than the limit
//   [2]   look up bounds of their lengths, all at once; limit := the least upper bound so far
//   [3]   the nodes whose lower bound is no more than the limit are candidates
//   [4]   leave if every cell further out is further away than the limit
//   [5] by increasing lower bound, as long as that is no more than the least length so far:
//       compute the exact length
class NearestNodes::Grid::Search {
 public:
  Search(const Grid& nodes, const Pose& sample)
      : all_(nodes),
        sample_(sample),
        heading_(static_cast<float>(wrap_angle(sample.heading))),
        centre_(nodes.cell_of(sample)) {}

  NearestNode run() {
    for (std::int32_t ring = 0;; ++ring) {
      collect_ring(ring);                                     // [1]
      find_candidates();                                      // [2] [3]
      if (beyond(ring) > static_cast<double>(limit_)) break;  // [4]
    }
    decide();  // [5]
    return best_;
  }

 private:
  struct Candidate {
    float low;
    std::int32_t node;
  };

  void collect_ring(std::int32_t ring) {
    const std::int32_t left = centre_.x - ring;
    const std::int32_t right = centre_.x + ring;
    const std::int32_t low = std::max(centre_.y - ring, 0);
    const std::int32_t high = std::min(centre_.y + ring, all_.rows - 1);
    for (std::int32_t y = low; y <= high; ++y) {
      const bool whole_row = std::abs(y - centre_.y) == ring;
      const std::int32_t step = whole_row ? 1 : 2 * ring;
      for (std::int32_t x = left; x <= right; x += step) {
        if (x >= 0 && x < all_.columns) collect_cell({x, y});
      }
    }
  }

  void collect_cell(GridCell cell) {
    std::int32_t next = all_.first_block[all_.index_of(cell)];
    while (next >= 0) {
      if (count_ + Block::capacity > batch) find_candidates();
      const Block& block = all_.blocks[static_cast<std::size_t>(next)];
      const float reach = limit_ * (1 + simd::noise);
      for (std::size_t i = 0; i < block.count; ++i) {
        const auto dx = static_cast<float>(block.x[i] - sample_.x);
        const auto dy = static_cast<float>(block.y[i] - sample_.y);
        x_[count_] = dx;
        y_[count_] = dy;
        node_heading_[count_] = block.heading[i];
        node_[count_] = block.node[i];
        count_ += dx * dx + dy * dy <= reach * reach ? 1 : 0;
      }
      next = block.next;
    }
  }

  void find_candidates() {
    simd::length_bounds(simd::bound_entries, first(x_), first(y_), first(node_heading_),
                        {0.0F, 0.0F, heading_}, static_cast<float>(all_.radius), first(low_),
                        first(high_));
    for (std::size_t i = 0; i < count_; ++i) limit_ = std::min(limit_, high_[i]);
    for (std::size_t i = 0; i < count_; ++i) {
      if (low_[i] > limit_) continue;
      if (candidates_ == candidate_.size()) decide();
      candidate_[candidates_++] = {low_[i], node_[i]};
    }
    count_ = 0;
  }

  std::span<float> first(auto& column) const { return std::span(column).first(count_); }

  // Every node outside of the rings up to this one is further away than this [m].
  double beyond(std::int32_t ring) const {
    const double x = sample_.x - all_.x_min;
    const double y = sample_.y - all_.y_min;
    const double size = all_.cell_size;
    double distance = infinity;
    const auto consider = [&](double edge) { distance = std::min(distance, edge - 1e-6 * size); };
    if (centre_.x - ring > 0) consider(x - (centre_.x - ring) * size);
    if (centre_.y - ring > 0) consider(y - (centre_.y - ring) * size);
    if (centre_.x + ring < all_.columns - 1) consider((centre_.x + ring + 1) * size - x);
    if (centre_.y + ring < all_.rows - 1) consider((centre_.y + ring + 1) * size - y);
    return distance;
  }

  void decide() {
    const auto begin = candidate_.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(candidates_);
    std::sort(begin, end, [](const Candidate& a, const Candidate& b) { return a.low < b.low; });
    for (auto it = begin; it != end && static_cast<double>(it->low) <= best_.length; ++it) {
      const Pose& pose = all_.poses[static_cast<std::size_t>(it->node)];
      const double length = reeds_shepp_length(pose, sample_, all_.radius);
      ++best_.exact_solves;
      if (length > best_.length || (length == best_.length && it->node > best_.node)) continue;
      best_.length = length;
      best_.node = it->node;
    }
    candidates_ = 0;
  }

  static constexpr std::size_t batch = 256;

  const Grid& all_;
  const Pose& sample_;
  float heading_;
  GridCell centre_;
  float limit_ = std::numeric_limits<float>::infinity();
  NearestNode best_{.length = infinity};
  std::size_t count_ = 0;  // nodes collected
  std::array<float, batch> x_, y_, node_heading_, low_, high_;
  std::array<std::int32_t, batch> node_;
  std::size_t candidates_ = 0;
  std::array<Candidate, 64> candidate_;
};

NearestNodes::NearestNodes(double radius) : grid_(std::make_unique<Grid>(Grid{.radius = radius})) {}
NearestNodes::~NearestNodes() = default;
NearestNodes::NearestNodes(const NearestNodes& other)
    : grid_(std::make_unique<Grid>(*other.grid_)) {}
NearestNodes& NearestNodes::operator=(const NearestNodes& other) {
  return *this = NearestNodes(other);
}
NearestNodes::NearestNodes(NearestNodes&& other) noexcept = default;
NearestNodes& NearestNodes::operator=(NearestNodes&& other) noexcept = default;

void NearestNodes::add(const Pose& pose) { grid_->add(pose); }

std::size_t NearestNodes::size() const noexcept { return grid_->poses.size(); }

std::optional<NearestNode> NearestNodes::nearest(const Pose& sample) const {
  if (grid_->poses.empty()) return std::nullopt;
  return Grid::Search(*grid_, sample).run();
}

}  // namespace vandplan
