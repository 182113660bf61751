// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "bindings/web/core/site.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "vandplan/input_error.h"

namespace vandplan::web {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<Pose> goals_at(const val& query, const Problem& problem, const PlanOptions& options) {
  if (!has(query, "goals")) return site_goals(problem, options).poses;
  const val list = query["goals"];
  std::vector<Pose> goals(size_of(list, "goals"));
  for (std::size_t i = 0; i < goals.size(); ++i) {
    goals[i] = pose_from(list[i], "goals[" + std::to_string(i) + "]");
  }
  return goals;
}

int headings_at(const val& query, int standard) {
  const double headings = number_at(query, "headings", "", standard);
  if (headings != std::floor(headings) || std::abs(headings) > 1e6) {
    throw InputError("headings", "expected a whole number");
  }
  return static_cast<int>(headings);
}

/// Numbers at a key: of an array, or of a typed one.
std::vector<double> numbers_at(const val& object, const char* key) {
  if (!has(object, key) || !object[key]["length"].isNumber()) {
    throw InputError(key_of("poses", key), "expected an array of numbers");
  }
  return emscripten::convertJSArrayToNumberVector<double>(object[key]);
}

/// The table has no cell for a pose that is not finite.
double cost_from(const SiteTable& table, const Pose& pose, std::size_t goal) {
  const bool is_finite =
      std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
  return is_finite ? table.cost(pose, goal) : infinity;
}

double least_cost_from(const SiteTable& table, double x, double y, std::size_t goal) {
  const double first = table.goals()[goal].heading;
  double least = infinity;
  for (int i = 0; i < table.headings(); ++i) {
    const double heading = first + i * 2 * std::numbers::pi / table.headings();
    least = std::min(least, cost_from(table, {x, y, heading}, goal));
  }
  return least;
}

}  // namespace

std::shared_ptr<const SiteTable> SiteReader::read(const val& given) {
  if (table_ && given.strictlyEquals(bytes_)) return table_;
  if (!val::global("ArrayBuffer").call<bool>("isView", given)) {
    throw InputError(site_key, "expected the bytes of a table, a Uint8Array");
  }
  const val bytes =
      val::global("Uint8Array").new_(given["buffer"], given["byteOffset"], given["byteLength"]);
  const auto kept = std::make_shared<std::string>(bytes["length"].as<std::size_t>(), '\0');
  auto* const begin = reinterpret_cast<std::uint8_t*>(kept->data());
  val{emscripten::typed_memory_view(kept->size(), begin)}.call<void>("set", bytes);
  table_ = std::make_shared<const SiteTable>(site_table_from_bytes(*kept, kept, site_key));
  bytes_ = given;
  return table_;
}

SiteWish site_wish_from(const val& query, const Problem& problem, const PlanOptions& options,
                        const val& progress) {
  SiteWish wish{.goals = goals_at(query, problem, options), .options = {}};
  wish.options.headings = headings_at(query, wish.options.headings);
  wish.options.cell = number_at(query, "cell", "", wish.options.cell);
  wish.options.starts = {problem.start()};
  if (!progress.isUndefined()) {
    wish.options.progress = [&](std::size_t goals) { progress(static_cast<double>(goals)); };
  }
  return wish;
}

val bytes_of(const SiteTable& table) {
  const std::string_view bytes = site_table_to_bytes(table);
  const auto* const begin = reinterpret_cast<const std::uint8_t*>(bytes.data());
  const val view{emscripten::typed_memory_view(bytes.size(), begin)};
  return val::global("Uint8Array").new_(view);
}

val object_of(const SiteTable& table) {
  val goals = val::array();
  for (const Pose& goal : table.goals()) goals.call<void>("push", object_of(goal));
  const auto range = [](double from, double to) {
    val list = val::array();
    list.set(0, from);
    list.set(1, to);
    return list;
  };
  val bounds = val::object();
  bounds.set("x", range(table.bounds().x_min, table.bounds().x_max));
  bounds.set("y", range(table.bounds().y_min, table.bounds().y_max));
  val object = val::object();
  object.set("goals", goals);
  object.set("bounds", bounds);
  object.set("cell", table.cell());
  object.set("headings", table.headings());
  return object;
}

val costs_of(const SiteTable& table, const val& poses, double goal) {
  if (!(goal >= 0 && goal < static_cast<double>(table.goals().size())) ||
      goal != std::floor(goal)) {
    throw InputError("goal", "the table has no such goal");
  }
  allow_only(poses, {"x", "y", "heading"}, "poses");
  const std::vector<double> x = numbers_at(poses, "x");
  const std::vector<double> y = numbers_at(poses, "y");
  const std::optional<std::vector<double>> heading =
      has(poses, "heading") ? std::optional(numbers_at(poses, "heading")) : std::nullopt;
  if (x.size() != y.size() || (heading && x.size() != heading->size())) {
    throw InputError("poses", "expected as many x as y and headings");
  }
  const auto number = static_cast<std::size_t>(goal);
  std::vector<double> costs(x.size());
  for (std::size_t i = 0; i < costs.size(); ++i) {
    costs[i] = heading ? cost_from(table, {x[i], y[i], (*heading)[i]}, number)
                       : least_cost_from(table, x[i], y[i], number);
  }
  return array_of(std::span<const double>(costs));
}

}  // namespace vandplan::web
