// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "planners/anytime/chain.h"
#include "planners/anytime/finish.h"
#include "planners/anytime/shorten.h"
#include "planners/commands/shorten_drive.h"
#include "planners/commands/wheels.h"
#include "planners/options.h"
#include "planners/pricing.h"
#include "planners/rig/softer_wheels.h"
#include "search/route.h"
#include "search/wheels.h"
#include "steering/words.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"

namespace vandplan {
namespace {

using namespace search;
using commands::DriveShortener;
using planning::Pricing, planning::pricing_of;

constexpr std::array<std::string_view, 2> method_names = {"clothoids", "optimised"};
constexpr std::int64_t max_repairs = 20'000;
constexpr std::int64_t settling = 1000;  // trials that take out what repairs made longer
constexpr double infinity = std::numeric_limits<double>::infinity();

/// One run of the smoother.
class Smoother {
 public:
  Smoother(const Task& task, const PlanOptions& options, const Path& path)
      : task_(task),
        seed_(options.budget.seed),
        pricing_(pricing_of(task, options)),
        budget_(options.budget),
        old_{task.start, path.segments} {}

  [[nodiscard]] PlannerAnswer run(SmoothMethod method);

 private:
  [[nodiscard]] bool is_drivable(Connector& connector) const;
  [[nodiscard]] std::optional<Route> chained(Connector& connector);
  void bend();
  void improve(std::optional<anytime::Shortener>& shortener, std::int64_t trials);
  void take(std::vector<Segment> segments, double price);

