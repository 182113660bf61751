// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How do OMPL's planners do on the same problems, in turns with ours?
// usage: peer_planners_bench SEEDS SECONDS bounds|scene PLANNER,...|all SCENARIO.yaml...
//
// Planners are OMPL's, as named below, and ours beside "anytime": "RRT*,rrt-star/informed=false".
// Region of the samples, for all alike. Times are processor time, of all threads together.
// Each of OMPL's planners runs twice: with an ordinary test of the footprint's polygon every 0.1 m,
// and with our checker as its motion validator. Every path goes through our judge.
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/SORRTstar.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "vandplan/path_check.h"
#include "vandplan/planner.h"
#include "vandplan/reeds_shepp.h"
#include "vandplan/scenario_file.h"

namespace vandplan {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Space = ob::ReedsSheppStateSpace;

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double check_distance = 0.1;  // [m] between two tests of the ordinary checker

Pose pose_of(const ob::State* state) {
  const auto* s = state->as<Space::StateType>();
  return {s->getX(), s->getY(), s->getYaw()};
}

// ---- the ordinary checker: sides of footprint and polygon cross, or one holds the other ----

double cross(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool sides_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return cross(a, b, c) * cross(a, b, d) <= 0 && cross(c, d, a) * cross(c, d, b) <= 0;
}

template <typename Corners>
bool holds(const Corners& polygon, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point& a = polygon[i];
    const Point& b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
      inside = !inside;
    }
  }
  return inside;
}

bool overlap(const std::array<Point, 4>& body, const Polygon& polygon) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < polygon.size(); ++j) {
      const Point& next = polygon[(j + 1) % polygon.size()];
      if (sides_cross(body[i], body[(i + 1) % 4], polygon[j], next)) return true;
    }
  }
  return holds(polygon, body[0]) || holds(body, polygon[0]);
}

class SampledChecker : public ob::StateValidityChecker {
 public:
  SampledChecker(const ob::SpaceInformationPtr& si, const Task& task)
      : StateValidityChecker(si), body_(footprint(task.vehicle)) {
    for (const Polygon& polygon : task.world->local().obstacles) {
      obstacles_.push_back({polygon, bounding_box(polygon)});
    }
  }
  bool isValid(const ob::State* state) const override {
    if (!si_->satisfiesBounds(state)) return false;
    const std::array<Point, 4> body = corners(body_, pose_of(state));
    const Bounds box = bounding_box(body);
    return std::none_of(obstacles_.begin(), obstacles_.end(), [&](const Obstacle& o) {
      const bool apart = o.box.x_min > box.x_max || o.box.x_max < box.x_min ||
                         o.box.y_min > box.y_max || o.box.y_max < box.y_min;
      return !apart && overlap(body, o.polygon);
    });
  }

 private:
  struct Obstacle {
    Polygon polygon;
    Bounds box;
  };
  Footprint body_;
  std::vector<Obstacle> obstacles_;
};

// ---- our checker in OMPL's place ----

class OurPoses : public ob::StateValidityChecker {
 public:
  OurPoses(const ob::SpaceInformationPtr& si, const Task& task)
      : StateValidityChecker(si), task_(task) {}
  bool isValid(const ob::State* state) const override {
    return task_.checker->is_free(pose_of(state));
  }

 private:
  const Task& task_;
};

class OurEdges : public ob::MotionValidator {
 public:
  OurEdges(const ob::SpaceInformationPtr& si, const Task& task)
      : MotionValidator(si), task_(task) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    const Piece piece = reeds_shepp(pose_of(a), pose_of(b), task_.vehicle.min_turning_radius);
    return task_.checker->is_free(pose_of(a), piece.view());
  }
  // The last valid state is looked for by halving.
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last) const override {
    if (checkMotion(a, b)) return true;
    last.second = 0.0;
    if (last.first != nullptr) si_->copyState(last.first, a);
    return false;
  }

 private:
  const Task& task_;
};

// ---- one run ----

struct Settings {
  int seeds;
  double seconds;
  Region region;
  std::string planners;  // names with commas between and around them, or all

  [[nodiscard]] bool wants(const std::string& name) const {
    return planners == ",all," || planners.find("," + name + ",") != std::string::npos;
  }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    std::istringstream text(planners);
    for (std::string name; std::getline(text, name, ',');) all.push_back(name);
    return all;
  }
};

