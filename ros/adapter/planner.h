// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a robot of ROS get a path over its costmap?
//
//   Planner planner;
//   planner.take(costmap);                       // while the costmap's owner keeps it still
//   const Answer answer = planner.plan(request);
//
// Poses are those of base_link, in the frame of the costmap.

#include <future>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "ros/adapter/costmap.h"
#include "ros/adapter/outcome.h"
#include "ros/adapter/parameters.h"
#include "ros/adapter/poses.h"
#include "vandplan/planner.h"
#include "vandplan/replanner.h"

namespace vandplan::ros {

/// How far from a goal a path may end if the goal itself is not free. With zeros it may not.
struct GoalSlack {
  double ahead = 0.0;    ///< distance along the goal's heading, either way [m]; >= 0
  double aside = 0.0;    ///< distance across it, either way [m]; >= 0
  double heading = 0.0;  ///< difference of the heading, either way [rad]; >= 0
  bool operator==(const GoalSlack&) const = default;
};

/// A place on the way to the goal.
struct ViaPoint {
  Pose pose = {};
  /// Whether the robot may have any heading there. Then it is the midpoint of the rear axle, not
  /// base_link, that passes the place.
  bool any_heading = false;
};

/// A wish for a path.
struct Request {
  Pose start = {};
  std::vector<Pose> goals = {};  ///< the path ends at whichever is cheapest to reach
  /// What the path passes on its way, in this order. The robot drives through, or stands there if
  /// no such way is found within half of the time limit or all iterations.
  std::vector<ViaPoint> viapoints = {};
  GoalHeading heading = GoalHeading::given;
  /// The rear axle may be anywhere in this box around a goal if no goal is free.
  GoalSlack slack = {};
  Vehicle vehicle = {};
  double rear_axle = 0.0;  ///< x of the rear axle in the frame base_link [m]
  CostRule cost_rule = {};
  PlanOptions options = {};
  /// If the time limit passes without a path, the call waits so much longer for its first one [s].
  double patience = 0.0;
  std::stop_token stop = {};  ///< when this is asked to stop, the call is cancelled
};

/// The wish for a path of a robot with these parameters. Throws InputError as `vehicle_of`.
[[nodiscard]] Request request_of(const Parameters& parameters, const Robot& robot);

/// Answer to a wish.
struct Answer {
  Outcome outcome = Outcome::invalid;
  std::string message = {};          ///< why there is no path; or empty
  std::optional<Path> path = {};     ///< path of the rear axle; none without a path
  std::vector<PathPose> poses = {};  ///< poses of the path, at most a cell apart
  std::size_t goal = 0;              ///< index of the goal at which the path ends
  bool used_slack = false;           ///< whether it ends beside the goal, which is not free
  double cost = 0.0;                 ///< cost of the path [m], or [s] where the cost is the time
  double planning_time = 0.0;        ///< time of the planner, without the judge [s]
};

/// Plans again and again over a costmap that changes. Not for several threads at once.
///
/// The world is kept between calls: only cells that have changed are looked at again. A new one is
/// built in a thread of its own, for which a cancelled call does not wait. A call begins with the
/// path of the call before. So equal calls give equal answers only after `forget`.
class Planner {
 public:
  /// Takes a costmap, by a copy of what has changed. Throws InputError as `KnownCostmap::take`.
  void take(const Costmap& costmap) { costmap_.take(costmap); }

  /// Plans over the last costmap. An error in the request is the outcome `invalid`.
  [[nodiscard]] Answer plan(const Request& request);

  /// Whether the vehicle touches something at one of the poses, or stands outside the costmap: only
  /// there, not between them. Throws InputError naming the number of the vehicle that is wrong, or
  /// "costmap" before the first one.
  [[nodiscard]] bool is_blocked(std::span<const Pose> poses, const Vehicle& vehicle,
                                const CostRule& rule);

  /// Forgets world and path, as if nothing had ever been planned.
  void forget();

  /// The world of the last call. Null before the first one.
  [[nodiscard]] std::shared_ptr<const World> world() const noexcept;

 private:
  Answer planned(const Request& request);
  std::optional<Answer> refusal(const Request& request) const;
  PlanResult result_to(const Request& request, const std::vector<GoalRegion>& goals) const;
  PlanResult patient_result_to(const Request& request, const std::vector<GoalRegion>& goals) const;
  bool renew_world(const CostRule& rule, const Point& near, const std::stop_token& stop);
  bool is_built(const std::stop_token& stop);

  KnownCostmap costmap_;
  std::optional<ChangingWorld> world_;
  std::future<ChangingWorld> building_;  // valid after a call that was cancelled meanwhile
  CostRule rule_;                        // of the world's map
  Path last_;                            // the last path; without segments there is none
};

}  // namespace vandplan::ros
