// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a planner build on?
//
// Budget, costs, connections between poses, trees: what the planners of the library are made of,
// for those who write their own (docs/own-planner.md). All poses are in the frame of the task.

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "vandplan/continuous_steering.h"
#include "vandplan/outcome.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan {
struct RigState;  // rig.h
}

namespace vandplan::search {

// ---- How long may it go on? ----

/// Counts the iterations and the time of one run: the one place of the core that looks at a clock.
/// A run begins when its budget is made.
class Budget {
 public:
  explicit Budget(const BudgetOptions& options);

  /// Begins the next iteration. False when there is none: `reason` says why.
  [[nodiscard]] bool next();
  /// Why there is no next iteration; none if there is one.
  [[nodiscard]] std::optional<PlanStatus> exhausted() const;
  /// How many of the `wanted` iterations there are when `promised` ones are taken first.
  [[nodiscard]] std::int64_t left(std::int64_t wanted, std::int64_t promised) const;
  /// Counts iterations that were done.
  void spend(std::int64_t iterations) { iterations_ += iterations; }
  /// Out of time or told to stop; may be asked from several threads.
  [[nodiscard]] bool is_interrupted() const;
  [[nodiscard]] std::int64_t iterations() const noexcept { return iterations_; }
  /// Time since the run began [s].
  [[nodiscard]] double elapsed() const;
  /// Time from the begin of the run to its first iteration [s]; 0 before that.
  [[nodiscard]] double set_up_time() const noexcept { return set_up_time_; }
  /// Why `next` said no.
  [[nodiscard]] PlanStatus reason() const noexcept { return reason_; }

 private:
  [[nodiscard]] bool is_late() const;

  std::optional<double> time_limit_;
  std::optional<std::int64_t> max_iterations_;
  const std::atomic<bool>* stop_;
  bool by_processor_;
  std::chrono::steady_clock::time_point begin_;
  std::chrono::nanoseconds processor_begin_;
  mutable double due_;  // before that much wall time the limit need not be looked at [s]
  double set_up_time_ = 0.0;
  std::int64_t iterations_ = 0;
  PlanStatus reason_ = PlanStatus::stopped;
};

/// Adds up the time spent in one phase of a run; costs next to nothing unless switched on.
class PhaseTimer {
 public:
  explicit PhaseTimer(bool on) : on_(on) {}
  void start() {
    if (on_) begin_ = std::chrono::steady_clock::now();
  }
  void stop() {
    if (on_) sum_ += std::chrono::steady_clock::now() - begin_;
  }
  /// Sum of the times between `start` and `stop` [s].
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(sum_).count(); }

 private:
  bool on_;
  std::chrono::steady_clock::time_point begin_ = {};
  std::chrono::steady_clock::duration sum_ = {};
};

// ---- What does driving cost? ----

/// Direction of travel: 1 forward, -1 reverse, 0 not driven yet.
using GearSign = int;

/// Prices of driving: metres, weighted by gear, a price for each gear change, and one for turning
/// the wheels; charged alike inside a piece, at the joint of two pieces and (gears) at the start.
/// Neutral values make the cost the length. A gear that may not be driven has an infinite weight.
/// docs/algorithms/anytime.md says what is optimal under it.
struct CostRule {
  double forward_weight = 1.0;         ///< per metre driven forward; >= 1
  double reverse_weight = 1.0;         ///< per metre driven in reverse; >= 1
  double gear_change_cost = 0.0;       ///< of one change [m]; >= 0
  GearSign initial_gear = 0;           ///< before the first metre; 0: any, and the first is free
  double curvature_change_cost = 0.0;  ///< of total variation of curvature [m per 1/m]; >= 0
  /// A metre costs 1 + clearance_weight * max(0, 1 - clearance / clearance_distance) times as much.
  double clearance_weight = 0.0;    ///< >= 0
  double clearance_distance = 1.0;  ///< [m]; > 0

