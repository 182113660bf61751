// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan evaluate: which planner is best at what?
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands.h"
#include "evaluation/compare.h"
#include "evaluation/exports.h"
#include "interrupt.h"
#include "live.h"
#include "option_flags.h"
#include "progress_bar.h"
#include "standard_streams.h"
#include "table_source.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "wording.h"

namespace vandplan::app {
namespace {

namespace fs = std::filesystem;
using namespace evaluation;

constexpr const char* default_output = "out/evaluation";
constexpr const char* default_time = "0.1";  // limit of the thesis [s]
// Repeats of the group thesis-goal. The thesis' claims are judged under its printed methods, so the
// others get fewer runs. Then a default campaign takes at most 6 min 20 s on two cores, even if
// every run takes all of its time.
const RepeatCap default_cap{"thesis-goal", 5, 1};

struct EvaluateArguments {
  std::vector<std::string> scenarios = {"scenarios/thesis"};
  std::vector<std::string> planners = {"thesis", "thesis-goal", default_planner().name};
  std::string region = "both";
  std::vector<TypedOption> options;
  std::optional<std::string> table;
  std::optional<int> repeats;
  std::optional<int> repeats_per_goal;
  std::uint64_t seed = 1;
  int jobs = 1;
  std::optional<Shard> shard;
  std::optional<std::string> output;
  bool resume = false;
  bool report_only = false;
  bool json = false;
  std::vector<std::string> merged;
  std::vector<std::string> exports;
  LiveArguments live;
};

// Folder of store and report. Each shard has a folder of its own.
std::string output_of(const EvaluateArguments& arguments) {
  if (arguments.output) return *arguments.output;
  if (!arguments.shard) return default_output;
  const auto [number, of] = *arguments.shard;
  return fmt::format("{}/shard-{}-of-{}", default_output, number, of);
}

// Scenario files at a path: the YAML files of a folder in the order of their names, or the file
// itself. Maps beside the scenarios are skipped.
std::vector<std::string> scenario_files(const std::string& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> files, maps;
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
    if (entry.path().extension() == ".yaml")
      (is_map(entry.path()) ? maps : files).push_back(entry.path().string());
  }
  std::ranges::sort(files);
  std::ranges::sort(maps);
  if (files.empty()) throw InputError(path, "holds no scenario (*.yaml)");
  for (const std::string& map : maps)
    say(fmt::format("{}: skipped, a map, not a scenario\n", printable(map)));
  return files;
}

std::vector<Planner> chosen_planners(const std::vector<std::string>& words) {
  std::vector<Planner> found;
  for (const std::string& word : words) {
    for (const Planner& planner : planners_called(word)) {
      if (std::ranges::find(found, planner.name, &Planner::name) == found.end())
        found.push_back(planner);
    }
  }
  return found;
}

std::vector<Region> regions_of(const std::string& name) {
  if (name == "both") return {Region::bounds, Region::scene};
  if (name == "bounds") return {Region::bounds};
  if (name == "scene") return {Region::scene};
  throw InputError("--region", "\"" + name + "\" is not bounds, scene or both");
}

std::vector<Setting> settings_of(const EvaluateArguments& arguments) {
  std::vector<Setting> settings;
  bool is_limited = false;
  for (const TypedOption& typed : arguments.options) {
    settings.push_back({typed.option, typed.value});
    is_limited |= typed.option == "time_limit" || typed.option == "max_iterations";
  }
  if (!is_limited) settings.push_back({"time_limit", default_time});
  return settings;
}

// Sets the repeats of a campaign. Repeats that the user gives hold for every planner, without caps.
void set_repeats(const EvaluateArguments& arguments, Campaign& campaign) {
  const Campaign standard;
  campaign.repeats = arguments.repeats.value_or(standard.repeats);
  campaign.repeats_per_goal = arguments.repeats_per_goal.value_or(
      std::min(standard.repeats_per_goal, std::max(1, campaign.repeats)));
  if (!arguments.repeats && !arguments.repeats_per_goal) campaign.caps = {default_cap};
}

Campaign campaign_of(const EvaluateArguments& arguments) {
  Campaign campaign{.planners = chosen_planners(arguments.planners),
                    .regions = regions_of(arguments.region),
                    .seed = arguments.seed,
                    .profile = true,
                    .settings = settings_of(arguments),
                    .table = table_of_user(arguments.table),
                    .shard = arguments.shard};
  set_repeats(arguments, campaign);
  for (const std::string& path : arguments.scenarios) {
    for (const std::string& file : scenario_files(path))
      campaign.scenarios.push_back({read_scenario_file(file), file});
  }
  for (const auto& [scenario, file] : campaign.scenarios) {
    if (!scenario.options.empty()) {
      warn({file + ": options: ignored, all scenarios are compared with the same options (--set)"});
    }
  }
  return campaign;
}

// Throws InputError if the store exists already and --resume is not given.
void expect_new_store(const EvaluateArguments& arguments) {
  const std::string file = store_file(output_of(arguments));
  if (fs::exists(file) && !arguments.resume)
    throw InputError(file, "exists already, expected --resume or another --output");
}

void write_exports(const EvaluateArguments& arguments) {
  if (arguments.exports.empty()) return;
  const std::string folder = output_of(arguments);
  Store store = store_in(folder);
  for (const std::string& format : arguments.exports) {
    if (format == "csv") write_file(folder + "/runs.csv", runs_to_csv(store));
    if (format == "json") write_file(folder + "/runs.json", runs_to_json(store));
    if (format == "ompl") write_ompl_database(store, folder + "/plannerarena.db");
  }
}

void show(const EvaluateArguments& arguments, const Comparison& comparison) {
  const auto& [missing, headline, json, store, page, text, gallery] = comparison;
  if (arguments.json) {
    auto object = nlohmann::ordered_json::parse(json);
    object["missing"] = missing;
    object["output"] = {{"store", store}, {"page", page}, {"text", text}, {"gallery", gallery}};
    print(object);
    return;
  }
  fmt::print("{}\nMore: {} (in a browser), {}, {}\n", headline, printable(page), printable(text),
             printable(gallery));
  if (missing > 0) fmt::print("{} runs are missing; --resume runs them.\n", missing);
}

// Runs nothing: adds the runs of other stores or joins shards, and writes the report.
Comparison report_again(const EvaluateArguments& arguments) {
  const std::string folder = output_of(arguments);
  if (std::ranges::any_of(arguments.merged, is_shard))
    return merge_shards(arguments.merged, folder);
  Store store = store_in(folder);
  for (const std::string& file : arguments.merged) {
    Store other = Store::open(file);
    say(fmt::format("{}: {} new runs\n", printable(file), store.merge(other)));
  }
  return write_report(make_report(store), folder);
}

Comparison run_and_report(const EvaluateArguments& arguments) {
  const Campaign campaign = campaign_of(arguments);
  say(explain_runs(campaign));
  expect_new_store(arguments);
  ProgressBar bar;
  const auto report = [&](const Progress& now) { bar.show(now); };
  return compare(campaign, output_of(arguments),
                 {.jobs = arguments.jobs, .stop = stop_on_signal(), .report = report});
}

int run_part(const EvaluateArguments& arguments) {
  const Campaign campaign = campaign_of(arguments);
  const std::string folder = output_of(arguments), store = store_file(folder);
  say(explain_runs(campaign));
  expect_new_store(arguments);
  Progress progress;
  {
    ProgressBar bar;
    const auto report = [&](const Progress& now) { bar.show(now); };
    progress = run_shard(campaign, folder,
                         {.jobs = arguments.jobs, .stop = stop_on_signal(), .report = report});
  }
  const auto [number, of] = *arguments.shard;
  const int missing = progress.total - progress.kept - progress.done;
  if (arguments.json) {
    print(nlohmann::ordered_json{{"shard", number},
                                 {"of", of},
                                 {"runs", progress.total},
                                 {"missing", missing},
                                 {"output", {{"store", store}}}});
  } else {
    fmt::print("Shard {}/{}: {} of {} runs in {}; {}\n", number, of, progress.total - missing,
               progress.total, printable(store),
               missing > 0 ? "--resume runs the rest." : "--merge joins all shards.");
  }
  return missing == 0 ? exit_status::done : exit_status::failed;
}

/// Drives every scenario `repeats` times, with a seed of its own each time, for --replan.
int drive_all(const EvaluateArguments& arguments) {
  std::vector<std::string> files;
  for (const std::string& path : arguments.scenarios) {
    for (std::string& file : scenario_files(path)) files.push_back(std::move(file));
  }
  LiveArguments live = arguments.live;
  live.options = arguments.options;
  LiveRuns runs{.runs = arguments.repeats.value_or(1), .json = arguments.json};
  if (runs.runs < 1) throw InputError("--repeats", "is less than 1");
  runs.drive.seed = arguments.seed;
  return compare_live(files, live, runs);
}

int run(const EvaluateArguments& arguments) {
  if (arguments.live.period) return drive_all(arguments);
  if (arguments.shard) return run_part(arguments);
  const bool only_reports = arguments.report_only || !arguments.merged.empty();
  const Comparison comparison = only_reports ? report_again(arguments) : run_and_report(arguments);
  write_exports(arguments);
  show(arguments, comparison);
  return comparison.missing == 0 ? exit_status::done : exit_status::failed;
}

// ---- the command line ----

void add_options_of_runs(CLI::App& command, EvaluateArguments& arguments) {
  const auto add = [&](const char* flag, const char* option, const char* type, const char* help) {
    const auto keep = [&arguments, flag, option](const std::string& value) {
      arguments.options.push_back({flag, option, value});
    };
    command.add_option_function<std::string>(flag, keep, help)->type_name(type);
  };
  add("--time", "time_limit", "S", "Processor time per run [s]; 0.1 without --max-iterations");
  add("--max-iterations", "max_iterations", "N", "Iterations per run (repeats bit for bit)");
  add("--max-nodes", "max_nodes", "N", "Largest search tree [nodes]; 5000");
  const auto set = [&arguments](const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) arguments.options.push_back(typed_setting(setting));
  };
  command
      .add_option_function<std::vector<std::string>>(
          "--set", set, "Set an option by its key, for planners that have it")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  add_table_flag(command, arguments.table);
}

