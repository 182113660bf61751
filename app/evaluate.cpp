// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan evaluate: which planner is best at what?
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands.h"
#include "evaluation/exports.h"
#include "evaluation/report.h"
#include "evaluation/runner.h"
#include "interrupt.h"
#include "progress_bar.h"
#include "vandplan/input_error.h"
#include "vandplan/io.h"

namespace vandplan {
namespace {

namespace fs = std::filesystem;

constexpr double default_time = 0.1;  // [s], the thesis'

struct EvaluateArguments {
  std::vector<std::string> scenarios = {"scenarios/thesis"};
  std::vector<std::string> planners = {"thesis", std::string(default_planner().name)};
  std::string region = "both";
  Campaign campaign{.profile = true};
  int jobs = 1;
  std::string output = "out/evaluation";
  bool resume = false;
  bool report_only = false;
  bool json = false;
  std::vector<std::string> merged;
  std::vector<std::string> exports;
};

// The YAML files of a folder in order of their names, or the file itself. Maps lie beside the
// scenarios that name them.
std::vector<std::string> scenario_files(const std::string& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> files, maps;
  for (const fs::directory_entry& entry : fs::directory_iterator(path))
    if (entry.path().extension() == ".yaml")
      (is_map(entry.path()) ? maps : files).push_back(entry.path().string());
  std::ranges::sort(files);
  std::ranges::sort(maps);
  if (files.empty()) throw InputError(path, "holds no scenario (*.yaml)");
  for (const std::string& map : maps)
    fmt::print(stderr, "{}: skipped, a map and no scenario\n", map);
  return files;
}

std::vector<PlannerInfo> planners_of(const std::vector<std::string>& names) {
  std::vector<PlannerInfo> found;
  for (const std::string& name : names) {
    std::vector<PlannerInfo> some;
    if (name == "thesis") {
      some = thesis_planners();
    } else if (name == "all") {
      some.assign(planners().begin(), planners().end());
    } else {
      some = {planner_named(name)};
    }
    for (const PlannerInfo& planner : some)
      if (std::ranges::find(found, planner.name, &PlannerInfo::name) == found.end())
        found.push_back(planner);
  }
  return found;
}

std::vector<Region> regions_of(const std::string& name) {
  if (name == "both") return {Region::bounds, Region::scene};
  PlanOptions options;
  set_option(options, "region", name);
  return {options.region};
}

Campaign campaign_of(const EvaluateArguments& arguments) {
  Campaign campaign = arguments.campaign;
  for (const std::string& path : arguments.scenarios)
    for (const std::string& file : scenario_files(path))
      campaign.scenarios.push_back({read_scenario(file), file});
  campaign.planners = planners_of(arguments.planners);
  campaign.regions = regions_of(arguments.region);
  if (!campaign.options.time_limit && !campaign.options.max_iterations)
    campaign.options.time_limit = default_time;
  return campaign;
}

// The result store in the output folder, made if it is not there.
Store open_store(const EvaluateArguments& arguments) {
  std::error_code error;
  fs::create_directories(arguments.output, error);
  if (error) throw InputError(arguments.output, "cannot be made a folder: " + error.message());
  const std::string file = arguments.output + "/runs.sqlite";
  if (!fs::exists(file)) return Store::create(file);
  if (!arguments.resume && !arguments.report_only && arguments.merged.empty())
    throw InputError(file, "exists already, expected --resume or another --output");
  return Store::open(file);
}

void announce(const Campaign& campaign, int jobs) {
  std::size_t goals = 0;
  for (const CampaignScenario& scenario : campaign.scenarios)
    goals += scenario.scenario.goals.size();
  fmt::print(stderr, "{} runs: {} scenarios ({} goals), {} planners, {} regions, {} at a time\n",
             runs_of(campaign).size(), campaign.scenarios.size(), goals, campaign.planners.size(),
             campaign.regions.size(), jobs);
}

// How many runs of the campaign are still missing.
int run_missing(const Campaign& campaign, Store& store, int jobs) {
  ProgressBar bar;
  const Progress progress = run_campaign(
      campaign, store, {.jobs = jobs, .stop = stop_on_signal(), .report = [&](const Progress& now) {
                          bar.show(now);
                        }});
  return progress.total - progress.kept - progress.done;
}

void merge(const std::vector<std::string>& files, Store& store) {
  for (const std::string& file : files) {
    Store other = Store::open(file);
    fmt::print(stderr, "{}: {} new runs\n", file, store.merge(other));
  }
}

void write_exports(const EvaluateArguments& arguments, Store& store) {
  for (const std::string& format : arguments.exports) {
    if (format == "csv") write_file(arguments.output + "/runs.csv", runs_to_csv(store));
    if (format == "json") write_file(arguments.output + "/runs.json", runs_to_json(store));
    if (format == "ompl") write_ompl_database(store, arguments.output + "/plannerarena.db");
  }
}

void write_report(const EvaluateArguments& arguments, const Report& report, int missing) {
  const std::string page = arguments.output + "/index.html", text = arguments.output + "/report.md",
                    picture = arguments.output + "/gallery.png";
  const std::string gallery = gallery_png(report);
  write_file(text, report_markdown(report));
  write_file(picture, gallery);
  write_file(page, report_html(report, gallery));
  if (arguments.json) {
    auto json = nlohmann::ordered_json::parse(headline_json(report));
    json["missing"] = missing;
    json["output"] = {{"store", arguments.output + "/runs.sqlite"},
                      {"page", page},
                      {"text", text},
                      {"gallery", picture}};
    print(json);
    return;
  }
  fmt::print("{}\nMore: {} (in a browser), {}, {}\n", headline_markdown(report), page, text,
             picture);
  if (missing > 0) fmt::print("{} runs are missing; --resume does them.\n", missing);
}

int run(const EvaluateArguments& arguments) {
  if (arguments.report_only || !arguments.merged.empty()) {
    Store store = open_store(arguments);
    merge(arguments.merged, store);
    write_exports(arguments, store);
    write_report(arguments, make_report(store), 0);
    return exit_status::done;
  }
  const Campaign campaign = campaign_of(arguments);
  announce(campaign, arguments.jobs);
  Store store = open_store(arguments);
  const int missing = run_missing(campaign, store, arguments.jobs);
  write_exports(arguments, store);
  write_report(arguments, make_report(store, campaign), missing);
  return missing == 0 ? exit_status::done : exit_status::failed;
}

// ---- the command line ----

void add_options_of_runs(CLI::App& command, EvaluateArguments& arguments) {
  PlanOptions& options = arguments.campaign.options;
  const auto add = [&](const char* flag, const char* option, const char* type, const char* help) {
    command
        .add_option_function<std::string>(
            flag,
            [&options, option](const std::string& value) { set_option(options, option, value); },
            help)
        ->type_name(type);
  };
  add("--time", "time_limit", "S", "Wall clock of a run [s]; 0.1 unless iterations are limited");
  add("--max-iterations", "max_iterations", "N", "Iterations of a run; reproduces bit for bit");
  add("--max-nodes", "max_nodes", "N", "Nodes of a search tree; 5000");
  const auto set = [&options](const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) {
      const std::size_t equals = setting.find('=');
      if (equals == std::string::npos)
        throw InputError("--set", "\"" + setting + "\" is not KEY=VALUE");
      set_option(options, setting.substr(0, equals), setting.substr(equals + 1));
    }
  };
  command.add_option_function<std::vector<std::string>>("--set", set, "Set any option by its key")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_options_of_output(CLI::App& command, EvaluateArguments& arguments) {
  command.add_option("--output", arguments.output, "Folder of the result store and the report")
      ->type_name("DIR")
      ->take_last()
      ->capture_default_str();
  command.add_flag("--resume", arguments.resume, "Do what a store that exists does not hold yet");
  command.add_flag("--report-only", arguments.report_only,
                   "Run nothing, tell of the store's last comparison");
  command
      .add_option("--merge", arguments.merged,
                  "Run nothing, add the runs of another store (runs.sqlite)")
      ->type_name("STORE")
      ->allow_extra_args(false);
  command
      .add_option("--export", arguments.exports,
                  "Write all runs of the store too: runs.csv, runs.json, plannerarena.db (OMPL)")
      ->delimiter(',')
      ->check(CLI::IsMember({"csv", "json", "ompl"}))
      ->type_name("csv|json|ompl");
  command.add_flag("--json", arguments.json, "Print one JSON object instead of a summary");
}

}  // namespace

void add_evaluate(CLI::App& vandplan, int& status) {
  CLI::App* const command = vandplan.add_subcommand(
      "evaluate", "Compare planners on scenarios: run, keep every run, report.");
  const auto arguments = std::make_shared<EvaluateArguments>();
  Campaign& campaign = arguments->campaign;
  command->add_option("--scenarios", arguments->scenarios, "Scenario files, or folders of them")
      ->type_name("PATH")
      ->capture_default_str();
  command
      ->add_option("--planners", arguments->planners,
                   "Names with commas between; thesis: its ten methods and four with exact lengths "
                   "or bounds of them; all")
      ->delimiter(',')
      ->type_name("LIST")
      ->capture_default_str();
  command->add_option("--repeats", campaign.repeats, "Runs of each planner, scenario and region")
      ->type_name("N")
      ->take_last()
      ->capture_default_str();
  command
      ->add_option("--goal-repeats", campaign.repeats_per_goal,
                   "The same for each goal in a row of goals")
      ->type_name("N")
      ->take_last()
      ->capture_default_str();
  add_options_of_runs(*command, *arguments);
  command->add_option("--region", arguments->region, "Where samples are drawn: bounds, scene, both")
      ->type_name("R")
      ->take_last()
      ->capture_default_str();
  command->add_option("--seed", campaign.seed, "Every run's seed is derived from it")
      ->type_name("N")
      ->take_last()
      ->capture_default_str();
  command->add_option("--jobs", arguments->jobs, "Runs at a time, each on one core")
      ->type_name("N")
      ->take_last()
      ->capture_default_str();
  add_options_of_output(*command, *arguments);
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace vandplan
