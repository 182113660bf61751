// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a planner build on?
//
// Budget, costs, connections between poses, trees: the planners of the library are made of these,
// and so can yours (docs/own-planner.md). All poses are in the frame of the task.

#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/steering.h"

namespace vandplan::search {

// ---- How long may it go on? ----

/// Counts the iterations and the time of one run, which begins when its budget is made. In the core
/// only `Budget` and `PhaseTimer` read clocks.
class Budget {
 public:
  explicit Budget(const BudgetOptions& options);

  /// Begins the next iteration. False when the budget is spent: `reason` says why.
  [[nodiscard]] bool next();
  /// Why the budget is spent; none if it is not.
  [[nodiscard]] std::optional<PlanStatus> exhausted() const;
  /// How many of `wanted` iterations are left when `promised` ones are taken first.
  [[nodiscard]] std::int64_t left(std::int64_t wanted, std::int64_t promised) const;
  /// Counts iterations that are done.
  void spend(std::int64_t iterations) { iterations_ += iterations; }
  /// Whether time is over or the caller stopped the run. May be asked from several threads.
  [[nodiscard]] bool is_interrupted() const;
  [[nodiscard]] std::int64_t iterations() const noexcept { return iterations_; }
  /// Time since the run began [s].
  [[nodiscard]] double elapsed() const;
  /// Time from the begin of the run to its first iteration [s]; 0 before that.
  [[nodiscard]] double set_up_time() const noexcept { return set_up_time_; }
  /// Why `next` returned false.
  [[nodiscard]] PlanStatus reason() const noexcept { return reason_; }

 private:
  [[nodiscard]] bool is_late() const;

  std::optional<double> time_limit_;
  std::optional<std::int64_t> max_iterations_;
  std::stop_token stop_;
  bool by_processor_;
  std::chrono::steady_clock::time_point begin_;
  std::chrono::nanoseconds processor_begin_;
  mutable double due_;  // wall time before which the limit need not be checked [s]
  double set_up_time_ = 0.0;
  std::int64_t iterations_ = 0;
  PlanStatus reason_ = PlanStatus::stopped;
};

/// Sums the time spent in one phase of a run. It costs next to nothing unless switched on.
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

/// Prices of driving: metres, weighted by gear, gear changes, and turning the wheels. They are
/// charged alike inside a piece, at the joint of two pieces and (gears) at the start. Neutral
/// values make the cost the length. A gear that may not be driven has an infinite weight.
/// docs/algorithms/anytime.md says what is optimal under a rule.
struct CostRule {
  double forward_weight = 1.0;    ///< cost of a metre forward [m]; >= 1
  double reverse_weight = 1.0;    ///< cost of a metre in reverse [m]; >= 1
  double gear_change_cost = 0.0;  ///< cost of one gear change [m]; >= 0
  GearSign initial_gear = 0;      ///< gear before the first metre; 0: any, the first gear is free
  GearSign final_gear = 0;        ///< gear after the last metre; 0: any, the last gear is free
  /// Cost of the total variation of curvature [m per 1/m]; >= 0.
  double curvature_change_cost = 0.0;
  /// Surcharge near obstacles; >= 0. A metre costs 1 + clearance_weight * max(0,
  /// 1 - clearance / clearance_distance) times as much.
  double clearance_weight = 0.0;
  double clearance_distance = 1.0;  ///< distance that is near [m]; > 0
  bool has_priced_ground = false;   ///< whether metres cost more in some zones or masks
  /// Price of a second that a metre takes longer where zones and masks limit the speed [m/s]; >= 0.
  double slowness_price = 0.0;
  InTime in_time = InTime::onward;  ///< order in which segments are driven: backward from the goal