struct Outcome {
  double first = never;  // [ms]
  double cost = never;   // at the end [m]
  bool valid = true;
  double rate = 0.0;  // iterations in a second, where they are known
};

using MakePlanner = std::function<ob::PlannerPtr(const ob::SpaceInformationPtr&)>;

template <typename Planner>
ob::PlannerPtr make(const ob::SpaceInformationPtr& si) {
  return std::make_shared<Planner>(si);
}

const std::vector<std::pair<const char*, MakePlanner>>& ompl_planners() {
  static const std::vector<std::pair<const char*, MakePlanner>> table = {
      {"RRTConnect", make<og::RRTConnect>},
      {"RRT", make<og::RRT>},
      {"RRT*", make<og::RRTstar>},
      {"InformedRRT*", make<og::InformedRRTstar>},
      {"SORRT*", make<og::SORRTstar>},
      {"BIT*", make<og::BITstar>},
      {"ABIT*", make<og::ABITstar>},
      {"AIT*", make<og::AITstar>},
      {"APS", make<og::AnytimePathShortening>},
  };
  return table;
}

void set_pose(ob::ScopedState<Space>& state, const Pose& pose) {
  state->setXY(pose.x, pose.y);
  state->setYaw(wrap_angle(pose.heading));
}

Path path_of(const og::PathGeometric& found, const Problem& problem) {
  Path path{problem.start(), {}};
  for (unsigned i = 1; i < found.getStateCount(); ++i) {
    const Piece piece = reeds_shepp(pose_of(found.getState(i - 1)), pose_of(found.getState(i)),
                                    problem.vehicle().min_turning_radius);
    path.segments.insert(path.segments.end(), piece.view().begin(), piece.view().end());
  }
  return path;
}

Outcome run_ompl(const Problem& problem, const MakePlanner& make_planner, bool ours,
                 const Settings& settings) {
  const Task& task = problem.task();
  const auto space = std::make_shared<Space>(task.vehicle.min_turning_radius);
  const Bounds region = sampling_region(task, settings.region);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0, region.x_min);
  bounds.setHigh(0, region.x_max);
  bounds.setLow(1, region.y_min);
  bounds.setHigh(1, region.y_max);
  space->setBounds(bounds);
  og::SimpleSetup setup(space);
  const ob::SpaceInformationPtr si = setup.getSpaceInformation();
  if (ours) {
    setup.setStateValidityChecker(std::make_shared<OurPoses>(si, task));
    si->setMotionValidator(std::make_shared<OurEdges>(si, task));
  } else {
    setup.setStateValidityChecker(std::make_shared<SampledChecker>(si, task));
  }
  si->setStateValidityCheckingResolution(check_distance / space->getMaximumExtent());
  ob::ScopedState<Space> start(space), goal(space);
  set_pose(start, task.start);
  set_pose(goal, task.goal);
  setup.setStartAndGoalStates(start, goal, 1e-9);
  setup.setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si));
  setup.setPlanner(make_planner(si));
  setup.setup();
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  Outcome outcome;
  const auto found = [&](const ob::Planner*, const std::vector<const ob::State*>&, ob::Cost) {
    outcome.first = std::min(outcome.first, 1e3 * elapsed());
  };
  setup.getProblemDefinition()->setIntermediateSolutionCallback(found);
  setup.solve(settings.seconds);
  if (const auto* star = dynamic_cast<const og::RRTstar*>(setup.getPlanner().get())) {
    outcome.rate = star->numIterations() / elapsed();
  }
  if (!setup.haveExactSolutionPath()) return outcome;
  outcome.first = std::min(outcome.first, 1e3 * elapsed());
  const Path path = path_of(setup.getSolutionPath(), problem);
  const PathCheck check = check_path(problem, path, {});
  outcome.cost = check.length;
  outcome.valid = check.valid;
  return outcome;
}

/// One of our planners with options of its own: "rrt-star/informed=false".
struct Ours {
  Planner planner;
  std::vector<std::pair<std::string, std::string>> options = {};
};