void add_options_of_output(CLI::App& command, EvaluateArguments& arguments) {
  command
      .add_option("--output", arguments.output,
                  fmt::format("Folder of store and report; {}, for a shard its\n"
                              "subfolder shard-I-of-N",
                              default_output))
      ->type_name("DIR")
      ->take_last();
  command.add_flag("--resume", arguments.resume, "Do only the runs that the store lacks");
  command.add_flag("--report-only", arguments.report_only,
                   "Run nothing, report the last comparison of the store");
  command
      .add_option("--merge", arguments.merged,
                  "Run nothing, add the runs of other stores (runs.sqlite), or join all\n"
                  "shards of a campaign (stores or folders) in a new store")
      ->type_name("STORE...");
  command
      .add_option("--export", arguments.exports,
                  "Also write all runs: runs.csv, runs.json, plannerarena.db (OMPL)")
      ->delimiter(',')
      ->check(CLI::IsMember({"csv", "json", "ompl"}).description(""))
      ->type_name("csv|json|ompl");
  const auto set_shard = [&arguments](const std::string& text) {
    arguments.shard = shard_in(text);
  };
  command
      .add_option_function<std::string>(
          "--shard", set_shard, "Do only part I of N, in a store of its own, without a report")
      ->type_name("I/N")
      ->excludes("--merge", "--report-only", "--export");
  command.add_flag("--json", arguments.json, "Print JSON");
}