  [[nodiscard]] bool is_length() const {
    return forward_weight == 1.0 && reverse_weight == 1.0 && gear_change_cost == 0.0 &&
           curvature_change_cost == 0.0 && !has_surcharge();
  }
  /// Whether metres may cost more near obstacles or in zones.
  [[nodiscard]] bool has_surcharge() const { return clearance_weight != 0.0 || tells_grounds(); }
  /// Whether the ground on which a metre lies counts.
  [[nodiscard]] bool tells_grounds() const { return has_priced_ground || slowness_price != 0.0; }
  /// Cost of a metre in a gear [m], without surcharges.
  [[nodiscard]] double weight(GearSign gear) const {
    return gear > 0 ? forward_weight : reverse_weight;
  }
  /// Whether a gear may be driven.
  [[nodiscard]] bool allows(GearSign gear) const {
    return weight(gear) < std::numeric_limits<double>::infinity();
  }
  /// Whether both gears may be driven.
  [[nodiscard]] bool allows_both() const { return allows(1) && allows(-1); }
  /// The only gear that may be driven; 0: both may.
  [[nodiscard]] GearSign only_gear() const { return allows_both() ? 0 : allows(1) ? 1 : -1; }
};

/// Gear and curvature just before or after a place, which decide what going on costs. A gear alone
/// is a `Driven` of any curvature.
struct Driven {
  static constexpr double any = std::numeric_limits<double>::quiet_NaN();

  Driven(GearSign sign = 0, double curvature_there = any)  // NOLINT(google-explicit-constructor)
      : gear(sign), curvature(curvature_there) {}

  /// Whether the curvature is known.
  [[nodiscard]] bool is_known() const { return !std::isnan(curvature); }

  GearSign gear;     ///< 1 forward, -1 reverse, 0 not driven yet
  double curvature;  ///< curvature [1/m]; `any`: turning the wheels is free
};

/// The rule of complete options. A price that is not set counts as in `shortest_style`. Without a
/// task zones have no prices.
[[nodiscard]] CostRule cost_rule(const CostOptions& options);
[[nodiscard]] CostRule cost_rule(const CostOptions& options, const Task& task);

/// The rule with an infinite weight for each gear that is not allowed.
[[nodiscard]] CostRule restricted(CostRule rule, AllowedGears gears);

/// The rule by which a path costs its length, in the gears that `rule` allows.
[[nodiscard]] CostRule length_rule(const CostRule& rule);

[[nodiscard]] inline GearSign gear_of(const Segment& segment) {
  return segment.length < 0.0 ? -1 : 1;
}
/// Gear and curvature at the begin of the first segment, or at the end of the last one. An empty
/// piece: any.
[[nodiscard]] Driven first_driven(const Piece& piece);
[[nodiscard]] Driven last_driven(const Piece& piece);
/// Gear and curvature at the end of a segment.
[[nodiscard]] Driven last_driven(const Segment& segment);

/// Whether the rule allows the gears of all segments.
[[nodiscard]] bool may_drive(const CostRule& rule, std::span<const Segment> segments);

/// Cost of going on as `to` after `from`: of a gear change, and of turning the wheels [m].
[[nodiscard]] double change_cost(const CostRule& rule, const Driven& from, const Driven& to);

/// Cost of driving the segments [m], without the surcharge near obstacles. `driven` is what was
/// driven before them; it becomes the end of the last segment.
[[nodiscard]] double drive_cost(const CostRule& rule, std::span<const Segment> segments,
                                Driven& driven);

/// Cost of driving the segments from the start of a drive [m], without the surcharge near
/// obstacles.
[[nodiscard]] double drive_cost(const CostRule& rule, std::span<const Segment> segments);

/// The rule for driving a path from its end to its start: gears and order in time change places.
/// `before` is the gear before the first metre of that.
[[nodiscard]] CostRule reversed(const CostRule& rule, GearSign before);

/// How finely the clearance is sampled along a path.
enum class ClearanceSampling {
  search,  ///< a few samples for each `clearance_distance`
  answer,  ///< samples so fine that the cost is within 1e-3
};
using Looks [[deprecated("use ClearanceSampling")]] = ClearanceSampling;

/// Surcharge near obstacles and in zones for driving the segments from a state, with the trailer
/// [m]. The price of a zone multiplies the whole cost of a metre, that of closeness included. Above
/// `cutoff` [m] any larger number may come back. Method: docs/algorithms/anytime.md.
[[nodiscard]] double clearance_cost(const Task& task, const CostRule& rule, const LocalState& from,
                                    std::span<const Segment> segments, ClearanceSampling sampling,
                                    double cutoff = std::numeric_limits<double>::infinity());

[[deprecated("use clearance_cost")]] [[nodiscard]] inline double rig_clearance_cost(
    const Task& task, const CostRule& rule, const LocalState& from,
    std::span<const Segment> segments, ClearanceSampling sampling,
    double cutoff = std::numeric_limits<double>::infinity()) {
  return clearance_cost(task, rule, from, segments, sampling, cutoff);
}

// ---- Which piece joins two poses, what does it cost, and may it be driven? ----

/// Gears and curvatures before and after a piece.
struct DrivenBeside {
  Driven before = {};  ///< end of what is driven before the piece
  Driven after = {};   ///< begin of what is driven after the piece
};
using Gears [[deprecated("use DrivenBeside")]] = DrivenBeside;

/// Terms of a connection that is wanted.
struct Terms {
  double cost_so_far = 0.0;  ///< cost up to the first pose [m]
  /// Total cost from which on a connection is of no interest [m].
  double cutoff = std::numeric_limits<double>::infinity();
  DrivenBeside beside = {};
};

/// A free piece with its cost.
struct Connection {
  Piece piece;
  double cost = 0.0;  ///< total cost, with the cost up to its begin [m]
};

/// Least radius on which a vehicle steers with continuous curvature [m]: its own, or a wider one if
/// its wheels turn so slowly that it has turned around before full lock.
[[nodiscard]] double continuous_radius(const Vehicle& vehicle) noexcept;

/// Steers, prices and checks for one task, and counts these calls. Each thread needs its own. It
/// steers from pose to pose; prices and checks look at a trailer, too, which begins straight behind
/// a bare pose.
class Connector {
 public:
  /// A connector of the task, which must outlive it. `profile`: times are measured. Throws
  /// InputError naming "curvature" if the wheels turn too slowly for the curvatures at the ends.
  explicit Connector(const Task& task, const CostRule& rule = {}, bool profile = false);

