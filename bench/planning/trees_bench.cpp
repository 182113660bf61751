// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How do planners do beside the first of them, seed by seed?
// usage: trees_bench SEEDS LIMIT bounds|scene PLANNER[,KEY=VALUE...]... -- SCENARIO.yaml...
//
// LIMIT is a number of iterations, or seconds as in "0.1s". Medians, and for the costs of the first
// and of the last path the ratio to those of the first planner: its mean over the seeds that both
// have solved (geometric), with the interval that holds 95 % of 2 000 resampled means.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "support/figure.h"
#include "vandplan/files.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

struct Limit {
  std::optional<std::int64_t> iterations;
  std::optional<double> seconds;
};

struct Run {
  bool solved = false;
  double first_time = 0.0;  // [ms]
  double first_cost = 0.0;  // [m]
  double cost = 0.0;        // [m]
  double iterations = 0.0;
  double seconds = 0.0;
};

struct Contender {
  std::string text;
  Planner planner;
  std::vector<Setting> settings;
};

std::vector<std::string> split(const std::string& text, char by) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == by) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

Contender contender(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  Contender made{text, planner_named(parts[0]), {}};
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::vector<std::string> pair = split(parts[i], '=');
    made.settings.push_back({pair[0], pair.at(1)});
  }
  return made;
}

Run run(const Problem& problem, const Contender& who, int seed, const Limit& limit,
        const std::string& region) {
  PlanOptions options{.cost = shortest_style, .steering = Steering::reeds_shepp};
  options.budget.seed = static_cast<std::uint64_t>(seed);
  options.budget.max_iterations = limit.iterations;
  options.budget.time_limit = limit.seconds;
  if (honours(who.planner, "region")) set_option(options, who.planner, "region", region);
  for (const auto& [name, value] : who.settings) set_option(options, who.planner, name, value);
  const PlanResult result = plan(problem, who.planner, options);
  if (result.status == PlanStatus::rejected) std::printf("REJECTED %s\n", result.reason.c_str());
  Run found{.iterations = static_cast<double>(result.iterations), .seconds = result.time_total};
  if (!result.path) return found;
  found.solved = true;
  found.first_time = 1e3 * result.anytime.front().time;
  found.first_cost = result.anytime.front().cost;
  found.cost = result.cost;
  return found;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// "0.912 (0.880 to 0.943)" from logarithms of ratios.
std::string with_interval(const std::vector<double>& logs) {
  if (logs.size() < 2) return "-";
  Rng rng(1);
  std::vector<double> means;
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> again;
    for (std::size_t j = 0; j < logs.size(); ++j) again.push_back(logs[rng() % logs.size()]);
    means.push_back(mean(again));
  }
  std::sort(means.begin(), means.end());
  char text[64];
  std::snprintf(text, sizeof text, "%.3f (%.3f to %.3f)", std::exp(mean(logs)), std::exp(means[50]),
                std::exp(means[1949]));
  return text;
}

std::string ratio(const std::vector<Run>& runs, const std::vector<Run>& others, double Run::*what) {
  std::vector<double> logs;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].solved || !others[i].solved) continue;
    const double log = std::log(runs[i].*what / others[i].*what);
    if (std::isfinite(log)) logs.push_back(log);
  }
  return with_interval(logs);
}

void print(const Contender& who, const std::vector<Run>& runs, const std::vector<Run>& others) {
  const auto all = [&](double Run::*what) {
    std::vector<double> values;
    for (const Run& run : runs) {
      if (run.solved) values.push_back(run.*what);
    }
    return median(values);
  };
  double iterations = 0.0;
  double seconds = 0.0;
  for (const Run& run : runs) {
    iterations += run.iterations;
    seconds += run.seconds;
  }
  std::printf(
      "  %-44s solved %3d  first %s ms %s m  last %s m  %s it/s  first %-24s last %s\n",
      who.text.c_str(), static_cast<int>(std::ranges::count(runs, true, &Run::solved)),
      figure("%8.3f", all(&Run::first_time)).c_str(),
      figure("%7.1f", all(&Run::first_cost)).c_str(), figure("%7.1f", all(&Run::cost)).c_str(),
      figure("%8.0f", iterations / seconds).c_str(), ratio(runs, others, &Run::first_cost).c_str(),
      ratio(runs, others, &Run::cost).c_str());
}

void compare(const std::string& name, const Problem& problem, int seeds, const Limit& limit,
             const std::string& region, const std::vector<Contender>& contenders) {
  std::vector<std::vector<Run>> runs(contenders.size());
  for (int seed = 1; seed <= seeds; ++seed) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      runs[i].push_back(run(problem, contenders[i], seed, limit, region));
    }
  }
  std::printf("%s\n", name.c_str());
  for (std::size_t i = 0; i < contenders.size(); ++i) print(contenders[i], runs[i], runs[0]);
  std::fflush(stdout);
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) {
  using namespace vandplan;
  const std::vector<std::string> words(argv + 1, argv + argc);
  const auto dashes = std::ranges::find(words, "--");
  if (dashes - words.begin() < 4) {
    std::fprintf(stderr,
                 "usage: trees_bench SEEDS LIMIT bounds|scene PLANNER[,KEY=VALUE...]... -- "
                 "SCENARIO.yaml...\n");
    return 2;
  }
  Limit limit;
  if (words[1].back() == 's') {
    limit.seconds = std::atof(words[1].c_str());
  } else {
    limit.iterations = std::atoll(words[1].c_str());
  }
  std::vector<Contender> contenders;
  for (auto word = words.begin() + 3; word != dashes; ++word)
    contenders.push_back(contender(*word));
  for (auto word = dashes + 1; word != words.end(); ++word) {
    const auto [file, problems] = read_problems(*word);
    // Of a row the goal that counts 200 m; otherwise the only one.
    const auto goal = std::ranges::find(file.row, 200.0, &RowGoal::distance);
    const auto number = goal == file.row.end() ? 0 : goal - file.row.begin();
    compare(file.scenario.name, problems[static_cast<std::size_t>(number)],
            std::atoi(words[0].c_str()), limit, words[2], contenders);
  }
}
