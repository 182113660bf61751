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
#include "planners/commands/closer.h"
#include "planners/commands/wheels.h"
#include "search/grid_distance.h"
#include "vandplan/random.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"
#include "vandplan/vehicle.h"
#include "vehicle/hitch_motion.h"

namespace vandplan::rig {

using namespace commands;

using search::Connector, search::CostRule, search::GearSign;

/// Fineness and greediness of one search.
struct Fineness {
  double step = 1.0;    ///< length of a step where there is room [m]
  double weight = 2.0;  ///< weight of the cost-to-go
  /// Number of levels, at most 4. Each level halves the step where half as much room is left.
  int levels = 1;
  std::size_t most_nodes = 100000;  ///< nodes at which the search ends
};

/// Ways around obstacles from all places to both ends, for all searches of a task.
struct Guides {
  explicit Guides(const Task& task);

  search::GridDistance to_goal, to_start;
};

/// A command as if wheels turned at once, and its effect on a rig.
struct Primitive {
  Primitive(const Vehicle& vehicle, const Command& of) noexcept;

  Command command;
  Pose moved;                    ///< pose of the tractor behind the command, seen from before it
  vehicle::HitchAlongArc hitch;  ///< change of the hitch angle
};

/// Two searches, one from the start and one back from the goal, that try to meet.
class RigSearch {
 public:
  /// The task has a vehicle with a trailer; task, rule and guides outlive the search.
  RigSearch(const Task& task, const CostRule& rule, const Guides& guides, const Fineness& fineness);

  /// Ignores drives that cost `cost` or more from now on [m].
  void set_cutoff(double cost) { cutoff_ = cost; }

  /// Expands one state. False if nothing is left to expand, or there are `most_nodes` nodes.
  bool step();

  /// The commands of the exact drive that was found since the last call; none if none was found.
  [[nodiscard]] std::optional<std::vector<Command>> take_found();

  [[nodiscard]] std::int64_t nodes() const;
  [[nodiscard]] std::int64_t checks() const { return checks_; }
  /// Gaps that were to be closed, and states that were steered to.
  [[nodiscard]] std::int64_t solves() const { return closings_ + bridges_; }

 private:
  /// State that was reached, with its command from the parent.
  struct Node {
    State state;
    Command command;        // command from the parent
    search::Driven driven;  // gear and curvature at the end of the command
    double cost;            // cost-to-come [m]
    double to_go;           // estimated cost-to-go [m]
    std::int32_t parent;    // index of the parent; -1 for the root
    bool is_reached;        // whether the command from the parent is known to be free
    int level;              // level of the cell; once expanded, of the steps from here
  };
  /// Best node of a cell of states.
  struct Cell {
    double least = 1e300;    // least cost-to-come of a node
    std::int32_t node = -1;  // index of the reached node; -1: none
  };
  /// A node while its children are added.
  struct Parent {
    Parent(std::int32_t of, const Node& with);

    std::int32_t id;
    Node node;
    base::SinCos heading, fold;  // sines and cosines of the node's heading and hitch angle
  };
  /// Entry of the open list.
  struct Entry {
    double rank;
    std::int32_t node;
    /// Whether `other` comes first: a std::priority_queue has its greatest entry in front.
    bool operator<(const Entry& other) const {
      return rank != other.rank ? rank > other.rank : node < other.node;
    }
  };
  /// One of the two searches.
  struct Side {
    CostRule rule;  // prices of driving from the root
    State root, target;
    Pose target_trailer;
    const search::GridDistance* grid;
    std::vector<Node> nodes;
    std::priority_queue<Entry> open = {};
    std::unordered_map<std::uint64_t, Cell> cells = {};
    std::int32_t nearest = 0;  // reached node with the least cost-to-go
    std::int32_t latest = 0;   // reached node that was expanded last
  };

  [[nodiscard]] Side side_from(const State& root, const State& target, const search::Driven& before,
                               const CostRule& rule, const search::GridDistance& grid) const;
  [[nodiscard]] std::uint64_t key_of(const State& state, int level) const;
  [[nodiscard]] int level_at(const State& state) const;
  /// Estimate and lower bound of the cost-to-go [m].
  struct ToGo {
    double guess, least;
  };
  [[nodiscard]] ToGo to_go(const Side& side, const State& state) const;
  bool expand(std::size_t which);
  void add_children(Side& side, std::int32_t id);
  void add(Side& side, const Parent& parent, Primitive primitive);
  [[nodiscard]] State after(const Parent& parent, const Primitive& primitive,
                            const Obeyed& obeyed) const;
  [[nodiscard]] bool turn_in_time(const search::Driven& here, const search::Driven& there,
                                  int level) const;
  void meet(std::size_t which, std::int32_t id);
  [[nodiscard]] std::vector<Segment> branch(const Side& side, std::int32_t from,
                                            std::int32_t to) const;
  [[nodiscard]] bool is_in_sight(const Pose& from, const Pose& to);
  void bridge(std::size_t which, std::int32_t id);
  [[nodiscard]] static std::int32_t steps_before(const Side& side, std::int32_t id, int steps);
  void join(std::int32_t forward, std::int32_t backward, std::span<const Segment> between = {});
  [[nodiscard]] bool is_free(const Side& side, const State& from,
                             std::span<const Segment> segments);

  const Task& task_;
  Wheels wheels_;
  Closer closer_;
  /// Exact steering; none for vehicles that it does not support.
  std::optional<RigSteering> steering_;
  Fineness fineness_;
  double trailer_radius_;  // turning radius that suits the trailer [m]
  /// Cells of places, headings and hitch angles at level 0.
  double cell_, heading_cell_, angle_cell_;
  std::vector<std::vector<Primitive>> primitives_;  // primitives of each level
  std::array<Side, 2> sides_;
  std::size_t turn_ = 0;
  double cutoff_ = std::numeric_limits<double>::infinity();
  std::optional<std::vector<Command>> found_;
  std::int64_t checks_ = 0;
  std::int64_t closings_ = 0;
  std::int64_t expansions_ = 0;
  std::int64_t bridges_ = 0;
  std::int64_t out_of_sight_ = 0;  // bridges between places out of sight
};

/// Unit of the steps of a search [m]: about the distance after which a trailer follows.
[[nodiscard]] double search_unit(const Vehicle& vehicle);

/// Exact steering of the vehicle; none for vehicles that it does not support.
[[nodiscard]] std::optional<RigSteering> steering_of(const Vehicle& vehicle);

/// Radius of the tractor on the sharpest circle that the rig can hold [m].
[[nodiscard]] double turning_radius(const Vehicle& vehicle);

}  // namespace vandplan::rig