  /// The piece of `steer` with its total cost, if that is below the cutoff and the piece is free.
  [[nodiscard]] std::optional<Connection> connect(const LocalState& from, const LocalPose& to,
                                                  const Terms& terms = {});

  /// The word of least cost from pose to pose, obstacles apart; the shortest one under a neutral
  /// rule. Under another rule vanishing arcs are left out: the piece ends at a pose on the way but
  /// for rounding, at the task's goal within what the judge allows. If no word costs less than
  /// `cutoff` [m], joints to both gears included, the result is any word or none, which is faster.
  ///
  /// Where the task's curvature is continuous, the piece continues the curvature before and after
  /// it. If a neighbour is unknown, and at poses on the way, its wheels are straight. None if no
  /// word does so.
  [[nodiscard]] std::optional<Piece> steer(const LocalPose& from, const LocalPose& to,
                                           const DrivenBeside& beside = {},
                                           double cutoff = std::numeric_limits<double>::infinity());

  /// Lower bound of the cost of every path between the poses, with the joints to both gears [m]. On
  /// open ground a path drives forward only, in reverse only, or changes gear. Under a neutral rule
  /// it is the length of the shortest path.
  [[nodiscard]] double least_cost(const LocalPose& from, const LocalPose& to,
                                  const DrivenBeside& beside = {});

  /// Cost of a piece between two others [m], without the surcharge near obstacles. The joint to the
  /// next piece is included, if there is one.
  [[nodiscard]] double cost(const Piece& piece, const DrivenBeside& beside = {}) const;

  /// Surcharge near obstacles and in zones for the segments from a state [m]; above `cutoff` any
  /// larger number.
  [[nodiscard]] double clearance_cost(
      const LocalState& from, std::span<const Segment> segments,
      double cutoff = std::numeric_limits<double>::infinity()) const {
    return !rule_.has_surcharge() ? 0.0
                                  : search::clearance_cost(task_, rule_, from, segments,
                                                           ClearanceSampling::search, cutoff);
  }

  /// Whether the vehicle is free on the whole piece, on the segment, or in the state. The rule says
  /// in which order segments are driven, which matters in zones.
  [[nodiscard]] bool is_free(const LocalState& from, const Piece& piece);
  [[nodiscard]] bool is_free(const LocalState& from, const Segment& segment);
  [[nodiscard]] bool is_free(const LocalState& state) const { return checker_.is_free(state); }
  /// Whether a segment breaks no rule of a zone, whatever else is in its way.
  [[nodiscard]] bool obeys_zones(const LocalState& from, const Segment& segment) const {
    return checker_.obeys_zones(from, segment, rule_.in_time);
  }

