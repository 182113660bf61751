// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which way over a lattice leads to the goal? The search that the lattice planners share.
//
// A* that looks at an edge when its turn comes, not when it is found (Cohen, Phillips and Likhachev
// 2014), with the rounds of ARA* (Likhachev, Gordon and Thrun 2003). docs/algorithms/lattice.md.

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <string>
#include <vector>

#include "lab/lattice_graph.h"
#include "vandplan/planner.h"
#include "vandplan/search.h"

namespace vandplan::lattice {

using namespace search;

/// What guides a search over a lattice to the goal.
struct Guide {
  std::function<double(const Vertex&)> length;  ///< [m]
  bool is_admissible = true;  ///< never above the way over the lattice: what is proven holds
  bool is_consistent = true;  ///< and never falls by more than an edge is long
};

/// The parts of one run; null as graph if making them was interrupted.
struct Ground {
  std::unique_ptr<const LatticeGraph> graph;
  Guide guide;
};

/// Lays the lattice for a task and takes the estimate that complete options name.
[[nodiscard]] Ground ground_of(const Task& task, const PlanOptions& options, const Budget& budget);

/// What no path of the task is shorter than [m]: the shortest path on open ground, less rounding.
[[nodiscard]] double length_on_open_ground(const Task& task);

/// A part of a way that a vehicle drives, and where it ends.
struct Leg {
  Piece piece;
  LocalPose end;
  std::int32_t node = -1;  ///< of the search, at the end; -1: none, it leads to the goal directly
};

/// A search from the start of a task to its goal.
class Search {
 public:
  struct Settings {
    double weight = 1.0;  ///< of the estimate; >= 1
    bool shots = true;    ///< tries the exact piece to the goal from some vertices
    std::size_t max_nodes = 500'000;
    bool keep_tree = false;
  };
  /// A vertex whose turn may come, or has come.
  using Id = std::int32_t;

  /// The task and the parts outlive the search.
  Search(const Task& task, const Ground& ground, Connector& connector, const Settings& settings);

  /// Whether an edge is left that may matter in this round. False ends the round.
  [[nodiscard]] bool has_next();
  /// Takes edges whose turn it is until one is free, at most 32 of them, and goes on from where it
  /// ends. True when that gave a cheaper way to the goal.
  bool step();
  /// Begins a round with another weight: what improved too late in the last one comes first.
  void begin_round(double weight);

  [[nodiscard]] bool is_full() const { return nodes_.size() >= settings_.max_nodes; }
  /// Length of the best way to the goal [m]; infinite if there is none.
  [[nodiscard]] double best() const { return best_; }
  [[nodiscard]] const std::vector<Leg>& best_way() const { return best_way_; }
  /// No way over the lattice costs less [m], if the estimate is admissible.
  [[nodiscard]] double lattice_bound() const;

  /// Where the edge whose turn it is begins; none if there is none. Call after `has_next`.
  [[nodiscard]] std::optional<Id> front() const;
  /// The way from the start to a vertex whose turn has come.
  [[nodiscard]] std::vector<Leg> way_to(Id node) const;

  /// Counters and the tree.
  void report(PlannerAnswer& answer) const;

 private:
  struct Node {
    Vertex vertex;
    Id parent = -1;             // -1: the start
    std::int32_t via = -1;      // position of the move, or of the joint
    std::int32_t round = -1;    // in which its turn came
    std::int32_t shown = -1;    // position in the tree that is kept
    std::int32_t waiting = -1;  // the cheapest edge that leads here and was not looked at
    bool is_free = false;       // the vehicle at the vertex, as far as is known
    double cost = std::numeric_limits<double>::infinity();
    double to_go = 0.0;
  };
  // Those that wait for a vertex are a list: the cheapest one, and the others in any order. Only
  // the cheapest one is in the queue: most of the others are never looked at.
  struct Edge {
    double cost;  // of the way to its end
    Id parent;
    std::int32_t via;
    std::int32_t next;
  };
  struct Entry {
    double rank;
    double cost;
    Id node;
    bool operator<(const Entry& other) const {  // a queue has its greatest in front
      if (rank != other.rank) return rank > other.rank;
      return cost != other.cost ? cost < other.cost : node > other.node;
    }
  };

  [[nodiscard]] Node& node(Id id) { return nodes_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] const Node& node(Id id) const { return nodes_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] Edge& edge(std::int32_t id) { return edges_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] const Edge& edge(std::int32_t id) const {
    return edges_[static_cast<std::size_t>(id)];
  }
  [[nodiscard]] Id node_at(const Vertex& vertex);
  void grow_slots();
  void open(const Vertex& vertex, double cost, Id parent, std::int32_t via);
  void push(Id id);
  void drop_cheapest(Id id);
  [[nodiscard]] bool may_improve(const Node& node) const;
  [[nodiscard]] bool is_free(Node& node, const Edge& edge);
  void expand(Id id);
  bool look();
  void shoot(Id id);
  [[nodiscard]] const Piece& piece_of(Id parent, std::int32_t via) const;
  void take(std::vector<Leg> way);
  void show(Id id);

  const Task& task_;
  const LatticeGraph& graph_;
  const Guide& guide_;
  Connector& connector_;
  Settings settings_;
  std::vector<Joint> joints_;
  std::vector<Node> nodes_;
  std::vector<Id> slots_;  // open addressing; -1 is free
  std::vector<Edge> edges_;
  std::priority_queue<Entry> open_;
  std::int32_t round_ = 0;
  double best_ = std::numeric_limits<double>::infinity();
  std::vector<Leg> best_way_;
  std::int64_t expansions_ = 0;
  std::int64_t shots_ = 0;
  std::int64_t next_shot_ = 0;
  TreeSnapshot tree_;
};

/// The segments of a way, joined.
[[nodiscard]] std::vector<Segment> segments_of(const std::vector<Leg>& way);
/// Length of a way [m].
[[nodiscard]] double length_of(const std::vector<Leg>& way);

/// Options of every search over a lattice.
[[nodiscard]] std::vector<OptionInfo> shared_options();

}  // namespace vandplan::lattice
