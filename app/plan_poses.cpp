// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "plan_poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include "commands.h"
#include "progress_bar.h"
#include "vandplan/input_error.h"
#include "vandplan/io.h"

namespace vandplan {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Calls `work(i)` for all i below `count`, `jobs` at a time, and `tell(done)` in between.
template <typename Work, typename Tell>
void for_all(std::size_t count, int jobs, Work work, Tell tell) {
  std::atomic<std::size_t> next = 0;
  std::size_t done = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto take = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      std::exception_ptr thrown;
      try {
        work(i);
      } catch (...) {
        thrown = std::current_exception();
        next = count;
      }
      const std::lock_guard lock(mutex);
      if (thrown) failure = thrown;
      tell(++done);
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int i = 1; i < jobs; ++i) helpers.emplace_back(take);
    take();
  }
  if (failure) std::rethrow_exception(failure);
}

/// The result as one line of JSON, in the scenario's frame.
std::string line_of(std::size_t pair, const Scenario& scenario, const ResultRecord& record) {
  nlohmann::ordered_json line = {{"pair", pair}};
  line.update(nlohmann::ordered_json::parse(results_to_json(scenario, {record})));
  return line.dump() + "\n";
}

std::string summary_of(std::size_t pair, const PlanResult& result) {
  if (!result.path) {
    return fmt::format("{}: no path: {}, {:.4f} s\n", pair, name_of(result.status),
                       result.time_total);
  }
  const std::vector<Segment>& segments = result.path->segments;
  return fmt::format("{}: solved: length {:.3f} m, gear changes {}, {:.4f} s\n", pair,
                     length(segments), gear_changes(segments), result.time_total);
}

}  // namespace

int plan_poses(const Scenario& scenario, const PlannerInfo& planner, const PlanOptions& options,
               const PosesJob& job) {
  const std::vector<PosePair> pairs = read_pose_pairs(job.poses);
  if (job.output) expect_writable(*job.output);
  const std::shared_ptr<const World> world = make_problem(scenario, 0).world;
  std::vector<Problem> problems;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    try {
      problems.push_back(make_problem(world, pairs[i].start, pairs[i].goal));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: pair {}", job.poses, i + 1), error.what());
    }
  }
  std::vector<PlanResult> results(pairs.size());
  const auto begin = std::chrono::steady_clock::now();
  {
    ProgressBar bar;
    Progress progress;
    progress.total = static_cast<int>(pairs.size());
    for_all(
        pairs.size(), job.jobs,
        [&](std::size_t i) { results[i] = plan(problems[i], planner, options); },
        [&](std::size_t done) {
          progress.done = static_cast<int>(done);
          progress.elapsed = seconds_since(begin);
          bar.show(progress);
        });
  }
  const double elapsed = seconds_since(begin);
  std::string lines;
  std::size_t solved = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    PlanResult& result = results[i];
    solved += result.path ? 1U : 0U;
    if (result.path) result.path->start = to_scenario(*world, result.path->start);
    if (!job.json) fmt::print("{}", summary_of(i + 1, result));
    if (!job.json && !job.output) continue;
    result.tree.reset();
    lines += line_of(i + 1, scenario,
                     {.scenario = scenario.name,
                      .planner = std::string(planner.name),
                      .options = options,
                      .distance = {},
                      .result = std::move(result),
                      .claims = {},
                      .furthest = {}});
  }
  if (job.output) write_file(*job.output, lines);
  if (job.json) {
    fmt::print("{}", lines);
  } else {
    fmt::print("{}, {}: {} of {} solved in {:.3f} s, {:.1f} plans per second\n", scenario.name,
               planner.name, solved, results.size(), elapsed,
               static_cast<double>(results.size()) / elapsed);
  }
  return solved == results.size() ? exit_status::done : exit_status::failed;
}

}  // namespace vandplan
