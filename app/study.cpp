// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan study: what did the thesis measure, and what comes out today?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/escape.h"
#include "commands.h"
#include "gnuplot.h"
#include "option_flags.h"
#include "standard_streams.h"
#include "study_summary.h"
#include "table_source.h"
#include "tables/rig_table.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/steering.h"
#include "vandplan/tables.h"
#include "wording.h"

namespace vandplan::app {
namespace {

using Json = nlohmann::ordered_json;

/// Arguments that every study has.
struct StudyArguments {
  std::string folder = "out/studies";
  bool json = false;
};

/// Writes the files of a study and prints its summary.
template <class Study>
void report(const Study& study, const StudyArguments& arguments) {
  const StudyFiles files = files_of(study);
  expect_writable_folder(arguments.folder, files);
  const bool has_pictures = write_study(arguments.folder, files);
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) { names.push_back(arguments.folder + "/" + name); };
  for (const TextFile& file : files.data) add(file.name);
  add(files.script.name);
  if (has_pictures) std::for_each(files.pictures.begin(), files.pictures.end(), add);
  if (arguments.json) {
    Json json = json_of(study);
    json["files"] = names;
    print(json);
  } else {
    fmt::print("{}written: {}\n", summary_of(study),
               printable(fmt::format("{}", fmt::join(names, " "))));
  }
  if (has_pictures) return;
  say(
      fmt::format("vandplan: no pictures, because gnuplot is not installed (Debian: apt install "
                  "gnuplot-nox); once it is: cd {} && gnuplot {}\n",
                  base::shell_file(arguments.folder), files.script.name));
}

// ---- options ----

void check_metres(const char* flag, double value) {
  if (value >= 1e-3 && value <= 1e6) return;
  throw InputError(flag, fmt::format("is {}, expected 0.001 to 1000000 m", value));
}

/// Adds options to a command. The present value of each variable is the default.
class Options {
 public:
  explicit Options(CLI::App& command) : command_(command) {}

  void metres(const char* flag, double& value, const char* help) {
    const auto set = [flag, &value](const double& given) {
      check_metres(flag, given);
      value = given;
    };
    command_.add_option_function<double>(flag, set, help)
        ->type_name("M")
        ->default_str(fmt::format("{}", value))
        ->take_last();
  }

  void pairs(std::int64_t& value, const char* help) {
    command_.add_option("--pairs", value, help)
        ->type_name("N")
        ->check(CLI::Range(std::int64_t{1}, std::int64_t{10'000'000}).description(""))
        ->capture_default_str()
        ->take_last();
  }

  void iterations(std::int64_t& value) {
    command_.add_option("--iterations", value, "Iterations per run; 1 to 1000000")
        ->type_name("N")
        ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000}).description(""))
        ->capture_default_str()
        ->take_last();
  }

  void seed(std::uint64_t& value) { add_seed(command_, value, "Random seed")->take_last(); }

  void output(StudyArguments& arguments) {
    command_.add_option("-o,--output", arguments.folder, "Output folder")
        ->type_name("DIR")
        ->capture_default_str()
        ->take_last();
    command_.add_flag("--json", arguments.json, "Print JSON");
  }

 private:
  CLI::App& command_;
};

/// Adds a study as the command `name`. `declare` adds the flags of its options, a plain struct, and
/// `study` runs with these options.
template <class OptionsOfStudy, class Declare, class Run>
void add_study_of(CLI::App& studies, const char* name, const char* summary, Declare declare,
                  Run study) {
  CLI::App* const command = studies.add_subcommand(name, summary);
  const auto options = std::make_shared<OptionsOfStudy>();
  const auto arguments = std::make_shared<StudyArguments>();
  Options declared(*command);
  declare(declared, *options);
  declared.output(*arguments);
  command->callback([options, arguments, study] { report(study(*options), *arguments); });
}

// ---- accuracy ----

struct AccuracyArguments {
  AccuracyOptions options;
  std::vector<std::string> tables = {"hlut-1", "hlut-3"};
};

