// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/anytime.h"

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <span>

#include "base/parallel.h"
#include "planners/anytime/chain.h"
#include "planners/anytime/fastest.h"
#include "planners/anytime/island.h"
#include "planners/anytime/open_ground.h"
#include "planners/anytime/shares.h"
#include "planners/anytime/strokes.h"
#include "planners/anytime/tidy.h"
#include "planners/commands/short_strokes.h"
#include "planners/pricing.h"
#include "planners/rig/rig_planner.h"
#include "planners/shared_options.h"
#include "search/enclosure.h"
#include "search/far_guide.h"
#include "steering/words.h"

namespace vandplan::anytime {
namespace {

constexpr std::int64_t first_later_round = 6;   // with a route: of islands that join late
constexpr std::int64_t first_adapt_round = 32;  // between stops; bending brings more before
constexpr std::int64_t first_survey = 3000;     // iteration; before, it would be in the way,
constexpr std::int64_t early_survey = 1000;     // where iterations take longer, for the first way
// Rounds until the bound with headings is raised where a gap is to be proven: boxes take long to
// make.
constexpr std::int64_t first_raise = 24;
constexpr std::uint64_t fastest_stream = 7;  // of random numbers
constexpr int tidy_trials = 1000;
constexpr int repairs_of_known = 12;              // of a known path that something is in the way of
constexpr std::int64_t first_look_for_walls = 4;  // round; who has a route by then does not
// Where trees found nothing by then the way is tight: only the lattices get through, by and by.
constexpr std::int64_t first_late_round = 16;
constexpr std::int64_t late_samples = 1;      // of a round
constexpr std::int64_t first_look_far = 100;  // over a whole site, where a look takes longer
constexpr std::int64_t rounds_of_far_cycle = 4;
constexpr std::int64_t far_detours = 4096;  // iterations of one round
constexpr int early_looks = 64;             // for walls: most are found by then
constexpr int looks_of_round = 32;          // as long as there were no more than these,
constexpr int late_looks_of_round = 3;      // and from then on

constexpr double a_good_deal = 0.999;                   // of the cost
constexpr std::int64_t unsettled = 4000;                // iterations
constexpr std::int64_t settled_steps = 4;               // of the bound, for one before
constexpr std::int64_t settled_steps_with_prices = 16;  // rounds take longer then,
constexpr std::int64_t settled_steps_with_bending = 8;  // but are shorter

constexpr std::int64_t quickening = 192;  // trials of a round
constexpr double no_time = 1e-12;         // relative
constexpr double no_gain = 1e-6;          // of a whole drive, relative: ends may be off by as much
constexpr double neat_slack = 1e-2;       // of a drive that is tidied, relative
constexpr double shortest_stroke = 0.1;   // where seconds have a price [m]

/// What is driven, and its cost.
struct Drivable {
  std::vector<Segment> segments;
  double cost;
};

class Run {
 public:
  Run(const Task& task, const PlanOptions& options, const planning::Pricing& pricing);

  void try_open_ground(const CostRule& rule);
  void try_along(const Path& known);
  void round();
  void look_for_walls();
  void tidy(std::uint64_t seed);
  void make_drivable();
  [[nodiscard]] bool is_optimal() const;
  /// Whether the best route is proven to be as near to the optimum as was asked for, with strokes
  /// as long as was asked for.
  [[nodiscard]] bool is_good_enough();
  [[nodiscard]] bool is_walled_in() const { return enclosure_ && enclosure_->is_proven(); }
  [[nodiscard]] const Budget& budget() const { return budget_; }
  /// Rounds do at most so many more iterations together, until this is called again.
  void pause_after(std::int64_t iterations) { pause_ = budget_.iterations() + iterations; }
  [[nodiscard]] PlannerAnswer result() const;

