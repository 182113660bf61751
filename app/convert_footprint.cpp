// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "convert_footprint.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "commands.h"
#include "endings.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "wording.h"

namespace vandplan::app {
namespace {

struct FootprintArguments {
  FootprintFile footprint;
  std::optional<double> min_turning_radius;
  std::optional<double> max_steering_angle;
  std::string output;
  bool json = false;
};

void convert_footprint(const FootprintArguments& arguments) {
  expect_ending(arguments.output, {"a vehicle is YAML", {".yaml", ".yml"}});
  FootprintFile file = arguments.footprint;
  if (arguments.max_steering_angle) {
    file.min_turning_radius = turning_radius(file.wheelbase, *arguments.max_steering_angle);
  } else if (arguments.min_turning_radius) {
    file.min_turning_radius = *arguments.min_turning_radius;
  } else {
    throw InputError("--min-turning-radius", "is missing, expected it or --max-steering-angle");
  }
  const FootprintVehicle made = read_footprint(file);
  write_file(arguments.output, to_yaml(made.vehicle));
  if (arguments.json) {
    print({{"output", arguments.output},
           {"footprint_area", made.footprint_area},
           {"added_area", made.added_area},
           {"added_width", made.added_width}});
    return;
  }
  if (!made.vehicle.outline.empty()) {
    fmt::print("outline with {} corners, written to {}\n", made.vehicle.outline.size(),
               printable(arguments.output));
    return;
  }
  const Footprint rectangle = footprint(made.vehicle);
  fmt::print("a rectangle of {:.3f} x {:.3f} m around the footprint, written to {}\n",
             rectangle.front + rectangle.rear, 2 * rectangle.half_width,
             printable(arguments.output));
  fmt::print("  added: {:.4f} m2, {:.1f} % of the footprint\n", made.added_area,
             100 * made.added_area / made.footprint_area);
  if (made.added_width > 0) {
    fmt::print("  of this {:.3f} m of width, because the rectangle is symmetric\n",
               made.added_width);
  }
}

}  // namespace

void add_footprint(CLI::App& convert) {
  CLI::App* const command =
      convert.add_subcommand("footprint", "Convert the footprint of a Nav2 robot into a vehicle.");
  const auto arguments = std::make_shared<FootprintArguments>();
  FootprintFile& file = arguments->footprint;
  command->add_option("FILE", file.file, "Parameters of Nav2, or list of corners (YAML)")
      ->required();
  command->add_option("--wheelbase", file.wheelbase, "Rear axle to front axle [m]")
      ->type_name("M")
      ->required();
  CLI::Option* const radius =
      command
          ->add_option("--min-turning-radius", arguments->min_turning_radius,
                       "Turning radius of the rear-axle midpoint [m]")
          ->type_name("M");
  command
      ->add_option("--max-steering-angle", arguments->max_steering_angle,
                   "Alternative: steering angle of the bicycle model [rad]")
      ->type_name("RAD")
      ->excludes(radius);
  command->add_option("--rear-axle", file.rear_axle, "x of the rear axle in the footprint [m]")
      ->type_name("M")
      ->capture_default_str();
  command->add_flag("--rectangle", file.rectangle,
                    "Use a rectangle, also if the footprint is convex");
  command->add_option("-o,--output", arguments->output, "Vehicle (YAML)")
      ->type_name("FILE")
      ->required();
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { convert_footprint(*arguments); });
}

}  // namespace vandplan::app
