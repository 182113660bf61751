// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How does a drive become a solution of CommonRoad?
//
// Model KS: states of the rear axle's midpoint at multiples of the time step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/commonroad.h"
#include "vandplan/input_error.h"
#include "vandplan/motion.h"

namespace vandplan {
namespace {

using namespace io;

constexpr double most_states = 1e6;

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

std::string state_text(const Motion& motion, double time) {
  return fmt::format(
      "    <ksState>\n      <x>{}</x>\n      <y>{}</y>\n"
      "      <steeringAngle>{}</steeringAngle>\n      <velocity>{}</velocity>\n"
      "      <orientation>{}</orientation>\n      <time>{}</time>\n    </ksState>\n",
      motion.pose.x, motion.pose.y, motion.steering_angle, motion.v, motion.pose.heading, time);
}

/// Tells why CommonRoad may refuse a drive that stands at its goal from the time step `arrival` on.
void warn_of_goal(const XmlFile& file, const XmlNode& goal, double arrival,
                  std::vector<std::string>& warnings) {
  if (const XmlNode time = goal.child("time")) {
    const Interval wanted = interval_from(file, time);
    if (arrival > wanted.most) {
      warnings.push_back(
          fmt::format("{}: the drive is at the goal at time step {}, expected at "
                      "most {}",
                      file.place_of(time), arrival, wanted.most));
    }
  }
  if (const XmlNode velocity = goal.child("velocity")) {
    const Interval wanted = interval_from(file, velocity);
    if (wanted.least > 0.0 || wanted.most < 0.0) {
      warnings.push_back(fmt::format("{}: the drive ends at rest, expected {} to {} m/s",
                                     file.place_of(velocity), wanted.least, wanted.most));
    }
  }
}

}  // namespace

CommonRoadSolution commonroad_solution(const CommonRoadCase& one, const PlanResult& result) {
  if (one.vehicle) {
    throw InputError("vehicle", "is given, expected none: solutions are of CommonRoad's vehicle 2");
  }
  if (!result.path) throw InputError("result", "has no path, expected one");
  const Scenario scenario = read_commonroad(one).file.scenario;
  const XmlFile file(one.file, "commonRoad", "a scenario of CommonRoad");
  const XmlNode problem = planning_problem(file, one.problem);
  const std::vector<XmlNode> places = goal_places(file, problem);
  const std::size_t index = result.goal ? result.goal->index : 0;
  const XmlNode goal = places.at(std::min(index, places.size() - 1)).parent().parent();
  const Path& path = *result.path;
  const SpeedProfile speeds =
      result.speeds ? *result.speeds
                    : speed_profile(path, scenario.vehicle, speed_options(scenario, path));
  const double step = time_step_of(file);
  const double begin = begin_of(file, problem);
  const double arrival = begin + std::ceil(speeds.duration / step - 1e-9);
  double end = arrival;
  if (const XmlNode time = goal.child("time")) end = std::max(end, interval_from(file, time).least);
  if (!(end - begin <= most_states)) {
    file.fail(problem,
              fmt::format("needs {} time steps, expected at most {}", end - begin, most_states));
  }
  CommonRoadSolution solution;
  solution.text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<CommonRoadSolution benchmark_id=\"KS2:SM1:{}:{}\" computation_time=\"{}\">\n"
      "  <ksTrajectory planningProblem=\"{}\">\n",
      escaped(file.text(file.root(), "benchmarkID")),
      escaped(file.text(file.root(), "commonRoadVersion")), result.time_total,
      escaped(file.text(problem, "id")));
  for (double time = begin; time <= end; time += 1.0) {
    const double seconds = (time - begin) * step;
    solution.text += state_text(motion_at(path, scenario.vehicle, speeds, seconds), time);
  }
  solution.text += "  </ksTrajectory>\n</CommonRoadSolution>\n";
  const XmlNode velocity = problem.child("initialState").child("velocity");
  if (velocity && exact_from(file, velocity) != 0.0) {
    solution.warnings.push_back(fmt::format("{}: the drive begins at rest, expected {} m/s",
                                            file.place_of(velocity), exact_from(file, velocity)));
  }
  warn_of_goal(file, goal, arrival, solution.warnings);
  return solution;
}

}  // namespace vandplan