 private:
  /// How many of the `wanted` iterations there are when `promised` ones are taken first.
  [[nodiscard]] std::int64_t left(std::int64_t wanted, std::int64_t promised) const {
    const std::int64_t most = pause_ - budget_.iterations() - promised;
    return std::min(budget_.left(wanted, promised), std::max<std::int64_t>(most, 0));
  }
  void take(Route route);
  void merge(Slice& slice);
  void join();
  void merge_relaxed(Slice& slice);
  [[nodiscard]] bool is_relaxed(std::size_t island) const;
  [[nodiscard]] bool has_relaxed() const { return islands_.size() > first_relaxed; }
  [[nodiscard]] const Route* route_for(std::size_t island) const;
  /// Without looking for other kinds of path.
  [[nodiscard]] bool knows_enough() const { return target_gap_ || is_warm_ || rule_.is_length(); }
  [[nodiscard]] bool has_work(std::size_t island) const;
  [[nodiscard]] std::int64_t share_of(std::size_t island) const;
  [[nodiscard]] std::int64_t share_of_survey(std::int64_t later) const;
  [[nodiscard]] std::int64_t far_share(Work work, std::int64_t share) const;
  [[nodiscard]] double least_found() const;
  [[nodiscard]] double lower_bound() const;
  [[nodiscard]] double enough() const;
  void prove();
  [[nodiscard]] std::int64_t raising_steps() const;
  void quicken();
  void offer_to_fastest();
  [[nodiscard]] std::vector<Segment> bent_segments() const;
  [[nodiscard]] std::vector<Segment> raw_segments() const;
  [[nodiscard]] std::optional<Drivable> drivable(const std::vector<Segment>& raw) const;

