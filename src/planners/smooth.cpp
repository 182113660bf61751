// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "planners/along_path.h"
#include "planners/anytime/chain.h"
#include "planners/anytime/finish.h"
#include "planners/anytime/shorten.h"
#include "planners/commands/shorten_drive.h"
#include "planners/commands/wheels.h"
#include "planners/last_stretch.h"
#include "planners/options.h"
#include "planners/pricing.h"
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
constexpr std::int64_t settling = 1000;          // trials that take out what repairs made longer
constexpr std::int64_t work_of_round = 1 << 20;  // iterations between two looks at the budget
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Smooths a path step by step.
class Smoother final : public planning::PathSearch {
 public:
  /// `path` is in the frame of the task; its ends need not be those of the task. The task outlives
  /// the smoother.
  Smoother(const Task& task, const PlanOptions& options, const Path& path, SmoothMethod method)
      : task_(task),
        seed_(options.budget.seed),
        method_(method),
        pricing_(pricing_of(task, options)),
        budget_(options.budget),
        old_(path) {}

  bool advance(std::int64_t most) override;
  /// The smoothed path; with the method clothoids none before it is settled.
  [[nodiscard]] std::optional<std::vector<Segment>> path() override {
    const bool is_settled = method_ == SmoothMethod::optimised || !has_work();
    return is_settled ? answer_.segments : std::nullopt;
  }
  [[nodiscard]] std::int64_t iterations() const override { return budget_.iterations(); }
  [[nodiscard]] PlannerAnswer answer() override;

 private:
  [[nodiscard]] bool is_drivable(Connector& connector) const;
  void begin();
  void begin_trials();
  void bend();
  [[nodiscard]] bool is_repairing() const;
  [[nodiscard]] bool has_work() const;
  void step();
  void offer_route();
  void offer_drive();
  void take(std::vector<Segment> segments, double price);

