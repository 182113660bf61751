// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan drive: what happens when a simulated vehicle drives a path?
#include "vandplan/drive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "chosen_path.h"
#include "commands.h"
#include "endings.h"
#include "evaluation/statistics.h"
#include "live.h"
#include "option_flags.h"
#include "pictures.h"
#include "recordings.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/recording.h"
#include "wording.h"

namespace vandplan::app {
namespace {

constexpr int most_runs = 1'000'000;
constexpr double most_rows = 2e6;      // rows of a log
constexpr double row_duration = 0.02;  // time between rows of a log [s]
constexpr double confidence = 0.95;
constexpr double degree = std::numbers::pi / 180;

struct DriveArguments {
  PathArguments path;
  DriveOptions options;
  LiveArguments live;
  int runs = 1;
  std::optional<std::string> output;
  std::optional<std::string> picture;
  std::optional<std::string> recording;
  bool json = false;
};

/// Worst and mean figures of many drives of one path.
struct DriveTotals {
  int runs = 0;
  int arrived = 0;
  int contacts = 0;
  DriveResult worst = {};        ///< worst value of each figure; no means, contact or log
  double lateral_squares = 0.0;  ///< sum of squared RMS lateral deviations [m^2]
  double heading_squares = 0.0;  ///< sum of squared RMS heading deviations [rad^2]
  double trailer_squares = 0.0;  ///< sum of squared RMS lateral deviations of the trailer [m^2]
  double durations = 0.0;        ///< sum of the durations [s]
  std::optional<Contact> contact = {};  ///< earliest contact of all drives
  /// Seed of the drive with `contact`; without a contact, of the drive with the largest deviation
  /// of the outline.
  std::uint64_t seed = 0;