  const Task& task_;
  const planning::Pricing& pricing_;
  const CostRule& rule_;         // by which routes are found
  bool is_far_;                  // over a whole site
  bool bends_;                   // routes: the shortest of arcs and lines has no use for it
  std::optional<Task> relaxed_;  // the task of wheels that turn at once, once it helps
  Bounds region_;                // of samples
  std::uint64_t seed_;
  int threads_;
  std::optional<double> target_gap_;
  double min_stroke_;                 // that is asked for [m]
  double cost_before_strokes_ = 0.0;  // of the route that was made drivable last,
  double cost_with_strokes_ = 0.0;    // and what it costs then
  bool is_warm_ = false;              // began with a route along a known path
  Budget budget_;
  std::int64_t pause_ = std::numeric_limits<std::int64_t>::max();  // iteration of the next pause
  std::deque<Island> islands_;
  std::optional<search::Enclosure> enclosure_;
  int looks_ = 0;  // for walls
  OpenGround open_ground_;
  std::optional<Route> best_;
  std::optional<Route> relaxed_best_;                            // of the relaxed task
  std::optional<BentDrive> bent_;                                // the cheapest
  double noted_cost_ = std::numeric_limits<double>::infinity();  // of the best route,
  std::int64_t noted_at_ = 0;                                    // when it last fell a good deal
  std::optional<Fastest> fastest_;                               // where time is a part of the cost
  std::vector<Segment> raw_;       // the raw segments that `segments_` were made from
  std::vector<Segment> segments_;  // the drivable segments of the best route
  std::vector<CostSample> trace_;
  std::int64_t rounds_ = 0;
  std::int64_t rounds_with_route_ = 0;
};

Run::Run(const Task& task, const PlanOptions& options, const planning::Pricing& pricing)
    : task_(task),
      pricing_(pricing),
      rule_(pricing.rule()),
      is_far_(search::FarGuide::is_wanted(task, sampling_region(task, Region::scene))),
      bends_((!rule_.is_length() || task.steering != Steering::reeds_shepp) &&
             !pricing.counts_time() && !is_far_),
      region_(sampling_region(task, planning::region_of(options))),
      seed_(options.budget.seed),
      threads_(options.budget.threads),
      target_gap_(options.budget.target_gap),
      min_stroke_(options.planner.number("min_stroke")),
      budget_(options.budget),
      open_ground_(open_ground(task, rule_)) {
  const bool is_whole = pricing.counts_time();
  for (std::size_t i = 0; i < first_later; ++i) {
    islands_.emplace_back(plans[i].work, task, rule_, region_, stream_seed(seed_, i),
                          is_whole || bends_);
  }
  if (is_whole) {
    const auto of_route = [this](const Route& route) {
      double clearance_cost = 0.0;
      for (const Leg& leg : route.legs) clearance_cost += leg.clearance_cost;
      return pricing_.cost(path_of(route).segments, clearance_cost);
    };
    Bender::Measure of_drive;  // where the time is all that counts
    if (pricing.is_time()) {
      of_drive = [this](std::span<const Segment> s) { return pricing_.cost(s, 0.0); };
    }
    fastest_.emplace(task, rule_, stream_seed(seed_, fastest_stream), of_route, of_drive);
  }
}

// The best word on open ground, if it is free: by length it is found sooner, by price it may be the
// optimum.
void Run::try_open_ground(const CostRule& rule) {
  Connector connector(task_, rule);
  const std::optional<Piece> piece =
      connector.steer(task_.start, task_.goal, {rule.initial_gear, 0});
  if (!piece || !connector.is_free(task_.start, *piece)) return;
  Route route{task_.start, {{*piece, task_.goal}}, 0.0};
  price(Connector(task_, rule_), route);
  take(std::move(route));
}

// A route that was there before the first round.
void Run::take(Route route) {
  if (best_ && route.cost >= best_->cost) return;
  best_ = std::move(route);
  if (fastest_) return offer_to_fastest();
  trace_.push_back({budget_.elapsed(), 0, best_->cost});
}

// Along a path that was good for a like task.
void Run::try_along(const Path& known) {
  Connector connector(task_, rule_);
  Chain chain(task_, connector, known, 0);
  if (!chain.take_over()) return;
  for (int i = 0; i < repairs_of_known && !chain.is_free() && !budget_.is_interrupted(); ++i) {
    chain.repair();
  }
  if (!chain.is_free()) return;
  is_warm_ = true;
  take(chain.route());
  if (!bends_) return;
  bent_ = islands_[bend_island].begin_with(known);
  if (bent_ && bent_->cost < best_->cost) {
    trace_.push_back({budget_.elapsed(), 0, bent_->cost});
  }
}

void Run::offer_to_fastest() {
  if (!fastest_->offer(*best_)) return;
  trace_.push_back({budget_.elapsed(), budget_.iterations(), fastest_->cost()});
}

// [8b] Makes the cheapest route cheaper yet, by the whole drive.
void Run::quicken() {
  const std::int64_t trials = left(quickening * growth(rounds_), 0);
  std::int64_t done = 0;
  for (; done < trials && (done % 4 != 0 || !budget_.is_interrupted()); ++done) {
    if (fastest_->step()) {
      trace_.push_back({budget_.elapsed(), budget_.iterations() + done, fastest_->cost()});
    }
  }
  budget_.spend(done);
}

bool Run::is_optimal() const {
  if (fastest_) {
    return best_ &&
           fastest_->cost() <= lower_bound() * (1 + (pricing_.is_time() ? no_time : no_gain));
  }
  return best_ &&
         least_found() <= least_cost(open_ground_, rule_, 0.0) * (1 + 1e-12) + open_ground_.leeway;
}

double Run::least_found() const { return bent_ ? std::min(best_->cost, bent_->cost) : best_->cost; }

double Run::lower_bound() const {
  // Ends that are off may save so much on the way around, too.
  const double off = rule_.is_length() ? 0.0 : 2 * steering::judged.position;
  double around = 0.0;
  for (const Island& island : islands_) {
    around = std::max(around, island.shortest() - off);
    around = std::max(around, island.shortest_turning() - open_ground_.leeway);
  }
  if (fastest_) {
    const double length = std::max(open_ground_.shortest, around);
    return pricing_.least_cost(length, length);
  }
  return least_cost(open_ground_, rule_, around);
}

// What a path may cost to be as near to the optimum as was asked for, as far as is proven.
double Run::enough() const { return target_gap_ ? (1 + *target_gap_) * lower_bound() : 0.0; }

bool Run::is_good_enough() {
  if (!best_ || !target_gap_) return false;
  const double cost = fastest_ ? fastest_->cost() : least_found();
  if (cost > enough()) return false;
  if (min_stroke_ == 0.0) return true;
  if (cost != cost_before_strokes_) {
    cost_before_strokes_ = cost;
    cost_with_strokes_ = drivable(raw_segments())->cost;
  }
  return cost_with_strokes_ <= enough();
}

// Raises the bound, no further than it takes for the gap that was asked for.
void Run::prove() {
  Island& bound = islands_[bound_island];
  std::int64_t steps = best_ ? share_of(bound_island) : 0;
  for (; steps > 0 && !is_good_enough(); --steps) {
    if (!bound.has_work()) {
      if (rounds_with_route_ < first_raise || !bound.may_raise()) return;
      bound.raise(1, budget_);
      continue;
    }
    Slice slice = bound.run(left(1, 0), &*best_, budget_, 0.0);
    if (slice.iterations == 0) return;
    merge(slice);
  }
}

// Once the best route hardly gets cheaper, proving how good it is gets more of the time.
std::int64_t Run::raising_steps() const {
  if (!best_ || target_gap_) return 0;
  const bool is_settled = budget_.iterations() > 2 * noted_at_ + unsettled;
  if (!is_settled && islands_[bound_island].has_work()) return 0;  // the way around comes first
  const std::int64_t settled = rule_.is_length() ? settled_steps
                               : bends_          ? settled_steps_with_bending
                                                 : settled_steps_with_prices;
  return share_of(bound_island) * (is_settled ? settled : 1);
}

std::int64_t Run::share_of(std::size_t island) const {
  const Plan& plan = is_far_ ? far_plans[island] : plans[island];
  if (!best_) {
    const bool is_late = plan.work == Work::random_trees && rounds_ >= first_late_round;
    return rounds_ < plan.first_round ? 0 : is_late ? late_samples : plan.before;
  }
  const std::int64_t after = rule_.is_length() ? plan.after
                             : !bends_         ? plan.after_with_prices
                             : has_relaxed()   ? plan.beside_relaxed
                                               : plan.after_with_bending;
  if (is_far_) return far_share(plans[island].work, after * growth(rounds_));
  if (after == 0) return 0;
  if (!(target_gap_ || is_warm_)) {
    if (!bends_ || rule_.is_length()) return after * growth(rounds_);
    return share_with_bending(island == survey_island ? share_of_survey(after) : after,
                              rounds_with_route_);
  }
  const GapPlan& gap_plan = gap_plans[island];
  return rounds_with_route_ < gap_plan.first_round ? 0 : gap_plan.share * growth(rounds_);
}

std::int64_t Run::share_of_survey(std::int64_t later) const {
  const Island& survey = islands_[survey_island];
  if (survey.is_glance()) return has_relaxed() ? first_glance : first_look;
  return survey.is_first_look() ? first_look : later;
}

// Over a whole site a detour changes a small part of a route, and refining another one: each has
// rounds of its own, or one would lose what the other gained.
std::int64_t Run::far_share(Work work, std::int64_t share) const {
  const bool is_round_of_detours = rounds_ % rounds_of_far_cycle == 0;
  if (is_round_of_detours) return work == Work::detours ? far_detours : 0;
  return work == Work::detours ? 0 : share;
}

void Run::merge(Slice& slice) {
  for (const CostSample& sample : slice.improvements) {
    if (fastest_) break;  // it keeps the trace
    if (!trace_.empty() && sample.cost >= trace_.back().cost) continue;
    const double time = trace_.empty() ? sample.time : std::max(sample.time, trace_.back().time);
    trace_.push_back({time, budget_.iterations() + sample.iteration, sample.cost});
  }
  budget_.spend(slice.iterations);
  if (slice.drive) bent_ = std::move(slice.drive);
  if (slice.route && (!best_ || slice.route->cost < best_->cost)) best_ = std::move(slice.route);
  if (best_ && least_found() < a_good_deal * noted_cost_) {
    noted_cost_ = least_found();
    noted_at_ = budget_.iterations();
  }
}

// [6c] [6e] [6f] The survey, and where the curvature is continuous islands that plan as if the
// wheels turned at once.
void Run::join() {
  const bool is_continuous = task_.steering != Steering::reeds_shepp;
  relaxed_ = task_;
  relaxed_->steering = Steering::reeds_shepp;
  for (std::size_t i = first_later; i < (is_continuous ? island_count : first_relaxed); ++i) {
    islands_.emplace_back(plans[i].work, is_relaxed(i) ? *relaxed_ : task_, rule_, region_,
                          stream_seed(seed_, i), true);
  }
}

// Whether an island plans so. The survey knows no other way.
bool Run::is_relaxed(std::size_t island) const {
  return task_.steering != Steering::reeds_shepp && island >= first_later && island != adapt_island;
}

// Relaxed routes go to those who look for drives along them.
void Run::merge_relaxed(Slice& slice) {
  budget_.spend(slice.iterations);
  std::vector<Route>& found = slice.losers;
  if (slice.route && (!relaxed_best_ || slice.route->cost < relaxed_best_->cost)) {
    relaxed_best_ = std::move(slice.route);
    found.push_back(*relaxed_best_);
  }
  for (const Route& route : found) {
    islands_[adapt_island].offer(route);
    islands_[bend_island].offer(route);
  }
}

// The best one of its task; null if there is none. The survey begins with what there is.
const Route* Run::route_for(std::size_t island) const {
  const bool knows_relaxed = is_relaxed(island) && (relaxed_best_ || island != survey_island);
  const std::optional<Route>& best = knows_relaxed ? relaxed_best_ : best_;
  return best ? &*best : nullptr;
}

bool Run::has_work(std::size_t island) const {
  const Work work = plans[island].work;
  if (work == Work::bend && !bends_) return false;
  if (work == Work::bound && target_gap_) return false;  // it has worked
  const bool may_jump = task_.steering == Steering::continuous_between_stops;
  if (work == Work::adapt && may_jump && rounds_ < first_adapt_round) return false;
  if (work == Work::survey) {
    const bool is_early = has_relaxed() && islands_[island].is_glance();
    return budget_.iterations() >= (is_early ? early_survey : first_survey);
  }
  if (work == Work::refine) return route_for(island) != nullptr;
  if (work == Work::detours && route_for(island) == nullptr) return false;
  return islands_[island].has_work();
}

// Every island works on its own, told only the best route so far; what they bring is merged in a
// fixed order. So the outcome does not depend on the number of threads.
void Run::round() {
  if (target_gap_) prove();
  if (is_good_enough()) return;
  const bool has_joined = islands_.size() > first_later;
  if (bends_ && !knows_enough() && !has_joined && rounds_with_route_ >= first_later_round) join();
  std::array<std::int64_t, island_count> wanted{};
  std::int64_t granted = 0;
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    if (!has_work(i)) continue;
    wanted[i] = left(share_of(i), granted);
    granted += wanted[i];
  }
  std::array<Slice, island_count> slices;
  const double good = fastest_ ? 0.0 : enough();
  const std::int64_t steps = raising_steps();
  parallel_for(islands_.size(), best_ ? threads_ : 1, [&](std::size_t i) {
    slices[i] = islands_[i].run(wanted[i], route_for(i), budget_, is_relaxed(i) ? 0.0 : good);
    if (i == bound_island) islands_[i].raise(steps, budget_);
  });
  if (best_) ++rounds_with_route_;
  for (std::size_t i = 0; i < islands_.size(); ++i) {  // [8]
    if (is_relaxed(i)) {
      merge_relaxed(slices[i]);
      continue;
    }
    merge(slices[i]);
    if (!bends_) continue;
    for (const Route& route : slices[i].losers) islands_[bend_island].offer(route);
  }
  if (fastest_ && best_) {
    offer_to_fastest();
    for (Slice& slice : slices) {
      for (Route& route : slice.losers) fastest_->offer(std::move(route));
    }
    quicken();
  }
  ++rounds_;
  if (!best_ && rounds_ >= (is_far_ ? first_look_far : first_look_for_walls)) {
    look_for_walls();  // [9]
  }
}

// As long as there is no route: perhaps there is none. These looks are no iterations: what a budget
// of iterations brings does not depend on them.
void Run::look_for_walls() {
  if (!enclosure_) enclosure_.emplace(task_);
  const int looks = looks_ < early_looks ? looks_of_round : late_looks_of_round;
  for (int i = 0; i < looks && !budget_.is_interrupted() && enclosure_->step(); ++i) ++looks_;
}

// Among paths of the least length one with fewer gear changes, by a price of theirs that is next to
// nothing. Turning on the spot has many paths of the same length.
void Run::tidy(std::uint64_t seed) {
  if (!rule_.is_length() || best_->legs.size() < 2) return;
  CostRule rule = rule_;
  rule.gear_change_cost = 1e-8;
  Connector connector(task_, rule);
  Route route = *best_;
  route.cost = cost_of(rule, route);
  Shortener shortener(connector, std::move(route), seed);
  for (int i = 0; i < tidy_trials && !budget_.is_interrupted() && budget_.next(); ++i) {
    shortener.step();
  }
  Route tidied = shortener.route();
  tidied.cost = cost_of(rule_, tidied);
  if (tidied.cost <= open_ground_.shortest * (1 + 1e-9)) best_ = std::move(tidied);
}

// What is driven at the commands, without crumbs where the curvature is continuous.
std::vector<Segment> Run::bent_segments() const {
  commands::DriveShortener drive(task_, rule_, bent_->commands, 0);
  if (task_.steering != Steering::reeds_shepp) drive.drop_crumbs();
  return drive.segments();
}

// The best route as it is.
std::vector<Segment> Run::raw_segments() const {
  const bool is_bent = bent_ && bent_->cost < best_->cost;
  if (fastest_) return fastest_->segments();
  return is_bent ? bent_segments() : path_of(*best_).segments;
}

// The best route tidied, with strokes as long as is asked for where there is room; nothing where it
// stays as it is: the shortest path is what it is.
std::optional<Drivable> Run::drivable(const std::vector<Segment>& raw) const {
  const bool is_bent = !fastest_ && bent_ && bent_->cost < best_->cost;
  const bool is_continuous = task_.steering != Steering::reeds_shepp;
  const bool is_route = fastest_ && !pricing_.is_time();
  const double stroke = is_route ? std::max(min_stroke_, shortest_stroke) : min_stroke_;
  if (stroke == 0.0 && !is_bent && rule_.is_length()) return std::nullopt;
  Connector connector(task_, rule_);
  Drivable drivable{raw, 0.0};
  if (!is_continuous) {
    drivable.segments = tidied(connector, task_.start, raw, stroke);
  } else if (stroke > 0.0) {
    const Route& route = fastest_ ? *fastest_->route() : *best_;
    const Route legs = is_bent ? legs_along({task_.start, raw}, task_.goal) : route;
    drivable.segments =
        path_of(with_strokes(connector, gears_at_ends(task_, rule_), legs, stroke)).segments;
  }
  if (is_continuous && !rule_.is_length() && !is_optimal()) {
    std::vector<Segment> neat = tidied(connector, task_.start, drivable.segments, 0.0);
    const auto lack = [&](std::span<const Segment> s) {
      return commands::price_of_lack(s, stroke);
    };
    if (lack(neat) <= lack(drivable.segments)) drivable.segments = std::move(neat);
  }
  if (stroke == 0.0 && !is_bent && drivable.segments == raw) return std::nullopt;
  drivable.cost =
      pricing_.cost(drivable.segments, connector.clearance_cost(task_.start, drivable.segments));
  return drivable;
}

void Run::make_drivable() {
  if (!best_) return;
  std::vector<Segment> raw = raw_segments();
  if (raw == raw_) return;  // it was made drivable before
  raw_ = raw;
  segments_ = std::move(raw);
  std::optional<Drivable> neat = drivable(segments_);
  if (!neat) return;
  const double slack = pricing_.is_time() ? no_time : neat_slack;
  if (fastest_ && min_stroke_ == 0.0 && neat->cost > fastest_->cost() * (1 + slack)) return;
  segments_ = std::move(neat->segments);
  if (fastest_) return;
  while (trace_.size() > 1 && trace_[trace_.size() - 2].cost <= neat->cost) trace_.pop_back();
  trace_.back().cost = neat->cost;
}

PlannerAnswer Run::result() const {
  PlannerAnswer result;
  result.iterations = budget_.iterations();
  result.anytime = trace_;
  result.lower_bound = lower_bound();
  std::int64_t nodes = 0, solves = 0, checks = 0;
  if (fastest_) {
    solves += fastest_->solves();
    checks += fastest_->checks();
  }
  for (const Island& island : islands_) {
    solves += island.solves();
    checks += island.checks();
    nodes += static_cast<std::int64_t>(island.nodes());
  }
  result.counters = {{"nodes", nodes}, {"exact_solves", solves}, {"edge_checks", checks}};
  if (best_) {
    result.status = PlanStatus::solved;
    result.segments = segments_;
  }
  return result;
}

// The steps of docs/algorithms/anytime.md; [2] to [7] are the islands' (island.cpp).
class Search final : public planning::PathSearch {
 public:
  Search(const Task& task, const PlanOptions& options, double time_price, const Path* known)
      : pricing_(task, options.cost, time_price),
        run_(task, options, pricing_),
        seed_(options.budget.seed) {
    run_.try_open_ground({});  // [1]
    if (!pricing_.rule().is_length()) run_.try_open_ground(pricing_.rule());
    if (known != nullptr) run_.try_along(*known);
  }