NamedEstimate estimate_of(const std::string& name, double radius) {
  const TableSource source = table_source(name);
  const HeuristicTable table = table_from_bytes(source.bytes, source.name);
  return {fmt::format("{} ({})", source.name, heading_step_text(table.options())),
          [table, radius](const State& node, const State& sample) {
            return table.distance(node.pose, sample.pose, radius);
          }};
}

double euclid(const State& node, const State& sample) {
  return std::hypot(node.pose.x - sample.pose.x, node.pose.y - sample.pose.y);
}

AccuracyStudy study_of(const AccuracyArguments& arguments) {
  const double radius = arguments.options.turning_radius;
  std::vector<NamedEstimate> estimates = {{"Euclid", euclid}};
  for (const std::string& table : arguments.tables) {
    estimates.push_back(estimate_of(table, radius));
  }
  // Not drawn (false): too near to the exact length to be seen beside other estimates.
  estimates.push_back({"lower bound",
                       [radius](const State& node, const State& sample) {
                         return length_bounds(node.pose, sample.pose, radius).low;
                       },
                       false});
  return study_accuracy(arguments.options, estimates);
}

// ---- trailer-accuracy ----

struct TrailerArguments {
  AccuracyOptions options{.pairs = 100'000, .reach = 30.0};
  std::string vehicle = "tractor-semitrailer";
};

AccuracyStudy study_of_trailer(const TrailerArguments& arguments) {
  AccuracyOptions options = arguments.options;
  options.rig = vehicle_named(arguments.vehicle);
  if (!options.rig->trailer) {
    throw InputError("--vehicle", arguments.vehicle + " has no trailer, expected one that has");
  }
  const double radius = options.turning_radius = options.rig->min_turning_radius;
  const RigTable table(*options.rig, {.reach = options.reach});
  return study_accuracy(options,
                        {{"Euclid", euclid},
                         estimate_of("hlut-4", radius),
                         {"Reeds-Shepp of the tractor",
                          [radius](const State& node, const State& sample) {
                            return reeds_shepp_length(node.pose, sample.pose, radius);
                          }},
                         {"table of the rig", [&table](const State& node, const State& sample) {
                            return table.distance(node, sample);
                          }}});
}

void add_trailer_accuracy(CLI::App& studies) {
  CLI::App* const command = studies.add_subcommand(
      "trailer-accuracy", "How accurate are estimates of lengths with a trailer?");
  const auto study = std::make_shared<TrailerArguments>();
  const auto arguments = std::make_shared<StudyArguments>();
  Options options(*command);
  options.pairs(study->options.pairs, "Random pairs; 1 to 10000000");
  options.metres("--reach", study->options.reach, "Largest |x| and |y| [m]");
  command->add_option("--vehicle", study->vehicle, "Catalogue vehicle with a trailer")
      ->type_name("NAME")
      ->capture_default_str();
  options.seed(study->options.seed);
  options.output(*arguments);
  command->callback([study, arguments] { report(study_of_trailer(*study), *arguments); });
}

struct SitesArguments {
  SitesOptions options;
  std::vector<std::string> files;
};

SitesStudy study_of(const SitesArguments& arguments) {
  SitesOptions options = arguments.options;
  for (const std::string& file : arguments.files) {
    const ScenarioFile read = read_scenario_file(file);
    warn(read.warnings);
    options.sites.push_back({read.scenario.name, read.scenario});
  }
  return study_sites(options);
}

void add_sites(CLI::App& studies) {
  CLI::App* const command = studies.add_subcommand(
      "sites", "What do tables of the site bring the searches, or networks that learned them?");
  const auto study = std::make_shared<SitesArguments>();
  const auto arguments = std::make_shared<StudyArguments>();
  command
      ->add_option("SCENARIO", study->files,
                   "Sites (YAML); default: five of the thesis and examples/depot.yaml")
      ->type_name("FILE");
  command->add_option("--starts", study->options.starts, "Starts on each site; 1 to 1000")
      ->type_name("N")
      ->check(CLI::Range(1, 1000).description(""))
      ->capture_default_str()
      ->take_last();
  command->add_option("--time", study->options.time_limit, "Processor time of each run [s]")
      ->type_name("S")
      ->check(CLI::Range(1e-4, 1e3).description(""))
      ->capture_default_str()
      ->take_last();
  command->add_option("--training", study->options.training, "Steps of training of each network")
      ->type_name("N")
      ->check(CLI::Range(1, 10'000'000).description(""))
      ->capture_default_str()
      ->take_last();
  Options options(*command);
  options.seed(study->options.seed);
  options.output(*arguments);
  command->callback([study, arguments] { report(study_of(*study), *arguments); });
}

void add_accuracy(CLI::App& studies) {
  CLI::App* const command = studies.add_subcommand(
      "accuracy", "How accurate are estimates of lengths? (Algorithm 4, Fig. 15)");
  const auto study = std::make_shared<AccuracyArguments>();
  const auto arguments = std::make_shared<StudyArguments>();
  Options options(*command);
  options.pairs(study->options.pairs, "Random pairs; 1 to 10000000");
  options.metres("--reach", study->options.reach, "Largest |x| and |y| [m]");
  options.metres("--radius", study->options.turning_radius, "Turning radius [m]");
  command->add_option("--table", study->tables, "hlut-1 to hlut-4 or files, comma-separated")
      ->delimiter(',')
      ->type_name("LIST")
      ->capture_default_str();
  options.seed(study->options.seed);
  options.output(*arguments);
  command->callback([study, arguments] { report(study_of(*study), *arguments); });
}

}  // namespace

