// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Goals in JavaScript: one pose, or a set, with the keys of a scenario file.

#include "bindings/web/core/values.h"
#include "vandplan/input_error.h"
#include "vandplan/vehicle.h"

namespace vandplan::web {
namespace {

bool is_any(const val& given) { return given.isString() && given.as<std::string>() == "any"; }

bool is_list(const val& object, const char* key) {
  return has(object, key) && object[key].isArray();
}

/// Interval from a number, or from a list of two.
Interval interval_from(const val& given, const std::string& where) {
  if (!given.isArray()) return {number_from(given, where), number_from(given, where)};
  if (given["length"].as<std::size_t>() != 2) throw InputError(where, "expected two numbers");
  return {number_from(given[0], where), number_from(given[1], where)};
}

bool is_set(const val& given) {
  if (has(given, "straight")) return true;
  const val axle = has(given, "trailer") ? given["trailer"] : given;
  for (const char* const key : {"any_of", "area", "either_way"}) {
    if (has(axle, key)) return true;
  }
  if (is_list(axle, "x") || is_list(axle, "y") || is_list(axle, "heading")) return true;
  if (has(axle, "heading") && is_any(axle["heading"])) return true;
  if (!has(given, "hitch_angles")) return false;
  const val angles = given["hitch_angles"];
  return is_any(angles) ||
         (angles.isArray() && angles["length"].as<std::size_t>() == 1 && angles[0].isArray());
}

void read_axle(const val& given, const std::string& where, GoalRegion& region) {
  const bool has_area = has(given, "area");
  if (has_area && (has(given, "x") || has(given, "y"))) {
    throw InputError(where + ".area", "is given beside x or y");
  }
  for (const char* const key : {"x", "y"}) {
    if (!has_area && !has(given, key)) throw InputError(where + "." + key, "is missing");
  }
  if (!has(given, "heading")) throw InputError(where + ".heading", "is missing");
  if (has_area) {
    region.area = polygon_from(given["area"], where + ".area");
    if (region.area.empty()) throw InputError(where + ".area", "has 0 corners");
  } else {
    region.x = interval_from(given["x"], where + ".x");
    region.y = interval_from(given["y"], where + ".y");
  }
  if (is_any(given["heading"])) {
    region.heading = any_heading;
  } else {
    const auto [from, to] = interval_from(given["heading"], where + ".heading");
    region.heading = {from, to};
  }
  if (!has(given, "either_way")) return;
  const val either_way = given["either_way"];
  if (!either_way.isTrue() && !either_way.isFalse()) {
    throw InputError(where + ".either_way", "expected true or false");
  }
  region.either_way = either_way.isTrue();
}

Interval hitch_angles_from(const val& given, const std::string& where, const Vehicle& vehicle) {
  if (!vehicle.trailer) throw InputError(where, "are given without a trailer");
  if (is_any(given)) return {-vehicle.max_hitch_angle, vehicle.max_hitch_angle};
  if (!given.isArray() || given["length"].as<std::size_t>() != 1) {
    throw InputError(where, "expected one angle for each trailer");
  }
  return interval_from(given[0], where);
}

GoalRegion region_from(const val& given, const std::string& where, const Vehicle& vehicle) {
  GoalRegion region;
  if (has(given, "trailer")) {
    allow_only(given, {"trailer", "curvature", "hitch_angles", "straight", "stop"}, where);
    if (!vehicle.trailer) throw InputError(where + ".trailer", "is given without a trailer");
    allow_only(given["trailer"], {"x", "y", "area", "heading", "either_way"}, where + ".trailer");
    region.is_of_trailer = true;
    read_axle(given["trailer"], where + ".trailer", region);
  } else {
    allow_only(given,
               {"x", "y", "area", "heading", "either_way", "curvature", "hitch_angles", "straight",
                "stop"},
               where);
    read_axle(given, where, region);
  }
  region.curvature = number_at(given, "curvature", where, 0.0);
  region.straight = number_at(given, "straight", where, 0.0);
  if (has(given, "hitch_angles")) {
    region.hitch_angle = hitch_angles_from(given["hitch_angles"], where + ".hitch_angles", vehicle);
  }
  return region;
}

std::vector<GoalRegion> set_from(const val& given, const std::string& where,
                                 const Vehicle& vehicle) {
  if (!has(given, "any_of")) return {region_from(given, where, vehicle)};
  allow_only(given, {"any_of", "stop"}, where);
  const val any_of = given["any_of"];
  if (!any_of.isArray()) throw InputError(where + ".any_of", "expected a list");
  std::vector<GoalRegion> set;
  const auto count = any_of["length"].as<std::size_t>();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string one = where + ".any_of[" + std::to_string(i) + "]";
    if (has(any_of[i], "stop")) throw InputError(one + ".stop", "is for entries of via alone");
    set.push_back(region_from(any_of[i], one, vehicle));
  }
  if (set.empty()) throw InputError(where + ".any_of", "is empty, expected at least one goal");
  return set;
}

}  // namespace

Goal goal_from(const val& given, const Vehicle& vehicle) {
  allow_only(given,
             {"x", "y", "heading", "curvature", "hitch_angles", "trailer", "area", "either_way",
              "any_of", "straight"},
             "goal");
  if (is_set(given)) return {.end = {}, .set = set_from(given, "goal", vehicle)};
  return {.end = end_from(given, "goal", vehicle), .set = {}};
}

std::vector<Via> via_at(const val& given, const Vehicle& vehicle) {
  std::vector<Via> all;
  if (!has(given, "via")) return all;
  const val list = given["via"];
  if (!list.isArray()) throw InputError("via", "expected a list");
  const auto count = list["length"].as<std::size_t>();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string where = "via[" + std::to_string(i) + "]";
    const val item = list[i];
    Via via{.any_of = set_from(item, where, vehicle)};
    if (has(item, "stop")) {
      const val stop = item["stop"];
      if (!stop.isTrue() && !stop.isFalse()) {
        throw InputError(where + ".stop", "expected true or false");
      }
      via.stop = stop.isTrue();
    }
    all.push_back(std::move(via));
  }
  return all;
}

val list_of(const std::vector<PassedVia>& passed) {
  val list = val::array();
  for (const auto& [s, pose] : passed) {
    val object = object_of(pose);
    object.set("s", s);
    list.call<void>("push", object);
  }
  return list;
}

val object_of(const std::optional<ReachedGoal>& goal) {
  if (!goal) return val::null();
  val object = object_of(goal->pose);
  object.set("index", static_cast<double>(goal->index));
  return object;
}

}  // namespace vandplan::web
