// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/ompl_spaces.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/SolutionNonExistenceProof.h>
#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <numbers>
#include <stop_token>
#include <thread>
#include <utility>

#include "ompl/curves.h"
#include "vandplan/input_error.h"

namespace vandplan::ompl {
namespace {

namespace ob = ::ompl::base;

constexpr double endless = 1e9;  // Time limit that stands for none [s].

/// Tests a condition at once and then about every millisecond, as long as the object lives.
class Watch {
 public:
  explicit Watch(const std::function<bool()>& has_ended) {
    if (has_ended()) stop_.request_stop();
    thread_ = std::jthread([this, has_ended](const std::stop_token& token) {
      std::mutex mutex;
      std::unique_lock lock(mutex);
      std::condition_variable_any sleep;
      while (!stop_.stop_requested() && !token.stop_requested()) {
        sleep.wait_for(lock, token, std::chrono::milliseconds(1), [] { return false; });
        if (has_ended()) stop_.request_stop();
      }
    });
  }

  /// Is asked to stop when the condition holds.
  [[nodiscard]] std::stop_token stop() const { return stop_.get_token(); }

 private:
  std::stop_source stop_;
  std::jthread thread_;
};

const StateValidityChecker& our_checker(const ob::SpaceInformation& si) {
  const auto* const checker =
      dynamic_cast<const StateValidityChecker*>(si.getStateValidityChecker().get());
  if (checker == nullptr) {
    throw ::ompl::Exception("vandplan", "needs a vandplan::ompl::StateValidityChecker");
  }
  return *checker;
}

/// Vehicle with the turning radius of the space, which may be larger than the vehicle's own.
Vehicle vehicle_in(const ob::StateSpace& space, const Vehicle& vehicle) {
  const Curves curves(space);
  if (!curves.is_reeds_shepp()) {
    throw ::ompl::Exception("vandplan", "needs a Reeds-Shepp state space: its planners reverse");
  }
  const double ratio = curves.radius() / vehicle.min_turning_radius;
  Vehicle turning = vehicle;
  if (std::abs(ratio - 1) > 1e-9) turning.min_turning_radius = curves.radius();
  if (ratio < 1 - 1e-9) {
    throw ::ompl::Exception("vandplan", "the space turns more sharply than the vehicle can");
  }
  return turning;
}

/// Value of an option as JSON.
std::string text_of(const OptionInfo& info, const PlanOptions& options) {
  const OptionValue* const value = options.planner.find(info.name);
  return json_of(value != nullptr ? *value : info.default_value);
}

}  // namespace

std::vector<Pose> way_points(const Path& path) {
  constexpr double quarter = std::numbers::pi / 2;
  std::vector<Pose> poses{path.start};
  // Relative to the start, so that nothing is rounded far from the origin.
  Pose beside{0.0, 0.0, path.start.heading};
  for (const Segment& segment : path.segments) {
    const double parts =
        std::max(1.0, std::ceil(std::abs(segment.curvature * segment.length) / quarter));
    for (double part = 0; part < parts; ++part) {
      beside = advance(beside, {segment.curvature, segment.length / parts});
      poses.push_back({path.start.x + beside.x, path.start.y + beside.y, beside.heading});
    }
  }
  return poses;
}

Planner::Planner(const ob::SpaceInformationPtr& si, const std::string& name)
    : Planner(si, planner_named(name), {.cost = shortest_style}) {}

Planner::Planner(const ob::SpaceInformationPtr& si, vandplan::Planner planner,
                 const PlanOptions& options)
    : ob::Planner(si, "vandplan_" + planner.name), planner_(std::move(planner)), options_(options) {
  if (options_.steering.value_or(Steering::reeds_shepp) != Steering::reeds_shepp) {
    throw InputError("steering", "is not that of the state space, expected: reeds-shepp");
  }
  options_.steering = Steering::reeds_shepp;
  (void)complete(planner_, options_);
  specs_.optimizingPaths = planner_.properties.anytime;
  specs_.provingSolutionNonExistence = planner_.can(Capability::target_gap);
  declare_options();
}

Planner::~Planner() = default;

void Planner::declare_options() {
  const auto declare = [&](const std::string& name, const std::function<std::string()>& get) {
    const auto set = [this, name](const std::string& value) {
      set_option(options_, planner_, name, value);
    };
    params_.declareParam<std::string>(name, set, get);
  };
  for (const CommonOption& common : common_options()) {
    const bool is_of_the_set_up =
        common.part == OptionPart::steering || common.part == OptionPart::clearance;
    if (is_of_the_set_up || !honours(planner_, common.name)) continue;
    declare(std::string(common.name), [this, get = common.get] { return get(options_); });
  }
  for (const OptionInfo& info : planner_.options) {
    declare(info.name, [this, info] { return text_of(info, options_); });
  }
}

void Planner::setup() {
  const StateValidityChecker& checker = our_checker(*si_);
  (void)vehicle_in(*si_->getStateSpace(), checker.problem().vehicle());
  if (options_.clearance != ClearanceOptions{} &&
      options_.clearance != checker.clearance_options()) {
    throw ::ompl::Exception(getName(), "the margin is that of the validity checker");
  }
  ob::Planner::setup();
}

void Planner::clear() {
  ob::Planner::clear();
  result_.reset();
  nodes_.clear();
  parents_.clear();
}

ob::PlannerStatus Planner::solve(const ob::PlannerTerminationCondition& ptc) {
  checkValidity();
  if (dynamic_cast<ob::GoalSampleableRegion*>(pdef_->getGoal().get()) == nullptr) {
    return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  }
  pis_.restart();
  const ob::State* const start = pis_.nextStart();
  if (start == nullptr) return ob::PlannerStatus::INVALID_START;
  const bool may_come_later = dynamic_cast<ob::GoalLazySamples*>(pdef_->getGoal().get()) != nullptr;
  const ob::State* const goal = may_come_later ? pis_.nextGoal(ptc) : pis_.nextGoal();
  if (goal == nullptr) return ob::PlannerStatus::INVALID_GOAL;

  const StateValidityChecker& checker = our_checker(*si_);
  const Problem& given = checker.problem();
  const Problem problem =
      make_problem(given.world(), vehicle_in(*si_->getStateSpace(), given.vehicle()),
                   pose_of(start), pose_of(goal));
  const Watch watch([&] { return ptc() || options_.budget.stop.stop_requested(); });
  PlanOptions options = options_;
  options.clearance = checker.clearance_options();
  options.budget.stop = watch.stop();
  if (!options.budget.time_limit && !options.budget.max_iterations) {
    options.budget.time_limit = endless;
  }
  result_ = plan(problem, planner_, options);
  return report(problem);
}

ob::PlannerStatus Planner::report(const Problem& problem) {
  std::vector<Pose> poses;
  if (result_->path) {
    poses = way_points(*result_->path);
    poses.back() = problem.goal();
  }
  keep_nodes(poses);
  const std::string status(name_of(result_->status));
  ::ompl::msg::log(__FILE__, __LINE__, ::ompl::msg::LOG_INFO, "%s: %s %s", getName().c_str(),
                   status.c_str(), result_->reason.c_str());
  switch (result_->status) {
    case PlanStatus::solved:
      break;
    case PlanStatus::start_in_collision:
      return ob::PlannerStatus::INVALID_START;
    case PlanStatus::goal_in_collision:
      return ob::PlannerStatus::INVALID_GOAL;
    case PlanStatus::no_path:
      pdef_->setSolutionNonExistenceProof(std::make_shared<ob::SolutionNonExistenceProof>(si_));
      return ob::PlannerStatus::ABORT;
    case PlanStatus::rejected:
      return ob::PlannerStatus::ABORT;
    default:
      return ob::PlannerStatus::TIMEOUT;
  }
  const auto path = std::make_shared<::ompl::geometric::PathGeometric>(si_);
  ob::ScopedState<> state(si_->getStateSpace());
  for (const Pose& pose : poses) {
    set_pose(state.get(), pose);
    path->append(state.get());
  }
  ob::PlannerSolution solution(path);
  solution.setPlannerName(getName());
  if (const ob::OptimizationObjectivePtr& objective = pdef_->getOptimizationObjective()) {
    const ob::Cost cost = path->cost(objective);
    solution.setOptimized(objective, cost, objective->isSatisfied(cost));
  }
  pdef_->addSolutionPath(solution);
  return ob::PlannerStatus::EXACT_SOLUTION;
}

void Planner::keep_nodes(const std::vector<Pose>& path) {
  nodes_.clear();
  parents_.clear();
  const std::vector<Pose>& poses = result_->tree ? result_->tree->poses : path;
  nodes_.reserve(poses.size());
  for (const Pose& pose : poses) {
    parents_.push_back(static_cast<std::int32_t>(nodes_.size()) - 1);
    set_pose(nodes_.emplace_back(si_->getStateSpace()).get(), pose);
  }
  if (result_->tree) parents_ = result_->tree->parents;
}

void Planner::getPlannerData(ob::PlannerData& data) const {
  ob::Planner::getPlannerData(data);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const ob::PlannerDataVertex vertex(nodes_[i].get());
    if (parents_[i] < 0) {
      data.addStartVertex(vertex);
    } else {
      data.addEdge(ob::PlannerDataVertex(nodes_[static_cast<std::size_t>(parents_[i])].get()),
                   vertex);
    }
  }
  if (!nodes_.empty() && !result_->tree) data.markGoalState(nodes_.back().get());
}

}  // namespace vandplan::ompl