void add_study(CLI::App& vandplan, int&) {
  CLI::App* const studies =
      vandplan.add_subcommand("study", "Repeat a study of the thesis (CSV, PNG, SVG).");
  studies->require_subcommand(0, 1);
  studies->callback([studies] {
    if (!studies->get_subcommands().empty()) return;
    throw InputError(
        "study",
        "a study is missing, expected range, accuracy, trailer-accuracy, growth, symmetry, "
        "steering, searches or sites");
  });
  add_study_of<RangeOptions>(
      *studies, "range",
      "How much longer than straight lines are shortest paths? (Algorithm 3, Fig. 14)",
      [](Options& declare, RangeOptions& options) {
        declare.pairs(options.pairs, "Pairs drawn as dots; 1 to 10000000");
        declare.metres("--reach", options.reach, "Largest distance of a pair [m]");
        declare.metres("--radius", options.turning_radius, "Turning radius [m]");
        declare.seed(options.seed);
      },
      study_range);
  add_accuracy(*studies);
  add_trailer_accuracy(*studies);
  add_study_of<GrowthOptions>(
      *studies, "growth", "How does a random tree spread over open ground? (Algorithm 1, Fig. 5)",
      [](Options& declare, GrowthOptions& options) {
        declare.metres("--reach", options.reach, "Largest |x| and |y| [m]");
        declare.metres("--step", options.step, "Length of an edge [m]");
        declare.metres("--radius", options.turning_radius, "Turning radius [m]");
        declare.seed(options.seed);
      },
      study_growth);
  add_study_of<SymmetryOptions>(
      *studies, "symmetry", "Which pairs of poses are equally far apart? (Algorithm 5, Fig. 6)",
      [](Options& declare, SymmetryOptions& options) {
        declare.pairs(options.pairs, "Random pairs; 1 to 10000000");
        declare.metres("--radius", options.turning_radius, "Turning radius [m]");
        declare.seed(options.seed);
      },
      study_symmetry);
  add_study_of<SteeringOptions>(
      *studies, "steering", "What do shortest paths look like? (Fig. 3, 4)",
      [](Options& declare, SteeringOptions& options) {
        declare.metres("--radius", options.turning_radius, "Turning radius [m]");
      },
      study_steering);
  add_study_of<SearchesOptions>(
      *studies, "searches", "What do planners look at, and in which order?",
      [](Options& declare, SearchesOptions& options) {
        declare.iterations(options.iterations);
        declare.seed(options.seed);
      },
      study_searches);
  add_sites(*studies);
}

}  // namespace vandplan::app
