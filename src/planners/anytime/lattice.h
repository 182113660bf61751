// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which routes does a systematic search find?
//
// A search over arcs and lines of fixed length, with one continuous pose per cell (Hybrid A*,
// Dolgov et al. 2010). Its routes are seeds for the shortener. With continuous curvature, clothoids
// lead from lock to lock, and each lock has cells of its own.

#include <array>
#include <optional>
#include <queue>
#include <vector>

#include "search/guide.h"
#include "search/route.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

using namespace search;

/// Fineness and greediness of one search.
struct LatticeOptions {
  int headings = 24;        ///< heading cells of a full turn; an arc step turns by one of them
  double cell = 0.25;       ///< side of a position cell [turning radii]
  double greediness = 1.0;  ///< weight of the cost-to-go; >= 1
};

/// Searches from coarse to fine. Each is twice as fine as the second one before. The first two are
/// greedy and find a first route; the third looks for the best route; the others find ways out of
/// ever tighter slots.
inline constexpr std::array<LatticeOptions, 8> coarse_to_fine = {
    LatticeOptions{12, 0.5, 2.0},    LatticeOptions{24, 0.25, 1.5},
    LatticeOptions{36, 0.17, 1.2},   LatticeOptions{48, 0.125, 2.0},
    LatticeOptions{96, 0.06, 2.0},   LatticeOptions{192, 0.03, 3.0},
    LatticeOptions{384, 0.015, 3.0}, LatticeOptions{768, 0.0075, 3.0}};

/// Number of searches from the first on that are coarse. Where they find no route, a slot is tight.
inline constexpr std::size_t coarse_searches = 4;

/// One search from `root` to `target`. `beside`: what is driven before and after the route.
class Lattice {
 public:
  /// Guide and connector outlive the search.
  Lattice(const LocalPose& root, const LocalPose& target, const DrivenBeside& beside,
          const LatticeOptions& options, const Guide& guide, Connector& connector);

  /// Expands one pose. True when a route was found that is cheaper than all before: `route`.
  [[nodiscard]] bool step();

  /// Whether no pose is left that could lead to a route cheaper than the cutoff.
  [[nodiscard]] bool is_exhausted() const { return open_.empty(); }
  /// Ignores routes that do not cost less than `cost` from now on.
  void set_cutoff(double cost) { cutoff_ = std::min(cutoff_, cost); }
  [[nodiscard]] const Route& route() const { return route_; }
  [[nodiscard]] std::int64_t size() const { return static_cast<std::int64_t>(nodes_.size()); }

 private:
  /// Pose that was reached, with its step from the parent.
  struct Node {
    LocalPose pose;
    Segment segment;  // step from the parent
    double cost_to_come;
    std::int32_t parent;
    bool is_free = false;  // whether the step is known to be free
  };
  /// Entry of the open list. It is ranked by the cost-to-go of the guide at first, and by the
  /// larger of both estimates when its turn comes. Most entries never get a turn.
  struct Entry {
    double rank;
    double around;       // cost-to-go by the guide
    double open_ground;  // lower bound of the cost-to-go on open ground; 0 until it is known
    std::int32_t node;
    /// Whether `other` comes first: a std::priority_queue has its greatest entry in front.
    bool operator<(const Entry& other) const {
      return rank != other.rank ? rank > other.rank : node > other.node;
    }
  };

  [[nodiscard]] std::uint64_t key_of(const Node& node) const;
  [[nodiscard]] Driven driven_to(const Node& node) const;
  [[nodiscard]] std::optional<Segment> step_from(const Node& node, int side,
                                                 GearSign direction) const;
  [[nodiscard]] int lock_of(double curvature) const;
  void open(const Node& node);
  [[nodiscard]] std::optional<Entry> next();
  [[nodiscard]] bool waits_for_cheaper(Entry entry);
  bool shoot(const Entry& entry);
  void expand(std::int32_t id);
  bool close(std::uint64_t key);
  [[nodiscard]] bool is_closed(std::uint64_t key) const;
  void grow_table();
  [[nodiscard]] bool is_straight(double curvature) const;
  void append(const Segment& step, const LocalPose& end);
  void build_route(std::int32_t node, const Piece& last);

  Connector& connector_;
  const Guide& guide_;
  LatticeOptions options_;
  LocalPose target_;
  DrivenBeside beside_;
  double cutoff_;
  double step_length_;
  double cell_;
  /// Locks to either side of straight; more than one only where the curvature is continuous.
  int locks_;
  std::vector<Node> nodes_;
  std::priority_queue<Entry> open_;
  std::vector<std::uint64_t> closed_;  // keys of closed cells, by open addressing; 0 is free
  std::size_t closed_count_ = 0;
  Route route_;
};

}  // namespace vandplan::anytime
