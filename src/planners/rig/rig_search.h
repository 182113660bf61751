// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which drive leads a rig to its goal, roughly at first and then exactly?
//
// Method: docs/algorithms/trailers.md.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>
#include <vector>

#include "base/trigonometry.h"
#include "planners/commands/wheels.h"
#include "planners/rig/exact_drive.h"
#include "search/grid_distance.h"
#include "vandplan/random.h"
#include "vandplan/rig.h"
#include "vandplan/rig_steering.h"
#include "vandplan/search.h"
#include "vehicle/hitch_motion.h"

namespace vandplan::rig {

using namespace commands;

using search::Connector, search::CostRule, search::GearSign;

/// How a search looks.
struct Fineness {
  double step = 1.0;    ///< from state to state where there is room [m]
  double weight = 2.0;  ///< of what is still to go
  int levels = 1;       ///< at most 4; with each the step is halved where half as much room is left
  std::size_t most_nodes = 100000;
};

/// Ways around the obstacles, for all searches of a task.
struct Guides {
  explicit Guides(const Task& task);

  search::GridDistance to_goal, to_start;
};

/// A command whose wheels turn at once, and what it does to a rig.
struct Primitive {
  Primitive(const Vehicle& vehicle, const Segment& of) noexcept;

  Segment command;
  Pose moved;  ///< where the tractor is, seen from where it was
  vehicle::HitchAlongArc hitch;
};

/// Two searches, one from the start and one back from the goal, that look for each other.
class RigSearch {
 public:
  /// The task has a vehicle with a trailer; task, rule and guides outlive the search.
  RigSearch(const Task& task, const CostRule& rule, const Guides& guides, const Fineness& fineness);

  /// From now on drives that cost as much are of no interest [m].
  void set_cutoff(double cost) { cutoff_ = cost; }

  /// Expands one state. False when there is nothing left to expand.
  bool step();

  /// The commands of the exact drive that was found, until they are asked for.
  [[nodiscard]] std::optional<std::vector<Segment>> take_found();

  [[nodiscard]] std::int64_t nodes() const;
  [[nodiscard]] std::int64_t checks() const { return checks_; }
  [[nodiscard]] std::int64_t closings() const { return closings_; }
  [[nodiscard]] std::int64_t bridges() const { return bridges_; }

 private:
  struct Node {
    RigState state;
    Segment command;        // at the parent
    search::Driven driven;  // to get here
    double cost;
    double to_go;
    std::int32_t parent;  // -1 for the root
    bool is_reached;      // the way from the parent is free
    int level;            // of the cell, and then of the steps from here
  };
  /// What is known of a cell of states.
  struct Cell {
    double least = 1e300;    // cost of a node
    std::int32_t node = -1;  // that is reached; -1: none
  };
  /// A node while its children are added.
  struct Parent {
    Parent(std::int32_t of, const Node& with);

    std::int32_t id;
    Node node;
    base::SinCos heading, fold;  // of its heading and of its hitch angle
  };
  struct Entry {
    double rank;
    std::int32_t node;
    bool operator<(const Entry& other) const {  // a queue has its greatest in front
      return rank != other.rank ? rank > other.rank : node < other.node;
    }
  };
  /// One of the two searches.
  struct Side {
    CostRule rule;  // of driving from its root
    RigState root, target;
    search::Driven before;  // the wheels at the root
    Pose target_trailer;
    const search::GridDistance* grid;
    std::vector<Node> nodes;
    std::priority_queue<Entry> open = {};
    std::unordered_map<std::uint64_t, Cell> cells = {};
    std::int32_t nearest = 0;  // reached node with the least to go
    std::int32_t latest = 0;   // reached node that was expanded last
  };

  [[nodiscard]] Side side_from(const RigState& root, const RigState& target,
                               const search::Driven& before, const CostRule& rule,
                               const search::GridDistance& grid) const;
  [[nodiscard]] std::uint64_t key_of(const RigState& state, int level) const;
  [[nodiscard]] int level_at(const RigState& state) const;
  /// What is left to drive, about, and at least [m].
  struct ToGo {
    double guess, least;
  };
  [[nodiscard]] ToGo to_go(const Side& side, const RigState& state) const;
  bool expand(std::size_t which);
  void add_children(Side& side, std::int32_t id);
  void add(Side& side, const Parent& parent, Primitive primitive);
  [[nodiscard]] RigState after(const Parent& parent, const Primitive& primitive,
                               const Obeyed& obeyed) const;
  [[nodiscard]] bool turn_in_time(const search::Driven& here, const search::Driven& there,
                                  int level) const;
  void meet(std::size_t which, std::int32_t id);
  [[nodiscard]] std::vector<Segment> branch(const Side& side, std::int32_t id) const;
  [[nodiscard]] bool is_in_sight(const Pose& from, const Pose& to);
  void bridge(std::size_t which, std::int32_t id);
  void join(std::int32_t forward, std::int32_t backward, std::span<const Segment> between = {});
  [[nodiscard]] bool is_free(const RigState& from, std::span<const Segment> segments);

  const Task& task_;
  Wheels wheels_;
  WheelEnds ends_;
  ExactDrive exact_;
  std::optional<RigSteering> steering_;  // none for vehicles that it does not know
  Fineness fineness_;
  double trailer_radius_;  // that a trailer turns with in ease [m]
  double cell_, heading_cell_, angle_cell_;
  std::vector<std::vector<Primitive>> primitives_;  // of each level
  std::array<Side, 2> sides_;
  std::size_t turn_ = 0;
  double cutoff_ = std::numeric_limits<double>::infinity();
  std::optional<std::vector<Segment>> found_;
  std::int64_t checks_ = 0;
  std::int64_t closings_ = 0;
  std::int64_t expansions_ = 0;
  std::int64_t bridges_ = 0;
  std::int64_t out_of_sight_ = 0;  // of the bridges
};

/// About what a rig drives until its trailer follows [m]: the unit of the steps of a search.
[[nodiscard]] double search_unit(const Vehicle& vehicle);

/// Exact steering of the vehicle; none for vehicles that it does not know.
[[nodiscard]] std::optional<RigSteering> steering_of(const Vehicle& vehicle);

/// Of the sharpest circle that the rig can go on driving, of its tractor [m].
[[nodiscard]] double turning_radius(const Vehicle& vehicle);

}  // namespace vandplan::rig