  [[nodiscard]] bool is_length() const {
    return forward_weight == 1.0 && reverse_weight == 1.0 && gear_change_cost == 0.0 &&
           curvature_change_cost == 0.0 && clearance_weight == 0.0;
  }
  /// What a metre costs in a gear, apart from what being near things adds.
  [[nodiscard]] double weight(GearSign gear) const {
    return gear > 0 ? forward_weight : reverse_weight;
  }
  /// Whether a gear may be driven.
  [[nodiscard]] bool allows(GearSign gear) const {
    return weight(gear) < std::numeric_limits<double>::infinity();
  }
  /// Whether both gears may be driven.
  [[nodiscard]] bool allows_both() const { return allows(1) && allows(-1); }
  /// The one gear that may be driven; 0: both may.
  [[nodiscard]] GearSign only_gear() const { return allows_both() ? 0 : allows(1) ? 1 : -1; }
};

/// How the vehicle drives just before or after a place, as far as it matters for what going on
/// costs. A gear alone is a `Driven` whose curvature may be any.
struct Driven {
  static constexpr double any = std::numeric_limits<double>::quiet_NaN();

  Driven(GearSign sign = 0, double curvature_there = any)  // NOLINT(google-explicit-constructor)
      : gear(sign), curvature(curvature_there) {}

  GearSign gear;
  double curvature;  ///< [1/m]; `any`: turning the wheels is free
};

/// The prices of complete options. A price that is not set counts as in `shortest_style`.
[[nodiscard]] CostRule cost_rule(const CostOptions& options);

/// The rule, with an infinite weight for a gear that is not allowed.
[[nodiscard]] CostRule restricted(CostRule rule, AllowedGears gears);

/// The rule by which a path costs its length, in the gears that the other rule allows.
[[nodiscard]] CostRule length_rule(const CostRule& rule);

[[nodiscard]] inline GearSign gear_of(const Segment& segment) {
  return segment.length < 0.0 ? -1 : 1;
}
/// How the first segment begins and how the last one ends; an empty piece: any.
[[nodiscard]] Driven first_driven(const Piece& piece);
[[nodiscard]] Driven last_driven(const Piece& piece);
[[nodiscard]] Driven last_driven(const Segment& segment);

/// Whether the rule allows the gears in which the segments are driven.
[[nodiscard]] bool may_drive(const CostRule& rule, std::span<const Segment> segments);

/// Price of going on as `to` after `from`: of a gear change, and of turning the wheels [m].
[[nodiscard]] double change_cost(const CostRule& rule, const Driven& from, const Driven& to);

/// Cost of driving the segments [m], apart from what being near things adds to it; `driven` is what
/// was driven before them and becomes how the last one ends.
[[nodiscard]] double drive_cost(const CostRule& rule, std::span<const Segment> segments,
                                Driven& driven);

/// The rule for driving a path from its end to its start: the gears change places, and `before` is
/// what is driven before the first metre of that.
[[nodiscard]] CostRule reversed(const CostRule& rule, GearSign before);

/// How finely the clearance is looked at along a way.
enum class Looks {
  search,  ///< a few for each `clearance_distance`
  answer,  ///< within 1e-3 of the cost
};

/// What being near things adds to the cost of driving the segments from a pose [m], with the hitch
/// angle of the task's start if there is a trailer. Above `cutoff` it is any number above it: the
/// sum ends there. docs/algorithms/anytime.md says how it is found.
[[nodiscard]] double clearance_cost(const Task& task, const CostRule& rule, const LocalPose& from,
                                    std::span<const Segment> segments, Looks looks,
                                    double cutoff = std::numeric_limits<double>::infinity());

/// What being near things adds, with the trailer, to the cost of driving the segments from a state
/// of the rig [m]; the vehicle alone if it has no trailer.
[[nodiscard]] double rig_clearance_cost(const Task& task, const CostRule& rule,
                                        const Local<RigState>& from,
                                        std::span<const Segment> segments, Looks looks,
                                        double cutoff = std::numeric_limits<double>::infinity());

// ---- Which piece joins two poses, what does it cost, and may it be driven? ----

/// What is driven before and after a piece.
struct Gears {
  Driven before = {};
  Driven after = {};
};

