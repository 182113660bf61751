// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long is the shortest way over a lattice to one vertex, where nothing stands in the way?
//
// Bergman's table of costs-to-go, as a ball instead of a box: it holds every vertex whose way is no
// longer than `most`, so that what it lacks is known to be further. docs/algorithms/lattice.md,
// "Table".

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "vandplan/primitives.h"

namespace vandplan::search {

/// A vertex of a lattice.
struct Vertex {
  std::int32_t x = 0;        ///< [steps]
  std::int32_t y = 0;        ///< [steps]
  std::int32_t heading = 0;  ///< index
  bool operator==(const Vertex&) const = default;
};

/// Lengths of the shortest ways over the primitives to the vertex at the origin whose heading is
/// nearest to 0.
class LatticeTable {
 public:
  /// Asks `is_interrupted` about once in a tenth of a millisecond; `is_whole` is false after a yes.
  LatticeTable(const Primitives& primitives, const std::function<bool()>& is_interrupted);

  [[nodiscard]] bool is_whole() const noexcept { return is_whole_; }
  /// The way from the vertex [m], rounded down; `most` where it is longer than that.
  [[nodiscard]] double length_from(const Vertex& vertex) const noexcept {
    const std::int32_t x = vertex.x + reach_;
    const std::int32_t y = vertex.y + reach_;
    const std::int32_t side = 2 * reach_ + 1;
    if (static_cast<std::uint32_t>(x) >= static_cast<std::uint32_t>(side) ||
        static_cast<std::uint32_t>(y) >= static_cast<std::uint32_t>(side)) {
      return most_;
    }
    return static_cast<double>(lengths_[index_of(vertex)]);
  }
  /// No way that is longer than this is told from another one [m].
  [[nodiscard]] double most() const noexcept { return most_; }
  /// Of how many vertices it knows the way.
  [[nodiscard]] std::int64_t size() const noexcept { return size_; }

 private:
  [[nodiscard]] std::size_t index_of(const Vertex& vertex) const noexcept {
    const std::int32_t side = 2 * reach_ + 1;
    return static_cast<std::size_t>(((vertex.y + reach_) * side + vertex.x + reach_) * headings_ +
                                    vertex.heading);
  }

  std::int32_t headings_;
  std::int32_t reach_;          // in x and y [steps]
  double most_;                 // [m]
  std::vector<float> lengths_;  // [m]
  std::int64_t size_ = 0;
  bool is_whole_ = false;
};

/// The heading that is nearest to 0, as an index.
[[nodiscard]] std::int32_t heading_ahead(const Primitives& primitives);

/// The table of primitives, kept with them. Null if making it was interrupted.
[[nodiscard]] std::shared_ptr<const LatticeTable> table_of(
    const Primitives& primitives, const std::function<bool()>& is_interrupted);

}  // namespace vandplan::search
