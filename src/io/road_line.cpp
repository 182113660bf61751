// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/road_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/ground.h"
#include "io/roads.h"

namespace vandplan::io {
namespace {

Cubic cubic_from(const XmlFile& file, const XmlNode& node) {
  return {file.number(node, "a"), file.number(node, "b"), file.number(node, "c"),
          file.number(node, "d")};
}

/// Length of the graph of a cubic from 0 to `u`: Gauss and Legendre's rule on equal parts.
double graph_length(const Cubic& cubic, double u) {
  constexpr std::array<double, 3> places = {0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> weights = {0.5688888888888889, 0.4786286704993665,
                                             0.2369268850561891};
  constexpr int count = 16;
  const double half = u / (2 * count);
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double middle = (2 * i + 1) * half;
    const auto speed = [&](double x) { return std::hypot(1.0, cubic.slope_at(x)); };
    sum += weights[0] * speed(middle);
    for (std::size_t k = 1; k < places.size(); ++k) {
      sum += weights[k] * (speed(middle - places[k] * half) + speed(middle + places[k] * half));
    }
  }
  return sum * half;
}

/// The u at which the graph of a cubic has a length, by Newton's method.
double u_after(const Cubic& cubic, double length) {
  double u = length / std::hypot(1.0, cubic.slope_at(0.0));
  for (int i = 0; i < 20; ++i) {
    const double excess = graph_length(cubic, u) - length;
    if (std::abs(excess) < 1e-10) break;
    u -= excess / std::hypot(1.0, cubic.slope_at(u));
  }
  return u;
}

}  // namespace

CubicLine::CubicLine(const XmlFile& file, const XmlNode& parent, const char* name, const char* from,
                     double start) {
  for (const XmlNode node : parent.children(name)) {
    const double s = start + file.number(node, from);
    if (!pieces_.empty() && s < pieces_.back().s) {
      file.fail(node, fmt::format("has {} {}, expected at least that of the {} before", from,
                                  file.number(node, from), name));
    }
    pieces_.push_back({s, cubic_from(file, node)});
  }
}

double CubicLine::at(double s) const {
  const auto next =
      std::find_if(pieces_.begin(), pieces_.end(), [&](const Piece& piece) { return piece.s > s; });
  if (next == pieces_.begin()) return 0.0;
  const Piece& piece = *std::prev(next);
  return piece.cubic.at(s - piece.s);
}

void CubicLine::add_begins(std::vector<double>& distances) const {
  for (const Piece& piece : pieces_) distances.push_back(piece.s);
}

SpeedLimits::SpeedLimits(const XmlFile& file, const XmlNode& road) {
  for (const XmlNode type : road.children("type")) {
    add(file, file.number(type, "s"), type.child("speed"));
  }
}

SpeedLimits::SpeedLimits(const XmlFile& file, const XmlNode& lane, double begin,
                         const SpeedLimits& of_road)
    : pieces_(of_road.pieces_) {
  const XmlNode first = lane.child("speed");
  if (!first) return;
  const double until = begin + file.number(first, "sOffset");
  std::erase_if(pieces_, [&](const Piece& piece) { return piece.s >= until; });
  for (const XmlNode speed : lane.children("speed")) {
    add(file, begin + file.number(speed, "sOffset"), speed);
  }
}

void SpeedLimits::add(const XmlFile& file, double s, const XmlNode& speed) {
  if (!pieces_.empty() && s < pieces_.back().s) {
    file.fail(speed, fmt::format("holds from s = {}, expected at least that of the one before, {}",
                                 s, pieces_.back().s));
  }
  std::optional<double> limit;
  if (speed && !is_any_of(speed.attribute("max").value(), {"no limit", "undefined"})) {
    const std::string_view unit = speed.attribute("unit").value();
    const double number = file.number(speed, "max");
    limit = speed_from(number, unit.empty() ? "m/s" : unit);
    if (!limit) {
      file.fail(speed, fmt::format("has max {} and unit \"{}\", expected a positive number of m/s, "
                                   "mph or km/h",
                                   number, unit));
    }
  }
  pieces_.push_back({s, limit});
}

std::optional<double> SpeedLimits::at(double s) const {
  std::optional<double> limit;
  for (const Piece& piece : pieces_) {
    if (piece.s <= s) limit = piece.limit;
  }
  return limit;
}

void SpeedLimits::add_begins(std::vector<double>& distances) const {
  for (const Piece& piece : pieces_) distances.push_back(piece.s);
}

Point beside(const Pose& on_line, double t) {
  return rounded(
      {on_line.x - t * std::sin(on_line.heading), on_line.y + t * std::cos(on_line.heading)});
}

RoadLine::RoadLine(const XmlFile& file, const XmlNode& road) {
  const XmlNode view = file.child(road, "planView");
  for (const XmlNode geometry : view.children("geometry")) {
    Piece piece = piece_from(file, geometry);
    if (!pieces_.empty() && piece.s < pieces_.back().s) {
      file.fail(geometry, fmt::format("has s {}, expected at least {}, that of the geometry before",
                                      piece.s, pieces_.back().s));
    }
    pieces_.push_back(piece);
  }
  if (pieces_.empty()) file.fail(view, "has no geometry, expected one at least");
}

double RoadLine::length() const { return pieces_.back().s + pieces_.back().length; }

Pose RoadLine::at(double s) const {
  const auto next = std::find_if(pieces_.begin() + 1, pieces_.end(),
                                 [&](const Piece& piece) { return piece.s > s; });
  const Piece& piece = *std::prev(next);
  return piece.at(std::clamp(s - piece.s, 0.0, piece.length));
}

void RoadLine::add_begins(std::vector<double>& distances) const {
  for (const Piece& piece : pieces_) distances.push_back(piece.s);
}

Pose RoadLine::Piece::at(double distance) const {
  if (!is_cubic) return advance(begin, {curvature, distance, curvature_rate});
  const double p = scale > 0.0 ? distance * scale : u_after(v, distance);
  return compose(begin, {u.at(p), v.at(p), std::atan2(v.slope_at(p), u.slope_at(p))});
}

RoadLine::Piece RoadLine::piece_from(const XmlFile& file, const XmlNode& geometry) {
  Piece piece;
  piece.s = file.number(geometry, "s");
  piece.length = file.number(geometry, "length");
  piece.begin = {file.number(geometry, "x"), file.number(geometry, "y"),
                 file.number(geometry, "hdg")};
  if (!(piece.length >= 0.0 && piece.length <= 1e6)) {
    file.fail(geometry, fmt::format("has length {}, expected 0 to 1000000 m", piece.length));
  }
  if (const XmlNode arc = geometry.child("arc")) {
    piece.curvature = file.number(arc, "curvature");
  } else if (const XmlNode spiral = geometry.child("spiral")) {
    piece.curvature = file.number(spiral, "curvStart");
    const double change = file.number(spiral, "curvEnd") - piece.curvature;
    piece.curvature_rate = piece.length > 0.0 ? change / piece.length : 0.0;
  } else if (const XmlNode curve = geometry.child("paramPoly3")) {
    piece.is_cubic = true;
    piece.u = {file.number(curve, "aU"), file.number(curve, "bU"), file.number(curve, "cU"),
               file.number(curve, "dU")};
    piece.v = {file.number(curve, "aV"), file.number(curve, "bV"), file.number(curve, "cV"),
               file.number(curve, "dV")};
    const bool by_length = curve.attribute("pRange").value() == std::string_view("arcLength");
    piece.scale = by_length || piece.length == 0.0 ? 1.0 : 1.0 / piece.length;
  } else if (const XmlNode graph = geometry.child("poly3")) {
    piece.is_cubic = true;
    piece.u = {0.0, 1.0, 0.0, 0.0};
    piece.v = cubic_from(file, graph);
    piece.scale = 0.0;
  } else if (!geometry.child("line")) {
    file.fail(geometry,
              "is of no known kind, expected line, arc, spiral, paramPoly3 or poly3 in it");
  }
  return piece;
}

}  // namespace vandplan::io
