// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "base/require.h"
#include "bound_entries.h"
#include "simd/bound_kernels.h"
#include "tables/pose_grid.h"
#include "vandplan/input_error.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using tables::Block, tables::GridCell;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Nodes of a vehicle with a turning radius [m], in a grid.
struct Nodes : tables::PoseGrid {
  double radius = 0.0;
};

/// Node that may be among the nearest, with bounds on its length [m].
struct Candidate {
  float low;
  float high;
  std::int32_t node;
};

// Candidates and result of a query for one node.
class One {
 public:
  One(const Nodes& nodes, const Pose& sample) : all_(nodes), sample_(sample) {}

  [[nodiscard]] float limit() const { return limit_; }

  void take(std::span<const float> low, std::span<const float> high,
            std::span<const std::int32_t> node) {
    for (const float bound : high) limit_ = std::min(limit_, bound);
    for (std::size_t i = 0; i < low.size(); ++i) {
      if (low[i] > limit_) continue;
      if (candidates_ == candidate_.size()) decide();
      candidate_[candidates_++] = {low[i], high[i], node[i]};
    }
  }

  NearestNode result() {
    decide();
    return best_;
  }

 private:
  void decide() {
    const auto begin = candidate_.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(candidates_);
    std::sort(begin, end, [](const Candidate& a, const Candidate& b) { return a.low < b.low; });
    for (auto it = begin; it != end && static_cast<double>(it->low) <= best_.length; ++it) {
      const double length = reeds_shepp_length(all_.pose(it->node), sample_, all_.radius);
      ++best_.exact_solves;
      if (length > best_.length || (length == best_.length && it->node > best_.node)) continue;
      best_.length = length;
      best_.node = it->node;
    }
    candidates_ = 0;
  }

  const Nodes& all_;
  const Pose& sample_;
  float limit_ = std::numeric_limits<float>::infinity();
  NearestNode best_{.length = infinity};
  std::size_t candidates_ = 0;
  std::array<Candidate, 64> candidate_;
};

// Candidates and result of a query for the k nearest nodes. The limit is the k-th least upper
// bound, or a little above it.
class Several {
 public:
  Several(const Nodes& nodes, const Pose& sample, const NearWanted& wanted)
      : all_(nodes),
        sample_(sample),
        within_(wanted.within),
        count_(std::min(wanted.count, nodes.count)),
        limit_(std::nextafter(static_cast<float>(wanted.within),
                              std::numeric_limits<float>::infinity())) {}

  [[nodiscard]] float limit() const { return limit_; }

  void take(std::span<const float> low, std::span<const float> high,
            std::span<const std::int32_t> node) {
    for (std::size_t i = 0; i < low.size(); ++i) {
      if (low[i] > limit_) continue;
      candidates_.push_back({low[i], high[i], node[i]});
      bounds_.push_back(high[i]);
    }
    if (bounds_.size() >= next_) lower_limit();
  }

  std::vector<NearNode> in_order() {
    drop_candidates();
    std::vector<NearNode> found = measured(candidates_, count_);
    std::ranges::sort(found, is_nearer);
    return found;
  }

  // Nodes in any order. Exact lengths are computed only where the bounds do not decide.
  std::vector<std::int32_t> in_any_order() {
    drop_candidates();
    double sure = infinity;  // Nodes whose length is below this are among the first [m].
    if (candidates_.size() > count_) {
      const auto last = candidates_.begin() + static_cast<std::ptrdiff_t>(count_) - 1;
      std::ranges::nth_element(candidates_, last, {}, &Candidate::low);
      sure = static_cast<double>(last->low);
    }
    std::vector<std::int32_t> found;
    std::erase_if(candidates_, [&](const Candidate& candidate) {
      const auto high = static_cast<double>(candidate.high);
      const bool is_sure = high < sure && high <= within_;
      if (is_sure) found.push_back(candidate.node);
      return is_sure;
    });
    for (const NearNode& near : measured(candidates_, count_ - found.size())) {
      found.push_back(near.node);
    }
    return found;
  }

 private:
  static bool is_nearer(const NearNode& a, const NearNode& b) {
    return a.length != b.length ? a.length < b.length : a.node < b.node;
  }

  void lower_limit() {
    const auto last = bounds_.begin() + static_cast<std::ptrdiff_t>(count_) - 1;
    std::ranges::nth_element(bounds_, last);
    limit_ = std::min(limit_, *last);
    bounds_.resize(count_);
    next_ = count_ + count_ / 4 + 8;
  }

  void drop_candidates() {
    if (bounds_.size() >= count_) lower_limit();
    std::erase_if(candidates_, [&](const Candidate& c) { return c.low > limit_; });
  }

  /// The `count` nearest of the candidates within the largest length, in any order.
  std::vector<NearNode> measured(std::span<const Candidate> candidates, std::size_t count) const {
    std::vector<NearNode> found;
    found.reserve(candidates.size());
    for (const auto& [low, high, node] : candidates) {
      const double length = reeds_shepp_length(all_.pose(node), sample_, all_.radius);
      if (length <= within_) found.push_back({node, length});
    }
    if (found.size() > count) {
      std::ranges::nth_element(found, found.begin() + static_cast<std::ptrdiff_t>(count),
                               is_nearer);
      found.resize(count);
    }
    return found;
  }

