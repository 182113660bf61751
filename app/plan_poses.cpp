// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "plan_poses.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

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

std::vector<Problem> problems_of(const std::shared_ptr<const World>& world,
                                 const std::string& file) {
  std::vector<Problem> problems;
  for (const PosePair& pair : read_pose_pairs(file)) {
    try {
      problems.push_back(make_problem(world, pair.start, pair.goal));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: pair {}", file, problems.size() + 1), error.what());
    }
  }
  return problems;
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

/// The result as one line of JSON, in the scenario's frame.
std::string line_of(std::size_t pair, const Scenario& scenario, const World& world,
                    ResultRecord record) {
  record.result.tree.reset();
  if (record.result.path) {
    Pose& start = record.result.path->start;
    start = to_scenario(world, start);
  }
  return result_to_json_line(pair, scenario, record);
}

/// What is said of one pair.
struct Answer {
  bool is_solved = false;
  std::string summary;
  std::string json;  ///< empty unless somebody wants it
};

void print(const Scenario& scenario, const PlannerInfo& planner, const std::vector<Answer>& answers,
           double elapsed) {
  std::size_t solved = 0;
  for (const Answer& answer : answers) {
    solved += answer.is_solved ? 1U : 0U;
    fmt::print("{}", answer.summary);
  }
  fmt::print("{}, {}: {} of {} solved in {:.3f} s, {:.1f} plans per second\n", scenario.name,
             planner.name, solved, answers.size(), elapsed,
             static_cast<double>(answers.size()) / elapsed);
}

}  // namespace

int plan_poses(const Scenario& scenario, const PlannerInfo& planner, const PlanOptions& options,
               const PosesJob& job) {
  const std::shared_ptr<const World> world = make_problem(scenario, 0).world;
  const std::vector<Problem> problems = problems_of(world, job.poses);
  if (job.output) expect_writable(*job.output);
  const auto answer_of = [&](std::size_t i) {
    PlanResult result = plan(problems[i], planner, options);
    Answer answer{result.path.has_value(), summary_of(i + 1, result), ""};
    if (!job.output && !job.json) return answer;
    answer.json = line_of(i + 1, scenario, *world,
                          {.scenario = scenario.name,
                           .planner = std::string(planner.name),
                           .options = options,
                           .distance = {},
                           .result = std::move(result),
                           .claims = {},
                           .furthest = {}});
    return answer;
  };
  std::vector<Answer> answers(problems.size());
  const auto begin = std::chrono::steady_clock::now();
  {
    ProgressBar bar;
    Progress progress;
    progress.total = static_cast<int>(problems.size());
    for_all(
        problems.size(), job.jobs, [&](std::size_t i) { answers[i] = answer_of(i); },
        [&](std::size_t done) {
          progress.done = static_cast<int>(done);
          progress.elapsed = seconds_since(begin);
          bar.show(progress);
        });
  }
  const double elapsed = seconds_since(begin);
  std::size_t size = 0;
  for (const Answer& answer : answers) size += answer.json.size();
  std::string lines;
  lines.reserve(size);
  bool all_solved = true;
  for (Answer& answer : answers) {
    lines += std::exchange(answer.json, {});
    all_solved = all_solved && answer.is_solved;
  }
  if (job.output) write_file(*job.output, lines);
  if (job.json) {
    fmt::print("{}", lines);
  } else {
    print(scenario, planner, answers, elapsed);
  }
  return all_solved ? exit_status::done : exit_status::failed;
}

}  // namespace vandplan