  /// The free begin of the piece, found by halving. Where the curvature is continuous it ends with
  /// straight wheels.
  [[nodiscard]] Piece free_prefix(const LocalState& from, const Piece& piece);

  /// The vehicle's turning radius [m].
  [[nodiscard]] double radius() const { return radius_; }
  /// The steering of the task; null if pieces are arcs and lines.
  [[nodiscard]] const ContinuousSteering* continuous() const {
    return continuous_ ? &*continuous_ : nullptr;
  }
  /// Whether the curvature may jump between what is driven before a pose and after it.
  [[nodiscard]] bool may_jump(const Driven& before, const Driven& after) const;
  [[nodiscard]] const CostRule& rule() const { return rule_; }

  /// Number of steering problems solved, and of edges checked.
  [[nodiscard]] std::int64_t solves() const { return solves_; }
  [[nodiscard]] std::int64_t checks() const { return checks_; }
  /// Time spent in steering, and in checking, if it is measured [s].
  [[nodiscard]] double steering_time() const { return steering_.seconds(); }
  [[nodiscard]] double checking_time() const { return checking_.seconds(); }

 private:
  // How a piece of continuous curvature may begin or end at a pose.
  struct End {
    bool stands;       ///< the vehicle stands there: any curvature is allowed
    double curvature;  ///< curvature there, unless it stands [1/m]
    GearSign gear;     ///< gear in which the piece is driven there; 0: either
  };

  [[nodiscard]] Piece cheapest_word(const LocalPose& from, const LocalPose& to,
                                    const DrivenBeside& beside, const Piece& shortest,
                                    double cutoff);
  [[nodiscard]] std::optional<Piece> continuous_piece(const LocalPose& from, const LocalPose& to,
                                                      const DrivenBeside& beside, double cutoff);
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

/// The first `s` metres of a piece.
[[nodiscard]] Piece prefix(const Piece& piece, double s);
/// The piece without its first `s` metres.
[[nodiscard]] Piece suffix(const Piece& piece, double s);

/// Largest curvature of straight wheels, times the turning radius: rounding leaves them so.
inline constexpr double straight_wheels = 1e-9;

/// The driven distance [m] nearest to `s` where the piece may be cut and another piece begin: the
/// wheels are straight or the gear changes. Both ends of the piece are such places.
[[nodiscard]] double nearest_cut(const Piece& piece, double s, double radius);

/// The pose at the end of a piece that begins at `from`.
[[nodiscard]] Pose end_of(const Pose& from, const Piece& piece);
[[nodiscard]] inline LocalPose end_of(const LocalPose& from, const Piece& piece) {
  return Local(end_of(static_cast<const Pose&>(from), piece));
}

// ---- Which nodes does a search tree have? ----

/// Position of a node in its tree; the root is 0 and parents come before their children.
using NodeId = std::int32_t;

/// Nodes of a search tree as structure of arrays. Decisions use the doubles; the float copies are
/// for kernels that rank. An edge is not stored: it is the piece that `Connector::steer` gives from
/// the parent's pose to the node's.
class Tree {
 public:
  /// A tree with a root. It reserves room for `capacity` nodes, so that `add` does not allocate.
  Tree(const LocalPose& root, std::size_t capacity);

  /// Adds a node whose cost from the root is `cost_to_come` [m], and returns its position.
  NodeId add(const LocalPose& pose, NodeId parent, double cost_to_come);

  [[nodiscard]] std::size_t size() const noexcept { return poses_.size(); }
  [[nodiscard]] const LocalPose& pose(NodeId id) const noexcept { return poses_[index(id)]; }
  [[nodiscard]] NodeId parent(NodeId id) const noexcept { return parents_[index(id)]; }
  /// Cost of the path from the root [m].
  [[nodiscard]] double cost_to_come(NodeId id) const noexcept { return costs_[index(id)]; }

  [[nodiscard]] std::span<const float> x() const noexcept { return x_; }  ///< x of all nodes [m]
  [[nodiscard]] std::span<const float> y() const noexcept { return y_; }  ///< y of all nodes [m]
  /// Headings of all nodes in [-pi, pi) [rad].
  [[nodiscard]] std::span<const float> heading() const noexcept { return heading_; }
  /// Costs of the paths from the root to all nodes [m].
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
