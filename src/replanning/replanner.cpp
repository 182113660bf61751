// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/replanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/require.h"
#include "base/text.h"
#include "drive/plant.h"
#include "problem/moving.h"
#include "replanning/checks.h"
#include "replanning/deviation.h"
#include "replanning/judging.h"
#include "replanning/known_ground.h"
#include "replanning/known_site.h"
#include "replanning/ways.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using namespace replanning;

constexpr std::int64_t first_iterations = 20'000;
/// A first plan in vain is tried again with twice the iterations, up to this factor.
constexpr std::int64_t most_patience = 16;
constexpr std::int64_t urgent_share = 3;  // factor of `tick_iterations` if a drive is needed
constexpr double calm_share = 0.3;        // factor of `tick_iterations` if the drive is good
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::array looks = {Look::new_times, Look::from_stop, Look::without_stop, Look::around};
constexpr double left_for_judge = 0.01;  // part of a time limit that is kept from looks [s]
constexpr double most_for_site = 0.5;    // share of a time limit for the repair of a table
constexpr double still = 0.05;           // largest measured speed of a vehicle that stands [m/s]

/// Checks that the current drive has passed; they hold for the rest of it.
struct Judged {
  bool ground = false;   // the path is free of standing obstacles, as known now
  bool company = false;  // the drive meets no moving obstacle, as predicted now
  bool times = false;    // the speeds keep the limits of the vehicle

  [[nodiscard]] bool all() const noexcept { return ground && company && times; }
};

}  // namespace

class Replanner::Impl {
 public:
  Impl(const Scenario& scenario, const ReplanOptions& options)
      : options_(options), problem_(make_problem(scenario)), ground_(*problem_.world()) {
    check_options(options);
    check_vehicle_of(scenario);
    const Task& task = problem_.task();
    scene_.vehicle = task.vehicle;
    scene_.planned = driving::with_reserve(task.vehicle, options.reserve);
    moving_ = task.moving;
    scene_.via = via_ = task.via;
    take_goal();
    const PlanOptions all = complete(default_planner(), options_.plan, task.vehicle);
    if (options.site) site_.emplace(options.site, scenario, all);
  }

  void patch(const WorldPatch& patch) {
    ground_.patch(patch);
    if (site_) site_->patch(patch);
  }

  void set_moving(std::span<const MovingObstacle> moving) {
    std::vector<MovingObstacle> local = problem::local_moving(moving, ground_.origin());
    if (local == moving_) return;
    moving_ = std::move(local);
    judged_.company = false;
  }

  void set_goal(const Pose& goal) {
    set_goal(make_problem(problem_.world(), problem_.vehicle(), problem_.start(), goal,
                          {problem_.curvatures().start, 0.0},
                          {problem_.hitch_angles().start, 0.0}));
  }

  void set_goal(const std::vector<GoalRegion>& set) { set_goal(with_goal_set(problem_, set)); }

  void tick(double t, const VehicleState* state, const TickLimit& limit) {
    base::require(std::isfinite(t), "t", t, "a time [s]");
    check_limit(limit);
    const BudgetOptions& plans = options_.plan.budget;
    std::optional<double> time = limit.time_limit;
    end_ = Deadline(time, limit.stop, plans);
    if (time) *time -= std::min(*time / 2, left_for_judge);
    end_of_looks_ = Deadline(time, limit.stop, plans);
    if (t < last_t_) {
      throw InputError("t", "is " + base::shortest_text(t) + " s, expected no less than " +
                                base::shortest_text(last_t_) + " s, the time of the last tick");
    }
    if (state != nullptr) check_state(*state, problem_);
    last_t_ = t;
    ++ticks_;
    scene_.world = ground_.world();
    scene_.moving = later(moving_, t);
    if (ground_version_ != ground_.version()) judged_.ground = false;
    if (answer_.drive) scene_.via = via_behind(scene_, via_, begin_of_drive(), driven_until(t));
    has_news_ = !judged_.all();
    ground_version_ = ground_.version();
    if (site_) take_site(limit);
    if (!answer_.drive) {
      begin(t);
    } else {
      go_on(t, state != nullptr && has_braked(t, *state) ? TickOutcome::stop : TickOutcome::kept);
    }
    const bool is_over = t >= answer_.begin + answer_.drive->speeds.duration;
    const bool stands = state == nullptr || std::abs(state->v) <= still;
    out_.has_arrived = answer_.reaches_goal && is_over && stands;
    if (site_) out_.without_site = site_->reason();
  }

