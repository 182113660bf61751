// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which way over a lattice leads to the goal? The search that the lattice planners share.
//
// A* with late edge checks: an edge is checked when it leaves the open list, not when it is found
// (Cohen, Phillips and Likhachev 2014). Rounds are those of ARA* (Likhachev, Gordon and Thrun
// 2003). Method: docs/algorithms/lattice.md.

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

/// Estimated cost-to-go of a search over a lattice.
struct Guide {
  std::function<double(const Vertex&)> length;  ///< estimated way from a vertex to the goal [m]
  bool is_admissible = true;  ///< whether `length` never exceeds the way over the lattice
  bool is_consistent = true;  ///< whether `length` falls by at most an edge's length on it
};

/// Lattice and estimate of one run. `graph` is null if making the lattice was interrupted.
struct Ground {
  std::unique_ptr<const LatticeGraph> graph;
  Guide guide;
};

/// Lays the lattice for a task and makes the estimate that the options name. The options are
/// complete.
[[nodiscard]] Ground ground_of(const Task& task, const PlanOptions& options, const Budget& budget);

/// Lower bound of the length of all paths of the task [m]: the shortest path on open ground, less
/// rounding.
[[nodiscard]] double length_on_open_ground(const Task& task);

/// A piece of a way, and the pose where it ends.
struct Leg {
  Piece piece;
  LocalPose end;
  std::int32_t node = -1;  ///< vertex of the search at the end; -1: the goal; -2: none
};

/// A search from the start of a task to its goal.
class LatticeSearch {
 public:
  struct Settings {
    double weight = 1.0;  ///< weight of the estimate; >= 1
    bool shots = true;    ///< whether exact pieces from some vertices to the goal are tried
    std::size_t max_nodes = 500'000;  ///< largest number of vertices
    bool keep_tree = false;           ///< whether `report` gives the search tree
  };
  /// Index of a vertex that the search has found.
  using Id = std::int32_t;

  /// The task and the parts outlive the search.
  LatticeSearch(const Task& task, const Ground& ground, Connector& connector,
                const Settings& settings);

  /// Whether an edge is left that may improve the best way in this round. False ends the round.
  [[nodiscard]] bool has_next();
  /// Takes edges from the open list until one is free, at most 32, and expands the vertex at its
  /// end. True when that gave a cheaper way to the goal.
  bool step();
  /// Begins a round with another weight. Its open list holds the edges that improved a closed
  /// vertex in the previous round, and those that were left.
  void begin_round(double weight);

  [[nodiscard]] bool is_full() const { return nodes_.size() >= settings_.max_nodes; }
  /// Length of the best way to the goal [m]; infinite if there is none.
  [[nodiscard]] double best() const { return best_; }
  [[nodiscard]] const std::vector<Leg>& best_way() const { return best_way_; }
  /// Lower bound of the length of all ways over the lattice [m], if the estimate is admissible.
  [[nodiscard]] double lattice_bound() const;

  /// Vertex where the next edge begins. None if no edge is left, or the edge begins at the start.
  /// Call after `has_next`.
  [[nodiscard]] std::optional<Id> front() const;
  /// The way from the start to a closed vertex.
  [[nodiscard]] std::vector<Leg> way_to(Id node) const;

  /// Fills in the counters, and the tree if it is kept.
  void report(PlannerAnswer& answer) const;

 private:
  struct Node {
    Vertex vertex;
    Id parent = -1;             // previous vertex; -1: the start
    std::int32_t via = -1;      // number of the move from the parent, or of the joint
    std::int32_t round = -1;    // round in which the vertex was closed last; -1: none
    std::int32_t shown = -1;    // position in the kept tree; -1: none
    std::int32_t waiting = -1;  // cheapest unchecked edge to the vertex; -1: none
    bool is_free = false;       // whether the vehicle is known to be free at the vertex
    double cost = std::numeric_limits<double>::infinity();  // cost-to-come [m]
    double to_go = 0.0;                                     // estimated cost-to-go [m]
  };
  // An unchecked edge. The edges to a vertex form a list: the cheapest one first, the others in any
  // order. Only the cheapest one is in the open list, because most others are never checked.
  struct Edge {
    double cost;  // cost of the way to the end of the edge [m]
    Id parent;
    std::int32_t via;
    std::int32_t next;  // next edge of the list; -1: none
  };
  struct Entry {
    double rank;
    double cost;
    Id node;
    bool operator<(const Entry& other) const {  // the largest entry comes first
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
  std::vector<Id> slots_;  // hash table of vertices, open addressing; -1: empty
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

/// The segments of a way, merged.
[[nodiscard]] std::vector<Segment> segments_of(const std::vector<Leg>& way);
/// Length of a way [m].
[[nodiscard]] double length_of(const std::vector<Leg>& way);

/// Options of every search over a lattice.
[[nodiscard]] std::vector<OptionInfo> shared_options();

}  // namespace vandplan::lattice
