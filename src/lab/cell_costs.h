// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is the least cost-to-come of each cell that a search has reached?

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace vandplan::search {

/// Least cost-to-come of each cell that was reached; a hash table with open addressing.
class CellCosts {
 public:
  /// Cost of the cell with that key, which is not 0; infinite for a new cell. The reference is
  /// valid until the next call.
  [[nodiscard]] double& cost(std::uint64_t key) {
    if (2 * count_ >= cells_.size()) grow();
    Cell& cell = find(key);
    if (cell.key == 0) {
      cell.key = key;
      ++count_;
    }
    return cell.cost;
  }

 private:
  struct Cell {
    std::uint64_t key = 0;  // key of the cell; 0: the slot is empty
    double cost = std::numeric_limits<double>::infinity();
  };

  [[nodiscard]] Cell& find(std::uint64_t key) {
    const std::size_t mask = cells_.size() - 1;
    std::size_t slot = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15U) >> 20) & mask;
    while (cells_[slot].key != 0 && cells_[slot].key != key) slot = (slot + 1) & mask;
    return cells_[slot];
  }

  void grow() {
    std::vector<Cell> old(4 * cells_.size());
    old.swap(cells_);
    for (const Cell& cell : old) {
      if (cell.key != 0) find(cell.key) = cell;
    }
  }

  std::vector<Cell> cells_ = std::vector<Cell>(4096);
  std::size_t count_ = 0;
};

}  // namespace vandplan::search
