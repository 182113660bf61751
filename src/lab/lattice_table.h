// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long is the shortest way over a lattice to one vertex, without obstacles?
//
// Bergman's table of costs-to-go, as a ball instead of a box: it holds every vertex whose way is at
// most `most` long. So a vertex that is missing is known to be further away. Method:
// docs/algorithms/lattice.md, "Table".

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "vandplan/graphs.h"

namespace vandplan::search {

/// A vertex of a lattice.
struct Vertex {
  std::int32_t x = 0;        ///< x on the grid [steps]
  std::int32_t y = 0;        ///< y on the grid [steps]
  std::int32_t heading = 0;  ///< index of the heading
  bool operator==(const Vertex&) const = default;
};

/// Lengths of the shortest ways over the primitives to the vertex at the origin whose heading is
/// nearest to 0.
class LatticeTable {
 public:
  /// Computes the table. It asks `is_interrupted` about every 0.1 ms and stops at a yes; then
  /// `is_whole` is false.
  LatticeTable(const Primitives& primitives, const std::function<bool()>& is_interrupted);

  /// Whether the table was computed to the end.
  [[nodiscard]] bool is_whole() const noexcept { return is_whole_; }
  /// Length of the shortest way from the vertex [m], rounded down; `most` if it is longer than
  /// `most`.
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
  /// Largest length in the table [m]; longer ways have this length, too.
  [[nodiscard]] double most() const noexcept { return most_; }
  /// Number of vertices whose way is known.
  [[nodiscard]] std::int64_t size() const noexcept { return size_; }

 private:
  [[nodiscard]] std::size_t index_of(const Vertex& vertex) const noexcept {
    const std::int32_t side = 2 * reach_ + 1;
    return static_cast<std::size_t>(((vertex.y + reach_) * side + vertex.x + reach_) * headings_ +
                                    vertex.heading);
  }

  std::int32_t headings_;
  std::int32_t reach_;          // largest |x| and |y| [steps]
  double most_;                 // largest length [m]
  std::vector<float> lengths_;  // lengths of the ways from all vertices [m]
  std::int64_t size_ = 0;
  bool is_whole_ = false;
};

/// Index of the heading that is nearest to 0.
[[nodiscard]] std::int32_t heading_ahead(const Primitives& primitives);

/// The table of primitives, which is kept with the primitives. Null if making it was interrupted.
[[nodiscard]] std::shared_ptr<const LatticeTable> table_of(
    const Primitives& primitives, const std::function<bool()>& is_interrupted);

}  // namespace vandplan::search
