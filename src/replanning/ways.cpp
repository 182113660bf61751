// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "replanning/ways.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "judge/track.h"
#include "judge/vias.h"
#include "moving/yielding.h"
#include "planners/in_time.h"
#include "planners/last_stretch.h"
#include "search/route.h"
#include "speed/moving_start.h"
#include "vandplan/input_error.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan::replanning {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double stands = 1e-6;         // up to this speed a vehicle counts as standing [m/s]
constexpr double shortest_stop = 1e-3;  // least length of a path to a stop [m]

double speed_of(const Motion& motion) { return std::abs(motion.v); }

/// The speed, or 0 if it counts as standing.
double standing_or(double speed) { return speed > stands ? speed : 0.0; }

double largest_growth(std::span<const MovingObstacle> moving) {
  double most = 0.0;
  for (const MovingObstacle& obstacle : moving) most = std::max(most, obstacle.inflate);
  return most;
}

/// A drive along a path that stands at its end, and nowhere before.
TimedPath stopping_at(const Path& path) { return {path, {.knots = {{.s = length(path)}}}}; }

bool begins_in_gear(const std::vector<Segment>& segments, Gear gear) {
  return segments.empty() || segments.front().gear() == gear;
}

}  // namespace

std::vector<MovingObstacle> later(std::vector<MovingObstacle> moving, double t) {
  for (MovingObstacle& obstacle : moving) {
    for (TimedPose& row : obstacle.trajectory) row.t -= t;
  }
  return moving;
}

Problem problem_to(const Scene& scene, const Vehicle& vehicle, const RigMotion& from,
                   const RigMotion& to) {
  const double sharpest = 1.0 / scene.vehicle.min_turning_radius;
  const double most = vehicle.max_hitch_angle;
  return make_problem(
      scene.world, vehicle, from.pose, to.pose,
      {std::clamp(from.curvature, -sharpest, sharpest),
       std::clamp(to.curvature, -sharpest, sharpest)},
      {std::clamp(from.hitch_angle, -most, most), std::clamp(to.hitch_angle, -most, most)});
}

Problem problem_from(const Scene& scene, const Vehicle& vehicle, const RigMotion& from) {
  if (!scene.goal_set.empty()) {
    return with_via(with_goal_set(problem_to(scene, vehicle, from, from), scene.goal_set),
                    scene.via);
  }
  const RigMotion goal{{.pose = scene.goal, .curvature = scene.goal_curvature},
                       scene.goal_hitch_angle};
  return with_via(problem_to(scene, vehicle, from, goal), scene.via);
}

// The vehicle has passed as many as the judge finds.
std::vector<Via> via_behind(const Scene& scene, const std::vector<Via>& via, const RigMotion& begin,
                            const TimedPath& drive) {
  if (via.empty()) return {};
  const Problem problem = with_via(problem_to(scene, scene.vehicle, begin, begin), via);
  const std::size_t passed =
      judge::passed_by(problem.task(), judge::integrate(drive.path), drive.speeds);
  return {via.begin() + static_cast<std::ptrdiff_t>(passed), via.end()};
}

double Ways::braking_distance(double v) const {
  const DrivingLimits& limits = scene_.planned.limits;
  return v * v / (2 * limits.max_braking.value_or(limits.max_acceleration));
}

double Ways::cost_of(const TimedPath& drive) const {
  const double time = drive.speeds.duration;
  if (options_.cost.measure == CostMeasure::time) return time;
  const search::CostRule rule = search::cost_rule(options_.cost);
  search::Driven driven = rule.initial_gear;
  return search::drive_cost(rule, drive.path.segments, driven) + in_time::time_price * time;
}

/// Limits of zones and vias on the speed along a path that begins with a motion.
std::vector<SpeedLimit> Ways::limits_along(const Path& path, const RigMotion& begin,
                                           const std::vector<Via>& via) const {
  const Surroundings& ground = scene_.world->local();
  if (ground.zones.empty() && ground.masks.empty() && via.empty()) return {};
  const Problem problem = problem_to(scene_, scene_.planned, begin, begin);
  return speed_options(with_via(problem, via), path).limits;
}

