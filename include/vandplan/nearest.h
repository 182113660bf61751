// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which of many nodes is nearest by Reeds-Shepp length?
//
// The answer is that of comparing all exact lengths; few of them are computed:
// docs/algorithms/nearest.md.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan {

/// The node that a query found.
struct NearestNode {
  std::int32_t node = 0;          ///< counted from 0 in the order of `add`
  double length = 0.0;            ///< `reeds_shepp_length` between it and the sample [m]
  std::int64_t exact_solves = 0;  ///< lengths that were computed to find it
};

/// One of the nodes that a query for several found.
struct NearNode {
  std::int32_t node = 0;  ///< counted from 0 in the order of `add`
  double length = 0.0;    ///< `reeds_shepp_length` between it and the sample [m]
  bool operator==(const NearNode&) const = default;
};

/// Which nodes a query for several wants.
struct NearWanted {
  std::size_t count = std::numeric_limits<std::size_t>::max();  ///< at most
  double within = std::numeric_limits<double>::infinity();      ///< no longer than this [m]; >= 0
};

/// Nodes in a grid over x and y, remade whenever their number has doubled. Copies are independent
/// of each other. Queries may run in many threads at once; the one for the nearest node allocates
/// nothing.
class NearestNodes {
 public:
  /// No nodes yet, for a vehicle with that turning radius [m]. Throws InputError unless it is
  /// finite and > 0.
  explicit NearestNodes(double radius);
  ~NearestNodes();
  NearestNodes(const NearestNodes& other);
  NearestNodes& operator=(const NearestNodes& other);
  /// What was moved from may only be destroyed or assigned to.
  NearestNodes(NearestNodes&& other) noexcept;
  NearestNodes& operator=(NearestNodes&& other) noexcept;

  /// Adds a node; its heading may be any angle [rad]. Throws InputError unless its numbers are
  /// finite.
  void add(const Pose& pose);

  /// Takes out a node. The numbers of the others stay; its own is not used again. Throws InputError
  /// if it is not there.
  void remove(std::int32_t node);

  /// The node with the least exact length to the sample; ties go to the older node. None if there
  /// are no nodes.
  [[nodiscard]] std::optional<NearestNode> nearest(const Pose& sample) const;

  /// The nodes with the least exact lengths to the sample, by length; ties go to the older node.
  [[nodiscard]] std::vector<NearNode> nearest(const Pose& sample, const NearWanted& wanted) const;

  /// The nodes that `nearest(sample, wanted)` has, in no order: sooner, for few lengths have to
  /// be computed.
  [[nodiscard]] std::vector<std::int32_t> nearest_in_any_order(const Pose& sample,
                                                               const NearWanted& wanted) const;

  /// How many nodes there are.
  [[nodiscard]] std::size_t size() const noexcept;

 private:
  struct Grid;
  std::unique_ptr<Grid> grid_;
};

}  // namespace vandplan
