// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Functions for JavaScript. An InputError is returned as {error: {where, problem}}; functions.js
// throws it.

#include <emscripten/bind.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "bindings/web/core/site.h"
#include "bindings/web/core/values.h"
#include "bindings/web/core/yard.h"
#include "vandplan/input_error.h"
#include "vandplan/steering.h"
#include "vandplan/tables.h"
#include "vandplan/vehicle.h"
#include "vandplan/version.h"

namespace vandplan::web {
namespace {

/// Result of `work()`, or an object with the error of the input.
template <typename Work>
val guarded(Work work) {
  try {
    return work();
  } catch (const InputError& error) {
    val wrong = val::object();
    wrong.set("where", error.where());
    wrong.set("problem", error.problem());
    val object = val::object();
    object.set("error", wrong);
    return object;
  }
}

/// Objects that JavaScript knows by their numbers, until it closes them.
template <typename Kept>
class Opened {
 public:
  /// `name` stands in errors.
  explicit Opened(const char* name) : name_(name) {}

  /// Keeps an object and returns its number.
  val open(std::unique_ptr<Kept> object) {
    const auto free = std::ranges::find(objects_, nullptr);
    const auto number = free - objects_.begin();
    if (free == objects_.end()) objects_.emplace_back();
    objects_[static_cast<std::size_t>(number)] = std::move(object);
    return val(static_cast<double>(number));
  }

  Kept& at(std::size_t number) {
    if (number >= objects_.size() || !objects_[number]) throw InputError(name_, "is closed");
    return *objects_[number];
  }

  void close(std::size_t number) {
    if (number < objects_.size()) objects_[number].reset();
  }

