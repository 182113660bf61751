// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which of many nodes is nearest by Reeds-Shepp length?
//
// The result is that of comparing all exact lengths, but few of them are computed:
// docs/algorithms/nearest.md.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan {

/// The node that a query for one node found.
struct NearestNode {
  std::int32_t node = 0;          ///< number of the node, from 0 in the order of `add`
  double length = 0.0;            ///< `reeds_shepp_length` between node and sample [m]
  std::int64_t exact_solves = 0;  ///< number of lengths that were computed
};

/// One of the nodes that a query for several nodes found.
struct NearNode {
  std::int32_t node = 0;  ///< number of the node, from 0 in the order of `add`
  double length = 0.0;    ///< `reeds_shepp_length` between node and sample [m]
  bool operator==(const NearNode&) const = default;
};

/// Nodes that a query for several nodes wants.
struct NearWanted {
  /// Largest number of nodes.
  std::size_t count = std::numeric_limits<std::size_t>::max();
  /// Largest length to the sample [m]; >= 0.
  double within = std::numeric_limits<double>::infinity();
};

/// Nodes in a grid over x and y, which is rebuilt whenever their number has doubled. Copies are
/// independent of each other. Queries may run in many threads at once. The query for one node
/// allocates nothing. All poses share one frame.
class NearestNodes {
 public:
  /// An empty set for a vehicle with that turning radius [m]. Throws InputError naming "radius"
  /// unless it is finite and > 0.
  explicit NearestNodes(double radius);
  ~NearestNodes();
  NearestNodes(const NearestNodes& other);
  NearestNodes& operator=(const NearestNodes& other);
  /// Moves the nodes. `other` may only be destroyed or assigned to afterwards.
  NearestNodes(NearestNodes&& other) noexcept;
  NearestNodes& operator=(NearestNodes&& other) noexcept;

  /// Adds a node; its heading may be any angle [rad]. Throws InputError naming "pose" unless its
  /// numbers are finite.
  void add(const Pose& pose);

  /// Removes a node. The numbers of the other nodes stay; its number is not used again. Throws
  /// InputError naming "node" if there is no such node.
  void remove(std::int32_t node);

  /// The node with the least exact length to the sample; ties go to the older node. None if there
  /// are no nodes. Throws InputError naming "sample" if it is not finite.
  [[nodiscard]] std::optional<NearestNode> nearest(const Pose& sample) const;

  /// The wanted nodes with the least exact lengths to the sample, by length; ties go to the older
  /// node. Throws InputError naming "sample" if it is not finite.
  [[nodiscard]] std::vector<NearNode> nearest(const Pose& sample, const NearWanted& wanted) const;

  /// Numbers of the nodes that `nearest(sample, wanted)` finds, in no order. It is faster, because
  /// few lengths have to be computed. Throws InputError naming "sample" if it is not finite.
  [[nodiscard]] std::vector<std::int32_t> nearest_in_any_order(const Pose& sample,
                                                               const NearWanted& wanted) const;

  /// Number of nodes that were added and not removed.
  [[nodiscard]] std::size_t size() const noexcept;

 private:
  struct Grid;
  std::unique_ptr<Grid> grid_;
};

}  // namespace vandplan
