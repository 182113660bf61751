// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan matrix: what does driving cost from many starts to many goals?
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "commands.h"
#include "interrupt.h"
#include "option_flags.h"
#include "table_site.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/site_table.h"
#include "wording.h"

namespace vandplan::app {
namespace {

struct MatrixArguments {
  std::string scenario, starts, goals, output;
  std::optional<std::string> site;
  std::vector<TypedOption> options;
  std::optional<std::int64_t> iterations;  // of each plan; none: costs are those of ways
  int jobs = 0;                            // starts at once; 0: one per processor
  bool json = false;
};

/// Starts and goals by the lines of their files.
struct Ends {
  Poses starts, goals;
};

/// Rows "start,goal,cost,lower_bound", numbered as in the files from 0. A pair without a way or
/// plan has no cost. Its bound is "inf" if it is proven that there is no path.
std::string csv_of(const std::vector<SiteCost>& costs, std::size_t goals) {
  std::string text = "start,goal,cost,lower_bound\n";
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const std::string cost = std::isinf(costs[i].cost) ? "" : fmt::format("{}", costs[i].cost);
    text += fmt::format("{},{},{},{}\n", i / goals, i % goals, cost, costs[i].lower_bound);
  }
  return text;
}

/// Options of the table, and of the plans if there are any.
PlanOptions options_of(const MatrixArguments& arguments, const ScenarioProblems& read) {
  if (!arguments.iterations) return site_options(read, arguments.options);
  for (const TypedOption& given : arguments.options) {
    if (given.option != "max_iterations") continue;
    throw InputError(given.typed, "is given twice, expected --max-iterations alone");
  }
  const Planner& planner = default_planner();
  PlanOptions options = options_for(planner, read.file.options, arguments.options);
  options.budget.max_iterations = arguments.iterations;
  return complete(planner, options, read.problems.front().vehicle());
}

/// The error, but if it names a start or a goal, it names the pose's line.
InputError by_line(const InputError& error, const MatrixArguments& arguments, const Ends& ends) {
  const InputError of_goal = named_by_line(error, "goals", arguments.goals, ends.goals);
  return named_by_line(of_goal, "starts", arguments.starts, ends.starts);
}

/// The table that is given, or else made for these ends. Throws InputError if it lacks a goal. A
/// pose that is wrong is named by its line.
SiteTable table_of(const MatrixArguments& arguments, const Problem& problem, const Ends& ends,
                   const PlanOptions& options, const std::stop_token& stop) {
  std::optional<SiteTable> table;
  try {
    if (arguments.site) return read_site_table(*arguments.site).with_goals(ends.goals.poses);
    table = make_site_table(problem, ends.goals.poses, options,
                            {.threads = threads_of(arguments.jobs),
                             .stop = stop,
                             .starts = ends.starts.poses,
                             .allows_blocked_goals = true});
  } catch (const InputError& error) {
    if (error.where() != "cell") throw by_line(error, arguments, ends);
    throw InputError(arguments.starts,
                     "starts, goals and obstacles span too much, expected --site with a table of "
                     "larger cells");
  }
  if (!table) throw InputError("matrix", "was stopped, nothing is written");
  return *std::move(table);
}

/// The costs. What is wrong with the table names its file, a start that is wrong its line.
std::vector<SiteCost> costs_of(const MatrixArguments& arguments, const Problem& problem,
                               const Ends& ends, PlanOptions options, const SiteTable& table,
                               const std::stop_token& stop) {
  const int threads = threads_of(arguments.jobs);
  const std::vector<Pose>& starts = ends.starts.poses;
  try {
    if (!arguments.iterations) return site_matrix(table, problem, starts, options, threads);
    options.budget.stop = stop;
    options.site = std::make_shared<const SiteTable>(table);
    return plan_matrix(problem, starts, options, threads);
  } catch (const InputError& error) {
    if (error.where() == "site" && arguments.site) {
      throw InputError(*arguments.site, error.problem());
    }
    throw by_line(error, arguments, ends);
  }
}

// ---- why is an entry empty? ----

const char* reason_of(SiteOutcome outcome) {
  switch (outcome) {
    case SiteOutcome::start_in_collision:
      return "the start is not free (of obstacles, or by zones)";
    case SiteOutcome::goal_in_collision:
      return "the goal is not free (of obstacles, or by zones)";
    case SiteOutcome::outside:
      return "the start is outside of the table";
    case SiteOutcome::no_path:
      return "proven: there is no path";
    case SiteOutcome::no_plan:
      return "no plan within --max-iterations";
    default:
      return "the table knows no free way";
  }
}

/// A line for each goal that is not free: "goals.csv:3: goal 1 has no costs: the goal is not free".
/// Goals are numbered as in the output.
std::vector<std::string> blocked_goals(const MatrixArguments& arguments, const Ends& ends,
                                       const std::vector<SiteCost>& costs) {
  std::vector<std::string> lines;
  const std::size_t goals = ends.goals.poses.size();
  for (std::size_t j = 0; j < goals; ++j) {
    for (std::size_t i = j; i < costs.size(); i += goals) {
      if (costs[i].outcome != SiteOutcome::goal_in_collision) continue;
      lines.push_back(fmt::format("{}: goal {} has no costs: {}",
                                  line_of_file(arguments.goals, ends.goals.lines[j]), j,
                                  reason_of(costs[i].outcome)));
      break;
    }
  }
  return lines;
}

/// A line for each start and reason: "starts.csv:3: start 1 has no cost to goals 0, 2: the start is
/// not free". Starts and goals are numbered as in the output. Goals that are not free are left out.
std::vector<std::string> empty_entries(const MatrixArguments& arguments, const Ends& ends,
                                       const std::vector<SiteCost>& costs) {
  std::vector<std::string> lines = blocked_goals(arguments, ends, costs);
  const std::size_t goals = ends.goals.poses.size();
  for (std::size_t i = 0; i < ends.starts.poses.size(); ++i) {
    std::map<SiteOutcome, std::vector<std::size_t>> empty;
    for (std::size_t j = 0; j < goals; ++j) {
      const SiteCost& cost = costs[i * goals + j];
      if (std::isinf(cost.cost)) empty[cost.outcome].push_back(j);
    }
    empty.erase(SiteOutcome::goal_in_collision);
    for (const auto& [outcome, to] : empty) {
      const std::string which =
          to.size() == goals
              ? "any goal"
              : fmt::format("goal{} {}", to.size() == 1 ? "" : "s", fmt::join(to, ", "));
      lines.push_back(fmt::format("{}: start {} has no cost to {}: {}",
                                  line_of_file(arguments.starts, ends.starts.lines[i]), i, which,
                                  reason_of(outcome)));
    }
  }
  return lines;
}

/// Warns of empty entries, of so many rows that the warnings can be read.
void warn_of_empty(const MatrixArguments& arguments, const Ends& ends,
                   const std::vector<SiteCost>& costs) {
  constexpr std::size_t most = 20;
  std::vector<std::string> lines = empty_entries(arguments, ends, costs);
  if (lines.size() > most) {
    const std::size_t more = lines.size() - most;
    lines.resize(most);
    lines.push_back(
        fmt::format("{}: {} more such lines; --json counts the reasons", arguments.starts, more));
  }
  warn(lines);
}

nlohmann::ordered_json counts_of_empty(const std::vector<SiteCost>& costs) {
  auto counts = nlohmann::ordered_json::object();
  for (const SiteCost& cost : costs) {
    if (!std::isinf(cost.cost)) continue;
    auto& count = counts[std::string(name_of(cost.outcome))];
    count = count.is_null() ? 1 : count.get<std::size_t>() + 1;
  }
  return counts;
}

/// The cheapest goal of each start that has a cost.
nlohmann::ordered_json cheapest_of(const std::vector<SiteCost>& costs, std::size_t goals) {
  auto rows = nlohmann::ordered_json::array();
  const std::vector<std::optional<CheapestGoal>> cheapest = cheapest_goals(costs, goals);
  for (std::size_t i = 0; i < cheapest.size(); ++i) {
    if (!cheapest[i]) continue;
    rows.push_back({{"start", i},
                    {"goal", cheapest[i]->goal},
                    {"cost", cheapest[i]->cost},
                    {"lower_bound", cheapest[i]->lower_bound},
                    {"proven", cheapest[i]->is_proven}});
  }
  return rows;
}

int make(const MatrixArguments& arguments) {
  expect_writable(arguments.output);
  const std::stop_token stop = stop_on_signal();
  const ScenarioProblems read = read_problems(arguments.scenario);
  warn(read.file.warnings);
  const Problem& problem = read.problems.front();
  if (problem.vehicle().trailer && !arguments.iterations) {
    throw InputError(arguments.scenario,
                     "has a trailer, and ways of a table are of the tractor alone: expected "
                     "--max-iterations, for costs of plans");
  }
  const PlanOptions options = options_of(arguments, read);
  const Ends ends{poses_in(arguments.starts), poses_in(arguments.goals)};
  const SiteTable table = table_of(arguments, problem, ends, options, stop);
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<SiteCost> costs = costs_of(arguments, problem, ends, options, table, stop);
  if (stop.stop_requested()) throw InputError("matrix", "was stopped, nothing is written");
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  write_file(arguments.output, csv_of(costs, ends.goals.poses.size()));
  warn_of_empty(arguments, ends, costs);
  if (arguments.output == "-") return exit_status::done;
  const auto found = std::count_if(costs.begin(), costs.end(),
                                   [](const SiteCost& cost) { return !std::isinf(cost.cost); });
  if (arguments.json) {
    print({{"output", arguments.output},
           {"pairs", costs.size()},
           {"with_way", found},
           {"without", counts_of_empty(costs)},
           {"cheapest", cheapest_of(costs, ends.goals.poses.size())},
           {"time", time.count()}});
  } else {
    fmt::print("{}: {} pairs, {} with a way, in {:.3f} s\n", printable(arguments.output),
               costs.size(), found, time.count());
  }
  return exit_status::done;
}

}  // namespace

void add_matrix(CLI::App& vandplan, int& status) {
  CLI::App* const command =
      vandplan.add_subcommand("matrix", "Costs of driving from many starts to many goals.");
  const auto arguments = std::make_shared<MatrixArguments>();
  add_scenario(*command, arguments->scenario);
  const auto add = [&](const char* flag, std::string& file, const char* about) {
    command->add_option(flag, file, about)->type_name("FILE")->required();
  };
  add("--starts", arguments->starts, "Starts (CSV: x, y, heading)");
  add("--goals", arguments->goals, "Goals (CSV: x, y, heading)");
  command
      ->add_option("--site", arguments->site,
                   "Table that has these goals, see `vandplan table site`; default: one is made")
      ->type_name("FILE");
  add_site_settings(*command, arguments->options);
  command
      ->add_option(
          "--max-iterations", arguments->iterations,
          "Costs of plans along the table's ways, N iterations each; needed with a trailer")
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000}).description(""));
  add_jobs(*command, arguments->jobs, "Starts at once; 0: one per processor; up to 256");
  add("-o,--output", arguments->output,
      "Costs and lower bounds (CSV); warnings say why some are empty");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments, &status] { status = make(*arguments); });
}

}  // namespace vandplan::app
