// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/in_time.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "moving/yielding.h"
#include "planners/blocked_ends.h"
#include "planners/default_search.h"
#include "planners/drive_source.h"
#include "planners/drive_time.h"
#include "planners/ghosts.h"
#include "planners/last_stretch.h"
#include "planners/path_search.h"
#include "planners/plan_to_set.h"
#include "planners/pricing.h"
#include "planners/refuges.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan::in_time {
namespace {

using planning::PathSearch;
using search::Budget;

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr std::int64_t states_per_iteration = 200;  // states that count as one iteration
constexpr std::int64_t first_states = 40'000;       // most states for one path at first
constexpr double worth_a_way_around = 0.5;          // excess that starts searches around [m or s]
constexpr std::size_t max_ghosts = 4;               // ghosts of one source
constexpr std::ptrdiff_t max_open_sources = 24;     // sources with ghosts that are not finished
constexpr std::int64_t max_states_of_path = 1'000'000;  // most states for one path (memory)
constexpr std::int64_t head_start = 64;        // work of others before ghosts for ever [iterations]
constexpr std::int64_t before_refuges = 1500;  // iterations before refuges are tried
constexpr double share_of_refuges = 0.5;       // share of later work without a drive
constexpr double later_share_of_refuges = 0.125;  // share of later work with a drive

/// One run: the best way so far, the sources, and the budget.
class InTimeRun {
 public:
  InTimeRun(const Task& task, const PlanOptions& options, std::span<const NamedSource> sources)
      : task_(task),
        options_(options),
        paths_(sources),
        pricing_(task, options.cost, time_price),
        budget_(options.budget),
        tried_(task.moving) {}

  [[nodiscard]] PlannerAnswer answer() {
    // 0. Cases without a search: an obstacle blocks start or goal, or the goal is the start.
    if (PlannerAnswer none{.status = PlanStatus::no_path,
                           .reason = proof_of_none(task_, options_.clearance.margin)};
        !none.reason.empty()) {
      return none;
    }
    Source& first = sources_.emplace_back(Source{.ghosts = {}, .task = task_});
    if (planning::is_there(task_)) {
      consider(first, {}, false);
      PlannerAnswer answer = finished({});
      if (!best_) answer.reason = "the goal is the start, and something that moves comes there";
      return answer;
    }
    // 1. The sources take turns, and each path that they find gets its times.
    while (!budget_.exhausted() && !is_settled() && step()) {
    }
    PlannerAnswer alone_answer = first.search ? first.search->answer() : PlannerAnswer{};
    if (!best_ && !alone_answer.segments && alone_answer.status == PlanStatus::no_path) {
      alone_answer.iterations = budget_.iterations();
      return alone_answer;
    }
    return finished(std::move(alone_answer));
  }

 private:
  [[nodiscard]] std::unique_ptr<PathSearch> search_of(const Task& task,
                                                      const anytime::Given& given) const {
    PlanOptions options = options_;
    options.budget.max_iterations.reset();
    if (options.budget.time_limit) {
      *options.budget.time_limit = std::max(*options.budget.time_limit - budget_.elapsed(), 0.0);
    }
    const auto search_to = [site = options_.site.get(), sources = given.sources](
                               const Task& to, const PlanOptions& round, const Path* known) {
      return planning::default_search(to, round, time_price,
                                      {.known = known, .site = site, .sources = sources});
    };
    return planning::search_with_line(task, options, time_price, given.known, {}, search_to);
  }

  /// Does one piece of work. False if nothing is left to do.
  bool step() {
    Source* source = next_source();
    const bool may_use_refuges = met_ && !sources_.front().path.empty() && task_.via.empty();
    if (may_use_refuges && (!source || is_turn_of_refuges())) {
      const std::int64_t before = budget_.iterations();
      go_on_with_refuges();
      refuge_work_ += budget_.iterations() - before;
      return true;
    }
    if (source) go_on(*source);
    return source != nullptr;
  }

