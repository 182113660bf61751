// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which way is there, systematically? A search over arcs and lines of fixed length, one continuous
// pose per cell (Hybrid A*, Dolgov et al. 2010). Its routes are seeds for the shortener. Where the
// curvature is continuous, clothoids lead from lock to lock, and a cell is one for each of them.

#include <limits>
#include <optional>
#include <queue>
#include <vector>

#include "search/guide.h"
#include "search/route.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

using namespace search;

/// How fine and how greedy one search is.
struct LatticeOptions {
  int headings = 24;        ///< cells of a full turn; an arc step turns by one of them
  double cell = 0.25;       ///< side of a position cell [turning radii]
  double greediness = 1.0;  ///< weight of the cost-to-go; >= 1
  /// A pose's turn comes without regard to what is near: routes are found sooner, not the best.
  bool overlooks_clearance = false;
  /// Beyond, the exact path to the target is tried once in a while only [turning radii].
  double far_shot = std::numeric_limits<double>::infinity();
  static constexpr int all_locks = 8;
  /// Where the curvature is continuous: locks to either side of straight; 1 to `all_locks`.
  int most_locks = all_locks;
};

/// One search from `root` to `target`; what is driven before and after it are its gears.
class Lattice {
 public:
  Lattice(const LocalPose& root, const LocalPose& target, const Gears& gears,
          const LatticeOptions& options, const Guide& guide, Connector& connector);

  /// Expands one pose. True when a route was found that is cheaper than those before: `route`.
  [[nodiscard]] bool step();

  /// Nothing is left that could be cheaper than the cutoff.
  [[nodiscard]] bool is_exhausted() const { return open_.empty(); }
  /// Only routes cheaper than this are of interest.
  void set_cutoff(double cost) { cutoff_ = std::min(cutoff_, cost); }
  [[nodiscard]] const Route& route() const { return route_; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }

 private:
  struct Node {
    LocalPose pose;
    Segment segment;  // from the parent
    double cost_to_come;
    std::int32_t parent;
    bool is_free = false;  // the way from the parent, as far as is known
  };
  // Ranked by the way around at first, and again by the larger of both when its turn comes: most
  // never get there.
  struct Entry {
    double rank;
    double around;
    double open_ground;  // what no way on open ground costs less than; 0 until it is known
    std::int32_t node;
    bool operator<(const Entry& other) const {  // a queue has its greatest in front
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
  Gears gears_;
  double cutoff_;
  double step_length_;
  double cell_;
  int locks_;  // to either side of straight; more than one where the curvature is continuous
  std::vector<Node> nodes_;
  std::priority_queue<Entry> open_;
  std::vector<std::uint64_t> closed_;  // open addressing; 0 is free
  std::size_t closed_count_ = 0;
  Route route_;
};

}  // namespace vandplan::anytime