  const Task& task_;
  std::uint64_t seed_;
  Pricing pricing_;
  Budget budget_;
  Path old_;
  std::optional<DriveShortener> drive_;  // drive along the old path
  double least_ = infinity;              // price of the answer
  PlannerAnswer answer_;
};

/// Whether the wheels can follow the old path from start to goal, within rounding, and no obstacle
/// blocks it.
bool Smoother::is_drivable(Connector& connector) const {
  Driven before = driven_at_ends(task_, connector.rule().initial_gear).before;
  LocalPose pose(old_.start);
  for (const Segment& segment : old_.segments) {
    if (!can_drive(connector, segment)) return false;
    if (!may_follow(connector, before, segment)) return false;
    if (!connector.is_free(pose, segment)) return false;
    before = last_driven(segment);
    pose = advance(pose, segment);
  }
  const double last = driven_at_ends(task_).after.curvature;
  if (std::abs(last - before.curvature) * connector.radius() > straight_wheels) return false;
  const Pose& goal = task_.goal;
  return std::hypot(pose.x - goal.x, pose.y - goal.y) <= steering::at_goal.position &&
         std::abs(wrap_angle(pose.heading - goal.heading)) <= steering::at_goal.heading;
}

/// Makes segments the answer so far. Because of longer strokes it may cost more than one before.
void Smoother::take(std::vector<Segment> segments, double price) {
  least_ = price;
  const double cost = price - pricing_.lack(segments);
  std::erase_if(answer_.anytime, [&](const CostSample& sample) { return sample.cost <= cost; });
  answer_.anytime.push_back({budget_.elapsed(), budget_.iterations(), cost});
  answer_.segments = std::move(segments);
  answer_.status = PlanStatus::solved;
}

/// [2], [3] A free route along the old path; none if none was found.
std::optional<Route> Smoother::chained(Connector& connector) {
  anytime::Chain chain(task_, connector, old_, stream_seed(seed_, 0));
  if (!chain.join()) return std::nullopt;
  for (std::int64_t i = 0; i < max_repairs && !chain.is_free() && budget_.next(); ++i) {
    chain.repair();
  }
  if (!chain.is_free()) return std::nullopt;
  return chain.route();
}

/// [4] Makes commands of the old path, if their drive is free.
void Smoother::bend() {
  const auto commands = commands::commands_along(task_, old_.segments);
  if (!commands) return;
  drive_.emplace(task_, pricing_.rule(), *commands, stream_seed(seed_, 2), pricing_.measure());
}

/// [5] Shortens the route and bends the old path, in turns.
void Smoother::improve(std::optional<anytime::Shortener>& shortener, std::int64_t trials) {
  const auto offer_route = [&] {
    if (shortener->cost() < least_) take(path_of(shortener->route()).segments, shortener->cost());
  };
  const auto offer_drive = [&] {
    if (drive_->cost() < least_) take(drive_->segments(), drive_->cost());
  };
  if (shortener) offer_route();
  if (drive_) offer_drive();
  for (std::int64_t i = 0; i < trials && (shortener || drive_) && budget_.next(); ++i) {
    if (drive_ && (!shortener || i % 2 == 0)) {
      if (drive_->step()) offer_drive();
    } else if (shortener->step()) {
      offer_route();
    }
  }
}

// The steps of docs/algorithms/smooth.md.
PlannerAnswer Smoother::run(SmoothMethod method) {
  const bool is_optimised = method == SmoothMethod::optimised;
  const std::int64_t trials = is_optimised ? std::numeric_limits<std::int64_t>::max() : settling;
  std::optional<Connector> connector;
  std::optional<anytime::Shortener> shortener;
  bool is_drivable = false;
  if (!task_.vehicle.trailer) {
    connector.emplace(task_, pricing_.rule());
    is_drivable = this->is_drivable(*connector);
    if (is_drivable) {  // [1]
      take(old_.segments, pricing_.price(old_.segments, ClearanceSampling::search));
    }
  }
  if (is_drivable && !is_optimised) return std::move(answer_);
  if (connector) {
    std::optional<Route> route = chained(*connector);
    std::function<double(const Route&)> measure;
    if (const auto of_drive = pricing_.measure()) {
      measure = [of_drive](const Route& r) { return of_drive(path_of(r).segments); };
    }
    if (route) {
      shortener.emplace(*connector, *std::move(route), stream_seed(seed_, 1), anytime::Scope::all,
                        std::move(measure));
    }
  }
  if (is_drivable || task_.vehicle.trailer) bend();
  improve(shortener, trials);
  answer_.iterations = budget_.iterations();
  if (answer_.segments) return std::move(answer_);
  answer_.status = budget_.exhausted().value_or(PlanStatus::no_path);
  answer_.reason = "no way along the path was found that the wheels can follow";
  return std::move(answer_);
}

/// Throws InputError naming "path" for a path with a number that is not finite.
void expect_finite(const Path& path) {
  const auto& [x, y, heading] = path.start;
  bool is_finite = std::isfinite(x) && std::isfinite(y) && std::isfinite(heading);
  for (const auto& [curvature, length, rate] : path.segments) {
    is_finite &= std::isfinite(curvature) && std::isfinite(length) && std::isfinite(rate);
  }
  if (!is_finite) throw InputError("path", "holds a number that is not finite");
}

/// The problem with one goal in place of its set: the goal of the set where the path ends, or else
/// the end of the path.
Problem to_end_of(const Problem& problem, const Path& path) {
  const bool has_set = !problem.goal_set().empty();
  if ((!has_set && problem.via().empty()) || !problem.task().moving.empty()) return problem;
  State end{path.start, problem.hitch_angles().start};
  for (const Segment& segment : path.segments) end = advance(problem.vehicle(), end, segment);
  const std::optional<ReachedGoal> goal = check_path(problem, path).goal;
  const double curvature = goal      ? problem.goal_set()[goal->index].curvature
                           : has_set ? 0.0
                                     : problem.curvatures().goal;
  return make_problem(problem.world(), problem.vehicle(), problem.start(),
                      goal ? goal->pose : end.pose, {problem.curvatures().start, curvature},
                      {problem.hitch_angles().start, end.hitch_angle});
}

/// Whether an option of the run that planned a path counts when the path is smoothed.
bool counts(const Planner& planner, const Setting& setting) {
  if (!honours(planner, setting.name)) return false;
  const CommonOption* const common = find_common_option(setting.name);
  if (common != nullptr && common->part == OptionPart::budget) return false;
  PlanOptions options;
  set_option(options, planner, setting.name, setting.value);
  return options.steering != Steering::reeds_shepp;
}

}  // namespace

SmoothMethod smooth_method_named(std::string_view name) {
  const auto found = std::ranges::find(method_names, name);
  if (found == method_names.end()) {
    throw InputError("method", "\"" + std::string(name) + "\" is not clothoids or optimised");
  }
  return static_cast<SmoothMethod>(found - method_names.begin());
}

Planner smoother(const Path& path, SmoothMethod method) {
  const auto name = method_names[static_cast<std::size_t>(method)];
  return {.name = "smooth-" + std::string(name),
          .summary = "smooths a given path",
          .properties = {.family = "smooth",
                         .capabilities = {Capability::prices, Capability::time, Capability::gears,
                                          Capability::steering, Capability::steering_of_rigs,
                                          Capability::trailers},
                         .style = Style::driver,
                         .steering = Steering::continuous_between_stops,
                         .anytime = method == SmoothMethod::optimised},
          .options = {anytime::min_stroke_option()},
          .function = [path, method](const Task& task, const PlanOptions& options) {
            return Smoother(task, options, path).run(method);
          }};
}

PlanOptions smooth_options(std::span<const Setting> scenario, std::span<const Setting> stored) {
  const Planner planner = smoother({}, {});
  PlanOptions options;
  set_honoured(options, planner, scenario);
  std::vector<Setting> of_run;
  std::copy_if(stored.begin(), stored.end(), std::back_inserter(of_run),
               [&](const Setting& setting) { return counts(planner, setting); });
  set_honoured(options, planner, of_run);
  // Version 0.2.0 stored prices beside the time, which did not count.
  const auto is_time = [](const Setting& s) { return s.name == "cost" && s.value == "time"; };
  if (std::any_of(of_run.begin(), of_run.end(), is_time)) planning::unset_prices(options);
  return options;
}

Smoothed smooth(const Problem& of_set, const Path& path, SmoothMethod method,
                const PlanOptions& options) {
  expect_finite(path);
  const Problem problem = to_end_of(of_set, path);
  const Planner planner = smoother(path, method);
  Smoothed smoothed{.result = plan(problem, planner, options)};
  smoothed.options = complete(planner, options, problem.vehicle());
  const auto& [clearance, steering] =
      std::pair(smoothed.options.clearance, *smoothed.options.steering);
  PathCheck given = check_path(
      problem, path,
      {.clearance = clearance, .steering = steering, .gears = smoothed.options.cost.gears});
  const Task task = task_of(problem, clearance, steering);
  const Pricing pricing = pricing_of(task, smoothed.options);
  smoothed.given_cost = pricing.cost(path.segments, ClearanceSampling::answer);
  const double lack = pricing.lack(path.segments);
  // [6] The answer is never worse than the given path.
  smoothed.given_fault = given.reason;
  PlanResult& result = smoothed.result;
  const auto name_goal = [&] {
    if (!result.path) return;
    PathCheck check = check_path(of_set, *result.path);
    result.goal = check.goal;
    if (check.valid) return;
    // The smoothed path ends at the goal, but not straight.
    result.status = PlanStatus::rejected;
    result.reason = std::move(check.reason);
    result.path.reset();
  };
  name_goal();
  if (!given.valid) return smoothed;
  if (result.path) {
    const double more_cost =
        pricing.cost(result.path->segments, ClearanceSampling::answer) - smoothed.given_cost;
    const double more_lack = pricing.lack(result.path->segments) - lack;
    if (more_cost <= 0.0 && more_lack <= 0.0 && more_cost + more_lack < 0.0) return smoothed;
  }
  smoothed.is_given = true;
  result.status = PlanStatus::solved;
  result.reason.clear();
  result.path = path;
  name_goal();
  result.cost = smoothed.given_cost;
  result.check = std::move(given);
  result.anytime = {{result.time_total, result.iterations, result.cost}};
  return smoothed;
}

}  // namespace vandplan
