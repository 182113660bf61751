// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan speed: how fast can a path be driven, and where is the vehicle when?
#include "vandplan/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <memory>

#include "chosen_path.h"
#include "commands.h"
#include "motions_file.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "wording.h"

namespace vandplan::app {
namespace {

constexpr double most_rows = 2e6;  // rows of a table

struct SpeedArguments {
  PathArguments path;
  std::optional<std::string> output;
  double step = 0.05;         // largest time between rows [s]
  std::string frame = "map";  // frame_id of a nav_msgs/Path
  bool json = false;
};

/// Part of a path between two stops.
struct Stretch {
  double length = 0.0;    // length of the part [m]
  double duration = 0.0;  // driving time of the part [s]
};

Stretch longest_stretch(const SpeedProfile& profile) {
  Stretch longest;
  double s = 0.0;
  double t = 0.0;
  const auto end_at = [&](double end_s, double end_t) {
    if (end_s - s > longest.length) longest = {end_s - s, end_t - t};
  };
  for (const Stop& stop : profile.stops) {
    end_at(stop.s, stop.t);
    s = stop.s;
    t = stop.t + stop.pause;
  }
  end_at(profile.knots.back().s, profile.duration);
  return longest;
}

constexpr std::array bounds = {SpeedBound::max_speed,     SpeedBound::lateral_acceleration,
                               SpeedBound::steering_rate, SpeedBound::acceleration,
                               SpeedBound::braking,       SpeedBound::jerk,
                               SpeedBound::standing};

/// Time during which `bound` keeps the vehicle from driving faster [s].
double time_bound_by(SpeedBound bound, const SpeedProfile& profile) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < profile.knots.size(); ++i) {
    if (profile.knots[i].bound == bound) sum += profile.knots[i + 1].t - profile.knots[i].t;
  }
  return sum;
}

/// Number of stops between start and goal. Turning the wheels at the start is no stop.
std::ptrdiff_t stops_on_the_way(const SpeedProfile& profile) {
  return std::ranges::count_if(profile.stops, [](const Stop& stop) { return stop.s > 0.0; });
}

double highest_speed(const SpeedProfile& profile) {
  double highest = 0.0;
  for (const SpeedKnot& knot : profile.knots) highest = std::max(highest, knot.v);
  return highest;
}

nlohmann::ordered_json speed_json(const Choice& choice, const SpeedProfile& profile) {
  const Stretch longest = longest_stretch(profile);
  nlohmann::ordered_json json = {
      {"scenario", choice.record.scenario},
      {"duration", profile.duration},
      {"length", length(*choice.record.result.path)},
      {"standing", profile.standing},
      {"highest_speed", highest_speed(profile)},
      {"longest_stretch", {{"length", longest.length}, {"duration", longest.duration}}}};
  json["stops"] = nlohmann::ordered_json::array();
  for (const Stop& stop : profile.stops) {
    json["stops"].push_back({{"t", stop.t},
                             {"s", stop.s},
                             {"pause", stop.pause},
                             {"curvature_before", stop.curvature_before},
                             {"curvature_after", stop.curvature_after}});
  }
  for (const SpeedBound bound : bounds) {
    json["bound_by"][std::string(name_of(bound))] = time_bound_by(bound, profile);
  }
  return json;
}

void print_summary(const Choice& choice, const SpeedProfile& profile) {
  const Stretch longest = longest_stretch(profile);
  fmt::print("{}: {} for {}, at most {:.3f} m/s, stops {}, standing {}\n", printable(choice.label),
             seconds_text(profile.duration), metres_text(length(*choice.record.result.path)),
             highest_speed(profile), stops_on_the_way(profile), seconds_text(profile.standing));
  fmt::print("  longest stretch: {} in {}\n", metres_text(longest.length),
             seconds_text(longest.duration));
  std::string shares;
  for (const SpeedBound bound : bounds) {
    const double share = time_bound_by(bound, profile) / profile.duration;
    if (!(share > 0.0)) continue;
    shares += fmt::format("{}{} {:.1f} %", shares.empty() ? "" : ", ", name_of(bound), 100 * share);
  }
  if (!shares.empty()) fmt::print("  limited by: {}\n", shares);
}