  [[nodiscard]] bool is_turn_of_refuges() const {
    const double share = best_ ? later_share_of_refuges : share_of_refuges;
    const std::int64_t work = budget_.iterations() - before_refuges;
    return static_cast<double>(refuge_work_) < share * static_cast<double>(work);
  }

  /// Goes on with a detour, or with the next one when the detour is spent.
  void go_on_with_refuges() {
    if (detour_ && detour_ != best_source_) {
      if (!detour_->is_detour_spent()) {
        go_on(*detour_);
        return;
      }
      drop_detour();
    }
    detour_ = nullptr;
    add_detour();
  }

  void drop_detour() {
    if (detour_ == &sources_.back()) {
      sources_.pop_back();
      return;
    }
    detour_->search.reset();
    detour_->is_searched = true;
    detour_->is_hasty = detour_->is_cut_off = false;
  }

  void add_detour() {
    if (!refuges_) {
      refuges_.emplace(task_, pricing_.rule(), options_);
    }
    const Source& alone = sources_.front();
    const std::int64_t done = refuges_->iterations();
    std::optional<Detour> detour = refuges_->draw({task_.start, alone.path}, met_->obstacle);
    budget_.spend(budget_.left(refuges_->iterations() - done, 0));
    if (!detour) return;
    std::vector<Segment> path = detour->there;
    path.insert(path.end(), detour->onward.begin(), detour->onward.end());
    detour_ = &sources_.emplace_back(
        Source{.ghosts = {}, .task = alone.task, .detour = *std::move(detour)});
    if (path.empty()) return;
    detour_->path = refuges_->tidied(std::move(path));
    consider(*detour_, detour_->path, true);
  }

  [[nodiscard]] std::unique_ptr<PathSearch> make_search(const Source& source) const {
    if (!source.detour) return search_of(source.task, {.sources = paths_});
    const auto of_leg = [this](const Task& leg, const Path& known) {
      return search_of(leg, {.known = known.segments.empty() ? nullptr : &known});
    };
    return search_through(source.task, *source.detour, of_leg);
  }

  /// The source whose turn it is: the one with the least work for its weight; null: none.
  [[nodiscard]] Source* next_source() {
    Source* next = nullptr;
    double least = endless;
    for (Source& source : sources_) {
      const double work =
          static_cast<double>(source.spent) / source.weight(best_cost(), &source == best_source_);
      const bool is_other = source.detour && &source != best_source_;
      if (is_other || source.is_finished() || work >= least) continue;
      least = work;
      next = &source;
    }
    return next;
  }

  /// Cost of the best drive; infinity: there is none.
  [[nodiscard]] double best_cost() const { return best_ ? best_->cost : endless; }

  /// Whether no better drive can be found: the search without ghosts has ended, and has no path or
  /// its path is driven as if nothing moved.
  [[nodiscard]] bool is_settled() const {
    const Source& alone = sources_.front();
    if (!alone.is_searched) return false;
    return alone.path.empty() || (best_ && best_->cost <= alone.fastest_cost);
  }

  void go_on(Source& source) {
    const std::int64_t before = budget_.iterations();
    if (source.wants_times()) {
      if (!source.is_hasty) ++source.doublings;
      source.is_hasty = source.is_cut_off = false;
      consider(source, source.path, false);
      source.spent += std::max<std::int64_t>(budget_.iterations() - before, 1);
      return;
    }
    if (!source.search) {
      source.search = make_search(source);
      offer(source);  // the path before the first round, if there is one
      if (!source.path.empty()) {
        ++source.spent;
        return;
      }
    }
    const std::int64_t done = source.search->iterations();
    const std::int64_t most = budget_.left(std::numeric_limits<std::int64_t>::max() / 4, 0);
    source.is_searched = !source.search->advance(most);
    budget_.spend(source.search->iterations() - done);
    offer(source);
    source.spent += std::max<std::int64_t>(budget_.iterations() - before, 1);
    follow(source);
  }

  /// Looks for times along the path of a source, if that is a new path that may win.
  void offer(Source& source) {
    std::optional<std::vector<Segment>> path = source.search->path();
    if (path && source.detour) path = refuges_->tidied(*std::move(path));
    if (!path || *path == source.path) return;
    source.path = *std::move(path);
    source.is_cut_off = false;
    source.doublings = 0;
    consider(source, source.path, true);
  }