  [[nodiscard]] const ReplanAnswer& answer() const noexcept { return out_; }

 private:
  void set_goal(Problem problem) {
    const auto goal_of = [](const Task& task) {
      return std::tie(task.goal, task.curvatures.goal, task.hitch_angles.goal, task.goal_set);
    };
    if (goal_of(problem.task()) == goal_of(problem_.task())) return;
    problem_ = std::move(problem);
    take_goal();
    has_new_goal_ = true;
    next_look_ = 0;
  }

  void take_goal() {
    const Task& task = problem_.task();
    scene_.goal = task.goal;
    scene_.goal_curvature = task.curvatures.goal;
    scene_.goal_hitch_angle = task.hitch_angles.goal;
    scene_.goal_set = task.goal_set;
  }

  /// Gives the plans of this tick the table of the site, repaired, if there is time.
  void take_site(const TickLimit& limit) {
    std::optional<double> time = limit.time_limit;
    if (time) *time *= most_for_site;
    const Deadline end(time, limit.stop, options_.plan.budget);
    options_.plan.site = site_->to_goals_of(problem_, !scene_.via.empty(), ground_, end);
  }

  [[nodiscard]] WorkLimit limit(std::int64_t iterations) const {
    return {iterations, options_.tick_states,
            stream_seed(options_.plan.budget.seed, static_cast<std::uint64_t>(ticks_))};
  }

  [[nodiscard]] Verdict judged(const NewDrive& way, const RigMotion& now, double margin) const {
    return judging_.of_drive({way.drive, now}, way.reaches_goal, margin);
  }

  /// Verdict on the rest of the current drive. Checks that still hold are skipped.
  [[nodiscard]] Verdict judged_again(const CutDrive& rest) const {
    if (judged_.all()) return {};
    if (!judged_.times) return judging_.of_drive(rest, answer_.reaches_goal, margin());
    if (!judged_.ground) {
      Verdict way = judging_.of_path(rest, answer_.reaches_goal);
      if (!way.is_good()) return way;
    }
    if (judged_.company) return {};
    return judging_.of_company(rest, answer_.reaches_goal);
  }

  void set(ReplanAnswer answer) {
    answer_ = std::move(answer);
    via_ = scene_.via;
    TimedPath drive = *answer_.drive;
    drive.path.start.x += ground_.origin().x;
    drive.path.start.y += ground_.origin().y;
    out_ = answer_;
    out_.drive = std::make_shared<const TimedPath>(std::move(drive));
  }

  void take(double t, NewDrive way, const RigMotion& now) {
    judged_ = {true, true, true};
    if (way.reaches_goal) {
      has_new_goal_ = false;
      patience_ = 1;
    }
    set({.outcome = way.outcome,
         .begin = t,
         .drive = std::make_shared<const TimedPath>(std::move(way.drive)),
         .start_speed = std::abs(now.v),
         .start_hitch_angle = now.hitch_angle,
         .reaches_goal = way.reaches_goal,
         .is_safe = true,
         .reason = way.reaches_goal ? "" : judging_.reason_of_no_way()});
  }

  void begin(double t) {
    const Task& task = problem_.task();
    const RigMotion now{{.pose = task.start, .curvature = task.curvatures.start},
                        task.hitch_angles.start};
    if (!plan_from_standing(t, now)) stop_or_brake(t, {standing_at(task.start), now});
  }

