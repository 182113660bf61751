// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "live.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "commands.h"
#include "endings.h"
#include "evaluation/statistics.h"
#include "pictures.h"
#include "recordings.h"
#include "vandplan/draw.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/recording.h"
#include "vandplan/site_table.h"
#include "wording.h"

namespace vandplan::app {
namespace {

constexpr double live_confidence = 0.95;
constexpr int live_picture_width = 1200;  // pixels or points
constexpr const char* actions_flag = "--actions";

/// The error of a library option, naming the flag of the command line instead.
InputError renamed_live(const InputError& error) {
  constexpr std::pair<const char*, const char*> names[] = {{"period", "--replan"},
                                                           {"sensor_range", "--sensor-range"},
                                                           {"horizon", "--horizon"},
                                                           {"action_rate", "--rate"},
                                                           {"controller", "--controller"},
                                                           {"noise", "--noise"},
                                                           {"delay", "--delay"},
                                                           {"reserve", "--reserve"},
                                                           {"spare_steering", "--spare-steering"}};
  for (const auto& [name, flag] : names) {
    if (error.where() == name) return {flag, error.problem()};
  }
  return error;
}

/// A table of the site to the goals of a scenario, as if nothing moved.
std::shared_ptr<ChangingSiteTable> live_site(Scenario scenario, const PlanOptions& options) {
  scenario.moving.clear();
  try {
    const Problem problem = make_problem(scenario);
    const PlanOptions all = complete(default_planner(), options, problem.vehicle());
    const std::vector<Pose> goals = site_goals(problem, all).poses;
    return std::make_shared<ChangingSiteTable>(problem, goals, all);
  } catch (const InputError& error) {
    throw InputError("--site", fmt::format("{}: {}", error.where(), error.problem()));
  }
}

LiveDriveOptions live_options(const ScenarioFile& file, const LiveArguments& arguments,
                              const DriveOptions& drive) {
  LiveDriveOptions options;
  options.replan.plan = options_for(default_planner(), file.options, arguments.options);
  options.period = *arguments.period;
  options.sensor_range = arguments.sensor_range;
  options.horizon = arguments.horizon;
  options.drive = drive;
  options.replan.plan.budget.seed = drive.seed;
  if (arguments.prediction == name_of(Prediction::constant_velocity)) {
    options.prediction = Prediction::constant_velocity;
  } else if (arguments.prediction != name_of(Prediction::known)) {
    throw InputError("--prediction",
                     "is \"" + arguments.prediction + "\", expected known or constant-velocity");
  }
  if (arguments.with_site) options.replan.site = live_site(file.scenario, options.replan.plan);
  return options;
}

ScenarioFile live_scenario(const std::string& name) {
  ScenarioFile file = read_scenario_file(name);
  warn(file.warnings);
  if (file.is_row()) throw InputError(name, "has a row of goals, expected one goal");
  return file;
}

LiveDriveResult driven_live(const Scenario& scenario, const LiveDriveOptions& options,
                            const std::function<void(const Action&)>& on_action = {}) {
  try {
    return drive_live(scenario, options, on_action);
  } catch (const InputError& error) {
    throw renamed_live(error);
  }
}

/// Sums and worst figures of many drives of one scenario.
struct LiveTotals {
  int runs = 0;
  int arrived = 0;
  int contacts = 0;
  std::int64_t ticks = 0;
  std::int64_t ticks_without_answer = 0;
  std::int64_t stopping_ticks = 0;
  int stops = 0;
  int new_ways = 0;
  int new_times = 0;
  double duration = 0.0;  // sum of the durations [s]
  double clearance = std::numeric_limits<double>::infinity();
  double moving_clearance = std::numeric_limits<double>::infinity();
  double end_distance = 0.0;
  double end_heading = 0.0;
  std::optional<Contact> contact = {};  // contact of the first drive that has one
  std::uint64_t seed = 0;               // seed of the drive with `contact`, else of the first

