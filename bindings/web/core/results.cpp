// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// JavaScript objects of plans and of the judge's verdicts.

#include <cstdint>
#include <optional>

#include "bindings/web/core/values.h"

namespace vandplan::web {
namespace {

val number_or_null(const std::optional<double>& number) {
  return number ? val(*number) : val::null();
}

val tree_of(const TreeSnapshot& tree) {
  std::vector<double> poses;
  poses.reserve(3 * tree.poses.size());
  for (const Pose& pose : tree.poses) poses.insert(poses.end(), {pose.x, pose.y, pose.heading});
  val object = val::object();
  object.set("poses", array_of(std::span<const double>(poses)));
  object.set("parents", array_of(std::span<const std::int32_t>(tree.parents)));
  return object;
}

val object_of(const std::optional<Hit>& hit) {
  if (!hit) return val::null();
  val object = val::object();
  object.set("what", std::string(name_of(hit->kind)));
  if (has_index(hit->kind)) {
    object.set("index", static_cast<double>(hit->index));
  }
  if (!hit->cell) return object;
  val cell = val::object();
  cell.set("x", hit->cell->x);
  cell.set("y", hit->cell->y);
  object.set("cell", cell);
  return object;
}

}  // namespace

val object_of(const PathCheck& check) {
  val object = val::object();
  object.set("valid", check.valid);
  object.set("reason", check.reason);
  object.set("hit", object_of(check.hit));
  object.set("at", check.at ? object_of(check.at->pose) : val::null());
  object.set("length", check.length);
  object.set("reverse_length", check.reverse_length);
  object.set("gear_changes", check.gear_changes);
  object.set("largest_hitch_angle", check.largest_hitch_angle);
  object.set("curvature_change", check.curvature_change);
  object.set("clearance", number_or_null(check.clearance));
  return object;
}

val object_of(const PlanResult& result) {
  val object = val::object();
  object.set("status", std::string(name_of(result.status)));
  object.set("reason", result.reason);
  object.set("hit", object_of(result.hit));
  object.set("path", result.path ? object_of(*result.path) : val::null());
  object.set("goal", object_of(result.goal));
  object.set("via", list_of(result.via));
  object.set("cost", result.path ? val(result.cost) : val::null());
  object.set("lower_bound", result.lower_bound ? val(*result.lower_bound) : val::null());
  object.set("iterations", static_cast<double>(result.iterations));
  object.set("time", result.time_total);
  val trace = val::array();
  for (std::size_t i = 0; i < result.anytime.size(); ++i) {
    val sample = val::object();
    sample.set("time", result.anytime[i].time);
    sample.set("iteration", static_cast<double>(result.anytime[i].iteration));
    sample.set("cost", result.anytime[i].cost);
    trace.set(i, sample);
  }
  object.set("anytime", trace);
  val counters = val::object();
  for (const Counter& counter : result.counters) {
    counters.set(counter.name, static_cast<double>(counter.value));
  }
  object.set("counters", counters);
  object.set("tree", result.tree ? tree_of(*result.tree) : val::null());
  object.set("check", result.check ? object_of(*result.check) : val::null());
  object.set("duration", result.speeds ? val(result.speeds->duration) : val::null());
  return object;
}

}  // namespace vandplan::web
