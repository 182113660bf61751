// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does it cost, about, to drive from a pose to everywhere else, in any direction and gear?
//
// Method: docs/algorithms/anytime.md, "Survey".

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "search/guide.h"
#include "search/room.h"
#include "vandplan/search.h"

namespace vandplan::search {

/// How fine a field is.
struct FieldOptions {
  int headings = 24;   ///< cells of a full turn; an arc turns by one of them
  double cell = 0.25;  ///< side of a position cell [turning radii]
  /// How often what a guide says counts: beyond 1 fewer poses are looked at, and dearer ways found.
  double greediness = 1.0;
};

/// Costs of ways of arcs and lines of one length from a root, one pose for each cell of place,
/// heading and gear (Hybrid A*, Dolgov et al. 2010). Lean enough to look everywhere: tables in
/// place of sines and of a heap, single precision, and a raster that tells where an exact check is
/// needless. A pose that costs no less than one in the other gear and a change is left out.
class DriveField {
 public:
  /// A pose that was reached.
  struct Node {
    float x, y;
    float cost;              // of getting there [m]
    float near;              // what being near things adds to a metre there
    std::int32_t parent;     // `none` for the root
    std::int16_t heading;    // steps of a turn, from that of the root on
    std::int8_t side, gear;  // of the step that leads there: 1 left, 0 straight on, -1 right
    bool is_open;            // nothing is in the way of that step
  };
  static constexpr std::int32_t none = -1;

  /// Ways begin at the root after something was driven in that gear; those that cost more than
  /// `most` in all are of no interest [m]. The connector has the rule of their direction. It and
  /// the room, which is complete, outlive the field.
  DriveField(Connector& connector, Room& room, const Bounds& box, const FieldOptions& options,
             const Pose& root, GearSign driven, double most);

  /// What going on costs: what the guide says, or what is known to a field of the other direction,
  /// with the same box and options; where that has not been, there is no way. To be said first.
  void look_towards(const Guide& guide);
  void look_towards(const DriveField& opposite);

  /// Goes on by one pose: the node, or `none` if that was of no use.
  std::int32_t step();
  /// No way is left.
  [[nodiscard]] bool is_exhausted() const noexcept { return waiting_ == 0; }
  /// Ways that cost more in all are of no interest any more [m].
  void set_cutoff(double cost) noexcept { cutoff_ = std::min(cutoff_, static_cast<float>(cost)); }
  /// About what the cheapest way costs in all that is left; there is one [m].
  [[nodiscard]] double least_cost();

  [[nodiscard]] const Node& node(std::int32_t id) const {
    return nodes_[static_cast<std::size_t>(id)];
  }
  [[nodiscard]] LocalPose pose(const Node& node) const;
  /// The step that leads to a node.
  [[nodiscard]] Segment step_to(const Node& node) const;

  /// Where in this field a way of the other direction goes on from a node of another field.
  struct Onward {
    std::int32_t node = none;
    float cost = std::numeric_limits<float>::infinity();  // with a change of gear, if it takes one
  };
  [[nodiscard]] Onward onward(const DriveField& other, const Node& node) const;

 private:
  struct State {
    float cost = std::numeric_limits<float>::infinity();
    std::int32_t node = none;  // that was closed there
  };
  struct Entry {
    float rank;
    std::int32_t node;
  };
  /// A step from one heading.
  struct Step {
    float x, y;
    float length, cost;
    std::int16_t heading;  // that it leads to
    std::int8_t side, gear;
  };

  [[nodiscard]] std::int64_t cell_of(float x, float y) const noexcept;
  [[nodiscard]] std::size_t state_of(std::int64_t cell, int heading, int gear) const noexcept;
  [[nodiscard]] float to_go(const Node& node, std::int64_t cell);
  void push(const Entry& entry);
  void find_front();
  [[nodiscard]] float room_at(const Node& node) noexcept;
  [[nodiscard]] float near_at(float room) const noexcept;
  [[nodiscard]] bool enter(Node& node, float& rank);
  void expand(std::int32_t id);

  Connector& connector_;
  Room& room_;
  Pose root_;
  int headings_;
  double turn_;
  float x_min_, y_min_, cells_of_metre_, buckets_of_metre_, greediness_;
  std::int64_t columns_, rows_;
  float gear_change_, turning_;  // prices: of a change of gear, of full lock from straight on
  float clearance_weight_, clearances_of_metre_;
  std::vector<Step> steps_;  // three in each gear from each heading
  std::vector<float> cos_, sin_;
  const Guide* guide_ = nullptr;
  std::vector<float> guided_;  // what the guide says in the middle of a cell; negative: not asked
  const DriveField* opposite_ = nullptr;
  float cutoff_;
  std::vector<Node> nodes_;
  std::vector<State> states_;
  std::vector<std::vector<Entry>> buckets_;  // by rank
  std::size_t front_ = 0;                    // none of a lower rank waits
  std::size_t waiting_ = 0;
};

}  // namespace vandplan::search