  const Nodes& all_;
  const Pose& sample_;
  double within_;                   // Largest length of a wanted node [m].
  std::size_t count_;               // Number of wanted nodes, at most the number in the grid.
  float limit_;                     // Largest lower bound of a candidate [m].
  std::size_t next_ = count_;       // Number of bounds at which the limit is lowered.
  std::vector<float> bounds_ = {};  // Upper bounds, with the least `count_` of them among them [m].
  std::vector<Candidate> candidates_ = {};
};

// Search of one query: nodes are collected ring by ring, then exact lengths are computed.
//
//   limit := infinity, which the least length is never above
//   for the sample's cell, then ring by ring of cells around it:
//   [1]   collect the nodes whose distance is no more than the limit
//   [2]   look up bounds of their lengths, all at once; limit := the least upper bound so far
//   [3]   the nodes whose lower bound is no more than the limit are candidates
//   [4]   leave if every cell further out is further away than the limit
//   [5] by increasing lower bound, as long as that is no more than the least length so far:
//       compute the exact length
//
// For k nodes the limit is the k-th least of the upper bounds, and [5] keeps the k least lengths.
template <typename Kept>
class NearestSearch {
 public:
  NearestSearch(const Nodes& nodes, const Pose& sample, Kept& kept)
      : all_(nodes),
        kept_(kept),
        sample_(sample),
        heading_(static_cast<float>(wrap_angle(sample.heading))),
        centre_(nodes.cell_of(sample)) {}

  void run() {
    for (std::int32_t ring = 0;; ++ring) {
      collect_ring(ring);  // [1]
      find_candidates();   // [2] [3]
      const double further = beyond(ring);
      if (further > static_cast<double>(kept_.limit()) || further == infinity) break;  // [4]
    }
  }

 private:
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
      const float reach = kept_.limit() * (1 + simd::noise);
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
    kept_.take(first(low_), first(high_), std::span(node_).first(count_));
    count_ = 0;
  }

  std::span<float> first(auto& column) const { return std::span(column).first(count_); }

  // Lower bound on the distance of all nodes outside this ring and those within it [m]. Infinity if
  // no cell is outside.
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

  static constexpr std::size_t batch = 256;

  const Nodes& all_;
  Kept& kept_;
  const Pose& sample_;
  float heading_;
  GridCell centre_;
  std::size_t count_ = 0;  // Number of nodes in the batch.
  std::array<float, batch> x_, y_, node_heading_, low_, high_;
  std::array<std::int32_t, batch> node_;
};

void expect_finite(const char* name, const Pose& pose) {
  if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.heading)) {
    throw InputError(name, "is not finite");
  }
}

}  // namespace

struct NearestNodes::Grid : Nodes {};

NearestNodes::NearestNodes(double radius) : grid_(std::make_unique<Grid>(Grid{{{}, radius}})) {
  base::require_radius(radius);
}
NearestNodes::~NearestNodes() = default;
NearestNodes::NearestNodes(const NearestNodes& other)
    : grid_(std::make_unique<Grid>(*other.grid_)) {}
NearestNodes& NearestNodes::operator=(const NearestNodes& other) {
  return *this = NearestNodes(other);
}
NearestNodes::NearestNodes(NearestNodes&& other) noexcept = default;
NearestNodes& NearestNodes::operator=(NearestNodes&& other) noexcept = default;

void NearestNodes::add(const Pose& pose) {
  expect_finite("pose", pose);
  grid_->add(pose);
}

void NearestNodes::remove(std::int32_t node) {
  base::require(grid_->holds(node), "node", node, "one that is there");
  grid_->remove(node);
}

std::size_t NearestNodes::size() const noexcept { return grid_->count; }

std::optional<NearestNode> NearestNodes::nearest(const Pose& sample) const {
  expect_finite("sample", sample);
  if (grid_->count == 0) return std::nullopt;
  One kept(*grid_, sample);
  NearestSearch(*grid_, sample, kept).run();
  return kept.result();  // [5]
}

std::vector<NearNode> NearestNodes::nearest(const Pose& sample, const NearWanted& wanted) const {
  expect_finite("sample", sample);
  if (grid_->count == 0 || wanted.count == 0) return {};
  Several kept(*grid_, sample, wanted);
  NearestSearch(*grid_, sample, kept).run();
  return kept.in_order();
}

std::vector<std::int32_t> NearestNodes::nearest_in_any_order(const Pose& sample,
                                                             const NearWanted& wanted) const {
  expect_finite("sample", sample);
  if (grid_->count == 0 || wanted.count == 0) return {};
  Several kept(*grid_, sample, wanted);
  NearestSearch(*grid_, sample, kept).run();
  return kept.in_any_order();
}

}  // namespace vandplan