void add_options_of_campaign(CLI::App& command, EvaluateArguments& arguments) {
  command.add_option("--scenarios", arguments.scenarios, "Scenario files or folders")
      ->type_name("PATH")
      ->capture_default_str();
  command
      .add_option("--planners", arguments.planners,
                  "Planners or groups, comma-separated. Groups: thesis (its ten methods,\n"
                  "goal only sampled), thesis-goal (goal tried from every node), family\n"
                  "(other searches, with each estimate), all")
      ->delimiter(',')
      ->type_name("LIST")
      ->capture_default_str();
  command
      .add_option("--repeats", arguments.repeats,
                  fmt::format("Runs per planner, region and scenario; {}, but {} for {}",
                              Campaign{}.repeats, default_cap.repeats, default_cap.group))
      ->type_name("N")
      ->take_last();
  command
      .add_option("--goal-repeats", arguments.repeats_per_goal,
                  fmt::format("Runs per planner, region and goal of a row; {}",
                              Campaign{}.repeats_per_goal))
      ->type_name("N")
      ->take_last();
  add_options_of_runs(command, arguments);
  command.add_option("--region", arguments.region, "Sampling region: bounds, scene or both")
      ->type_name("R")
      ->take_last()
      ->capture_default_str();
  add_seed(command, arguments.seed, "Random seed, from which each run derives its own")
      ->take_last();
  command.add_option("--jobs", arguments.jobs, "Runs at once, one core each")
      ->type_name("N")
      ->take_last()
      ->capture_default_str();
}

}  // namespace

void add_evaluate(CLI::App& vandplan, int& status) {
  CLI::App* const command =
      vandplan.add_subcommand("evaluate", "Compare planners on scenarios and write a report.");
  command->footer(
      "Planners minimise the length, whatever scenarios ask for; --set style=driver changes that.\n"
      "With --replan simulated vehicles drive the scenarios and plan meanwhile. The table shows\n"
      "contacts and times; vs alone: time relative to a drive without moving obstacles; unsafe:\n"
      "plans that are not safe.");
  const auto arguments = std::make_shared<EvaluateArguments>();
  add_options_of_campaign(*command, *arguments);
  add_options_of_output(*command, *arguments);
  add_live_options(*command, arguments->live, false);
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace vandplan::app