/// On which terms a connection is wanted.
struct Terms {
  double cost_so_far = 0.0;  ///< of getting to the first pose [m]
  /// Only what costs less in all is of interest [m].
  double cutoff = std::numeric_limits<double>::infinity();
  Gears gears = {};
};

/// A piece that may be driven.
struct Connection {
  Piece piece;
  double cost = 0.0;  ///< in all, with what it cost to get to its begin [m]
};

/// The least radius on which a vehicle steers with continuous curvature [m]: its own, or a wider
/// one if its wheels turn so slowly that it has turned around before they are at full lock.
[[nodiscard]] double continuous_radius(const Vehicle& vehicle) noexcept;

/// Steers, prices and checks for one task, and counts what it is asked. One for each thread.
class Connector {
 public:
  /// The task outlives the connector. With `profile` the time of steering and checking is measured.
  explicit Connector(const Task& task, const CostRule& rule = {}, bool profile = false);

  /// The cheapest word from pose to pose, if it costs less than the cutoff and is free.
  [[nodiscard]] std::optional<Connection> connect(const LocalPose& from, const LocalPose& to,
                                                  const Terms& terms = {});

  /// The word of least cost; the shortest one under a neutral rule. Under another rule arcs that
  /// vanish are left out: the piece then ends at a pose on the way but for rounding, at the goal of
  /// the task within what the judge allows. If no word costs less than `cutoff` [m], the joints to
  /// both gears included, it is any word or none: most calls for a cheaper way end so, and sooner.
  ///
  /// Where the task's curvature is continuous, the piece goes on from what is driven before it and
  /// goes over into what is driven after it; where that is not known, and at poses on the way, its
  /// wheels are straight. There may be no such piece among the words.
  [[nodiscard]] std::optional<Piece> steer(const LocalPose& from, const LocalPose& to,
                                           const Gears& gears = {},
                                           double cutoff = std::numeric_limits<double>::infinity());

  /// What no path between the poses costs less than, with the joints to both gears [m]: on open
  /// ground it is driven forward, or in reverse, or changes gear. The length of the shortest path
  /// under a neutral rule.
  [[nodiscard]] double least_cost(const LocalPose& from, const LocalPose& to,
                                  const Gears& gears = {});

  /// Cost of a piece between two others [m], apart from what being near things adds to it; the
  /// joint to the next one is its part, if there is one.
  [[nodiscard]] double cost(const Piece& piece, const Gears& gears = {}) const;

  /// What being near things adds to the cost of the segments [m]; above `cutoff` any number above
  /// it.
  [[nodiscard]] double clearance_cost(
      const LocalPose& from, std::span<const Segment> segments,
      double cutoff = std::numeric_limits<double>::infinity()) const {
    return rule_.clearance_weight == 0.0
               ? 0.0
               : search::clearance_cost(task_, rule_, from, segments, Looks::search, cutoff);
  }

  [[nodiscard]] bool is_free(const LocalPose& from, const Piece& piece);
  [[nodiscard]] bool is_free(const LocalPose& from, const Segment& segment);
  [[nodiscard]] bool is_free(const LocalPose& pose) const { return checker_.is_free(pose); }

  /// As much of the piece as is free, found by halving; where the curvature is continuous it ends
  /// with straight wheels.
  [[nodiscard]] Piece free_prefix(const LocalPose& from, const Piece& piece);

  /// The vehicle's turning radius [m].
  [[nodiscard]] double radius() const { return radius_; }
  /// The steering of the task; null if pieces are arcs and lines.
  [[nodiscard]] const ContinuousSteering* continuous() const {
    return continuous_ ? &*continuous_ : nullptr;
  }
  /// Whether the curvature may jump between what is driven before a pose and after it.
  [[nodiscard]] bool may_jump(const Driven& before, const Driven& after) const;
  [[nodiscard]] const CostRule& rule() const { return rule_; }

  /// How many steering problems it has solved and how many edges it has checked.
  [[nodiscard]] std::int64_t solves() const { return solves_; }
  [[nodiscard]] std::int64_t checks() const { return checks_; }
  /// Time spent in both, when it was asked to measure [s].
  [[nodiscard]] double steering_time() const { return steering_.seconds(); }
  [[nodiscard]] double checking_time() const { return checking_.seconds(); }

