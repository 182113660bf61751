// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/speeds_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace vandplan::io {
namespace {

/// A number, 0 if it is missing.
double number_or_zero(const Document& file, const Node& node, std::string_view key) {
  const Node* const found = file.find(node, key);
  return found == nullptr ? 0.0 : file.number(*found);
}

}  // namespace

SpeedProfile speeds_from(const Document& file, const Node& node) {
  SpeedProfile speeds;
  speeds.duration = file.number(file.at(node, "duration"));
  const Node& knots = file.at(node, "knots");
  for (const Node& item : file.list(knots, "a list of knots")) {
    speeds.knots.push_back({.t = file.number(file.at(item, "t")),
                            .s = file.number(file.at(item, "s")),
                            .v = file.number(file.at(item, "v")),
                            .a = file.number(file.at(item, "a")),
                            .jerk = number_or_zero(file, item, "jerk")});
  }
  if (speeds.knots.empty()) file.fail(knots, "is empty, expected at least one knot");
  if (const double first = speeds.knots.front().t; first != 0.0) {
    file.fail(knots, fmt::format("begin at {} s, expected 0 s", first));
  }
  const Node* const stops = file.find(node, "stops");
  if (stops == nullptr) return speeds;
  for (const Node& item : file.list(*stops, "a list of stops")) {
    speeds.stops.push_back({.t = file.number(file.at(item, "t")),
                            .s = file.number(file.at(item, "s")),
                            .pause = file.number(file.at(item, "pause")),
                            .curvature_before = number_or_zero(file, item, "curvature_before"),
                            .curvature_after = number_or_zero(file, item, "curvature_after")});
    speeds.standing += speeds.stops.back().pause;
  }
  return speeds;
}

nlohmann::ordered_json json_of(const SpeedProfile& speeds) {
  using Value = nlohmann::ordered_json;
  Value knots = Value::array();
  for (const SpeedKnot& knot : speeds.knots) {
    Value json = {{"t", knot.t}, {"s", knot.s}, {"v", knot.v}, {"a", knot.a}};
    if (knot.jerk != 0.0) json["jerk"] = knot.jerk;
    knots.push_back(std::move(json));
  }
  Value stops = Value::array();
  for (const Stop& stop : speeds.stops) {
    stops.push_back({{"t", stop.t},
                     {"s", stop.s},
                     {"pause", stop.pause},
                     {"curvature_before", stop.curvature_before},
                     {"curvature_after", stop.curvature_after}});
  }
  return {{"duration", speeds.duration}, {"stops", std::move(stops)}, {"knots", std::move(knots)}};
}

}  // namespace vandplan::io
