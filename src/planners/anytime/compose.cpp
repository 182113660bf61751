// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/compose.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "planners/anytime/bend.h"
#include "planners/anytime/chain.h"
#include "planners/anytime/provers.h"
#include "planners/anytime/shares.h"
#include "planners/anytime/sources.h"
#include "planners/anytime/workers.h"
#include "search/grid_distance.h"
#include "sites/way.h"

namespace vandplan::anytime {
namespace {

/// Least length of strokes where seconds have a price beside others [m].
constexpr double shortest_stroke = 0.1;
/// Largest additional cost of a finished drive, relative, where seconds have a price beside others.
constexpr double slack_of_both = 1e-2;
/// Streams of random numbers, one for each worker; a new worker takes the next number. Other
/// numbers would change answers, so those of former workers stay unused. No run has both a survey
/// and a worker for the cheapest drive.
enum Stream : std::uint64_t {
  of_search_from_goal = 0,
  of_search_from_start = 1,
  of_refine = 3,
  of_detours = 5,
  of_bend = 6,
  of_cheapest_drive = 7,
  of_survey = 7,
  of_proposals = 8
};

/// Free routes of one word: the shortest word, which is found sooner, and with prices the cheapest
/// one, which may be the optimum. The task has no trailer.
std::vector<Route> open_ways(const Task& task, const search::CostRule& rule) {
  std::vector<Route> routes;
  std::vector<CostRule> rules = {length_rule(rule)};
  if (!rule.is_length()) rules.push_back(rule);
  for (const CostRule& of : rules) {
    Connector connector(task, of);
    const std::optional<Piece> piece =
        connector.steer(task.start, task.goal, {of.initial_gear, of.final_gear});
    if (!piece || !connector.is_free(task.start, *piece)) continue;
    Route& route = routes.emplace_back(Route{task.start, {{*piece, task.goal}}, 0.0});
    price(Connector(task, rule), route);
  }
  return routes;
}

/// Puts the portfolio of one run together.
class Composer {
 public:
  Composer(const Task& task, const PlanOptions& options, double time_price, const Given& given);

  [[nodiscard]] Portfolio portfolio() &&;

 private:
  [[nodiscard]] bool is_continuous() const { return task_.steering != Steering::reeds_shepp; }
  [[nodiscard]] bool has_relaxed() const { return has_survey_ && is_continuous(); }
  [[nodiscard]] std::uint64_t seed(std::uint64_t stream) const {
    return stream_seed(options_.budget.seed, stream);
  }
  [[nodiscard]] FinishRules finish_rules() const;
  [[nodiscard]] std::int64_t share_with_route(const Row& row) const;
  [[nodiscard]] Share until_route(const Row& row) const;
  [[nodiscard]] Share with_route(const Row& row) const;
  [[nodiscard]] Share share(const Row& row) const;
  Slot& add(std::string_view name, std::unique_ptr<Worker> worker, Share share);
  [[nodiscard]] Share share_of_search(const Row& row, const Worker& own, const Worker& other) const;
  void take_known(const Path& known);
  void add_searches();
  void add_length_prover();
  void add_detours();
  void add_survey();
  void add_wall_prover();
  void add_zone_prover();
  void add_cheapest_drive();
  void add_proposals(const NamedSource& source, std::uint64_t number);
  void feed(std::string_view listener);

