// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "plan_poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <deque>
#include <functional>
#include <span>

#include "commands.h"
#include "progress_bar.h"
#include "vandplan/input_error.h"
#include "vandplan/random.h"
#include "vandplan/result_file.h"
#include "vandplan/site_table.h"
#include "wording.h"

namespace vandplan::app {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Problems in memory at once. A problem and its result take many times the memory of a pair, and
// there may be millions of pairs.
constexpr std::size_t problems_at_once = 4096;

/// A pair and its number in the file, counted from 1.
struct NumberedPair {
  std::size_t number;
  PosePair pair;
};

/// Whether a pair falls into a shard, which depends on the six numbers of the pair alone.
bool is_in(const evaluation::Shard& shard, const PosePair& pair) {
  std::uint64_t key = 0;
  for (const Pose& pose : {pair.start, pair.goal}) {
    for (const double value : {pose.x, pose.y, pose.heading}) {
      key = stream_seed(key, std::bit_cast<std::uint64_t>(value));
    }
  }
  return key % static_cast<std::uint64_t>(shard.of) + 1 == static_cast<std::uint64_t>(shard.number);
}

std::vector<NumberedPair> pairs_of(const std::vector<PosePair>& all,
                                   const std::optional<evaluation::Shard>& shard) {
  std::vector<NumberedPair> pairs;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!shard || is_in(*shard, all[i])) pairs.push_back({i + 1, all[i]});
  return pairs;
}

std::vector<Problem> problems_of(const Problem& pattern, std::span<const NumberedPair> pairs) {
  std::vector<Problem> problems;
  for (const auto& [number, pair] : pairs) {
    problems.push_back(with_poses(pattern, pair.start, pair.goal));
  }
  return problems;
}

/// Throws InputError naming the table, or the line of a pair whose goal the table of the site
/// lacks.
void check_site(const SiteTable& site, const ScenarioProblems& read, const PlanOptions& options,
                const PosesJob& job, const PosePairs& poses) {
  try {
    site.expect_made_for(read.problems.front(), options);
  } catch (const InputError& error) {
    throw InputError(*job.site, error.problem());
  }
  for (std::size_t i = 0; i < poses.pairs.size(); ++i) {
    site.expect_goal(poses.pairs[i].goal, line_of_file(job.poses, poses.lines[i]));
  }
}

/// Planner and options for all pairs, and the number of pairs planned at once.
struct Manner {
  const Planner& planner;
  const PlanOptions& options;
  int jobs;
};

using Take = std::function<void(std::size_t pair, const Problem& problem, PlanResult result)>;

/// Plans all pairs in the world of `pattern`, and hands the results to `take` in the order of the
/// pairs.
void plan_all(const Problem& pattern, std::span<const NumberedPair> pairs, const Manner& manner,
              const Take& take) {
  for (std::size_t first = 0; first < pairs.size(); first += problems_at_once) {
    const std::size_t count = std::min(problems_at_once, pairs.size() - first);
    const std::vector<Problem> problems = problems_of(pattern, pairs.subspan(first, count));
    plan_many(problems, manner.planner, manner.options, manner.jobs,
              [&](std::size_t i, PlanResult result) {
                take(pairs[first + i].number, problems[i], std::move(result));
              });
  }
}

std::string outcome_text(const PlanResult& result) {
  const std::string time = seconds_text(result.time_total);
  if (!result.path) return no_path_text(result) + ", " + time;
  return "solved: " + path_text(*result.check) + ", " + time;
}

/// Writes results as JSON at once, and keeps the summary until the end. Otherwise its lines would
/// stand between those of the progress bar.
class Results {
 public:
  Results(const ResultRecord& pattern, const PosesJob& job) : pattern_(pattern), job_(job) {
    if (job.output) outputs_.emplace_back(*job.output, pattern);
    if (job.json) outputs_.emplace_back("-", pattern);
  }

  void take(std::size_t pair, const Problem& problem, PlanResult result) {
    solved_ += result.path ? 1U : 0U;
    if (!job_.json) summaries_ += fmt::format("{}: {}\n", pair, outcome_text(result));
    if (outputs_.empty()) return;
    ResultRecord record = pattern_;
    record.result = std::move(result);
    record.result.tree.reset();
    for (PairWriter& output : outputs_) output.write(pair, problem, record);
  }

  void commit() {
    for (PairWriter& output : outputs_) output.commit();
  }
  [[nodiscard]] std::size_t solved() const { return solved_; }
  [[nodiscard]] const std::string& summaries() const { return summaries_; }

 private:
  const ResultRecord& pattern_;
  const PosesJob& job_;
  std::deque<PairWriter> outputs_;
  std::string summaries_;
  std::size_t solved_ = 0;
};

}  // namespace

int plan_poses(const ScenarioProblems& read, const Planner& planner, const PlanOptions& options,
               const PosesJob& job) {
  const PosePairs poses = read_pose_pairs(job.poses);
  warn(poses.warnings);
  if (options.site) check_site(*options.site, read, options, job, poses);
  const std::vector<NumberedPair> pairs = pairs_of(poses.pairs, job.shard);
  ResultRecord pattern;
  pattern.scenario = read.file.scenario.name;
  pattern.planner = planner.name;
  pattern.options = options;
  Results results(pattern, job);
  const auto begin = std::chrono::steady_clock::now();
  {
    ProgressBar bar;
    Progress progress;
    progress.total = static_cast<int>(pairs.size());
    const auto take = [&](std::size_t pair, const Problem& problem, PlanResult result) {
      results.take(pair, problem, std::move(result));
      ++progress.done;
      progress.elapsed = seconds_since(begin);
      bar.show(progress);
    };
    plan_all(read.problems.front(), pairs, {planner, options, job.jobs}, take);
  }
  results.commit();
  const double elapsed = seconds_since(begin);
  if (!job.json) {
    fmt::print("{}{}, {}: {} of {} solved in {}, {:.1f} plans per second\n", results.summaries(),
               printable(pattern.scenario), planner.name, results.solved(), pairs.size(),
               seconds_text(elapsed), static_cast<double>(pairs.size()) / elapsed);
  }
  return results.solved() == pairs.size() ? exit_status::done : exit_status::failed;
}

}  // namespace vandplan::app