  void add(const LiveDriveResult& drive, std::uint64_t its_seed) {
    if (runs++ == 0) seed = its_seed;
    arrived += drive.has_arrived ? 1 : 0;
    contacts += drive.contact ? 1 : 0;
    ticks += drive.ticks;
    ticks_without_answer += drive.ticks_without_answer;
    stopping_ticks += drive.stopping_ticks;
    stops += drive.stops;
    new_ways += drive.new_ways;
    new_times += drive.new_times;
    duration += drive.duration;
    clearance = std::min(clearance, drive.clearance);
    moving_clearance = std::min(moving_clearance, drive.moving_clearance);
    end_distance = std::max(end_distance, drive.end_distance);
    end_heading = std::max(end_heading, drive.end_heading);
    if (!drive.contact || contact) return;
    contact = drive.contact;
    seed = its_seed;
  }
};

LiveTotals all_live(const ScenarioFile& file, const LiveDriveOptions& options, int runs) {
  LiveTotals totals;
  LiveDriveOptions each = options;
  for (int i = 0; i < runs; ++i) {
    totals.add(driven_live(file.scenario, each), each.drive.seed);
    each.replan.plan.budget.seed = ++each.drive.seed;
  }
  return totals;
}

nlohmann::ordered_json json_or_null(double metres) {
  return std::isfinite(metres) ? nlohmann::ordered_json(metres) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json live_json(const ScenarioFile& file, const LiveDriveOptions& options,
                                 const LiveTotals& totals) {
  const auto [low, high] =
      evaluation::share_interval(totals.contacts, totals.runs, live_confidence);
  nlohmann::ordered_json json = {
      {"scenario", file.scenario.name},
      {"replan", options.period},
      {"sensor_range", options.sensor_range ? nlohmann::ordered_json(*options.sensor_range)
                                            : nlohmann::ordered_json(nullptr)},
      {"prediction", std::string(name_of(options.prediction))},
      {"seed", options.drive.seed},
      {"runs", totals.runs},
      {"arrived", totals.arrived},
      {"contacts", totals.contacts},
      {"contact_rate",
       {{"share", static_cast<double>(totals.contacts) / totals.runs},
        {"low", low},
        {"high", high}}},
      {"duration", totals.duration / totals.runs},
      {"ticks", totals.ticks},
      {"ticks_without_answer", totals.ticks_without_answer},
      {"ticks_without_goal", totals.stopping_ticks},
      {"stops", totals.stops},
      {"route_changes", totals.new_ways},
      {"new_times", totals.new_times},
      {"end_distance", totals.end_distance},
      {"end_heading", totals.end_heading},
      {"clearance", json_or_null(totals.clearance)},
      {"moving_clearance", json_or_null(totals.moving_clearance)}};
  if (totals.contact) {
    const Contact& contact = *totals.contact;
    json["first_contact"] = {{"t", contact.t},       {"x", contact.pose.x},
                             {"y", contact.pose.y},  {"heading", contact.pose.heading},
                             {"what", contact.what}, {"seed", totals.seed}};
  }
  return json;
}

std::string count_text(std::int64_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void print_live(const ScenarioFile& file, const LiveDriveOptions& options,
                const LiveTotals& totals) {
  const std::string contacts =
      totals.contacts == 0 ? "no contact" : count_text(totals.contacts, "contact");
  fmt::print("{}: replanned every {}: {} in {}, {} arrived\n", printable(file.scenario.name),
             seconds_text(options.period), contacts, count_text(totals.runs, "drive"),
             totals.arrived);
  if (totals.contact) {
    fmt::print("  first contact: after {}, seed {}: {}\n", seconds_text(totals.contact->t),
               totals.seed, printable(totals.contact->what));
  }
  fmt::print("  time: {}; at the end {} from the goal\n",
             seconds_text(totals.duration / totals.runs), metres_text(totals.end_distance));
  fmt::print("  {}, without a safe plan {}, without a plan to the goal {}\n",
             count_text(totals.ticks, "tick"), totals.ticks_without_answer, totals.stopping_ticks);
  fmt::print("  {} on the way, {}, {}\n", count_text(totals.stops, "stop"),
             count_text(totals.new_ways, "route change"),
             count_text(totals.new_times, "speed change"));
  fmt::print("  {}", clearance_text(totals.clearance));
  if (std::isfinite(totals.moving_clearance)) {
    fmt::print(", {} from moving obstacles", metres_text(totals.moving_clearance));
  }
  fmt::print("\n");
}

/// A drive in arcs of 0.1 s: few enough for a picture.
TimedPath coarse(const TimedPath& driven) {
  constexpr double step = 0.1;  // duration of an arc [s]
  TimedPath result{{driven.path.start, {}}, {}};
  std::vector<SpeedKnot>& knots = result.speeds.knots;
  double begin = 0.0, s = 0.0, length = 0.0, turn = 0.0;
  const auto finish = [&](double t) {
    if (t <= begin) return;
    knots.push_back({.t = begin, .s = s, .v = std::abs(length) / (t - begin)});
    if (length != 0.0) result.path.segments.push_back({turn / length, length});
    s += std::abs(length);
    begin = t;
    length = turn = 0.0;
  };
  auto arc = driven.path.segments.begin();
  for (const SpeedKnot& knot : driven.speeds.knots) {
    const bool moves = knot.v > 0.0;
    const bool turns_round =
        moves && length != 0.0 && arc != driven.path.segments.end() && length * arc->length < 0.0;
    if (knot.t >= begin + step - 1e-9 || turns_round || moves != (length != 0.0)) finish(knot.t);
    if (!moves || arc == driven.path.segments.end()) continue;
    length += arc->length;
    turn += arc->curvature * arc->length;
    ++arc;
  }
  finish(driven.speeds.duration);
  knots.push_back({.t = driven.speeds.duration, .s = s});
  result.speeds.duration = driven.speeds.duration;
  return result;
}

void write_live_picture(const std::string& picture, const Scenario& scenario,
                        const LiveDriveResult& result) {
  const TimedPath looked_at = coarse(result.driven);
  std::vector<Pose> poses;
  for (const DriveMoment& moment : result.log) poses.push_back(moment.pose);
  Drawing drawing{.scenario = &scenario, .path = &looked_at.path, .driven = &poses};
  const PictureFormat format = picture_format(picture);
  if (format == PictureFormat::svg) drawing.speeds = &looked_at.speeds;
  drawing.caption = printable(fmt::format("{}: {:.1f} s, {}, {}", scenario.name, result.duration,
                                          result.contact ? "a contact" : "no contact",
                                          count_text(result.new_ways, "route change")));
  write_file(picture, draw(drawing, format, live_picture_width));
}

/// Repeats the drive with the seed `seed`, and writes its log, actions, picture and recording.
void write_live(const ScenarioFile& file, LiveDriveOptions options, const LiveArguments& arguments,
                const LiveRuns& runs, std::uint64_t seed) {
  if (!runs.output && !runs.picture && !runs.recording && !arguments.actions) return;
  options.drive.seed = options.replan.plan.budget.seed = seed;
  options.drive.keep_log = true;
  if (arguments.actions) options.action_rate = arguments.rate;
  std::string actions = "t,steering_angle,v,a\n";
  const LiveDriveResult result = driven_live(file.scenario, options, [&](const Action& action) {
    actions += fmt::format("{},{},{},{}\n", action.t, action.steering_angle, action.v, action.a);
  });
  if (runs.picture) write_live_picture(*runs.picture, file.scenario, result);
  if (runs.output) write_file(*runs.output, csv_of(result.log));
  if (arguments.actions) write_file(*arguments.actions, actions);
  if (runs.recording) {
    record(*runs.recording,
           {.scenario = &file.scenario,
            .drive = RecordedDrive{result.log, result.has_arrived, result.contact}});
  }
}

void check_live_outputs(const LiveArguments& arguments, const LiveRuns& runs) {
  if (runs.picture) expect_picture(*runs.picture);
  if (runs.recording) expect_recording(*runs.recording);
  for (const auto& [flag, name] :
       {std::pair{"--output", &runs.output}, std::pair{actions_flag, &arguments.actions}}) {
    if (!*name) continue;
    if (runs.json && **name == "-") {
      throw InputError("--json", fmt::format("does not go with {} -, both would print", flag));
    }
    expect_ending(**name, FileKind{"a drive is CSV", {".csv"}});
    expect_writable(**name);
  }
}

}  // namespace

void add_live_options(CLI::App& command, LiveArguments& arguments, bool is_one) {
  CLI::Option* const replan =
      command
          .add_option("--replan", arguments.period,
                      "Plan while driving, with this period [s]; multiple of 0.02 up to 10")
          ->type_name("S");
  command
      .add_option("--sensor-range", arguments.sensor_range,
                  "Range of the sensor [m]; unseen ground is free, or unknown in a map;\n"
                  "default: all is known")
      ->type_name("M")
      ->needs(replan);
  command
      .add_option("--prediction", arguments.prediction,
                  "Prediction of moving obstacles: known (true trajectories) or\nconstant-velocity")
      ->type_name("NAME")
      ->capture_default_str()
      ->needs(replan);
  command
      .add_option("--horizon", arguments.horizon, "Horizon of constant-velocity [s]; 0.1 to 100")
      ->type_name("S")
      ->capture_default_str()
      ->needs(replan);
  command
      .add_flag("--site", arguments.with_site,
                "Make a table of the site, begin plans with its way, and repair it\n"
                "where the ground turns out to be different")
      ->needs(replan);
  if (!is_one) return;
  CLI::Option* const actions =
      command
          .add_option(actions_flag, arguments.actions,
                      "Planned steering and speed over time (.csv); - prints it")
          ->type_name("FILE")
          ->needs(replan);
  command.add_option("--rate", arguments.rate, "Rows of --actions per second; up to 1000")
      ->type_name("HZ")
      ->capture_default_str()
      ->needs(actions);
  const auto add = [&arguments](const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) arguments.options.push_back(typed_setting(setting));
  };
  command
      .add_option_function<std::vector<std::string>>(
          "--set", add, "Option of the planner, as for `vandplan plan`")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->needs(replan);
}

int drive_again_and_again(const std::string& scenario, const LiveArguments& arguments,
                          const LiveRuns& runs) {
  check_live_outputs(arguments, runs);
  const ScenarioFile file = live_scenario(scenario);
  const LiveDriveOptions options = live_options(file, arguments, runs.drive);
  const LiveTotals totals = all_live(file, options, runs.runs);
  write_live(file, options, arguments, runs, totals.seed);
  if (runs.json) {
    print(live_json(file, options, totals));
  } else if (runs.output != "-" && arguments.actions != "-") {
    print_live(file, options, totals);
  }
  const bool is_good = totals.contacts == 0 && totals.arrived == totals.runs;
  return is_good ? exit_status::done : exit_status::failed;
}

int compare_live(const std::vector<std::string>& files, const LiveArguments& arguments,
                 const LiveRuns& runs) {
  bool is_good = true;
  if (!runs.json) {
    fmt::print("{:<28} {:>6} {:>8} {:>9} {:>8} {:>8} {:>9} {:>6} {:>8}\n", "scenario", "drives",
               "arrived", "contacts", "time", "vs alone", "unsafe", "stops", "changes");
  }
  for (const std::string& name : files) {
    ScenarioFile file = live_scenario(name);
    const LiveDriveOptions options = live_options(file, arguments, runs.drive);
    const LiveTotals totals = all_live(file, options, runs.runs);
    ScenarioFile alone = file;
    alone.scenario.moving.clear();
    const LiveTotals without = all_live(alone, options, 1);
    const double time = totals.duration / totals.runs;
    is_good = is_good && totals.contacts == 0 && totals.arrived == totals.runs;
    if (runs.json) {
      nlohmann::ordered_json json = live_json(file, options, totals);
      json["duration_without_movers"] = without.duration;
      json["duration_ratio"] = time / without.duration;
      json["route_changes_per_minute"] = 60 * totals.new_ways / totals.duration;
      print_line(json);
      continue;
    }
    fmt::print("{:<28} {:>6} {:>8} {:>7.2f} % {:>6.1f} s {:>8.3f} {:>9} {:>6} {:>8}\n",
               printable(file.scenario.name), totals.runs, totals.arrived,
               100.0 * totals.contacts / totals.runs, time, time / without.duration,
               fmt::format("{}/{}", totals.ticks_without_answer, totals.ticks), totals.stops,
               totals.new_ways);
  }
  return is_good ? exit_status::done : exit_status::failed;
}

}  // namespace vandplan::app