  const Task& task_;
  const PlanOptions& options_;
  std::span<const NamedSource> sources_;
  std::unique_ptr<const planning::Pricing> pricing_;
  const CostRule& rule_;
  bool is_far_;                // whether the task goes over a whole site
  bool bends_;                 // whether bending may make routes cheaper
  bool has_gap_;               // whether a gap is to be proven
  bool is_warm_ = false;       // whether the run begins with a route along a known path
  bool has_site_way_ = false;  // whether that path is the way of a table
  /// Whether the wheels do not turn as that way says, and its drive is still to be found.
  bool follows_site_way_ = false;
  bool has_survey_ = false;       // whether a survey finds routes of other kinds
  std::unique_ptr<Bender> bend_;  // bends routes; null if none are bent
  Portfolio portfolio_;
};

Composer::Composer(const Task& task, const PlanOptions& options, double time_price,
                   const Given& given)
    : task_(task),
      options_(options),
      sources_(given.sources),
      pricing_(std::make_unique<planning::Pricing>(task, options.cost, time_price)),
      rule_(pricing_->rule()),
      is_far_(search::is_site(task, sampling_region(task, Region::scene))),
      bends_((!rule_.is_length() || is_continuous()) && !pricing_->counts_time() && !is_far_),
      has_gap_(options.budget.target_gap.has_value()),
      portfolio_{.pricing = nullptr,
                 .relaxed = nullptr,
                 .bound = CostBound(task, *pricing_),
                 .finisher = Finisher(task, *pricing_, finish_rules()),
                 .slots = {},
                 .gap = options.budget.target_gap,
                 .routes_are_answers = !pricing_->counts_time()} {
  if (bends_) bend_ = std::make_unique<Bender>(task, rule_, stream_seed(seed(of_bend), 0));
  portfolio_.routes = open_ways(task, rule_);  // [1]
  if (given.known != nullptr) {
    take_known(*given.known);
  } else if (given.site != nullptr) {
    const auto way = sites::way_in_world(*given.site, task, options.cost);
    if (way) take_known(way->path);
    has_site_way_ = is_warm_;
    follows_site_way_ = way && !is_warm_ && bend_;
    if (follows_site_way_) bend_->offer_path(way->path.segments, way->cost);
  }
  has_survey_ = bends_ && !has_gap_ && !is_warm_ && !rule_.is_length();
}

FinishRules Composer::finish_rules() const {
  const double min_stroke = options_.planner.number("min_stroke");
  FinishRules rules{
      .min_stroke = min_stroke, .stroke = min_stroke, .is_continuous = is_continuous()};
  if (!pricing_->counts_time()) return rules;
  if (!pricing_->is_time()) rules.stroke = std::max(min_stroke, shortest_stroke);
  if (min_stroke == 0.0) rules.slack = pricing_->is_time() ? rounding_of_cost : slack_of_both;
  return rules;
}

// Begins with a route along a known path, if one is free.
void Composer::take_known(const Path& known) {
  Connector connector(task_, rule_);
  std::optional<Route> route = route_along(task_, connector, known, 0);
  if (!route) return;
  is_warm_ = true;
  portfolio_.routes.push_back(*std::move(route));
  const bool is_allowed = may_drive(rule_, known.segments);
  if (bend_ && is_allowed) portfolio_.drive = bend_->begin_with(known);
}

Share Composer::until_route(const Row& row) const {
  const Turn turn = is_far_ ? row.far_until_route : row.until_route;
  return [turn](const Progress& now) { return now.rounds < turn.first_round ? 0 : turn.share; };
}

// Iterations of a worker in a round with a route.
std::int64_t Composer::share_with_route(const Row& row) const {
  if (is_far_ || rule_.is_length()) return row.by_length;
  return bends_ ? row.by_prices : row.by_time;
}

Share Composer::with_route(const Row& row) const {
  const std::int64_t share = share_with_route(row);
  if (is_far_) {
    return [share](const Progress& now) {
      return now.rounds % shares::far_cycle == 0 ? 0 : share * growth(now.rounds);
    };
  }
  if (has_gap_ || is_warm_) {
    Turn turn = share == 0 ? Turn{} : row.with_gap_or_known;
    if (has_site_way_ && turn.first_round > 0) turn.first_round += shares::rounds_of_site_way;
    return [turn](const Progress& now) {
      return now.rounds_with_path < turn.first_round ? 0 : turn.share * growth(now.rounds);
    };
  }
  if (!bends_ || rule_.is_length()) {
    return [share](const Progress& now) { return share * growth(now.rounds); };
  }
  return [share](const Progress& now) { return growing_share(share, now.rounds_with_path); };
}

Share Composer::share(const Row& row) const {
  return [before = until_route(row), after = with_route(row)](const Progress& now) {
    return now.has_path ? after(now) : before(now);
  };
}

Slot& Composer::add(std::string_view name, std::unique_ptr<Worker> worker, Share share) {
  return portfolio_.slots.emplace_back(
      Slot{.name = name, .worker = std::move(worker), .share = std::move(share)});
}

// Share of the searches from one end. While there is no route, the end with the finer search gets
// more: its former searches ended soon, as there is little room around it, and it needs fine steps.
Share Composer::share_of_search(const Row& row, const Worker& own, const Worker& other) const {
  if (is_far_) return share(row);
  return [usual = share(row), &own, &other](const Progress& now) {
    const std::int64_t iterations = usual(now);
    if (now.has_path || iterations == 0) return iterations;
    return iterations + shares::moved_to_finer_search(own.stage() - other.stage());
  };
}

// [2] [3] Adds lattice searches from both ends.
void Composer::add_searches() {
  const auto searches = [this](auto ladder, std::uint64_t stream) {
    return seeker(task_, rule_, seed(stream),
                  [&task = task_, &rule = rule_, ladder] { return ladder(task, rule); });
  };
  auto from_goal = searches(ladder_from_goal, of_search_from_goal);
  auto from_start = searches(ladder_from_start, of_search_from_start);
  Share of_goal = share_of_search(shares::search_from_goal, *from_goal, *from_start);
  Share of_start = share_of_search(shares::search_from_start, *from_start, *from_goal);
  add("search from the goal", std::move(from_goal), std::move(of_goal));
  add("search from the start", std::move(from_start), std::move(of_start));
}

// [6] Adds the length prover. The bound around obstacles comes before the bound with headings. Once
// the best cost hardly falls, proving gets more of the time.
void Composer::add_length_prover() {
  std::unique_ptr<Worker> prover = length_prover(task_, rule_.only_gear());
  const Share share_now = share(shares::length_prover);
  Share proofs = [share_now, &prover = *prover](const Progress& now) -> std::int64_t {
    if (!now.has_path || (!now.is_settled && prover.has_work())) return 0;
    return share_now(now) * (now.is_settled ? shares::settled_steps : 1);
  };
  Slot& slot = add("length prover", std::move(prover), share_now);
  slot.proofs = std::move(proofs);
  if (!has_gap_) return;
  slot.phase = Phase::before;
  slot.proofs = [](const Progress& now) {
    return now.rounds_with_path < shares::first_raise ? 0 : 1;
  };
}

// [5b] Adds the detours, which have rounds of their own.
void Composer::add_detours() {
  const std::uint64_t own_seed = stream_seed(seed(of_detours), 0);
  auto worker = seeker(task_, rule_, seed(of_detours), [&task = task_, &rule = rule_, own_seed] {
    return detours(task, rule, own_seed);
  });
  add("detours", std::move(worker), [](const Progress& now) {
    return now.has_path && now.rounds % shares::far_cycle == 0 ? shares::far_detours : 0;
  });
}

// [5c] Adds the survey. With continuous curvature it plans the relaxed task.
void Composer::add_survey() {
  const Task& task = has_relaxed() ? *portfolio_.relaxed : task_;
  auto worker =
      seeker(task, rule_, seed(of_survey), [&task, &rule = rule_] { return survey(task, rule); });
  Share share = [&worker = *worker](const Progress& now) -> std::int64_t {
    const bool is_early = now.iterations < shares::first_survey;
    if (!now.has_path) return 0;
    if (is_early && now.rounds_with_path < shares::rounds_without_work) return 0;
    const bool is_first = worker.stage() == 0;
    return growing_share(is_first ? shares::first_pass : shares::survey, now.rounds_with_path);
  };
  Slot& slot = add("survey", std::move(worker), std::move(share));
  slot.is_relaxed = has_relaxed();
}

// [8] Adds the wall prover, which works while there is no route.
void Composer::add_wall_prover() {
  const auto never = [](const Progress&) { return 0; };
  Slot& slot = add("wall prover", wall_prover(task_, nullptr, rule_.only_gear()), never);
  slot.proofs = [first = is_far_ ? shares::first_wall_round_far
                                 : shares::first_wall_round](const Progress& now) {
    return now.has_path || now.rounds < first ? 0 : shares::wall_steps;
  };
}

// [6b] Adds the zone prover.
void Composer::add_zone_prover() {
  const auto never = [](const Progress&) { return 0; };
  Slot& slot = add("zone prover", zone_prover(task_, *pricing_, true), never);
  slot.proofs = share_of_zone_prover();
}

// [7b] Adds the worker that judges routes by the whole drive.
void Composer::add_cheapest_drive() {
  const auto cost = [&pricing = *pricing_](const Route& route) { return pricing.cost(route); };
  auto worker = cheapest_drive(task_, rule_, seed(of_cheapest_drive), cost, pricing_->measure());
  Slot& slot = add("cheapest drive", std::move(worker), [](const Progress& now) {
    return growing_share(shares::cheapest_drive, now.rounds_with_path);
  });
  slot.phase = Phase::after;
}

// Adds a worker that shortens routes along the paths of a caller's source.
void Composer::add_proposals(const NamedSource& source, std::uint64_t number) {
  const std::uint64_t own_seed = stream_seed(seed(of_proposals), number);
  auto make = [&task = task_, &rule = rule_, options = options_, &source, own_seed] {
    return proposals(task, rule, source.make(task, options), own_seed);
  };
  add(source.name, seeker(task_, rule_, own_seed, std::move(make)),
      [share = source.share](const Progress& now) {
        return now.has_path ? growing_share(share, now.rounds_with_path) : share;
      });
}

// Lets the slot `name` hear of all routes that are given up.
void Composer::feed(std::string_view name) {
  std::vector<Slot>& slots = portfolio_.slots;
  const auto listener = std::ranges::find(slots, name, &Slot::name);
  if (listener == slots.end()) return;
  const auto index = static_cast<std::size_t>(listener - slots.begin());
  for (Slot& slot : slots) slot.feeds.push_back(index);
}

Portfolio Composer::portfolio() && {
  if (has_relaxed()) {
    auto relaxed = std::make_unique<Task>(task_);
    relaxed->steering = Steering::reeds_shepp;
    portfolio_.relaxed = std::move(relaxed);
  }
  add_searches();
  if (is_far_ || rule_.is_length()) {
    add("refine", refiner(task_, rule_, seed(of_refine)), share(shares::refine));
  }
  add_length_prover();
  if (is_far_) add_detours();
  Row bend = shares::bend;
  if (follows_site_way_) bend.until_route = shares::following_of_site_way;
  if (bend_) add("bend", std::move(bend_), share(bend));  // [5d]
  if (has_survey_) add_survey();
  add_wall_prover();
  if (has_rules_of_ground(task_)) add_zone_prover();
  if (pricing_->counts_time()) add_cheapest_drive();
  for (std::size_t i = 0; i < sources_.size(); ++i) add_proposals(sources_[i], i);
  feed("bend");
  feed("cheapest drive");
  portfolio_.pricing = std::move(pricing_);
  return std::move(portfolio_);
}

}  // namespace

Portfolio compose(const Task& task, const PlanOptions& options, double time_price,
                  const Given& given) {
  return Composer(task, options, time_price, given).portfolio();
}

}  // namespace vandplan::anytime