  const Task& task_;
  std::uint64_t seed_;
  SmoothMethod method_;
  Pricing pricing_;
  Budget budget_;
  Path old_;
  bool has_begun_ = false, is_drivable_ = false, is_trying_ = false;
  std::optional<Connector> connector_;
  std::optional<anytime::Chain> chain_;  // none once it is free or given up
  std::optional<anytime::Shortener> shortener_;
  std::optional<DriveShortener> drive_;  // drive along the old path
  std::int64_t repairs_ = 0, trials_ = 0;
  double least_ = infinity;  // price of the answer
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
    pose = vandplan::advance(pose, segment);
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

/// [4] Makes commands of the old path, if their drive is free.
void Smoother::bend() {
  const auto commands = commands::commands_along(task_, old_.segments);
  if (!commands) return;
  drive_.emplace(task_, pricing_.rule(), *commands, stream_seed(seed_, 2), pricing_.measure());
}

void Smoother::offer_route() {
  if (shortener_->cost() < least_) take(path_of(shortener_->route()).segments, shortener_->cost());
}

void Smoother::offer_drive() {
  if (drive_->cost() < least_) take(drive_->segments(), drive_->cost());
}

// The steps of docs/algorithms/smooth.md.
void Smoother::begin() {
  has_begun_ = true;
  if (!task_.vehicle.trailer) {
    connector_.emplace(task_, pricing_.rule());
    is_drivable_ = is_drivable(*connector_);
    if (is_drivable_) {  // [1]
      take(old_.segments, pricing_.price(old_.segments, ClearanceSampling::search));
      if (method_ != SmoothMethod::optimised) return;
    }
    chain_.emplace(task_, *connector_, old_, stream_seed(seed_, 0));  // [2]
    if (!chain_->join()) chain_.reset();
  }
  if (!is_repairing()) begin_trials();
}

/// Makes what trials shorten: a route of the chain, if that is free, and the old path bent.
void Smoother::begin_trials() {
  is_trying_ = true;
  if (chain_ && chain_->is_free()) {
    std::function<double(const Route&)> measure;
    if (const auto of_drive = pricing_.measure()) {
      measure = [of_drive](const Route& r) { return of_drive(path_of(r).segments); };
    }
    shortener_.emplace(*connector_, chain_->route(), stream_seed(seed_, 1), std::move(measure));
  }
  chain_.reset();
  if (is_drivable_ || task_.vehicle.trailer) bend();
  if (shortener_) offer_route();
  if (drive_) offer_drive();
}

bool Smoother::is_repairing() const {
  return chain_ && repairs_ < max_repairs && !chain_->is_free();
}

bool Smoother::has_work() const {
  if (is_repairing()) return true;
  const bool may_try = method_ == SmoothMethod::optimised || trials_ < settling;
  return is_trying_ && may_try && (shortener_ || drive_);
}

/// [3] One repair, or [5] one trial: the route is shortened and the old path bent, in turns.
void Smoother::step() {
  if (is_repairing()) {
    ++repairs_;
    chain_->repair();
    if (!is_repairing()) begin_trials();
    return;
  }
  if (drive_ && (!shortener_ || trials_ % 2 == 0)) {
    if (drive_->step()) offer_drive();
  } else if (shortener_->step()) {
    offer_route();
  }
  ++trials_;
}

bool Smoother::advance(std::int64_t most) {
  if (!has_begun_) begin();
  for (; most > 0 && has_work(); --most) {
    if (!budget_.next()) {
      if (is_repairing()) {
        chain_.reset();
        begin_trials();
      }
      return false;
    }
    step();
  }
  return has_work();
}

PlannerAnswer Smoother::answer() {
  PlannerAnswer answer = answer_;
  answer.iterations = budget_.iterations();
  if (answer.segments) return answer;
  answer.status = budget_.exhausted().value_or(PlanStatus::no_path);
  answer.reason = "no way along the path was found that the wheels can follow";
  return answer;
}

/// Smooths a path leg by leg: past vias, after the distances `passed`, and up to the straight line
/// that ends it, `last_stretch` of the task. In turn with that, vias slide along their sets where
/// that makes it cheaper.
PlannerAnswer smoothed_by_legs(Task to_goal, const PlanOptions& options, const Path& path,
                               std::span<const double> passed, SmoothMethod method) {
  to_goal.goal_set.clear();
  const planning::SearchTo smoother_of = [&](const Task& leg, const PlanOptions& of_leg,
                                             const Path* known) {
    const Path& old = known != nullptr ? *known : path;
    return std::make_unique<Smoother>(leg, of_leg, Path{leg.start, old.segments}, method);
  };
  const auto search = planning::search_with_line(to_goal, options, 0.0, &path, passed, smoother_of);
  Budget budget(options.budget);
  const bool is_optimised = method == SmoothMethod::optimised;
  while (!budget.exhausted() && (is_optimised || !search->path())) {
    const std::int64_t before = search->iterations();
    const std::int64_t wanted = search->path() ? work_of_round : 1;  // at first on each leg
    const bool goes_on = search->advance(budget.left(wanted, 0));
    budget.spend(search->iterations() - before);
    if (!goes_on) break;
  }
  PlannerAnswer answer = search->answer();
  answer.lower_bound.reset();
  if (!answer.segments && budget.exhausted()) answer.status = *budget.exhausted();
  return answer;
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

/// `smoother` of a path, leg by leg.
Planner smoother_by_legs(const Path& path, const planning::Along& along, SmoothMethod method) {
  Planner planner = smoother(path, method);
  planner.properties.capabilities.add(Capability::goal_sets);  // the end of the path
  planner.properties.capabilities.add(Capability::via);
  planner.function = [path, passed = along.passed, last_stretch = along.last_stretch, method](
                         const Task& task, const PlanOptions& options) {
    Task to_goal = task;
    to_goal.last_stretch = last_stretch;
    return smoothed_by_legs(to_goal, options, {task.start, path.segments}, passed, method);
  };
  return planner;
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
            Smoother smoother(task, options, {task.start, path.segments}, method);
            while (smoother.advance(work_of_round)) {
            }
            return smoother.answer();
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
  const planning::Along along = planning::along_path(of_set, path);
  const Problem& problem = along.problem;
  const bool has_legs = !along.passed.empty() || along.last_stretch != 0.0;
  const Planner planner = has_legs ? smoother_by_legs(path, along, method) : smoother(path, method);
  const Problem planned = along.passed.empty() ? with_via(problem, {}) : problem;
  Smoothed smoothed{.result = plan(planned, planner, options)};
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
    result.via = check.via;
    if (check.valid) return;
    // The given path did not end straight, nor does the smoothed one.
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