 private:
  /// How a piece of continuous curvature may begin or end at a pose.
  struct End {
    bool stands;       ///< the vehicle stands there: any curvature will do
    double curvature;  ///< else [1/m]
    GearSign gear;     ///< in which the piece has to be driven there; 0: in either
  };

  [[nodiscard]] Piece cheapest_word(const LocalPose& from, const LocalPose& to, const Gears& gears,
                                    const Piece& shortest, double cutoff);
  [[nodiscard]] std::optional<Piece> continuous_piece(const LocalPose& from, const LocalPose& to,
                                                      const Gears& gears, double cutoff);
  void find_ends(const LocalPose& pose, const Driven& beside, std::vector<End>& ends) const;

  const Task& task_;
  const CollisionChecker& checker_;
  double radius_;
  CostRule rule_;
  std::optional<ContinuousSteering> continuous_;
  std::vector<End> starts_, goals_;  // buffers
  std::vector<Piece> words_;         // buffer
  std::int64_t solves_ = 0;
  std::int64_t checks_ = 0;
  PhaseTimer steering_;
  PhaseTimer checking_;
};

/// The first `s` metres of a piece; and the piece without them.
[[nodiscard]] Piece prefix(const Piece& piece, double s);
[[nodiscard]] Piece suffix(const Piece& piece, double s);

/// How far from straight rounding leaves the wheels, times the turning radius.
inline constexpr double straight_wheels = 1e-9;

/// The place [m] on a piece nearest to `s` where it may be cut, and another piece begin there: the
/// wheels are straight or the gear changes. Both ends of the piece are such places.
[[nodiscard]] double nearest_cut(const Piece& piece, double s, double radius);

/// The pose at the end of a piece.
[[nodiscard]] Pose end_of(const Pose& from, const Piece& piece);
[[nodiscard]] inline LocalPose end_of(const LocalPose& from, const Piece& piece) {
  return Local(end_of(static_cast<const Pose&>(from), piece));
}

// ---- Which nodes does a search tree have? ----

/// Position of a node in its tree; the root is 0 and parents come before their children.
using NodeId = std::int32_t;

/// Nodes as structure of arrays. What decides is double; the float copies are for kernels that
/// rank. An edge is not stored: it is what `Connector::steer` gives from the parent's pose to the
/// node's.
class Tree {
 public:
  /// Reserves room for `capacity` nodes, so that `add` does not allocate.
  Tree(const LocalPose& root, std::size_t capacity);

  NodeId add(const LocalPose& pose, NodeId parent, double cost_to_come);

  [[nodiscard]] std::size_t size() const noexcept { return poses_.size(); }
  [[nodiscard]] const LocalPose& pose(NodeId id) const noexcept { return poses_[index(id)]; }
  [[nodiscard]] NodeId parent(NodeId id) const noexcept { return parents_[index(id)]; }
  /// Cost of the path from the root [m].
  [[nodiscard]] double cost_to_come(NodeId id) const noexcept { return costs_[index(id)]; }

  [[nodiscard]] std::span<const float> x() const noexcept { return x_; }
  [[nodiscard]] std::span<const float> y() const noexcept { return y_; }
  /// Headings in [-pi, pi).
  [[nodiscard]] std::span<const float> heading() const noexcept { return heading_; }
  [[nodiscard]] std::span<const float> cost_to_come() const noexcept { return ranking_cost_; }

  /// The poses from the root to the node, both included.
  [[nodiscard]] std::vector<LocalPose> branch(NodeId id) const;

  [[nodiscard]] TreeSnapshot snapshot() const { return {{poses_.begin(), poses_.end()}, parents_}; }

 private:
  static std::size_t index(NodeId id) noexcept { return static_cast<std::size_t>(id); }

  std::vector<LocalPose> poses_;
  std::vector<NodeId> parents_;
  std::vector<double> costs_;
  std::vector<float> x_, y_, heading_, ranking_cost_;
};

}  // namespace vandplan::search
