// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does it cost, approximately, to drive from one pose to all others, in any direction and
// gear?
//
// Method: docs/algorithms/anytime.md, "Survey".

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "search/clearance_raster.h"
#include "search/guide.h"
#include "vandplan/search.h"

namespace vandplan::search {

/// Resolution of a field.
struct FieldOptions {
  int headings = 24;   ///< Cells of a full turn; each arc turns by one cell.
  double cell = 0.25;  ///< Side of a position cell [turning radii].
};

/// Costs of ways from a root, made of arcs and lines of fixed lengths. Each cell of place, heading
/// and gear keeps one pose (Hybrid A*, Dolgov et al. 2010). It is fast enough to cover a whole box:
/// tables replace sines and the heap, numbers are single precision, and a raster tells where an
/// exact collision check is needless. Poses are dropped that cost at least as much as a pose in the
/// other gear plus a gear change.
class DriveField {
 public:
  /// Pose that was reached.
  struct Node {
    float x, y;
    float cost;              // Cost of the way from the root [m].
    float near;              // Cost that small clearance adds to a metre here.
    std::int32_t parent;     // Parent node; `none` for the root.
    std::int16_t heading;    // Steps of a turn, relative to the root's heading.
    std::int8_t side, gear;  // Step that leads here: side 1 left, 0 straight, -1 right.
    bool is_open;            // Whether that step is known to be free.
  };
  static constexpr std::int32_t none = -1;

  /// Ways begin at the root, after driving in gear `driven`. Ways that cost more than `most` in
  /// total are ignored [m]. The connector must have the cost rule of this direction. Connector and
  /// raster must outlive the field, and the raster must be complete.
  DriveField(Connector& connector, ClearanceRaster& raster, const Bounds& box,
             const FieldOptions& options, const Pose& root, GearSign driven, double most);

  /// Sets the cost-to-go: the estimate of a guide, or the costs of a field of the opposite
  /// direction. That field needs the same box and options; where it has no pose, there is no way.
  /// Must be called once before `step`.
  void look_towards(const Guide& guide);
  void look_towards(const DriveField& opposite);

  /// Expands one pose. Returns its node, or `none` if the pose was of no use.
  std::int32_t step();
  /// Whether no pose is left to expand.
  [[nodiscard]] bool is_exhausted() const noexcept { return waiting_ == 0; }
  /// From now on ignores ways that cost more than `cost` in total [m].
  void set_cutoff(double cost) noexcept { cutoff_ = std::min(cutoff_, static_cast<float>(cost)); }
  /// Approximate total cost of the cheapest way through a pose left to expand [m]. Requires such a
  /// pose.
  [[nodiscard]] double least_cost();

  [[nodiscard]] const Node& node(std::int32_t id) const {
    return nodes_[static_cast<std::size_t>(id)];
  }
  [[nodiscard]] LocalPose pose(const Node& node) const;
  /// Segment that leads from a node's parent to the node.
  [[nodiscard]] Segment step_to(const Node& node) const;

  /// Continuation of a way of another field in this field, which has the opposite direction.
  struct Onward {
    std::int32_t node = none;
    /// Cost to this field's root [m], with a gear change if needed.
    float cost = std::numeric_limits<float>::infinity();
  };
  [[nodiscard]] Onward onward(const DriveField& other, const Node& node) const;

 private:
  struct State {
    float cost = std::numeric_limits<float>::infinity();
    std::int32_t node = none;  // Node that was closed in this state.
  };
  struct Entry {
    float rank;
    std::int32_t node;
  };
  /// Motion from one heading by an arc or a line.
  struct Step {
    float x, y;
    float length, cost;
    std::int16_t heading;  // Heading at the end.
    std::int8_t side, gear;
  };

  [[nodiscard]] std::int64_t cell_of(float x, float y) const noexcept;
  [[nodiscard]] std::size_t state_of(std::int64_t cell, int heading, int gear) const noexcept;
  [[nodiscard]] float to_go(const Node& node, std::int64_t cell);
  void push(const Entry& entry);
  void find_front();
  [[nodiscard]] float clearance_at(const Node& node) noexcept;
  [[nodiscard]] float near_at(float clearance) const noexcept;
  [[nodiscard]] bool enter(Node& node, float& rank);
  void expand(std::int32_t id);

  Connector& connector_;
  ClearanceRaster& raster_;
  Pose root_;
  int headings_;
  double turn_;
  float x_min_, y_min_, cells_of_metre_, buckets_of_metre_;
  std::int64_t columns_, rows_;
  /// Prices [m]: a gear change; turning the wheels from straight to full lock.
  float gear_change_, turning_;
  float clearance_weight_, clearances_of_metre_;
  std::vector<Step> steps_;  // Three steps in each allowed gear, for each heading.
  std::vector<float> cos_, sin_;
  const Guide* guide_ = nullptr;
  /// Guide's estimate at the centre of each cell; negative: not asked yet.
  std::vector<float> guided_;
  const DriveField* opposite_ = nullptr;
  float cutoff_;
  std::vector<Node> nodes_;
  std::vector<State> states_;
  std::vector<std::vector<Entry>> buckets_;  // Entries by rank.
  std::size_t front_ = 0;                    // No waiting entry is in a bucket below.
  std::size_t waiting_ = 0;
};

}  // namespace vandplan::search
