// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/runner.h"

#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

// A run of the campaign that the store does not hold yet.
struct Task {
  RunRecord run;  // all but the result
  const Problem* problem;
  const Scenario* scenario;
  const PlannerInfo* planner;
};

struct Finished {
  RunRecord run;
  double judging_time;
};

// Everything that is to be done, and the problems that the tasks point into.
class TaskList {
 public:
  TaskList(const Campaign& campaign, Store& store, int jobs) {
    environment_ = store.index_of(this_environment());
    std::vector<std::size_t> scenarios;
    for (const auto& [scenario, file] : campaign.scenarios)
      scenarios.push_back(store.index_of(stored(scenario, file)));
    for (const RunSpec& spec : runs_of(campaign)) {
      ++total_;
      const Scenario& scenario = campaign.scenarios[spec.scenario].scenario;
      const PlannerInfo& planner = campaign.planners[spec.planner];
      Task task{{}, nullptr, &scenario, &planner};
      task.run.environment = environment_;
      task.run.scenario = scenarios[spec.scenario];
      task.run.goal = spec.goal;
      task.run.planner = planner.name;
      task.run.options = spec.options;
      task.run.jobs = jobs;
      if (store.contains(task.run)) continue;
      task.problem = &problems_of(scenario)[spec.goal];
      tasks_.push_back(std::move(task));
    }
  }

  const std::vector<Task>& tasks() const { return tasks_; }
  std::size_t environment() const { return environment_; }
  int total() const { return total_; }

 private:
  // Their worlds are built once, for all runs of all planners.
  const std::vector<Problem>& problems_of(const Scenario& scenario) {
    std::vector<Problem>& problems = problems_[&scenario];
    if (problems.empty()) problems = make_problems(scenario);
    return problems;
  }

  std::size_t environment_ = 0;
  int total_ = 0;
  std::map<const Scenario*, std::vector<Problem>> problems_;
  std::vector<Task> tasks_;
};

Finished carry_out(const Task& task, const std::atomic<bool>& stop) {
  Finished finished{task.run, 0.0};
  RunRecord& run = finished.run;
  run.started = utc_now();
  PlanOptions options = run.options;
  options.stop = &stop;
  const Clock::time_point begin = Clock::now();
  run.result = plan(*task.problem, *task.planner, options);
  finished.judging_time = seconds(Clock::now() - begin) - run.result.time_total;
  run.result.tree.reset();
  if (run.result.path) run.result.path->start = task.scenario->start;
  return finished;
}

// Threads that carry out tasks in order; what they finish waits until it is taken.
class Workers {
 public:
  Workers(const std::vector<Task>& tasks, int jobs) : tasks_(tasks), active_(jobs) {
    for (int i = 0; i < jobs; ++i) threads_.emplace_back([this] { work(); });
  }
  ~Workers() { stop(); }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Ends the runs in flight; they are dropped.
  void stop() { stop_ = true; }

  /// What has been finished since the last call, after waiting a moment for something; nothing
  /// and `done` at the end. Throws what a planner has thrown.
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
      for (std::size_t i = next_++; i < tasks_.size(); i = next_++) {
        Finished finished = carry_out(tasks_[i], stop_);
        if (stop_) break;  // the run may have been cut short
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

  const std::vector<Task>& tasks_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  int active_;  // guarded by the mutex, as what follows
  std::vector<Finished> finished_;
  std::exception_ptr error_;
  std::vector<std::jthread> threads_;  // last: joined before anything they use goes away
};

// The first run of a planner would pay for bringing its code and tables into memory.
void warm_up(const Campaign& campaign, const std::vector<Task>& tasks,
             const std::atomic<bool>* stop) {
  if (tasks.empty()) return;
  PlanOptions options = campaign.options;
  options.stop = stop;
  options.max_iterations = 20;
  for (const PlannerInfo& planner : campaign.planners)
    static_cast<void>(plan(*tasks.front().problem, planner, options));
}

void check_jobs(const Campaign& campaign, int jobs) {
  if (jobs < 1) throw InputError("jobs", "must be at least 1");
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  if (campaign.options.time_limit && jobs > cores)
    throw InputError("jobs", fmt::format("{} runs at once on {} cores would take each other's "
                                         "time, expected at most {} with a time budget",
                                         jobs, cores, cores));
}

}  // namespace

double Progress::left() const noexcept {
  return done == 0 ? 0.0 : elapsed / done * (total - kept - done);
}

Progress run_campaign(const Campaign& campaign, Store& store, const RunnerOptions& options) {
  check_jobs(campaign, options.jobs);
  const TaskList list(campaign, store, options.jobs);
  warm_up(campaign, list.tasks(), options.stop);
  const auto total = static_cast<int>(list.total());
  Progress progress{.total = total, .kept = total - static_cast<int>(list.tasks().size())};
  Session session{.environment = list.environment(), .started = utc_now(), .jobs = options.jobs};
  const Clock::time_point begin = Clock::now();
  Workers workers(list.tasks(), options.jobs);
  for (bool done = false; !done;) {
    if (options.stop != nullptr && *options.stop) workers.stop();
    for (const Finished& finished : workers.take(done)) {
      const Clock::time_point before = Clock::now();
      store.add(finished.run);
      session.storing_time += seconds(Clock::now() - before);
      session.planning_time += finished.run.result.time_total;
      session.judging_time += finished.judging_time;
      session.runs = ++progress.done;
      progress.elapsed = seconds(Clock::now() - begin);
      progress.last = &finished.run;
      if (options.report) options.report(progress);
    }
    progress.last = nullptr;
    progress.elapsed = seconds(Clock::now() - begin);
    if (options.report) options.report(progress);
  }
  session.wall_time = progress.elapsed;
  if (session.runs > 0) store.add(session);
  return progress;
}

}  // namespace vandplan