/// Speeds for a path that the vehicle begins `t` seconds from now; none if none are found.
std::optional<TimedPath> Ways::timed(const Path& path, const RigMotion& begin,
                                     const std::vector<Via>& via, double t, double margin,
                                     const WorkLimit& limit, double longest) {
  const double speed = standing_or(speed_of(begin));
  if (speed > 0.0 && !begins_in_gear(path.segments, begin.gear)) return std::nullopt;
  const std::vector<MovingObstacle> moving = later(scene_.moving, t);
  const moving::Traffic traffic{.moving = moving,
                                // `later` drops the growth of outlines before time t, so the margin
                                // contains it.
                                .margin = margin + t * largest_growth(moving),
                                .start_curvature = begin.curvature,
                                .limits = limits_along(path, begin, via),
                                .start_hitch_angle = begin.hitch_angle,
                                .start_speed = speed,
                                .longest = longest,
                                .most_states = limit.states,
                                .is_interrupted = [this] { return deadline_.is_over(); }};
  moving::Yielding yielding = moving::yielding_speeds(path, scene_.planned, traffic);
  work_.states += yielding.states;
  if (!yielding.speeds) return std::nullopt;
  return TimedPath{path, *std::move(yielding.speeds)};
}

/// Path of the planner from standstill, `t` seconds from now; none if it finds none. The
/// path is not judged: callers have the whole drive judged before they take it.
std::optional<std::vector<Segment>> Ways::segments_to_goal(const RigMotion& from,
                                                           const std::vector<Via>& via, double t,
                                                           const PlanOptions& options,
                                                           bool whole_drive) {
  const bool has_set = !scene_.goal_set.empty();
  const double radius = scene_.vehicle.min_turning_radius;
  const bool is_folded_alike =
      !scene_.vehicle.trailer || from.hitch_angle == scene_.goal_hitch_angle;
  if (!has_set && via.empty() && is_folded_alike &&
      reeds_shepp_length(from.pose, scene_.goal, radius) == 0.0) {
    return std::vector<Segment>{};
  }
  try {
    Problem problem = with_via(problem_from(scene_, scene_.planned, from), via);
    if (t >= 0.0) problem = with_moving(std::move(problem), later(scene_.moving, t));
    const Planner& planner = default_planner();
    PlanOptions all = complete(planner, options, scene_.vehicle);
    all.budget = deadline_.cut(all.budget);
    const Task task = planning::to_set_behind_vias(task_of(problem, all.clearance, *all.steering));
    if (!task.checker->is_free(start_state(task))) return std::nullopt;
    if (!has_set && !task.checker->is_free(goal_state(task))) return std::nullopt;
    const bool is_drive = whole_drive || !task.moving.empty();
    PlannerAnswer answer = is_drive ? in_time::plan(task, all) : planner.function(task, all);
    work_.iterations += answer.iterations;
    return std::move(answer.segments);
  } catch (const InputError&) {
    // A pose with a larger error than planners accept has no path.
  }
  return std::nullopt;
}

std::optional<NewDrive> Ways::from_standing(const RigMotion& from, const WorkLimit& limit) {
  PlanOptions options = options_;
  options.budget.seed = limit.seed;
  if (!options.budget.time_limit) options.budget.max_iterations = limit.iterations;
  auto segments = segments_to_goal(from, scene_.via, 0.0, options, true);
  if (!segments) return std::nullopt;
  const Path path{from.pose, *std::move(segments)};
  auto drive = timed(path, from, scene_.via, 0.0, options_.clearance.margin, limit, endless);
  if (!drive) return std::nullopt;
  NewDrive way{*std::move(drive), TickOutcome::new_way, true};
  way.cost = cost_of(way.drive);
  return way;
}

/// Path that a look finds for a vehicle that begins it `t` seconds from now.
std::optional<Path> Ways::path_of(Look look, const CutDrive& from, const std::vector<Via>& via,
                                  double t, const WorkLimit& limit) {
  const RigMotion& begin = from.begin;
  if (look == Look::new_times) return from.drive.path;
  PlanOptions options = options_;
  options.budget.time_limit.reset();
  options.budget.max_iterations = limit.iterations;
  options.budget.seed = limit.seed;
  const double speed = speed_of(begin);
  Path path{begin.pose, {}};
  RigMotion root = begin;
  double begins_at = -1.0;
  if (look == Look::without_stop) {
    // The path continues the current curvature and gear.
    if (speed <= stands) return std::nullopt;
    options.steering = Steering::continuous;
    const bool reverses = begin.gear == Gear::reverse;
    options.cost.initial_gear = reverses ? InitialGear::reverse : InitialGear::forward;
  } else if (speed > stands) {
    path.segments =
        search::part_of(from.drive.path.segments, 0.0, braking_distance(speed) * (1 + 1e-6));
    root.pose = end_pose(path);
    root.hitch_angle = hitch_angle_after(scene_.vehicle, begin.hitch_angle, path.segments);
    if (!path.segments.empty()) {
      const Segment& last = path.segments.back();
      root.curvature = curvature_at(last, std::abs(last.length));
    }
  }
  if (look == Look::around) begins_at = t + 2 * length(path.segments) / std::max(speed, stands);
  const std::vector<Via> ahead =
      path.segments.empty() ? via : via_behind(scene_, via, begin, stopping_at(path));
  const auto found = segments_to_goal(root, ahead, begins_at, options, limit.whole_drive);
  if (!found || found->empty()) return std::nullopt;
  path.segments.insert(path.segments.end(), found->begin(), found->end());
  return path;
}

