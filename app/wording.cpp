// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "wording.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>

namespace vandplan::app {
namespace {

struct Unit {
  double size;
  const char* name;
};

constexpr std::array length_units = {Unit{1.0, "m"}, Unit{1e-3, "mm"}, Unit{1e-6, "um"}};
constexpr std::array time_units = {Unit{1.0, "s"}, Unit{1e-3, "ms"}, Unit{1e-6, "us"},
                                   Unit{1e-9, "ns"}};
constexpr double clearance_accuracy = 1e-3;  // accuracy of the judge's clearance [m]

/// A value in the largest unit of which it is at least a tenth. The first unit is that of `value`.
std::string with_unit(double value, std::span<const Unit> units) {
  const Unit& base = units.front();
  if (value == 0.0) return fmt::format("0 {}", base.name);
  if (!(std::abs(value) < 0.1 * base.size)) return fmt::format("{:.3f} {}", value, base.name);
  std::size_t i = 1;
  while (i + 1 < units.size() && std::abs(value) < 0.1 * units[i].size) ++i;
  const double count = value / units[i].size;
  const int decimals = std::abs(count) >= 10.0 ? 1 : 2;
  return fmt::format("{:.{}f} {}", count, decimals, units[i].name);
}

/// Name of the prices by which a cost was computed.
std::string name_of(CostOptions cost, const Problem& problem) {
  const Vehicle& vehicle = problem.vehicle();
  cost.gears = AllowedGears::both;  // named elsewhere
  if (is_length(cost)) {
    const bool has_zones = problem.task().checker->has_prices();
    return has_zones ? "length and the prices of zones" : "length alone";
  }
  if (cost == driver_style) return "a driver's prices";
  if (cost != prices_of(Style::driver, vehicle)) return "prices";
  return fmt::format("a driver's prices for a turning radius of {:.3g} m",
                     vehicle.min_turning_radius);
}

}  // namespace

std::string line_of_file(const std::string& file, int line) {
  return fmt::format("{}:{}", file == "-" ? "standard input" : file, line);
}

std::string metres_text(double metres) { return with_unit(metres, length_units); }

std::string seconds_text(double seconds) { return with_unit(seconds, time_units); }

std::string clearance_text(double clearance) {
  if (!std::isfinite(clearance)) return "no obstacles";
  const std::string text = "clearance " + metres_text(clearance);
  return clearance < 10 * clearance_accuracy
             ? text + " (accurate to " + metres_text(clearance_accuracy) + ")"
             : text;
}

std::string path_text(const PathCheck& check) {
  std::string text =
      fmt::format("length {}, gear changes {}, in reverse {}", metres_text(check.length),
                  check.gear_changes, metres_text(check.reverse_length));
  return check.clearance ? text + ", " + clearance_text(*check.clearance) : text;
}

std::string drive_text(const std::optional<DriveCheck>& check) {
  if (!check) return "";
  std::string text = fmt::format(", driven in {}", seconds_text(check->duration));
  if (!check->clearance || !std::isfinite(*check->clearance)) return text;
  return fmt::format("{}, {} from moving obstacles", text, metres_text(*check->clearance));
}

std::string cost_text(double cost, const CostOptions& rule, const Problem& problem) {
  const std::string only = rule.gears == AllowedGears::forward   ? ", forward only"
                           : rule.gears == AllowedGears::reverse ? ", in reverse only"
                                                                 : "";
  if (rule.measure == CostMeasure::time) return "driven in " + seconds_text(cost) + only;
  return fmt::format("cost {} by {}{}", metres_text(cost), name_of(rule, problem), only);
}

std::string no_path_text(const PlanResult& result) {
  const std::string text = fmt::format("no path: {}", name_of(result.status));
  return result.reason.empty() ? text : fmt::format("{} ({})", text, printable(result.reason));
}

}  // namespace vandplan::app