  /// Whether a vehicle that stands tries the first plan again: after one tick in vain, then after
  /// two, four, ...
  [[nodiscard]] bool tries_again() const { return patience_ > 1 && ticks_ >= next_try_; }

  /// Takes a drive that a vehicle which stands finds with the budget of the first plan.
  bool plan_from_standing(double t, const RigMotion& now) {
    if (has_new_goal_) patience_ = 1;
    has_new_goal_ = false;
    WorkLimit first = limit(std::min(patience_, most_patience) *
                            options_.plan.budget.max_iterations.value_or(first_iterations));
    next_try_ = ticks_ + patience_;
    patience_ *= 2;
    first.seed = options_.plan.budget.seed;
    first.states = std::max<std::int64_t>(first.states, 200'000);
    auto way = Ways(scene_, options_.plan, end_of_looks_).from_standing(now, first);
    if (!way || !judged(*way, now, margin()).is_good()) return false;
    take(t, *std::move(way), now);
    return true;
  }

  [[nodiscard]] double margin() const { return options_.plan.clearance.margin; }

  /// Whether the vehicle is off the planned state. Unchecked braking then replaces the drive.
  bool has_braked(double t, const VehicleState& state) {
    const RigMotion planned = rest_at(t).begin;
    const RigMotion now = measured_motion(scene_.vehicle, state, planned, ground_.origin());
    if (!is_off(now, planned)) return false;
    NewDrive way = Ways(scene_, options_.plan, end_).braking({standing_at(now.pose), now});
    set({.outcome = TickOutcome::none,
         .begin = t,
         .drive = std::make_shared<const TimedPath>(std::move(way.drive)),
         .start_speed = std::abs(state.v),
         .start_hitch_angle = now.hitch_angle,
         .reaches_goal = false,
         .is_safe = false,
         .reason = "the vehicle is not where it should be"});
    judged_ = {};
    return true;
  }

  [[nodiscard]] RigMotion begin_of_drive() const {
    return {{.pose = answer_.drive->path.start}, answer_.start_hitch_angle};
  }

  /// Part of the current drive before time `t` [s].
  [[nodiscard]] TimedPath driven_until(double t) const {
    return before(*answer_.drive, scene_.vehicle, t - answer_.begin);
  }

  /// Rest of the current drive from time `t` on [s].
  [[nodiscard]] CutDrive rest_at(double t) const {
    return rest_of(*answer_.drive, scene_.vehicle, t - answer_.begin, answer_.start_hitch_angle);
  }

  /// Begins now at the limit of the hitch angle if braking has folded the rig a little beyond it.
  void unfold(double t, CutDrive& rest) {
    const double angle = planned_hitch_angle(scene_.vehicle, rest.begin.hitch_angle);
    if (angle == rest.begin.hitch_angle) return;
    rest.begin.hitch_angle = answer_.start_hitch_angle = angle;
    answer_.begin = t;
    answer_.drive = std::make_shared<const TimedPath>(rest.drive);
    answer_.start_speed = std::abs(rest.begin.v);
    set(answer_);
  }

  /// Goes on; `otherwise` is the outcome if the drive stays though it ends on the way.
  void go_on(double t, TickOutcome otherwise) {
    CutDrive rest = rest_at(t);
    unfold(t, rest);
    if (has_new_goal_) answer_.reaches_goal = judging_.of_path(rest, true).is_good();
    out_.reaches_goal = answer_.reaches_goal;
    const Verdict verdict = judged_again(rest);
    if (verdict.is_good()) judged_ = {true, true, true};
    if (verdict.is_good() && answer_.reaches_goal) {
      next_look_ = 0;
      has_new_goal_ = false;
      return improve(t, rest);
    }
    const bool stands = rest.drive.speeds.duration == 0.0;
    if (stands && (has_new_goal_ || tries_again()) && plan_from_standing(t, rest.begin)) return;
    if (look_on(t, rest, verdict)) return;
    if (verdict.is_good()) return keep(otherwise);
    stop_or_brake(t, rest);
  }

  /// Searches other drives, one look after another, until the work of a tick is used up. The next
  /// tick goes on with the next look. The first round of looks keeps the committed seconds, unless
  /// an obstacle is met within them. The second round drops them.
  bool look_on(double t, const CutDrive& rest, const Verdict& verdict) {
    if (verdict.met <= 0.0) return false;  // every drive meets that obstacle at once
    Ways ways(scene_, options_.plan, end_of_looks_);
    const bool stands = rest.drive.speeds.duration == 0.0;
    const double committed = stands || verdict.met < options_.committed ? 0.0 : options_.committed;
    const std::size_t rounds = verdict.is_good() || committed == 0.0 ? 1 : 2;
    WorkLimit each = limit(options_.tick_iterations * urgent_share / 2);
    bool has_gone_around = false;
    std::vector<NewDrive> found;  // the cheapest last
    for (std::size_t i = 0; i < rounds * looks.size(); ++i) {
      const std::size_t k = next_look_ % (rounds * looks.size());
      if (k % looks.size() == 0 && take_cheapest(t, found, rest.begin)) return true;
      each.states = options_.tick_states * urgent_share - ways.work().states;
      const bool is_enough = ways.work().iterations >= 2 * each.iterations || each.states <= 0;
      if ((i > 0 && is_enough) || end_of_looks_.is_over()) break;
      ++next_look_;
      const Look look = looks[k % looks.size()];
      if (look == Look::around) {
        if (!found.empty() || has_gone_around) continue;
        has_gone_around = true;
      }
      const Wish wish{.committed = k < looks.size() ? committed : 0.0,
                      .rest_reaches_goal = answer_.reaches_goal,
                      .most = found.empty() ? infinite : found.back().cost};
      auto way = ways.to_goal(look, rest, wish, each);
      if (way && way->cost < wish.most) found.push_back(*std::move(way));
      if (!found.empty() && look == Look::new_times) break;  // new speeds on the path suffice
    }
    return take_cheapest(t, found, rest.begin);
  }

  /// Takes the last candidate that the judge accepts, and removes the later ones. When the time is
  /// over, only one is judged.
  bool take_cheapest(double t, std::vector<NewDrive>& found, const RigMotion& now) {
    for (bool is_first = true; !found.empty(); found.pop_back(), is_first = false) {
      if (!is_first && end_.is_over()) return false;
      if (!judged(found.back(), now, margin()).is_good()) continue;
      take(t, std::move(found.back()), now);
      return true;
    }
    return false;
  }

  /// Takes another drive if it is cheaper by the share `better`; otherwise keeps the current one.
  void improve(double t, const CutDrive& rest) {
    if (options_.tick_iterations == 0 || rest.drive.speeds.duration <= 2 * options_.committed) {
      return keep();
    }
    Ways ways(scene_, options_.plan, end_of_looks_);
    Wish wish{.committed = options_.committed,
              .rest_reaches_goal = true,
              .most = ways.cost_of(rest.drive) * (1 - options_.better)};
    const Look not_now = ticks_ % 2 == 0 ? Look::from_stop : Look::without_stop;
    // The current drive is good, so there is time for whole drives: fewer iterations, each dearer.
    WorkLimit calm = limit(static_cast<std::int64_t>(
        std::ceil(calm_share * static_cast<double>(options_.tick_iterations))));
    calm.whole_drive = true;
    std::vector<NewDrive> found;  // the cheapest last
    for (const Look look : looks) {
      if (look == Look::new_times && !has_news_) continue;
      if (look == Look::around || look == not_now || end_of_looks_.is_over()) continue;
      auto way = ways.to_goal(look, rest, wish, calm);
      if (!way || way->cost >= wish.most) continue;
      wish.most = way->cost;
      found.push_back(*std::move(way));
    }
    if (!take_cheapest(t, found, rest.begin)) keep();
  }

  void keep(TickOutcome outcome = TickOutcome::kept) {
    answer_.outcome = out_.outcome = outcome;
    answer_.is_safe = out_.is_safe = true;
    answer_.reason = out_.reason = answer_.reaches_goal ? "" : judging_.reason_of_no_way();
  }

  void stop_or_brake(double t, const CutDrive& rest) {
    const Deadline none;
    Ways ways(scene_, options_.plan, none);
    std::string fault;
    for (const double kept : {margin(), 0.0}) {
      for (int i = 0; i == 0 || (i < Ways::stops && !end_.is_over()); ++i) {
        WorkLimit each = limit(0);
        each.states = std::max<std::int64_t>(each.states * urgent_share - ways.work().states, 0);
        auto way = ways.to_stop(i, rest, kept, each);
        if (!way) continue;
        Verdict verdict = judged(*way, rest.begin, kept);
        if (verdict.is_good()) return take(t, *std::move(way), rest.begin);
        if (fault.empty()) fault = std::move(verdict.fault);
      }
      if (margin() == 0.0) break;
    }
    // Driving on is better if it meets an obstacle later than braking: predictions may change until
    // then.
    NewDrive braking = ways.braking(rest);
    if (judging_.met_at(rest, answer_.reaches_goal) >
        judging_.met_at({braking.drive, rest.begin}, false)) {
      answer_.outcome = out_.outcome = TickOutcome::none;
      judged_.ground = judged_.company = false;
    } else {
      take(t, std::move(braking), rest.begin);
      judged_ = {};
    }
    answer_.is_safe = out_.is_safe = false;
    answer_.reason = out_.reason = fault.empty() ? "there is no time to stop" : fault;
  }

  ReplanOptions options_;
  Problem problem_;
  KnownGround ground_;
  std::optional<KnownSite> site_;  // table that `options_.plan.site` is of
  Scene scene_;
  Judging judging_{scene_, options_.plan.clearance};
  std::vector<MovingObstacle> moving_;  // moving obstacles, with times of the clock
  std::vector<Via> via_;                // what lay ahead when the answer's drive began
  ReplanAnswer answer_;                 // answer of the last tick, in the frame of the ground
  ReplanAnswer out_;                    // answer of the last tick, in the scenario's frame
  std::int64_t ground_version_ = 0;
  std::int64_t ticks_ = 0;
  std::int64_t patience_ = 1;  // factor on the iterations of the next first plan
  std::int64_t next_try_ = 0;  // tick of that plan, if one was in vain
  double last_t_ = -infinite;  // time of the last tick [s]
  std::size_t next_look_ = 0;  // index of the next look while a new drive is needed
  Deadline end_;               // time at which the tick must answer
  Deadline end_of_looks_;      // time at which its looks for better drives end
  Judged judged_;              // checks that the answer's drive has passed
  bool has_new_goal_ = false;  // whether no drive to the goal was looked for yet, or none was found
  bool has_news_ = false;      // whether ground or moving obstacles changed since the last tick
};

Replanner::Replanner(const Scenario& scenario, const ReplanOptions& options)
    : impl_(std::make_unique<Impl>(scenario, options)) {}
Replanner::~Replanner() = default;
Replanner::Replanner(Replanner&&) noexcept = default;
Replanner& Replanner::operator=(Replanner&&) noexcept = default;

void Replanner::patch(const WorldPatch& patch) { impl_->patch(patch); }
void Replanner::set_moving(std::span<const MovingObstacle> moving) { impl_->set_moving(moving); }
void Replanner::set_goal(const Pose& goal) { impl_->set_goal(goal); }
void Replanner::set_goal(const std::vector<GoalRegion>& set) { impl_->set_goal(set); }
ReplanAnswer Replanner::tick(double t, const TickLimit& limit) {
  impl_->tick(t, nullptr, limit);
  return impl_->answer();
}
ReplanAnswer Replanner::tick(double t, const VehicleState& state, const TickLimit& limit) {
  impl_->tick(t, &state, limit);
  return impl_->answer();
}
ReplanAnswer Replanner::answer() const { return impl_->answer(); }

}  // namespace vandplan