std::optional<NewDrive> Ways::to_goal(Look look, const CutDrive& rest, const Wish& wish,
                                      const WorkLimit& limit) {
  if (look == Look::new_times && !wish.rest_reaches_goal) return std::nullopt;
  if (scene_.moving.empty() && (look == Look::new_times || look == Look::around)) {
    return std::nullopt;
  }
  const double t = std::min(wish.committed, rest.drive.speeds.duration);
  const TimedPath prefix = before(rest.drive, scene_.vehicle, t);
  const CutDrive after = rest_of(rest.drive, scene_.vehicle, t, rest.begin.hitch_angle);
  const std::vector<Via> via = via_behind(scene_, scene_.via, rest.begin, prefix);
  const std::optional<Path> tail = path_of(look, after, via, t, limit);
  if (!tail) return std::nullopt;
  // The fastest speeds give a lower bound of the cost.
  const RigMotion& begin = after.begin;
  const std::vector<SpeedLimit> limits = limits_along(*tail, begin, via);
  const auto fastest = speed::profile_from(*tail, scene_.planned,
                                           {begin.curvature, standing_or(speed_of(begin)), limits});
  if (!fastest) return std::nullopt;
  const double left = wish.most - cost_of(joined(prefix, {*tail, *fastest}));
  if (left <= 0.0) return std::nullopt;
  const bool is_time = options_.cost.measure == CostMeasure::time;
  const double longest = fastest->duration + (is_time ? left : left / in_time::time_price);
  const auto drive = timed(*tail, begin, via, t, options_.clearance.margin, limit, longest);
  if (!drive) return std::nullopt;
  const bool is_same = look == Look::new_times;
  NewDrive way{joined(prefix, *drive), is_same ? TickOutcome::new_times : TickOutcome::new_way,
               true};
  way.cost = cost_of(way.drive);
  return way;
}

std::optional<NewDrive> Ways::to_stop(int i, const CutDrive& rest, double margin,
                                      const WorkLimit& limit) {
  const std::vector<Segment>& segments = rest.drive.path.segments;
  const double whole = length(segments);
  const double speed = speed_of(rest.begin);
  const double first = speed > stands ? std::min(braking_distance(speed) * (1 + 2e-3), whole) : 0.0;
  if (i > 0 && whole - first <= shortest_stop) return std::nullopt;
  const double far = first + (whole - first) * i * i / ((stops - 1) * (stops - 1));
  if (far <= shortest_stop) return NewDrive{standing_at(rest.begin.pose), TickOutcome::stop};
  const Path path{rest.begin.pose, search::part_of(segments, 0.0, far)};
  auto drive = timed(path, rest.begin, scene_.via, 0.0, margin, limit, endless);
  if (!drive) return std::nullopt;
  return NewDrive{*std::move(drive), TickOutcome::stop};
}

NewDrive Ways::braking(const CutDrive& rest) const {
  const double speed = speed_of(rest.begin);
  NewDrive way{standing_at(rest.begin.pose), TickOutcome::none};
  if (speed <= stands) return way;
  // The vehicle brakes as hard as it can along its path. If the path is too short, it goes on with
  // the current curvature.
  const DrivingLimits& limits = scene_.vehicle.limits;
  const double braking = limits.max_braking.value_or(limits.max_acceleration);
  const double far = speed * speed / (2 * braking);
  Path path{rest.begin.pose, search::part_of(rest.drive.path.segments, 0.0, far)};
  const double left = far - length(path);
  if (path.segments.empty() || left > 1e-9) {
    path.segments.push_back(
        {rest.begin.curvature, std::copysign(left, direction_of(rest.begin.gear))});
  }
  way.drive.path = path;
  SpeedProfile& speeds = way.drive.speeds;
  speeds = {.knots = {{.t = 0.0, .s = 0.0, .v = speed, .a = -braking, .bound = SpeedBound::braking},
                      {.t = speed / braking, .s = length(path)}},
            .duration = speed / braking};
  return way;
}

}  // namespace vandplan::replanning
