// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "evaluation/shards.h"
#include "vandplan/input_error.h"
#include "vandplan/search.h"

namespace vandplan::evaluation {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

// Run of a campaign that the store does not hold yet.
struct Job {
  RunRecord run;  // record of the run, without the result
  const Problem* problem;
  const Planner* planner;
};

struct Finished {
  RunRecord run;
  double judging_time;
};

// List of all jobs, and the problems that they refer to.
class JobList {
 public:
  JobList(const Campaign& campaign, Store& store, int jobs) {
    environment_ = store.index_of(environment_of(campaign));
    std::vector<std::size_t> scenarios;
    for (const auto& [scenario, file] : campaign.scenarios)
      scenarios.push_back(store.index_of(stored(scenario, file)));
    for (const RunSpec& spec : runs_of(campaign)) {
      ++total_;
      const Planner& planner = campaign.planners[spec.planner];
      Job job{{}, nullptr, &planner};
      job.run.environment = environment_;
      job.run.scenario = scenarios[spec.scenario];
      job.run.goal = spec.goal;
      job.run.planner = planner.name;
      job.run.region = spec.region;
      job.run.options = spec.options;
      job.run.seed = spec.seed;
      job.run.jobs = jobs;
      if (store.contains(job.run)) continue;
      job.problem = &problems_of(campaign.scenarios[spec.scenario].scenario)[spec.goal];
      jobs_.push_back(std::move(job));
    }
  }

  const std::vector<Job>& jobs() const { return jobs_; }
  std::size_t environment() const { return environment_; }
  int total() const { return total_; }

 private:
  // Problems of a scenario. Their worlds are built once, for all runs of all planners.
  const std::vector<Problem>& problems_of(const ScenarioFile& scenario) {
    std::vector<Problem>& problems = problems_[&scenario];
    if (problems.empty()) problems = make_problems(scenario);
    return problems;
  }

  std::size_t environment_ = 0;
  int total_ = 0;
  std::map<const ScenarioFile*, std::vector<Problem>> problems_;
  std::vector<Job> jobs_;
};

Finished carry_out(const Job& job, const std::stop_token& stop) {
  Finished finished{job.run, 0.0};
  RunRecord& run = finished.run;
  run.started = utc_now();
  PlanOptions options = *run.options;
  options.budget.seed = run.seed;
  options.budget.stop = stop;
  const search::Budget clock(options.budget);  // clock of the same kind as the planner's
  run.result = plan(*job.problem, *job.planner, options);
  finished.judging_time = clock.elapsed() - run.result.time_total;
  run.result.tree.reset();
  return finished;
}

// Threads that carry out jobs in order. Finished runs wait until they are taken.
class Workers {
 public:
  Workers(const std::vector<Job>& jobs, int threads) : jobs_(jobs), active_(threads) {
    for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
  }
  ~Workers() { stop(); }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Ends and drops the runs in flight.
  void stop() { stop_.request_stop(); }

  /// Runs that have finished since the last call. Waits a moment if there are none. At the end it
  /// returns none and sets `done`. Throws what a planner has thrown.
  std::vector<Finished> take(bool& done) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::milliseconds(100),
                      [this] { return !finished_.empty() || active_ == 0; });
    if (error_) std::rethrow_exception(error_);
    done = active_ == 0;
    return std::exchange(finished_, {});
  }

 private:
  void work() {
    try {
      for (std::size_t i = next_++; i < jobs_.size(); i = next_++) {
        Finished finished = carry_out(jobs_[i], stop_.get_token());
        if (stop_.stop_requested()) break;  // the run may have been cut short
        const std::lock_guard lock(mutex_);
        finished_.push_back(std::move(finished));
        changed_.notify_one();
      }
    } catch (...) {
      stop();
      const std::lock_guard lock(mutex_);
      error_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    --active_;
    changed_.notify_one();
  }

  const std::vector<Job>& jobs_;
  std::atomic<std::size_t> next_ = 0;
  std::stop_source stop_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int active_;  // number of working threads; guarded by `mutex_`, as are the next two members
  std::vector<Finished> finished_;
  std::exception_ptr error_;
  // Threads; last member, so they are joined before what they use is destroyed.
  std::vector<std::jthread> threads_;
};

// Runs each planner briefly. Otherwise its first run would pay for loading its code and tables.
void warm_up(const Campaign& campaign, const std::vector<Job>& jobs, const std::stop_token& stop) {
  if (jobs.empty()) return;
  for (const Planner& planner : campaign.planners) {
    const Problem& problem = *jobs.front().problem;
    PlanOptions options = options_of(campaign, planner, problem.vehicle());
    options.budget.stop = stop;
    options.budget.max_iterations = 20;
    static_cast<void>(plan(problem, planner, options));
  }
}

void check_jobs(const Campaign& campaign, int jobs) {
  if (jobs < 1) throw InputError("jobs", "must be at least 1");
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  const auto is_timed = [&](const Planner& planner) {
    return budget_of(campaign, planner).time_limit.has_value();
  };
  if (jobs > cores && std::ranges::any_of(campaign.planners, is_timed)) {
    throw InputError("jobs", fmt::format("{} runs at once on {} cores would take each other's "
                                         "time, expected at most {} with a time budget",
                                         jobs, cores, cores));
  }
}

}  // namespace

double Progress::left() const noexcept {
  return done == 0 ? 0.0 : elapsed / done * (total - kept - done);
}

Progress run_campaign(const Campaign& campaign, Store& store, const RunnerOptions& options) {
  check_jobs(campaign, options.jobs);
  const JobList list(campaign, store, options.jobs);
  warm_up(campaign, list.jobs(), options.stop);
  const auto total = static_cast<int>(list.total());
  Progress progress{.total = total, .kept = total - static_cast<int>(list.jobs().size())};
  Session session{.environment = list.environment(), .started = utc_now(), .jobs = options.jobs};
  const Clock::time_point begin = Clock::now();
  Workers workers(list.jobs(), options.jobs);
  for (bool done = false; !done;) {
    if (options.stop.stop_requested()) workers.stop();
    for (const Finished& finished : workers.take(done)) {
      const Clock::time_point before = Clock::now();
      store.add(finished.run);
      session.storing_time += seconds(Clock::now() - before);
      session.planning_time += finished.run.result.time_total;
      session.judging_time += finished.judging_time;
      session.runs = ++progress.done;
      progress.elapsed = seconds(Clock::now() - begin);
      if (options.report) options.report(progress);
    }
    progress.elapsed = seconds(Clock::now() - begin);
    if (options.report) options.report(progress);
  }
  session.wall_time = progress.elapsed;
  if (session.runs > 0) store.add(session);
  return progress;
}

}  // namespace vandplan::evaluation
