// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/nearest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "bound_entries.h"
#include "simd/bound_kernels.h"
#include "vandplan/reeds_shepp.h"

namespace vandplan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Measured: 3 and 10 nodes in a cell are slower.
constexpr double nodes_per_cell = 6.0;
constexpr std::size_t fewest_nodes_for_a_grid = 32;

}  // namespace

NearestNodes::Cell NearestNodes::cell_of(const Pose& pose) const noexcept {
  const double x = std::clamp((pose.x - x_min_) / cell_size_, 0.0, columns_ - 0.5);
  const double y = std::clamp((pose.y - y_min_) / cell_size_, 0.0, rows_ - 0.5);
  return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
}

std::size_t NearestNodes::index_of(Cell cell) const noexcept {
  return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(cell.x);
}

void NearestNodes::add(const Pose& pose) {
  poses_.push_back(pose);
  if (poses_.size() > grid_limit_) {
    make_grid();
  } else {
    put_into_grid(static_cast<std::int32_t>(poses_.size()) - 1);
  }
}

void NearestNodes::make_grid() {
  grid_limit_ = std::max(fewest_nodes_for_a_grid, 2 * poses_.size());
  x_min_ = y_min_ = infinity;
  double x_max = -infinity;
  double y_max = -infinity;
  for (const Pose& pose : poses_) {
    x_min_ = std::min(x_min_, pose.x);
    y_min_ = std::min(y_min_, pose.y);
    x_max = std::max(x_max, pose.x);
    y_max = std::max(y_max, pose.y);
  }
  const double width = x_max - x_min_;
  const double height = y_max - y_min_;
  const double cells = 0.75 * static_cast<double>(grid_limit_) / nodes_per_cell;
  cell_size_ = std::max(std::sqrt(width / cells) * std::sqrt(height), width / cells);
  cell_size_ = std::max(cell_size_, height / cells);
  if (cell_size_ == 0.0) cell_size_ = 1.0;
  columns_ = static_cast<std::int32_t>(width / cell_size_) + 1;
  rows_ = static_cast<std::int32_t>(height / cell_size_) + 1;
  first_block_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
  blocks_.clear();
  for (std::size_t i = 0; i < poses_.size(); ++i) put_into_grid(static_cast<std::int32_t>(i));
}

void NearestNodes::put_into_grid(std::int32_t node) {
  const Pose& pose = poses_[static_cast<std::size_t>(node)];
  std::int32_t& first = first_block_[index_of(cell_of(pose))];
  if (first < 0 || blocks_[static_cast<std::size_t>(first)].count == Block::capacity) {
    blocks_.emplace_back().next = first;
    first = static_cast<std::int32_t>(blocks_.size()) - 1;
  }
  Block& block = blocks_[static_cast<std::size_t>(first)];
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
class NearestNodes::Search {
 public:
  Search(const NearestNodes& nodes, const Pose& sample)
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
    const std::int32_t high = std::min(centre_.y + ring, all_.rows_ - 1);
    for (std::int32_t y = low; y <= high; ++y) {
      const bool whole_row = std::abs(y - centre_.y) == ring;
      const std::int32_t step = whole_row ? 1 : 2 * ring;
      for (std::int32_t x = left; x <= right; x += step) {
        if (x >= 0 && x < all_.columns_) collect_cell({x, y});
      }
    }
  }

  void collect_cell(Cell cell) {
    std::int32_t next = all_.first_block_[all_.index_of(cell)];
    while (next >= 0) {
      if (count_ + Block::capacity > batch) find_candidates();
      const Block& block = all_.blocks_[static_cast<std::size_t>(next)];
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
                        {0.0F, 0.0F, heading_}, static_cast<float>(all_.radius_), first(low_),
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
    const double x = sample_.x - all_.x_min_;
    const double y = sample_.y - all_.y_min_;
    const double size = all_.cell_size_;
    double distance = infinity;
    const auto consider = [&](double edge) { distance = std::min(distance, edge - 1e-6 * size); };
    if (centre_.x - ring > 0) consider(x - (centre_.x - ring) * size);
    if (centre_.y - ring > 0) consider(y - (centre_.y - ring) * size);
    if (centre_.x + ring < all_.columns_ - 1) consider((centre_.x + ring + 1) * size - x);
    if (centre_.y + ring < all_.rows_ - 1) consider((centre_.y + ring + 1) * size - y);
    return distance;
  }

  void decide() {
    const auto begin = candidate_.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(candidates_);
    std::sort(begin, end, [](const Candidate& a, const Candidate& b) { return a.low < b.low; });
    for (auto it = begin; it != end && static_cast<double>(it->low) <= best_.length; ++it) {
      const Pose& pose = all_.poses_[static_cast<std::size_t>(it->node)];
      const double length = reeds_shepp_length(pose, sample_, all_.radius_);
      ++best_.exact_solves;
      if (length > best_.length || (length == best_.length && it->node > best_.node)) continue;
      best_.length = length;
      best_.node = it->node;
    }
    candidates_ = 0;
  }

  static constexpr std::size_t batch = 256;

  const NearestNodes& all_;
  const Pose& sample_;
  float heading_;
  Cell centre_;
  float limit_ = std::numeric_limits<float>::infinity();
  NearestNode best_{.length = infinity};
  std::size_t count_ = 0;  // nodes collected
  std::array<float, batch> x_, y_, node_heading_, low_, high_;
  std::array<std::int32_t, batch> node_;
  std::size_t candidates_ = 0;
  std::array<Candidate, 64> candidate_;
};

std::optional<NearestNode> NearestNodes::nearest(const Pose& sample) const {
  if (poses_.empty()) return std::nullopt;
  return Search(*this, sample).run();
}

}  // namespace vandplan
