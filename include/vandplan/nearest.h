// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which of many nodes is nearest by Reeds-Shepp length?
//
// The answer is that of comparing all exact lengths; few of them are computed:
// docs/algorithms/nearest.md.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "vandplan/geometry.h"

namespace vandplan {

/// The node that a query found.
struct NearestNode {
  std::int32_t node = 0;          ///< counted from 0 in the order of `add`
  double length = 0.0;            ///< `reeds_shepp_length` between it and the sample [m]
  std::int64_t exact_solves = 0;  ///< lengths that were computed to find it
};

/// Nodes in a grid over x and y, remade whenever their number has doubled. Copies are independent
/// of each other. Queries allocate nothing and may run in many threads at once.
class NearestNodes {
 public:
  /// No nodes yet, for a vehicle whose turning `radius` is > 0 [m].
  explicit NearestNodes(double radius);
  ~NearestNodes();
  NearestNodes(const NearestNodes& other);
  NearestNodes& operator=(const NearestNodes& other);
  /// What was moved from may only be destroyed or assigned to.
  NearestNodes(NearestNodes&& other) noexcept;
  NearestNodes& operator=(NearestNodes&& other) noexcept;

  /// Adds a node. Its numbers [m, rad] are finite; its heading may be any angle.
  void add(const Pose& pose);

  /// The node with the least exact length to the sample; ties go to the older node. None if there
  /// are no nodes.
  [[nodiscard]] std::optional<NearestNode> nearest(const Pose& sample) const;

  /// How many nodes were added.
  [[nodiscard]] std::size_t size() const noexcept;

 private:
  struct Grid;
  std::unique_ptr<Grid> grid_;
};

}  // namespace vandplan
