// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Prints hashes of the bits of 10^5 steering results, of what every planner answers in two
// scenarios, and of what converters and vehicle files compute; same_on_every_processor compares.

#include <bit>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

#include "base/hash.h"
#include "support/pose_pairs.h"
#include "support/shared_files.h"
#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/path.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

class Hash {
 public:
  void add(double value) {
    char bytes[8];
    auto bits = std::bit_cast<std::uint64_t>(value);
    for (char& byte : bytes) {
      byte = static_cast<char>(bits & 0xff);
      bits >>= 8;
    }
    value_ = base::hash_of({bytes, sizeof bytes}, value_);
  }
  void add(const Pose& pose) {
    for (const double v : {pose.x, pose.y, pose.heading}) add(v);
  }
  /// Segments and the poses at their ends.
  void add(const Pose& from, std::span<const Segment> segments) {
    Pose pose = from;
    for (const Segment& segment : segments) {
      pose = advance(pose, segment);
      for (const double v : {segment.curvature, segment.length, segment.curvature_rate}) add(v);
      add(pose);
    }
  }
  void add(const Pose& from, const Piece& piece) {
    add(piece.length);
    add(from, piece.view());
  }
  void print(const std::string& name) const {
    std::printf("%s %016llx\n", name.c_str(), static_cast<unsigned long long>(value_));
  }

 private:
  std::uint64_t value_ = base::empty_hash;
};

void print_steering() {
  Rng rng(1);
  Hash hash;
  for (int i = 0; i < 100'000; ++i) {
    const auto [from, to] = any_pair(7, rng);
    hash.add(from, reeds_shepp(from, to, 7));
    hash.add(from, dubins(from, to, 7));
  }
  hash.print("steering");
}

void print_plans(const std::string& name, std::int64_t iterations) {
  const Problem problem =
      make_problem(read_scenario((repository() / "scenarios/thesis" / name).string() + ".yaml"));
  PlanOptions options{.cost = shortest_style};
  options.budget.max_iterations = iterations;
  for (const Planner& planner : planners()) {
    const PlanResult result = plan(problem, planner, options);
    Hash hash;
    for (const double v : {result.cost, result.lower_bound.value_or(0.0)}) hash.add(v);
    for (const std::int64_t n :
         {result.iterations, counter(result, "nodes"), counter(result, "edge_checks")}) {
      hash.add(static_cast<double>(n));
    }
    for (const CostSample& sample : result.anytime) hash.add(sample.cost);
    if (result.path) {
      hash.add(result.path->start);
      hash.add(result.path->start, result.path->segments);
    }
    hash.print(name + " " + planner.name + (result.path ? "" : " (no path)"));
  }
}

// For the following numbers the C library's tangent and arc tangent do vary.

/// The turning radius of a vehicle whose file gives the angle of its wheels instead.
void print_radii() {
  Hash hash;
  for (const int angle : {26892, 27944, 28981, 42514, 46295, 49993, 53518, 55729}) {
    const ScenarioFile file = scenario_from_yaml(
        "name: x\nobstacles: []\nbounds: {x: [-9, 9], y: [-9, 9]}\n"
        "start: {x: 0, y: 0, heading: 0}\ngoal: {x: 1, y: 0, heading: 0}\n"
        "vehicle: {wheelbase: 3, front_overhang: 1, rear_overhang: 1, width: 2, "
        "max_steering_angle: " +
            std::to_string(angle) + "e-6}\n",
        "made up");
    hash.add(file.scenario.vehicle.min_turning_radius);
  }
  hash.print("radii");
}

/// The heading from start to goal that a MovingAI problem gets.
void print_headings() {
  TemporaryFolder folder;
  std::string map = "type octile\nheight 30\nwidth 400\nmap\n";
  for (int row = 0; row < 30; ++row) map += std::string(400, '.') + "\n";
  const std::string map_file = folder.put("a.map", map);
  Hash hash;
  for (const auto& [x, y] : {std::pair{69, 8}, {83, 15}, {138, 17}, {237, 19}, {349, 29}}) {
    const std::string problem = "version 1\n0\ta.map\t400\t30\t0\t" + std::to_string(y) + "\t" +
                                std::to_string(x) + "\t0\t1\n";
    const std::string problems = folder.put("a.scen", problem);
    hash.add(read_movingai({.map = map_file, .problems = problems}).start);
  }
  hash.print("headings");
}

}  // namespace
}  // namespace vandplan

int main() {
  vandplan::print_steering();
  vandplan::print_plans("2-flat-obstacle", 400);
  vandplan::print_plans("3-h-shape", 400);
  vandplan::print_radii();
  vandplan::print_headings();
}