  /// Looks for times along a path: in haste at first, with care when the source has its next turn.
  void consider(Source& source, const std::vector<Segment>& segments, bool is_hasty) {
    const double path_cost = pricing_.path_cost(segments, search::ClearanceSampling::answer);
    source.fastest_cost = pricing_.timed_cost(path_cost, planning::drive_time(task_, segments));
    if (best_ && best_->cost <= source.fastest_cost) return;
    if (is_hasty && !source.detour) {  // sources near each other find the same paths
      if (std::ranges::find(offered_, segments) != offered_.end()) return;
      offered_.push_back(segments);
    }
    const Path path{task_.start, segments};
    const std::int64_t before = budget_.iterations();
    const std::int64_t most = budget_.left(states_for(source) / states_per_iteration, 0);
    moving::Traffic traffic{.moving = task_.moving,
                            .margin = options_.clearance.margin,
                            .start_curvature = task_.curvatures.start,
                            .limits = speed_limits(task_, start_state(task_), segments),
                            .start_hitch_angle = task_.hitch_angles.start,
                            .longest = longest_of(path_cost),
                            .most_states = most * states_per_iteration,
                            .is_hasty = is_hasty,
                            .is_interrupted = [this] { return budget_.is_interrupted(); }};
    const bool is_short_enough =
        source.detour ? best_ || !is_hasty : best_ && source.doublings == 0;
    moving::Yielding yielding = times_along(path, traffic, is_short_enough);
    states_ += yielding.states;
    budget_.spend(budget_.left(yielding.states / states_per_iteration, 0));
    double cost = endless;
    if (yielding.speeds) {
      cost = pricing_.timed_cost(path_cost, yielding.speeds->duration);
      if (!best_ || cost < best_->cost) {
        trace_.push_back({budget_.elapsed(), budget_.iterations(), path_cost});
        best_ = TimedWay{segments, *std::move(yielding.speeds), path_cost, cost};
        best_source_ = &source;
      }
    }
    source.is_hasty = is_hasty && yielding.met.has_value();
    const bool may_be_better =
        yielding.is_cut_off || (!yielding.speeds && traffic.longest < longest_of(path_cost));
    // A detour that does not win has one careful search: there are many detours.
    const bool may_go_on = !source.detour || &source == best_source_;
    source.is_cut_off =
        may_go_on && !is_hasty && may_be_better && states_for(source) < max_states_of_path;
    source.retry_at = source.spent + 4 * (budget_.iterations() - before);
    if (yielding.met && cost > source.fastest_cost + worth_a_way_around) {
      go_around(source, *yielding.met);
    }
  }

  /// The best times along a path. Most good drives take less than twice as long as the fastest one.
  /// So such drives are searched first, which is a fraction of the work.
  [[nodiscard]] moving::Yielding times_along(const Path& path, moving::Traffic& traffic,
                                             bool is_short_enough) const {
    const double longest = traffic.longest;
    traffic.longest = std::min(longest, 2 * planning::drive_time(task_, path.segments));
    moving::Yielding short_drive = moving::yielding_speeds(path, task_.vehicle, traffic);
    const bool is_all = is_short_enough || traffic.longest == longest || !short_drive.met;
    if (short_drive.speeds || is_all) return short_drive;
    traffic.longest = longest;
    moving::Yielding yielding = moving::yielding_speeds(path, task_.vehicle, traffic);
    yielding.states += short_drive.states;
    return yielding;
  }

  /// Adds sources that go around the obstacle that the fastest drive of a source meets.
  void go_around(const Source& source, const Meeting& meeting) {
    if (!met_) met_ = meeting;
    if (source.detour || source.ghosts.size() >= max_ghosts) return;
    for (const Ghost& ghost : ghosts_at(meeting)) {
      if (!has_room()) return;
      add_source(tried_.with(source.ghosts, ghost));
    }
  }

