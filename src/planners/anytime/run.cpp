// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "planners/anytime/portfolio.h"

// The steps in brackets are those of docs/algorithms/anytime.md.
namespace vandplan::anytime {
namespace {

constexpr int max_idle_rounds = 128;  // rounds in a row without work that end a run

class Run final : public planning::PathSearch {
 public:
  Run(Portfolio portfolio, const search::Budget& budget, const BudgetOptions& options);

  bool advance(std::int64_t most) override;
  [[nodiscard]] std::int64_t iterations() const override { return budget_.iterations(); }
  [[nodiscard]] std::optional<std::vector<Segment>> path() override;
  [[nodiscard]] PlannerAnswer answer() override;
  [[nodiscard]] Proven proven() const override;

 private:
  [[nodiscard]] std::int64_t left(std::int64_t wanted, std::int64_t promised) const;
  [[nodiscard]] Progress progress() const;
  [[nodiscard]] Told told(const Slot& slot, double enough_cost) const;
  [[nodiscard]] Drive best() const;
  [[nodiscard]] bool has_path() const { return route_ || drive_; }
  [[nodiscard]] double cost() const;
  [[nodiscard]] double cost_of_search() const;
  [[nodiscard]] double enough() const;
  [[nodiscard]] bool is_optimal() const;
  [[nodiscard]] bool is_good_enough();
  [[nodiscard]] bool is_exhausted() const;

  void take(search::Route route);
  void round();
  void work_before(Slot& slot);
  void work_together();
  void work_after(Slot& slot, std::int64_t iterations);
  void merge(const Slot& slot, Found& found);
  void merge_relaxed(Found& found);
  void note(std::span<const CostSample> improvements);
  void note_cost();
  void make_drivable();