/// Throws InputError unless ROS accepts the name of the frame.
void check_frame(const std::string& frame) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '/' || c == '.';
  };
  const bool begins_well =
      !frame.empty() && std::isalpha(static_cast<unsigned char>(frame[0])) != 0;
  if (begins_well && std::ranges::all_of(frame, is_plain)) return;
  throw InputError("--frame", "is \"" + frame.substr(0, 40) +
                                  "\", expected a letter, then letters, digits, _, -, / or .");
}

void check_output(const SpeedArguments& arguments) {
  if (!(arguments.step >= 1e-4 && arguments.step <= 0.05)) {
    throw InputError("--step", fmt::format("is {}, expected 0.0001 to 0.05 s", arguments.step));
  }
  check_frame(arguments.frame);
  if (arguments.output) {
    expect_drive_output(*arguments.output, motions_file, arguments.json);
  }
}

int run(const SpeedArguments& arguments) {
  check_output(arguments);
  const Choice choice = chosen_path(arguments.path);
  const std::string reason = reason_not_to_drive(choice);
  if (!reason.empty()) return refuse(choice, reason, arguments.json);
  const std::optional<Path>& path = choice.record.result.path;
  const Vehicle& vehicle = choice.problem.vehicle();
  const std::optional<SpeedProfile>& stated = choice.record.result.speeds;
  if (stated) {
    const DriveCheck check = check_drive(choice.problem, {*path, *stated});
    if (!check.valid) return refuse(choice, check.reason, arguments.json);
  }
  const SpeedProfile profile =
      stated ? *stated : speed_profile(*path, vehicle, speed_options(choice.problem, *path));
  nlohmann::ordered_json json = speed_json(choice, profile);
  if (arguments.output) {
    if (profile.duration / arguments.step > most_rows) {
      throw InputError("--output", fmt::format("would have more than {} rows", most_rows));
    }
    const std::vector<Motion> motions = sampled(*path, vehicle, profile, arguments.step);
    write_motions(*arguments.output, motions, arguments.frame);
    json["rows"] = motions.size();
    json["output"] = *arguments.output;
  }
  if (arguments.json) {
    print(json);
  } else if (arguments.output != "-") {
    print_summary(choice, profile);
    if (arguments.output) {
      fmt::print("  {} rows written to {}\n", json["rows"].get<std::size_t>(),
                 printable(*arguments.output));
    }
  }
  return exit_status::done;
}

}  // namespace

void add_speed(CLI::App& vandplan, int& status) {
  CLI::App* const command =
      vandplan.add_subcommand("speed", "Compute the fastest drive along a path.");
  command->footer(
      "Valid times of the result (planned among moving obstacles) are kept.\n"
      "Columns: t [s], s, x, y [m], heading [rad], curvature [1/m], steering_angle [rad],\n"
      "direction (1 or -1), v [m/s], a [m/s^2]; v is negative in reverse.\n"
      "Exit status: 0 done, 1 no path or an invalid one, 2 bad input.");
  const auto arguments = std::make_shared<SpeedArguments>();
  add_scenario_and_result(*command, arguments->path.scenario, arguments->path.result);
  command
      ->add_option("-o,--output", arguments->output,
                   "Table over time (.csv; .yaml: nav_msgs/Path of ROS 2); - prints it")
      ->type_name("FILE");
  command->add_option("--step", arguments->step, "Largest time between rows [s]; 0.0001 to 0.05")
      ->type_name("S")
      ->capture_default_str();
  command->add_option("--frame", arguments->frame, "frame_id of a .yaml")
      ->type_name("NAME")
      ->capture_default_str();
  add_choice(*command, arguments->path);
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace vandplan::app