 private:
  const char* name_;
  std::vector<std::unique_ptr<Kept>> objects_;
};

// ---- planning ----

Opened<Yard> yards("yard");

val open_yard(const val& scenario) {
  return guarded([&] { return yards.open(std::make_unique<Yard>(scenario)); });
}

void close_yard(std::size_t number) { yards.close(number); }

val plan_in(std::size_t yard, const val& query) {
  return guarded([&] { return yards.at(yard).plan(query); });
}

val check_in(std::size_t yard, const val& query) {
  return guarded([&] { return yards.at(yard).check(query); });
}

val drive_in(std::size_t yard, const val& query) {
  return guarded([&] { return yards.at(yard).drive(query); });
}

val is_free_in(std::size_t yard, const val& query) {
  return guarded([&] { return yards.at(yard).is_free(query); });
}

val site_table_in(std::size_t yard, const val& query, const val& progress) {
  return guarded([&] { return yards.at(yard).site_table(query, progress); });
}

// ---- tables of a site ----

Opened<ChangingSiteTable> changing_sites("changingSiteTable");

val open_site_in(std::size_t yard, const val& query, const val& progress) {
  return guarded([&] {
    return changing_sites.open(
        std::make_unique<ChangingSiteTable>(yards.at(yard).changing_site_table(query, progress)));
  });
}

void close_site(std::size_t number) { changing_sites.close(number); }

val repair_site(std::size_t number, const val& scenario) {
  return guarded([&] {
    changing_sites.at(number).repair(scenario_from(scenario));
    return val::null();
  });
}

/// Bytes of the table now.
val changed_site(std::size_t number) {
  return guarded([&] { return bytes_of(changing_sites.at(number).table()); });
}

/// The table with these bytes; the last one is kept.
std::shared_ptr<const SiteTable> site_from(const val& bytes) {
  static SiteReader reader;
  return reader.read(bytes);
}

val site_info(const val& bytes) {
  return guarded([&] { return object_of(*site_from(bytes)); });
}

val site_costs(const val& bytes, const val& poses, double goal) {
  return guarded([&] { return costs_of(*site_from(bytes), poses, goal); });
}

// ---- paths ----

/// Rows s, x, y, heading, curvature, direction, at most `step` metres apart.
val sampled_path(const val& given, double step) {
  return guarded([&] {
    if (!(step >= 1e-3)) throw InputError("step", "expected at least 0.001 m");
    std::vector<double> rows;
    for (const PathPoint& point : sampled(path_from(given), step)) {
      rows.insert(rows.end(), {point.s, point.pose.x, point.pose.y, point.pose.heading,
                               point.curvature, static_cast<double>(direction_of(point.gear))});
    }
    return array_of(std::span<const double>(rows));
  });
}

/// Rows t, s, x, y, heading, curvature, v of the fastest drive, at most `step` seconds apart.
val driven_path(const val& given, const val& vehicle, double step) {
  return guarded([&] { return rows_of_drive(path_from(given), vehicle_from(vehicle), {}, step); });
}

/// Rows x, y, heading of the trailer, at the places of `sampled_path` with this step.
val trailed_path(const val& given, const val& vehicle, double hitch_angle, double step) {
  return guarded([&] {
    if (!(step >= 1e-3)) throw InputError("step", "expected at least 0.001 m");
    const Path path = path_from(given);
    const Vehicle checked = vehicle_from(vehicle);
    if (!checked.trailer) throw InputError("vehicle.trailers", "are missing");
    const std::vector<double> angles = sampled_hitch_angles(checked, path, hitch_angle, step);
    std::vector<double> rows;
    std::size_t i = 0;
    for (const PathPoint& point : sampled(path, step)) {
      const Pose trailer = trailer_pose(checked, {point.pose, angles[i++]});
      rows.insert(rows.end(), {trailer.x, trailer.y, trailer.heading});
    }
    return array_of(std::span<const double>(rows));
  });
}

/// Pose and hitch angle after a segment.
val advanced(const val& given, const val& vehicle, double curvature, double length) {
  return guarded([&] {
    const Vehicle checked = vehicle_from(vehicle);
    const End end = end_from(given, "pose", checked);
    const Segment segment{curvature, length};
    val object = object_of(advance(end.pose, segment));
    if (!checked.trailer) return object;
    val angles = val::array();
    angles.set(0, hitch_angle_after(checked, end.hitch_angle, segment));
    object.set("hitch_angles", angles);
    return object;
  });
}

// ---- open ground ----

double radius_from(double radius) {
  if (!(radius > 0 && radius <= 1e4)) throw InputError("radius", "expected 0 to 10000 m");
  return radius;
}

/// Paths of all words that join two poses, shortest first.
val words_between(const val& from, const val& to, double radius, bool reverse) {
  return guarded([&] {
    const Pose begin = pose_from(from, "from");
    const Pose end = pose_from(to, "to");
    std::vector<Piece> words = reverse ? reeds_shepp_words(begin, end, radius_from(radius))
                                       : dubins_words(begin, end, radius_from(radius));
    std::ranges::stable_sort(words, {}, &Piece::length);
    val list = val::array();
    for (std::size_t i = 0; i < words.size(); ++i) list.set(i, list_of(words[i].view()));
    return list;
  });
}

/// Shortest path between two poses.
val steered(const val& from, const val& to, double radius, bool reverse) {
  return guarded([&] {
    const Pose begin = pose_from(from, "from");
    const Pose end = pose_from(to, "to");
    const Piece piece = reverse ? reeds_shepp(begin, end, radius_from(radius))
                                : dubins(begin, end, radius_from(radius));
    return list_of(piece.view());
  });
}

/// Lengths from each node to one sample by a measure [m].
void measure_all(const std::string& measure, const PoseColumns& nodes, const Pose& sample,
                 double radius, std::span<float> out) {
  if (measure == "reeds-shepp") {
    reeds_shepp_lengths(nodes, sample, radius, out);
  } else if (measure == "euclid") {
    for (std::size_t i = 0; i < out.size(); ++i) {
      const float dx = nodes.x[i] - static_cast<float>(sample.x);
      const float dy = nodes.y[i] - static_cast<float>(sample.y);
      out[i] = std::sqrt(dx * dx + dy * dy);
    }
  } else if (measure == "bound") {
    std::vector<float> high(out.size());
    length_bounds(nodes, sample, radius, out, high);
  } else if (measure.size() == 6 && measure.starts_with("hlut-") && measure[5] >= '1' &&
             measure[5] <= '4') {
    thesis_table(measure[5] - '0').distances(nodes, sample, radius, out);
  } else {
    throw InputError("measure", "expected euclid, hlut-1 to hlut-4, bound or reeds-shepp");
  }
}

/// Lengths from nodes to a sample. `columns`: x, y and heading of equal sizes.
val distances(const std::string& measure, const val& columns, const val& sample, double radius) {
  return guarded([&] {
    const auto x = emscripten::convertJSArrayToNumberVector<float>(columns["x"]);
    const auto y = emscripten::convertJSArrayToNumberVector<float>(columns["y"]);
    const auto heading = emscripten::convertJSArrayToNumberVector<float>(columns["heading"]);
    if (x.size() != y.size() || x.size() != heading.size()) {
      throw InputError("nodes", "expected as many x as y and headings");
    }
    std::vector<float> out(x.size());
    measure_all(measure, {x, y, heading}, pose_from(sample, "sample"), radius_from(radius), out);
    return array_of(std::span<const float>(out));
  });
}

// ---- planners and prices ----

val options_of(const Planner& planner) {
  val list = val::array();
  for (std::size_t i = 0; i < planner.options.size(); ++i) {
    const OptionInfo& option = planner.options[i];
    val object = val::object();
    object.set("name", option.name);
    object.set("summary", option.summary);
    object.set("standard", json_of(option.default_value));
    object.set("range", option.range());
    list.set(i, object);
  }
  return list;
}

val all_planners() {
  val list = val::array();
  for (const Planner& planner : planners()) {
    val object = val::object();
    object.set("name", planner.name);
    object.set("summary", planner.summary);
    object.set("family", planner.properties.family);
    object.set("estimate", planner.properties.estimate);
    val capabilities = val::array();
    for (const std::string_view name : names_of(planner.properties.capabilities)) {
      capabilities.call<void>("push", std::string(name));
    }
    object.set("capabilities", capabilities);
    // As version 0.2.0 had them.
    object.set("honours_prices", planner.can(Capability::prices));
    object.set("honours_gears", planner.can(Capability::gears));
    object.set("honours_steering", planner.can(Capability::steering));
    object.set("proves", planner.can(Capability::target_gap));
    object.set("options", options_of(planner));
    list.call<void>("push", object);
  }
  return list;
}

/// The prices of a style for a vehicle.
val prices(const std::string& style, const val& vehicle) {
  return guarded([&] {
    const CostOptions prices = prices_of(style_named(style), vehicle_from(vehicle));
    val object = val::object();
    object.set("forward_weight", *prices.forward_weight);
    object.set("reverse_weight", *prices.reverse_weight);
    object.set("gear_change_cost", *prices.gear_change_cost);
    object.set("curvature_change_cost", *prices.curvature_change_cost);
    object.set("clearance_weight", *prices.clearance_weight);
    object.set("clearance_distance", *prices.clearance_distance);
    return object;
  });
}

std::string version() { return std::string(build_info().version); }

}  // namespace

EMSCRIPTEN_BINDINGS(vandplan) {
  using emscripten::function;
  function("version", &version);
  function("planners", &all_planners);
  function("prices", &prices);
  function("openYard", &open_yard);
  function("closeYard", &close_yard);
  function("planIn", &plan_in);
  function("checkIn", &check_in);
  function("driveIn", &drive_in);
  function("isFreeIn", &is_free_in);
  function("siteTableIn", &site_table_in);
  function("openSiteIn", &open_site_in);
  function("closeSite", &close_site);
  function("repairSite", &repair_site);
  function("changedSite", &changed_site);
  function("siteInfo", &site_info);
  function("siteCosts", &site_costs);
  function("sampledPath", &sampled_path);
  function("drivenPath", &driven_path);
  function("trailedPath", &trailed_path);
  function("advanced", &advanced);
  function("wordsBetween", &words_between);
  function("steered", &steered);
  function("distances", &distances);
}

}  // namespace vandplan::web