  void add(const DriveResult& drive, std::uint64_t its_seed);
  void add_trailer(const DriveResult& drive);
  [[nodiscard]] double rms_lateral() const { return std::sqrt(lateral_squares / runs); }
  [[nodiscard]] double rms_heading() const { return std::sqrt(heading_squares / runs); }
  [[nodiscard]] double rms_trailer_lateral() const { return std::sqrt(trailer_squares / runs); }
  [[nodiscard]] double duration() const { return durations / runs; }
  [[nodiscard]] evaluation::Interval contact_rate() const {
    return evaluation::share_interval(contacts, runs, confidence);
  }
};

void DriveTotals::add(const DriveResult& drive, std::uint64_t its_seed) {
  const bool is_first = runs++ == 0;
  arrived += drive.has_arrived ? 1 : 0;
  contacts += drive.contact ? 1 : 0;
  lateral_squares += drive.rms_lateral * drive.rms_lateral;
  heading_squares += drive.rms_heading * drive.rms_heading;
  durations += drive.duration;
  if (drive.contact && (!contact || drive.contact->t < contact->t)) {
    contact = drive.contact;
    seed = its_seed;
  } else if (is_first || (!contact && drive.outline_deviation > worst.outline_deviation)) {
    seed = its_seed;
  }
  const auto raise = [&](double DriveResult::*figure) {
    worst.*figure = std::max(worst.*figure, drive.*figure);
  };
  raise(&DriveResult::duration);
  raise(&DriveResult::planned_duration);
  raise(&DriveResult::largest_lateral);
  raise(&DriveResult::largest_heading);
  raise(&DriveResult::end_distance);
  raise(&DriveResult::end_heading);
  raise(&DriveResult::outline_deviation);
  raise(&DriveResult::out_of_bounds);
  add_trailer(drive);
  worst.clearance = is_first ? drive.clearance : std::min(worst.clearance, drive.clearance);
}

void DriveTotals::add_trailer(const DriveResult& drive) {
  if (!drive.trailer) return;
  if (!worst.trailer) worst.trailer.emplace();
  trailer_squares += drive.trailer->rms_lateral * drive.trailer->rms_lateral;
  const auto raise = [&](double TrailerDeviation::*figure) {
    (*worst.trailer).*figure = std::max((*worst.trailer).*figure, (*drive.trailer).*figure);
  };
  raise(&TrailerDeviation::largest_lateral);
  raise(&TrailerDeviation::end_distance);
  raise(&TrailerDeviation::end_heading);
  raise(&TrailerDeviation::hitch_deviation);
}

/// The error of a library option, naming the flag of the command line instead.
InputError renamed(const InputError& error) {
  for (const char* name : {"controller", "noise", "delay", "reserve"}) {
    if (error.where() == name) return {"--" + error.where(), error.problem()};
  }
  if (error.where() == "spare_steering") return {"--spare-steering", error.problem()};
  return error;
}

DriveResult driven(const Choice& choice, const DriveOptions& options) {
  try {
    return drive(choice.problem, *choice.record.result.path, options);
  } catch (const InputError& error) {
    throw renamed(error);
  }
}

DriveTotals all_driven(const Choice& choice, const DriveArguments& arguments) {
  DriveTotals totals;
  DriveOptions options = arguments.options;
  for (int i = 0; i < arguments.runs; ++i) {
    totals.add(driven(choice, options), options.seed);
    ++options.seed;
  }
  return totals;
}

/// Length of the path's segments at full lock [m]. A controller without spare steering cannot
/// correct there.
double metres_at_full_lock(const Path& path, const Vehicle& vehicle) {
  constexpr double nearly = 0.999;
  const double most = nearly / vehicle.min_turning_radius;
  double metres = 0.0;
  for (const Segment& segment : path.segments) {
    const double way = std::abs(segment.length);
    const double at_end = curvature_at(segment, way);
    const bool is_locked = std::abs(segment.curvature) >= most && std::abs(at_end) >= most;
    if (is_locked && segment.curvature * at_end > 0.0) metres += way;
  }
  return metres;
}

nlohmann::ordered_json json_of(const Execution& execution) {
  nlohmann::ordered_json json = {{"passes", execution.passes},
                                 {"duration", execution.duration},
                                 {"end_distance", execution.end_distance},
                                 {"end_heading", execution.end_heading}};
  if (!execution.passes) json["reason"] = execution.reason;
  return json;
}

nlohmann::ordered_json json_of(const Contact& contact, std::uint64_t seed) {
  const Pose& pose = contact.pose;
  return {{"t", contact.t},
          {"s", contact.s},
          {"pose", {{"x", pose.x}, {"y", pose.y}, {"heading", pose.heading}}},
          {"what", contact.what},
          {"seed", seed}};
}

nlohmann::ordered_json json_of(const Choice& choice, const DriveArguments& arguments,
                               const DriveTotals& totals, const ExecutableCheck& check) {
  const auto [low, high] = totals.contact_rate();
  const DriveOptions& options = arguments.options;
  const DriveResult& worst = totals.worst;
  nlohmann::ordered_json json = {{"scenario", choice.record.scenario},
                                 {"controller", options.controller},
                                 {"noise", options.noise},
                                 {"delay", options.delay},
                                 {"reserve", options.reserve},
                                 {"spare_steering", options.spare_steering},
                                 {"seed", options.seed},
                                 {"runs", totals.runs},
                                 {"arrived", totals.arrived},
                                 {"contacts", totals.contacts},
                                 {"contact_rate",
                                  {{"share", static_cast<double>(totals.contacts) / totals.runs},
                                   {"low", low},
                                   {"high", high}}},
                                 {"duration", totals.duration()},
                                 {"planned_duration", worst.planned_duration},
                                 {"largest_lateral", worst.largest_lateral},
                                 {"rms_lateral", totals.rms_lateral()},
                                 {"largest_heading", worst.largest_heading},
                                 {"rms_heading", totals.rms_heading()},
                                 {"end_distance", worst.end_distance},
                                 {"end_heading", worst.end_heading},
                                 {"outline_deviation", worst.outline_deviation},
                                 {"out_of_bounds", worst.out_of_bounds}};
  if (worst.trailer) {
    json["trailer"] = {{"largest_lateral", worst.trailer->largest_lateral},
                       {"rms_lateral", totals.rms_trailer_lateral()},
                       {"end_distance", worst.trailer->end_distance},
                       {"end_heading", worst.trailer->end_heading},
                       {"hitch_deviation", worst.trailer->hitch_deviation}};
  }
  json["clearance"] = nullptr;
  if (std::isfinite(worst.clearance)) json["clearance"] = worst.clearance;
  if (totals.contact) json["first_contact"] = json_of(*totals.contact, totals.seed);
  json["full_lock"] = metres_at_full_lock(*choice.record.result.path, choice.problem.vehicle());
  json["executable"] = {{"jumps", check.jumps},
                        {"flowing", json_of(check.flowing)},
                        {"pausing", json_of(check.pausing)}};
  return json;
}

std::string degrees_text(double angle) { return fmt::format("{:.2f} degrees", angle / degree); }

std::string contacts_text(const DriveTotals& totals) {
  std::string text = totals.contacts == 0 ? "no contact"
                                          : fmt::format("{} contact{}", totals.contacts,
                                                        totals.contacts == 1 ? "" : "s");
  if (totals.runs > 1) {
    const auto [low, high] = totals.contact_rate();
    text += fmt::format(" in {} drives, {:.2f} % (95 %: {:.2f} to {:.2f} %)", totals.runs,
                        100.0 * totals.contacts / totals.runs, 100 * low, 100 * high);
  }
  if (totals.arrived < totals.runs) {
    text += fmt::format("; {} did not arrive", totals.runs - totals.arrived);
  }
  return text;
}

std::string executable_text(const ExecutableCheck& check) {
  if (check.flowing.passes) return "yes";
  std::string no = "no, " + check.flowing.reason;
  if (check.jumps == 0) return no;
  return fmt::format("{}; with pauses at {} jump{} of the curvature: {}", no, check.jumps,
                     check.jumps == 1 ? "" : "s",
                     check.pausing.passes ? "yes" : "no, " + check.pausing.reason);
}

void print_summary(const Choice& choice, const DriveArguments& arguments, const DriveTotals& totals,
                   const ExecutableCheck& check) {
  const DriveResult& worst = totals.worst;
  const double locked = metres_at_full_lock(*choice.record.result.path, choice.problem.vehicle());
  const bool has_spare = locked == 0.0 || arguments.options.spare_steering > 0.0;
  fmt::print("{}: {}: {}\n", printable(choice.label), arguments.options.controller,
             contacts_text(totals));
  if (totals.contact) {
    fmt::print("  first contact: after {} at {}, seed {}: {}\n", seconds_text(totals.contact->t),
               metres_text(totals.contact->s), totals.seed, printable(totals.contact->what));
  }
  fmt::print("  time: {}, planned {}\n", seconds_text(totals.duration()),
             seconds_text(worst.planned_duration));
  fmt::print("  deviation: at most {} and {}, RMS {} and {}; at the end {} and {}\n",
             metres_text(worst.largest_lateral), degrees_text(worst.largest_heading),
             metres_text(totals.rms_lateral()), degrees_text(totals.rms_heading()),
             metres_text(worst.end_distance), degrees_text(worst.end_heading));
  if (worst.trailer) {
    fmt::print(
        "  trailer: deviation at most {}, RMS {}; at the end {} and {}; hitch angle at most {} "
        "beyond the plan\n",
        metres_text(worst.trailer->largest_lateral), metres_text(totals.rms_trailer_lateral()),
        metres_text(worst.trailer->end_distance), degrees_text(worst.trailer->end_heading),
        degrees_text(worst.trailer->hitch_deviation));
  }
  fmt::print(
      "  outline: at most {} beyond the plan, so a margin of {:.3f} m is enough on this path\n",
      metres_text(worst.outline_deviation), std::ceil(worst.outline_deviation * 1e3) / 1e3);
  fmt::print("  {}\n", clearance_text(worst.clearance));
  if (totals.contacts > 0 && worst.outline_deviation > choice.record.options.clearance.margin) {
    fmt::print(
        "  verdict: the path is too close to obstacles for this drive; plan with --set "
        "margin={:.3f} or, if that finds no path, with a higher clearance_weight\n",
        std::ceil(worst.outline_deviation * 1e3) / 1e3);
  }
  if (worst.out_of_bounds > 0.0) {
    fmt::print("  rear axle: at most {} out of bounds\n", metres_text(worst.out_of_bounds));
  }
  if (!has_spare) {
    fmt::print(
        "  steering: full lock for {}, where no controller can correct; try --spare-steering "
        "0.1\n",
        metres_text(locked));
  }
  fmt::print("  executable: {}{}\n", executable_text(check),
             check.flowing.passes && !has_spare
                 ? " without noise, but a controller lacks spare steering"
                 : "");
}

/// Repeats the drive with the seed of the totals, and writes its log, picture and recording.
void write_worst(const Choice& choice, const DriveArguments& arguments, const DriveTotals& totals) {
  if (!arguments.output && !arguments.picture && !arguments.recording) return;
  if (totals.worst.duration / row_duration > most_rows) {
    throw InputError(arguments.output    ? "--output"
                     : arguments.picture ? "--draw"
                                         : "--record",
                     fmt::format("would have more than {} rows", most_rows));
  }
  DriveOptions options = arguments.options;
  options.seed = totals.seed;
  options.keep_log = true;
  const DriveResult result = driven(choice, options);
  if (arguments.picture) {
    std::vector<Pose> poses;
    for (const DriveMoment& moment : result.log) poses.push_back(moment.pose);
    const std::string caption =
        fmt::format("{}: {}, {}", choice.label, options.controller, contacts_text(totals));
    write_picture(*arguments.picture, choice.scenario, choice.record, {poses, caption});
  }
  if (arguments.output) write_file(*arguments.output, csv_of(result.log));
  if (arguments.recording) {
    record(*arguments.recording, {&choice.scenario, &choice.record.result,
                                  RecordedDrive{result.log, result.has_arrived, result.contact}});
  }
}

void check_arguments(const DriveArguments& arguments) {
  if (arguments.runs < 1 || arguments.runs > most_runs) {
    throw InputError("--runs", fmt::format("is {}, expected 1 to {}", arguments.runs, most_runs));
  }
  if (arguments.picture) expect_picture(*arguments.picture);
  if (arguments.recording) expect_recording(*arguments.recording);
  if (arguments.output) {
    expect_drive_output(*arguments.output, {"a drive is CSV", {".csv"}}, arguments.json);
  }
}

int run(DriveArguments& arguments) {
  check_arguments(arguments);
  if (arguments.live.period) {
    return drive_again_and_again(arguments.path.scenario, arguments.live,
                                 {arguments.options, arguments.runs, arguments.output,
                                  arguments.picture, arguments.recording, arguments.json});
  }
  if (arguments.path.result.empty()) {
    throw InputError("RESULT", "is not given, expected a result file, or --replan");
  }
  const Choice choice = chosen_path(arguments.path);
  if (arguments.options.controller.empty()) {
    arguments.options.controller = usual_controller(choice.problem.vehicle());
  }
  const std::string reason = reason_not_to_drive(choice);
  if (!reason.empty()) return refuse(choice, reason, arguments.json);
  const DriveTotals totals = all_driven(choice, arguments);
  const ExecutableCheck check = executable(choice.problem, *choice.record.result.path);
  write_worst(choice, arguments, totals);
  if (arguments.json) {
    print(json_of(choice, arguments, totals, check));
  } else if (arguments.output != "-") {
    print_summary(choice, arguments, totals, check);
  }
  const bool is_good = totals.contacts == 0 && totals.arrived == totals.runs;
  return is_good ? exit_status::done : exit_status::failed;
}

std::string controllers_text() {
  std::string text = "Steering controller; default: rear-axle-feedback, with a trailer lqr";
  for (const ControllerInfo& info : controllers()) {
    text += fmt::format("\n{}: {}", info.name, info.summary);
  }
  return text;
}

void add_options(CLI::App& command, DriveArguments& arguments) {
  DriveOptions& options = arguments.options;
  command.add_option("--controller", options.controller, controllers_text())->type_name("NAME");
  command
      .add_option("--noise", options.noise,
                  "Noise; 1: standard deviations 2 cm and 0.2 degrees (measured poses),\n"
                  "0.2 degrees and 1 % (wheels), 1 % (speed); 0 to 10")
      ->type_name("X")
      ->capture_default_str();
  command.add_option("--delay", options.delay, "Delay from measurement to effect [s]; 0 to 1")
      ->type_name("S")
      ->capture_default_str();
  command
      .add_option("--reserve", options.reserve,
                  "Share of steering rate, acceleration and braking kept for\n"
                  "corrections; 0 to 0.5")
      ->type_name("SHARE")
      ->capture_default_str();
  command
      .add_option("--spare-steering", options.spare_steering,
                  "Share by which the vehicle can exceed the planned curvature and\n"
                  "hitch angle; 0 to 0.5")
      ->type_name("SHARE")
      ->capture_default_str();
  command.add_option("--runs", arguments.runs, "Number of drives, with seeds from --seed on")
      ->type_name("N")
      ->capture_default_str();
  add_seed(command, options.seed, "Random seed of the first drive");
  command
      .add_option("-o,--output", arguments.output,
                  "Log of the drive with the earliest contact, else the largest\n"
                  "deviation (.csv); - prints it")
      ->type_name("FILE");
  command.add_option("--draw", arguments.picture, "Picture of that drive (.svg, .png or .pdf)")
      ->type_name("FILE");
  add_record(command, arguments.recording,
             "Recording of that drive (.mcap), for Foxglove or Lichtblick");
}

}  // namespace

std::string csv_of(const std::vector<DriveMoment>& log) {
  std::string text =
      "t,s,x,y,heading,direction,v,steering_angle,wanted_steering,wanted_acceleration,"
      "lateral_error,heading_error";
  text += !log.empty() && log.front().hitch_angle ? ",hitch_angle\n" : "\n";
  for (const DriveMoment& m : log) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}", m.t, m.s, m.pose.x, m.pose.y,
                        m.pose.heading, direction_of(m.gear), m.v, m.steering_angle,
                        m.wanted_steering, m.wanted_acceleration, m.lateral_error, m.heading_error);
    if (m.hitch_angle) text += fmt::format(",{}", *m.hitch_angle);
    text += '\n';
  }
  return text;
}

void add_drive(CLI::App& vandplan, int& status) {
  CLI::App* const command = vandplan.add_subcommand(
      "drive", "Simulate a vehicle that drives a path, or plans while it drives.");
  command->footer(
      "Columns of the log, every 0.02 s: t [s], s, x, y [m], heading [rad], direction (1 or -1),\n"
      "v [m/s], steering_angle, wanted_steering [rad], wanted_acceleration [m/s^2],\n"
      "lateral_error [m], heading_error [rad], with a trailer hitch_angle [rad].\n"
      "Executable: driven without feedback and with stops at start, goal and gear changes only,\n"
      "the vehicle touches nothing and ends within 1 cm and 1 degree.\n"
      "Exit status: 0 done, 1 no path, an invalid one, a contact or no arrival, 2 bad input.");
  const auto arguments = std::make_shared<DriveArguments>();
  add_scenario(*command, arguments->path.scenario);
  CLI::Option* const result =
      command->add_option("RESULT", arguments->path.result, "Result (JSON, JSON Lines or binary)");
  add_options(*command, *arguments);
  add_live_options(*command, arguments->live, true);
  result->excludes("--replan");
  add_choice(*command, arguments->path);
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace vandplan::app
