// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <limits>
#include <optional>

#include "planners/anytime/sources.h"

namespace vandplan::anytime {
namespace {

constexpr std::int64_t first_turn = 1024;    // expansions of the first turn of the coarsest search
constexpr std::int64_t max_nodes = 100'000;  // nodes of one search

class Rotation final : public Source {
 public:
  Rotation(const LocalPose& root, const LocalPose& target, const DrivenBeside& beside,
           std::span<const LatticeOptions> searches, std::int64_t turn, const Guide& guide,
           Connector& connector)
      : turn_(turn), left_(std::max(first_turn, turn)) {
    for (const LatticeOptions& options : searches) {
      lattices_.emplace_back(std::in_place, root, target, beside, options, guide, connector);
    }
  }

  [[nodiscard]] bool step() override;
  [[nodiscard]] Route route() const override { return lattices_[current_]->route(); }
  [[nodiscard]] bool has_work() const override { return !finished_; }
  void set_cutoff(double cost) override { cutoff_ = cost; }
  /// Nodes of all searches. The connector is counted by its owner.
  [[nodiscard]] Counts counts() const override;

 private:
  bool begin_turn();

  std::vector<std::optional<Lattice>> lattices_;  // from coarse to fine; none: the search has ended
  std::size_t current_ = 0;                       // index of the search whose turn it is
  std::int64_t turn_;                             // expansions of a turn
  std::int64_t left_;                             // expansions left in this turn
  double cutoff_ = std::numeric_limits<double>::infinity();
  bool finished_ = false;
};

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

bool Rotation::step() {
  if (left_ == 0 && !begin_turn()) return false;
  --left_;
  std::optional<Lattice>& lattice = lattices_[current_];
  if (lattice->is_exhausted() || lattice->size() > max_nodes) {
    lattice.reset();
    left_ = 0;
    return false;
  }
  lattice->set_cutoff(cutoff_);
  return lattice->step();
}

Counts Rotation::counts() const {
  Counts sum;
  for (const std::optional<Lattice>& lattice : lattices_)
    sum.nodes += lattice ? lattice->size() : 0;
  return sum;
}

}  // namespace

std::unique_ptr<Source> rotation(const LocalPose& root, const LocalPose& target,
                                 const DrivenBeside& beside,
                                 std::span<const LatticeOptions> searches, std::int64_t turn,
                                 const Guide& guide, Connector& connector) {
  return std::make_unique<Rotation>(root, target, beside, searches, turn, guide, connector);
}

}  // namespace vandplan::anytime
