// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/rotation.h"

#include <algorithm>

namespace vandplan::anytime {
namespace {

constexpr std::int64_t first_turn = 1024;    // expansions of the first turn of the coarsest search
constexpr std::int64_t max_nodes = 100'000;  // nodes of one search

}  // namespace

Rotation::Rotation(const LocalPose& root, const LocalPose& target, const DrivenBeside& beside,
                   std::span<const LatticeOptions> searches, std::int64_t turn, const Guide& guide,
                   Connector& connector)
    : turn_(turn), left_(std::max(first_turn, turn)) {
  for (const LatticeOptions& options : searches) {
    lattices_.emplace_back(std::in_place, root, target, beside, options, guide, connector);
  }
}

// Finds the next search that has not ended; false if there is none.
bool Rotation::begin_turn() {
  for (std::size_t tried = 0; tried < lattices_.size(); ++tried) {
    current_ = (current_ + 1) % lattices_.size();
    left_ = turn_;
    if (lattices_[current_]) return true;
  }
  finished_ = true;
  return false;
}

bool Rotation::step(double cutoff) {
  if (left_ == 0 && !begin_turn()) return false;
  --left_;
  std::optional<Lattice>& lattice = lattices_[current_];
  if (lattice->is_exhausted() || lattice->size() > max_nodes) {
    lattice.reset();
    left_ = 0;
    return false;
  }
  lattice->set_cutoff(cutoff);
  return lattice->step();
}

std::int64_t Rotation::size() const {
  std::int64_t sum = 0;
  for (const std::optional<Lattice>& lattice : lattices_) sum += lattice ? lattice->size() : 0;
  return sum;
}

}  // namespace vandplan::anytime