std::optional<Ours> ours_named(const std::string& text) {
  std::istringstream parts(text);
  std::string part;
  std::getline(parts, part, '/');
  const std::optional<Planner> planner = find_planner(part);
  if (!planner) return std::nullopt;
  Ours ours{*planner};
  while (std::getline(parts, part, '/')) {
    const std::size_t equals = part.find('=');
    ours.options.emplace_back(part.substr(0, equals), part.substr(equals + 1));
  }
  return ours;
}

Outcome run_ours(const Problem& problem, const Ours& ours, int seed, double seconds,
                 Region region) {
  PlanOptions options{.cost = shortest_style};
  options.budget.seed = static_cast<std::uint64_t>(seed);
  options.budget.time_limit = seconds;
  options.planner.set("region", region == Region::scene ? "scene" : "bounds");
  for (const auto& [name, value] : ours.options) set_option(options, ours.planner, name, value);
  const PlanResult result = plan(problem, ours.planner, options);
  Outcome outcome{.rate = static_cast<double>(result.iterations) / result.time_total};
  outcome.valid = result.status != PlanStatus::rejected;
  if (!result.path) return outcome;
  outcome.first = 1e3 * result.anytime.front().time;
  outcome.cost = result.cost;
  return outcome;
}

// ---- the table ----

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void print(const char* planner, const std::vector<Outcome>& outcomes) {
  std::vector<double> first, cost, rate;
  int judged = 0;
  for (const Outcome& outcome : outcomes) {
    first.push_back(outcome.first);
    cost.push_back(outcome.cost);
    rate.push_back(outcome.rate);
    judged += outcome.valid ? 0 : 1;
  }
  std::printf(
      "  %-26s first %9.3f %9.3f %9.3f ms   length %8.2f %8.2f %8.2f m   rejected %d"
      "   %7.0f iterations/s\n",
      planner, quantile(first, 0.5), quantile(first, 0.95), quantile(first, 1.0),
      quantile(cost, 0.5), quantile(cost, 0.95), quantile(cost, 1.0), judged, quantile(rate, 0.5));
}

void compare(const std::string& scenario, const Problem& problem, const Settings& settings) {
  std::map<std::string, std::vector<Outcome>> outcomes;
  std::vector<std::string> order;
  const auto add = [&](const std::string& name, const Outcome& outcome) {
    if (outcomes[name].empty()) order.push_back(name);
    outcomes[name].push_back(outcome);
  };
  for (int seed = 1; seed <= settings.seeds; ++seed) {
    for (const double time : {0.01, 0.1, settings.seconds}) {
      const std::string name = "anytime, " + std::to_string(std::lround(1e3 * time)) + " ms";
      add(name, run_ours(problem, {default_planner()}, seed, time, settings.region));
    }
    for (const std::string& name : settings.names()) {
      const std::optional<Ours> ours = ours_named(name);
      if (ours) add(name, run_ours(problem, *ours, seed, settings.seconds, settings.region));
    }
    for (const auto& [name, make_planner] : ompl_planners()) {
      if (!settings.wants(name)) continue;
      add(name, run_ompl(problem, make_planner, false, settings));
      add(std::string(name) + ", our checker", run_ompl(problem, make_planner, true, settings));
    }
  }
  std::printf("%s\n", scenario.c_str());
  for (const std::string& name : order) print(name.c_str(), outcomes[name]);
  std::fflush(stdout);
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) {
  using namespace vandplan;
  if (argc < 6) {
    std::fprintf(stderr,
                 "usage: peer_planners_bench SEEDS SECONDS bounds|scene PLANNER,...|all "
                 "SCENARIO.yaml...\n");
    return 2;
  }
  const Settings settings{std::atoi(argv[1]), std::atof(argv[2]),
                          argv[3] == std::string("bounds") ? Region::bounds : Region::scene,
                          "," + std::string(argv[4]) + ","};
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(1);
  std::printf("median, 95 %%, worst of %d; region %s; processor time, without OMPL's setup\n",
              settings.seeds, argv[3]);
  for (int i = 5; i < argc; ++i) {
    const auto [file, problems] = read_problems(argv[i]);
    // Of a row the goal that counts 200 m; otherwise the only one.
    const auto goal = std::ranges::find(file.row, 200.0, &RowGoal::distance);
    const auto number = goal == file.row.end() ? 0 : goal - file.row.begin();
    compare(file.scenario.name, problems[static_cast<std::size_t>(number)], settings);
  }
}
