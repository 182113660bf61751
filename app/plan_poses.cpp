// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "plan_poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "commands.h"
#include "progress_bar.h"
#include "vandplan/io.h"

namespace vandplan {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Calls `work(i)` for all i below `count`, `jobs` at a time, and `take_in(i, result)` one by one.
template <typename Work, typename TakeIn>
void for_all(std::size_t count, int jobs, Work work, TakeIn take_in) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto take = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        auto result = work(i);
        const std::lock_guard lock(mutex);
        take_in(i, std::move(result));
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
        next = count;
      }
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
    problems.push_back(make_problem(world, pair.start, pair.goal));
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
  return result_to_json_line(pair, scenario, in_scenario(world, std::move(record)));
}

/// What is said of one pair.
struct Answer {
  bool is_planned = false;
  bool is_solved = false;
  std::string summary;
  std::string json;  ///< empty unless somebody wants it
};

/// Where JSON goes: a pair's line as soon as all before it are there.
class Lines {
 public:
  Lines(const PosesJob& job, std::vector<Answer>& answers) : answers_(answers) {
    if (job.output) outputs_.emplace_back(*job.output);
    if (job.json) outputs_.emplace_back("-");
  }

  [[nodiscard]] bool are_wanted() const { return !outputs_.empty(); }
  void write() {
    for (; next_ < answers_.size() && answers_[next_].is_planned; ++next_) {
      const std::string line = std::exchange(answers_[next_].json, {});
      for (FileWriter& output : outputs_) output.write(line);
    }
  }
  void commit() {
    for (FileWriter& output : outputs_) output.commit();
  }

 private:
  std::vector<Answer>& answers_;
  std::deque<FileWriter> outputs_;
  std::size_t next_ = 0;
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
  std::vector<Answer> answers(problems.size());
  Lines lines(job, answers);
  const auto answer_of = [&](std::size_t i) {
    PlanResult result = plan(problems[i], planner, options);
    Answer answer{true, result.path.has_value(), summary_of(i + 1, result), ""};
    if (!lines.are_wanted()) return answer;
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
  const auto begin = std::chrono::steady_clock::now();
  {
    ProgressBar bar;
    Progress progress;
    progress.total = static_cast<int>(problems.size());
    for_all(problems.size(), job.jobs, answer_of, [&](std::size_t i, Answer answer) {
      answers[i] = std::move(answer);
      lines.write();
      ++progress.done;
      progress.elapsed = seconds_since(begin);
      bar.show(progress);
    });
  }
  lines.commit();
  if (!job.json) print(scenario, planner, answers, seconds_since(begin));
  const bool all_solved = std::all_of(answers.begin(), answers.end(),
                                      [](const Answer& answer) { return answer.is_solved; });
  return all_solved ? exit_status::done : exit_status::failed;
}

}  // namespace vandplan
