// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How long does a roadmap take to build and to ask, beside OMPL's PRM, in turns in one run?
// usage: peer_roadmap_bench NODES NEIGHBOURS QUERIES ROUNDS bounds|scene SCENARIO.yaml...
//
// Both join each milestone to as many nearest ones, with our checker for poses and edges. OMPL's
// checks each edge at once; ours is built both ways: when a route wants it, and at once.
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "support/figure.h"
#include "vandplan/files.h"
#include "vandplan/graphs.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Space = ob::ReedsSheppStateSpace;

struct Settings {
  std::int64_t nodes;
  int neighbours, queries, rounds;
  Region region;
};

Pose pose_of(const ob::State* state) {
  const auto* s = state->as<Space::StateType>();
  return {s->getX(), s->getY(), s->getYaw()};
}

/// Our checker as both of OMPL's.
class OurEdges : public ob::MotionValidator {
 public:
  OurEdges(const ob::SpaceInformationPtr& si, const Task& task)
      : MotionValidator(si), task_(task) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    const Piece piece = reeds_shepp(pose_of(a), pose_of(b), task_.vehicle.min_turning_radius);
    return task_.checker->is_free(Local(pose_of(a)), piece.view());
  }
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>&) const override {
    return checkMotion(a, b);
  }

 private:
  const Task& task_;
};

double seconds(auto work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Grows OMPL's roadmap until it has so many milestones [s].
double build_ompl(const Task& task, const Settings& settings) {
  const auto space = std::make_shared<Space>(task.vehicle.min_turning_radius);
  const Local<Bounds> region = sampling_region(task, settings.region);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0, region.x_min);
  bounds.setHigh(0, region.x_max);
  bounds.setLow(1, region.y_min);
  bounds.setHigh(1, region.y_max);
  space->setBounds(bounds);
  const auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker(
      [&](const ob::State* state) { return task.checker->is_free(Local(pose_of(state))); });
  si->setMotionValidator(std::make_shared<OurEdges>(si, task));
  si->setup();
  ob::ScopedState<Space> start(space), goal(space);
  for (const auto& [state, pose] : {std::pair{&start, task.start}, {&goal, task.goal}}) {
    (*state)->setXY(pose.x, pose.y);
    (*state)->setYaw(wrap_angle(pose.heading));
  }
  const auto definition = std::make_shared<ob::ProblemDefinition>(si);
  definition->setStartAndGoalStates(start, goal);
  og::PRM prm(si);
  prm.setMaxNearestNeighbors(static_cast<unsigned>(settings.neighbours));
  prm.setProblemDefinition(definition);
  prm.setup();
  return seconds([&] {
    prm.growRoadmap(ob::PlannerTerminationCondition(
        [&] { return static_cast<std::int64_t>(prm.milestoneCount()) >= settings.nodes; }));
  });
}

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Times of the same queries, which are to be answered the same [s].
std::vector<double> ask(const Roadmap& roadmap,
                        const std::vector<std::pair<LocalPose, LocalPose>>& queries, int& solved) {
  std::vector<double> times;
  solved = 0;
  for (const auto& [from, to] : queries) {
    times.push_back(seconds([&] { solved += roadmap.route(from, to).route ? 1 : 0; }));
  }
  return times;
}

void compare(const std::string& name, const Problem& problem, const Settings& settings) {
  const Task& task = problem.task();
  const Local<Bounds> region = sampling_region(task, settings.region);
  std::vector<std::pair<LocalPose, LocalPose>> queries;
  Rng rng(1);
  const auto free_pose = [&] {
    for (;;) {
      const LocalPose pose = uniform_pose(region, rng);
      if (task.checker->is_free(pose)) return pose;
    }
  };
  for (int i = 0; i < settings.queries; ++i) {
    const LocalPose from = free_pose();
    queries.emplace_back(from, free_pose());
  }
  std::vector<double> lazy, whole, ompl, cold, warm;
  int solved = 0;
  std::int64_t edges = 0;
  for (int round = 0; round < settings.rounds; ++round) {
    const RoadmapOptions options{.nodes = settings.nodes,
                                 .neighbours = settings.neighbours,
                                 .seed = static_cast<std::uint64_t>(round) + 1,
                                 .region = region};
    std::optional<Roadmap> roadmap;
    lazy.push_back(
        seconds([&] { roadmap = build_roadmap(*problem.world(), task.vehicle, options); }));
    cold.push_back(median(ask(*roadmap, queries, solved)));
    const Roadmap other = build_roadmap(*problem.world(), task.vehicle, options);
    whole.push_back(lazy.back() + seconds([&] { other.check_edges(); }));
    warm.push_back(median(ask(other, queries, solved)));
    edges = other.edges();
    ompl.push_back(build_ompl(task, settings));
  }
  std::printf(
      "%-24s build %8.4f s, with edges %8.4f s, OMPL %8.3f s: %6.1f and %6.1f times as fast; "
      "query %s ms at first, %s ms then; %d of %d answered, %lld edges\n",
      name.c_str(), median(lazy), median(whole), median(ompl), median(ompl) / median(lazy),
      median(ompl) / median(whole), figure("%.3f", 1e3 * median(cold)).c_str(),
      figure("%.3f", 1e3 * median(warm)).c_str(), solved, settings.queries,
      static_cast<long long>(edges));
  std::fflush(stdout);
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) {
  using namespace vandplan;
  if (argc < 7) {
    std::fprintf(stderr,
                 "usage: peer_roadmap_bench NODES NEIGHBOURS QUERIES ROUNDS bounds|scene "
                 "SCENARIO.yaml...\n");
    return 2;
  }
  const Settings settings{std::atoll(argv[1]), std::atoi(argv[2]), std::atoi(argv[3]),
                          std::atoi(argv[4]),
                          argv[5] == std::string("bounds") ? Region::bounds : Region::scene};
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(1);
  for (int i = 6; i < argc; ++i) {
    const auto [file, problems] = read_problems(argv[i]);
    compare(file.scenario.name, problems[0], settings);
  }
}