  Portfolio portfolio_;
  search::Budget budget_;
  std::uint64_t seed_;
  int threads_;
  bool has_time_limit_;
  std::int64_t last_ = 0;               // iteration at which the round ends
  std::optional<PlanStatus> end_;       // why the run ended, if the budget was spent
  std::optional<search::Route> route_;  // cheapest route
  std::optional<Drive> drive_;          // cheapest drive
  std::vector<CostSample> trace_;       // costs of each improvement
  std::int64_t rounds_ = 0, rounds_with_path_ = 0;
  std::int64_t proofs_of_round_ = 0;  // steps of proving in this round
  int idle_rounds_ = 0;               // rounds in a row without any work
  /// Cost of the best path when it last fell clearly.
  double noted_cost_ = std::numeric_limits<double>::infinity();
  /// Iteration at which the best cost last fell clearly.
  std::int64_t noted_at_ = 0;
  /// Cost of the path whose strokes were lengthened last to test the gap, before and after that.
  double cost_before_strokes_ = 0.0;
  double cost_with_strokes_ = 0.0;
  std::vector<Segment> raw_;       // segments that `segments_` were made of
  std::vector<Segment> segments_;  // segments of the answer, tidied
};

Run::Run(Portfolio portfolio, const search::Budget& budget, const BudgetOptions& options)
    : portfolio_(std::move(portfolio)),
      budget_(budget),
      seed_(options.seed),
      threads_(options.threads),
      has_time_limit_(options.time_limit.has_value()) {
  for (search::Route& route : portfolio_.routes) take(std::move(route));
  if (!portfolio_.drive) return;
  drive_ = std::move(portfolio_.drive);
  note({{{budget_.elapsed(), 0, drive_->cost}}});
}

// Takes a route that is known before the first round.
void Run::take(search::Route route) {
  if (route_ && route.cost >= route_->cost) return;
  route_ = std::move(route);
  if (portfolio_.routes_are_answers) note({{{budget_.elapsed(), 0, route_->cost}}});
  for (Slot& slot : portfolio_.slots) {
    if (slot.phase == Phase::after) work_after(slot, 0);
  }
}

// Number of the `wanted` iterations that are left after `promised` ones.
std::int64_t Run::left(std::int64_t wanted, std::int64_t promised) const {
  const std::int64_t most = last_ - budget_.iterations() - promised;
  return std::min(budget_.left(wanted, promised), std::max<std::int64_t>(most, 0));
}

Progress Run::progress() const {
  return {.rounds = rounds_,
          .rounds_with_path = rounds_with_path_,
          .iterations = budget_.iterations(),
          .has_path = has_path(),
          .is_settled = budget_.iterations() > 2 * noted_at_};
}

Told Run::told(const Slot& slot, double enough_cost) const {
  const bool may_be_enough = portfolio_.routes_are_answers && !slot.is_relaxed;
  return {.route = route_ ? &*route_ : nullptr,
          .drive = drive_ ? &*drive_ : nullptr,
          .enough = may_be_enough ? enough_cost : 0.0};
}

// The best drive, or else the drive along the best route.
Drive Run::best() const {
  if (drive_ && (!route_ || !portfolio_.routes_are_answers || drive_->cost < route_->cost)) {
    return *drive_;
  }
  return {.segments = path_of(*route_).segments, .route = route_, .cost = route_->cost};
}

// Cost of the best answer before tidying.
double Run::cost() const {
  if (!portfolio_.routes_are_answers || !route_) return drive_->cost;
  return drive_ ? std::min(route_->cost, drive_->cost) : route_->cost;
}

// Cost of the best path by the prices of the searches.
double Run::cost_of_search() const {
  return portfolio_.routes_are_answers || !route_ ? cost() : route_->cost;
}

Proven Run::proven() const {
  Proven all;
  for (const Slot& slot : portfolio_.slots) {
    const Proven proven = slot.worker->proven();
    all.shortest = std::max(all.shortest, proven.shortest);
    all.shortest_turn = std::max(all.shortest_turn, proven.shortest_turn);
    all.added = std::max(all.added, proven.added);
    all.in_zones = std::max(all.in_zones, proven.in_zones);
    if (all.walled_in.empty()) all.walled_in = proven.walled_in;
  }
  return all;
}

// Largest cost that is proven to be within the gap of the optimum; 0 without a gap.
double Run::enough() const {
  return portfolio_.gap ? (1 + *portfolio_.gap) * portfolio_.bound.least(proven()) : 0.0;
}

bool Run::is_optimal() const { return has_path() && portfolio_.bound.is_optimal(cost(), proven()); }

// Whether the best path is proven to be within the gap of the optimum, even with strokes of
// `min_stroke`.
bool Run::is_good_enough() {
  if (!has_path() || !portfolio_.gap) return false;
  const double found = cost();
  if (found > enough()) return false;
  if (portfolio_.finisher.min_stroke() == 0.0) return true;
  if (found != cost_before_strokes_) {
    const Drive best_found = best();
    cost_before_strokes_ = found;
    cost_with_strokes_ =
        portfolio_.finisher.drivable(best_found, portfolio_.finisher.raw(best_found), is_optimal())
            ->cost;
  }
  return cost_with_strokes_ <= enough();
}

void Run::note(std::span<const CostSample> improvements) {
  for (const CostSample& sample : improvements) {
    if (!trace_.empty() && sample.cost >= trace_.back().cost) continue;
    const double time = trace_.empty() ? sample.time : std::max(sample.time, trace_.back().time);
    trace_.push_back({time, budget_.iterations() + sample.iteration, sample.cost});
  }
}

void Run::merge(const Slot& slot, Found& found) {
  if (portfolio_.routes_are_answers || slot.phase == Phase::after) note(found.improvements);
  budget_.spend(found.iterations);
  if (found.drive && (!drive_ || found.drive->cost <= drive_->cost)) {
    drive_ = std::move(found.drive);
  }
  if (found.route && (!route_ || found.route->cost < route_->cost)) {
    route_ = std::move(found.route);
  }
}

void Run::note_cost() {
  if (!has_path() || cost_of_search() >= (1 - search::progress) * noted_cost_) return;
  noted_cost_ = cost_of_search();
  noted_at_ = budget_.iterations();
}

// Takes results of the relaxed task: routes are no answers, but other workers make drives of them.
void Run::merge_relaxed(Found& found) {
  budget_.spend(found.iterations);
  if (found.route) found.given_up.push_back(*std::move(found.route));
}

// Lets a worker raise the bound until the gap is proven or its share is used up.
void Run::work_before(Slot& slot) {
  std::int64_t steps = has_path() ? slot.share(progress()) : 0;
  for (; steps > 0 && !is_good_enough(); --steps) {
    if (!slot.worker->has_work()) {
      const std::int64_t proofs = slot.worker->prove(slot.proofs(progress()), budget_);
      if (proofs == 0) return;
      proofs_of_round_ += proofs;
      continue;
    }
    Found found = slot.worker->work(left(1, 0), told(slot, 0.0), budget_);
    if (found.iterations == 0) return;
    merge(slot, found);
    note_cost();
  }
}

void Run::work_together() {
  std::vector<Slot>& slots = portfolio_.slots;
  const Progress now = progress();
  std::vector<std::int64_t> granted(slots.size()), proofs(slots.size());
  std::int64_t promised = 0;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Slot& slot = slots[i];
    if (slot.phase != Phase::together) continue;
    if (slot.worker->has_work()) granted[i] = left(slot.share(now), promised);
    if (slot.proofs) proofs[i] = slot.proofs(now);
    promised += granted[i];
  }
  const double enough_cost = enough();
  std::vector<Found> found(slots.size());
  parallel_for(slots.size(), has_path() ? threads_ : 1, [&](std::size_t i) {
    if (slots[i].phase == Phase::after) return;
    found[i] = slots[i].worker->work(granted[i], told(slots[i], enough_cost), budget_);
    if (proofs[i] > 0) proofs[i] = slots[i].worker->prove(proofs[i], budget_);
  });
  for (const std::int64_t made : proofs) proofs_of_round_ += made;
  if (has_path()) ++rounds_with_path_;
  for (std::size_t i = 0; i < slots.size(); ++i) {  // [7]
    if (slots[i].is_relaxed) {
      merge_relaxed(found[i]);
    } else {
      merge(slots[i], found[i]);
      note_cost();
    }
    for (const search::Route& route : found[i].given_up) {
      for (const std::size_t listener : slots[i].feeds) slots[listener].worker->offer(route);
    }
  }
}

void Run::work_after(Slot& slot, std::int64_t iterations) {
  Found found = slot.worker->work(iterations, told(slot, 0.0), budget_);
  merge(slot, found);
}

void Run::round() {
  const std::int64_t before = budget_.iterations();
  const bool may_work = left(1, 0) > 0;
  proofs_of_round_ = 0;
  for (Slot& slot : portfolio_.slots) {
    if (slot.phase == Phase::before) work_before(slot);
  }
  if (is_good_enough()) return;
  work_together();
  for (Slot& slot : portfolio_.slots) {
    if (slot.phase == Phase::after && route_) work_after(slot, left(slot.share(progress()), 0));
  }
  ++rounds_;
  const bool has_proven = (has_time_limit_ || !has_path()) && proofs_of_round_ > 0;
  const bool is_idle = budget_.iterations() == before && !has_proven;
  if (may_work) idle_rounds_ = is_idle ? idle_rounds_ + 1 : 0;
}

// Whether the run was idle for many rounds; some workers wait for later rounds. A round of proofs
// is not idle while there is no route: a proof that there is none ends. With a route it is idle,
// unless there is a time limit, as iterations would never end it.
bool Run::is_exhausted() const { return idle_rounds_ >= max_idle_rounds; }

bool Run::advance(std::int64_t most) {
  const std::int64_t endless = std::numeric_limits<std::int64_t>::max();
  last_ = budget_.iterations() + std::min(most, endless - budget_.iterations());
  const bool is_over =
      is_optimal() || is_good_enough() || !proven().walled_in.empty() || is_exhausted();
  if (is_over) return false;
  end_ = budget_.exhausted();
  if (!end_) round();
  return !end_;
}

void Run::make_drivable() {
  if (!has_path()) return;
  const Drive best_found = best();
  std::vector<Segment> raw = portfolio_.finisher.raw(best_found);
  if (raw == raw_) return;  // the answer has not changed
  raw_ = raw;
  segments_ = std::move(raw);
  std::optional<Drive> neat = portfolio_.finisher.finished(best_found, segments_, is_optimal());
  if (!neat) return;
  segments_ = std::move(neat->segments);
  if (!portfolio_.routes_are_answers) return;
  while (trace_.size() > 1 && trace_[trace_.size() - 2].cost <= neat->cost) trace_.pop_back();
  trace_.back().cost = neat->cost;
}

std::optional<std::vector<Segment>> Run::path() {
  make_drivable();  // [10]
  if (!has_path()) return std::nullopt;
  return segments_;
}

PlannerAnswer Run::answer() {
  if (route_ && is_optimal()) {  // [9]
    route_ = portfolio_.finisher.with_fewer_changes(*route_, portfolio_.bound.shortest(), seed_,
                                                    budget_);
  }
  PlannerAnswer answer;
  answer.segments = path();
  answer.iterations = budget_.iterations();
  answer.anytime = trace_;
  answer.lower_bound = portfolio_.bound.least(proven());
  Counts sum;
  for (const Slot& slot : portfolio_.slots) sum += slot.worker->counts();
  answer.counters = {
      {"nodes", sum.nodes}, {"exact_solves", sum.solves}, {"edge_checks", sum.checks}};
  if (answer.segments) {
    answer.status = PlanStatus::solved;
    return answer;
  }
  if (const std::string_view what = proven().walled_in; !what.empty()) {
    answer.status = PlanStatus::no_path;
    answer.reason = "proven: " + std::string(what) + " gets from the start to the goal";
    return answer;
  }
  if (is_exhausted()) {
    answer.status = PlanStatus::node_limit;
    answer.reason = "the finest searches have no route";
    return answer;
  }
  answer.status = end_.value_or(PlanStatus::iteration_limit);  // the run has only paused
  return answer;
}

}  // namespace

std::unique_ptr<planning::PathSearch> begin_run(Portfolio portfolio, const search::Budget& budget,
                                                const BudgetOptions& options) {
  return std::make_unique<Run>(std::move(portfolio), budget, options);
}

}  // namespace vandplan::anytime
