// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "drive/stroke.h"

#include <algorithm>
#include <cmath>

#include "base/trigonometry.h"

namespace vandplan::driving {
namespace {

/// Distance between samples of a clothoid [m]. An arc between two samples has an error of rate *
/// spacing^3 / 12, which is some micrometres.
double spacing_of(double rate) { return 0.05 * std::sqrt(std::sqrt(0.1 / std::abs(rate))); }

/// Time after a knot at which the drive is at place `s` [s].
double time_at(const SpeedKnot& knot, double duration, double s) {
  double low = 0.0;
  double high = duration;
  for (int i = 0; i < 40; ++i) {
    const double t = (low + high) / 2;
    const double there = knot.s + t * (knot.v + t * (knot.a / 2 + t * knot.jerk / 6));
    (there < s ? low : high) = t;
  }
  return (low + high) / 2;
}

}  // namespace

Stroke::Stroke(const Pose& start, double s)
    : begin_(s), end_(start), samples_{{0.0, start, 0.0, 0.0}} {}

void Stroke::add(const Segment& segment) {
  const double size = std::abs(segment.length);
  direction_ = segment.length < 0.0 ? -1 : 1;
  const double s = length();
  samples_.pop_back();
  const double rate = segment.curvature_rate;
  const double count = rate == 0.0 ? 1.0 : std::max(std::ceil(size / spacing_of(rate)), 1.0);
  for (double i = 0.0; i < count; ++i) {
    const double driven = size * (i / count);
    samples_.push_back({s + driven, advance(end_, part_of(segment, 0.0, driven)),
                        vandplan::curvature_at(segment, driven), rate});
  }
  end_ = advance(end_, segment);
  samples_.push_back({s + size, end_, vandplan::curvature_at(segment, size), 0.0});
}

const Stroke::Sample& Stroke::before(double s) const noexcept {
  const auto later = std::ranges::upper_bound(samples_, s, {}, &Sample::s);
  return later == samples_.begin() ? *later : *std::prev(later);
}

double Stroke::curvature_at(double s) const noexcept {
  const Sample& sample = before(s);
  return sample.curvature + sample.rate * std::max(s - sample.s, 0.0);
}

StrokePlace Stroke::at(double s) const noexcept {
  const Sample& sample = before(s);
  const double driven = s - sample.s;
  const double rate = driven > 0.0 ? sample.rate : 0.0;
  const Segment arc{sample.curvature + rate * driven / 2, direction_ * driven};
  return {s, advance(sample.pose, arc), sample.curvature + rate * driven};
}

Offset Stroke::offset_of(const Pose& pose, double guess) const noexcept {
  constexpr int most_rounds = 10;
  constexpr double enough = 1e-8;  // largest error of the nearest place [m]
  Offset offset;
  double s = guess;
  for (int i = 0; i < most_rounds; ++i) {
    offset.place = at(s);
    const Pose& there = offset.place.pose;
    const auto [sin, cos] = base::sin_cos(there.heading);
    const double dx = pose.x - there.x;
    const double dy = pose.y - there.y;
    offset.lateral = dy * cos - dx * sin;
    const double ahead = direction_ * (dx * cos + dy * sin);
    if (std::abs(ahead) <= enough) break;
    // The nearest place moves faster than the pose inside of a turn, and slower outside.
    s += ahead / std::max(1 - offset.place.curvature * offset.lateral, 0.2);
  }
  offset.heading = wrap_angle(pose.heading - offset.place.pose.heading);
  return offset;
}

double Stroke::speed_at(double s) const noexcept {
  if (knots_.empty()) return 0.0;
  const double on_path = begin_ + std::max(s, 0.0);
  const auto later =
      std::ranges::upper_bound(knots_, on_path, {}, [](const Knot& each) { return each.knot.s; });
  const auto& [knot, duration] = later == knots_.begin() ? *later : *std::prev(later);
  if (knot.jerk == 0.0) {
    return std::sqrt(std::max(knot.v * knot.v + 2 * knot.a * (on_path - knot.s), 0.0));
  }
  const double t = time_at(knot, duration, on_path);
  return std::max(knot.v + t * (knot.a + t * knot.jerk / 2), 0.0);
}

std::vector<Stroke> strokes_of(const Path& path, const SpeedProfile& profile) {
  constexpr double rounding = 1e-9;  // relative rounding error of a place
  std::vector<Stroke> strokes = {Stroke(path.start, 0.0)};
  auto stop = profile.stops.begin();
  double s = 0.0;
  for (const Segment& segment : merged(path.segments)) {
    for (; stop != profile.stops.end() && stop->s <= s + rounding * (1 + s); ++stop) {
      if (stop->s > 0.0) strokes.emplace_back(strokes.back().end(), s);
    }
    strokes.back().add(segment);
    s += std::abs(segment.length);
  }
  std::size_t at = 0;
  for (std::size_t i = 0; i + 1 < profile.knots.size(); ++i) {
    const SpeedKnot& knot = profile.knots[i];
    if (knot.bound == SpeedBound::standing) continue;
    while (at + 1 < strokes.size() && knot.s >= strokes[at + 1].begin() - rounding * (1 + s)) ++at;
    strokes[at].add(knot, profile.knots[i + 1].t - knot.t);
  }
  return strokes;
}

}  // namespace vandplan::driving