  // [2] to [9]
  bool advance() {
    if (run_.is_optimal() || run_.is_good_enough() || run_.is_walled_in()) return false;
    end_ = run_.budget().exhausted();
    if (!end_) run_.round();
    return !end_;
  }
  bool advance(std::int64_t most) override {
    run_.pause_after(most);
    return advance();
  }

  [[nodiscard]] std::optional<std::vector<Segment>> path() override {
    run_.make_drivable();  // [11]
    return run_.result().segments;
  }
  [[nodiscard]] std::int64_t iterations() const override { return run_.budget().iterations(); }

  [[nodiscard]] PlannerAnswer answer() override {
    if (run_.is_optimal()) run_.tidy(seed_);  // [10]
    run_.make_drivable();                     // [11]
    PlannerAnswer answer = run_.result();
    if (answer.segments) return answer;
    answer.status = end_.value_or(PlanStatus::no_path);
    if (!end_)
      answer.reason = "proven: nothing as wide as the vehicle gets from the start to the goal";
    return answer;
  }

 private:
  planning::Pricing pricing_;
  Run run_;
  std::uint64_t seed_;
  std::optional<PlanStatus> end_;
};

}  // namespace

PlannerAnswer plan_anytime(const Task& task, const PlanOptions& options, const Path* known) {
  if (task.vehicle.trailer) return rig::plan_rig(task, options, {task, options.cost});
  Search search(task, options, 0.0, known);
  while (search.advance()) {
  }
  return search.answer();
}

std::unique_ptr<planning::PathSearch> drive_search(const Task& task, const PlanOptions& options,
                                                   double time_price, const Path* known) {
  if (!task.vehicle.trailer) return std::make_unique<Search>(task, options, time_price, known);
  const auto rig = [&task, time_price](const PlanOptions& round) {
    return rig::plan_rig(task, round, {task, round.cost, time_price});
  };
  return planning::restarted(rig, options);
}

}  // namespace vandplan::anytime
