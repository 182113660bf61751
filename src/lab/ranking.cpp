// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/ranking.h"

#include <algorithm>
#include <limits>

namespace vandplan::search {
namespace {

bool is_before(const Candidate& a, const Candidate& b) {
  return a.rank != b.rank ? a.rank < b.rank : a.id < b.id;
}

}  // namespace

Ranking::Ranking(const Tree& tree, double radius, std::size_t capacity, Estimate estimate,
                 RankBy by, GearSign only)
    : tree_(tree), radius_(radius), estimate_(estimate), by_(by), only_(only) {
  if (only == 0 && by == RankBy::length && estimate == Estimate::reeds_shepp) {
    exact_.emplace(radius).add(tree.pose(0));
  } else {
    ranks_.resize(capacity);
  }
}

void Ranking::add_last() {
  if (exact_) exact_->add(tree_.pose(static_cast<NodeId>(tree_.size()) - 1));
}

const std::vector<Candidate>& Ranking::first(std::size_t count, const Pose& sample) {
  best_.clear();
  if (exact_) {
    look_up(count, sample);
  } else {
    rank_all(count, sample);
  }
  return best_;
}

const std::vector<Candidate>& Ranking::first(std::size_t count, std::span<const float> lengths) {
  best_.clear();
  std::ranges::copy(lengths, ranks_.begin());
  choose(count);
  return best_;
}

void Ranking::look_up(std::size_t count, const Pose& sample) {
  if (count == 1) {
    const auto [node, length, solves] = *exact_->nearest(sample);
    best_.push_back({static_cast<float>(length), node});
    exact_solves_ += solves;
    return;
  }
  for (const auto& [node, length] : exact_->nearest(sample, {.count = count})) {
    best_.push_back({static_cast<float>(length), node});
  }
  exact_solves_ += static_cast<std::int64_t>(best_.size());
}

void Ranking::rank_all(std::size_t count, const Pose& sample) {
  const std::span<float> ranks(ranks_.data(), tree_.size());
  if (only_ == 0) {
    estimate_lengths(estimate_, tree_, sample, radius_, ranks);
  } else {
    estimate_lengths_in(only_, estimate_, tree_, sample, radius_, ranks);
  }
  choose(count);
}

/// Fills `best_` with the first `count` nodes. `ranks_` holds the length from each node.
void Ranking::choose(std::size_t count) {
  const std::span<float> ranks(ranks_.data(), tree_.size());
  if (by_ == RankBy::total_cost) {
    for (std::size_t i = 0; i < ranks.size(); ++i) ranks[i] += tree_.cost_to_come()[i];
  }
  // `best_` is a heap with its worst node in front, until it is sorted.
  float limit = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    if (ranks[i] >= limit) continue;
    if (best_.size() == count) {
      std::pop_heap(best_.begin(), best_.end(), is_before);
      best_.pop_back();
    }
    best_.push_back({ranks[i], static_cast<NodeId>(i)});
    std::push_heap(best_.begin(), best_.end(), is_before);
    if (best_.size() == count) limit = best_.front().rank;
  }
  std::sort_heap(best_.begin(), best_.end(), is_before);
}

}  // namespace vandplan::search