  /// Whether one more source with ghosts may be opened.
  [[nodiscard]] bool has_room() const {
    const auto is_open = [](const Source& source) { return source.is_open(); };
    return std::count_if(sources_.begin(), sources_.end(), is_open) < max_open_sources;
  }

  /// Adds a source around ghosts, which begin later if start or goal would not be free.
  void add_source(std::optional<Ghosts> ghosts) {
    for (; ghosts; ghosts = tried_.begun_later(*std::move(ghosts))) {
      auto around = task_around(task_, *ghosts, options_.clearance);
      if (!around) continue;
      const std::int64_t spent = ghosts->back().end == endless ? head_start : 0;
      sources_.push_back(
          {.ghosts = *std::move(ghosts), .task = *std::move(around), .spent = spent});
      return;
    }
  }

  /// Tries ghosts that begin later, so that more room is left, if those of a source leave no way or
  /// only dear ones.
  void follow(Source& source) {
    if (source.ghosts.empty() || source.is_followed || !has_room()) return;
    if (!source.is_blocked() && !source.is_in_vain(best_cost())) return;
    source.is_followed = true;
    if (source.is_blocked()) {
      tried_.add_blocked(source.ghosts);
      source.search.reset();
      source.task = {};
    }
    add_source(tried_.begun_later(source.ghosts));
  }

  /// Most states of a search for the times along the path of a source.
  [[nodiscard]] std::int64_t states_for(const Source& source) const {
    const std::int64_t states = first_states + states_per_iteration / 10 * budget_.iterations();
    if (source.detour && &source != best_source_) return first_states;  // there are many detours
    return std::min(states << source.doublings, max_states_of_path);
  }

  /// Longest drive along a path of cost `path_cost` that is better than the best drive [s].
  [[nodiscard]] double longest_of(double path_cost) const {
    return best_ ? pricing_.duration(path_cost, best_->cost) : endless;
  }

  PlannerAnswer finished(PlannerAnswer&& first) {
    PlannerAnswer answer{.status = PlanStatus::solved,
                         .iterations = budget_.iterations(),
                         .counters = std::move(first.counters),
                         .phases = std::move(first.phases),
                         .tree = std::move(first.tree)};
    answer.counters.push_back({"states_in_time", states_});
    if (best_) {
      answer.anytime = std::move(trace_);
      answer.segments = std::move(best_->segments);
      answer.speeds = std::move(best_->speeds);
      return answer;
    }
    answer.status = budget_.exhausted().value_or(
        options_.budget.max_iterations ? PlanStatus::iteration_limit : PlanStatus::time_limit);
    if (!sources_.front().path.empty()) {
      answer.reason = "there are paths, but none on which a drive was found that meets nothing";
    } else {
      answer.reason = std::move(first.reason);
    }
    return answer;
  }

  const Task& task_;
  const PlanOptions& options_;
  std::span<const NamedSource> paths_;  // sources of paths from the caller
  planning::Pricing pricing_;
  Budget budget_;
  std::deque<Source> sources_;                 // the first source has no ghosts
  TriedGhosts tried_;                          // ghosts of all sources, also of refused ones
  std::vector<std::vector<Segment>> offered_;  // paths of all sources but detours
  std::optional<Refuges> refuges_;
  std::optional<Meeting> met_;    // first meeting that is worth a way around
  Source* detour_ = nullptr;      // current detour; null: none
  std::int64_t refuge_work_ = 0;  // work on detours [iterations]
  std::optional<TimedWay> best_;
  const Source* best_source_ = nullptr;
  std::vector<CostSample> trace_;  // cost of the path of each better drive
  std::int64_t states_ = 0;
};

}  // namespace

PlannerAnswer plan(const Task& task, const PlanOptions& options,
                   std::span<const NamedSource> sources) {
  if (!task.goal_set.empty()) {
    const auto to_one = [sources](const Task& to, const PlanOptions& round) {
      return InTimeRun(to, round, sources).answer();
    };
    return planning::plan_to_set(task, options, time_price, planning::restarted_search(to_one));
  }
  return InTimeRun(task, options, sources).answer();
}

}  // namespace vandplan::in_time
