// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a stretch driven with limited jerk?

#include <algorithm>
#include <cmath>
#include <utility>

#include "speed/smooth_motion.h"
#include "speed/stretch.h"

namespace vandplan::speed {
namespace {

/// Part of the path with a constant largest speed.
struct Zone {
  double begin;  // begin of the zone [m]
  double end;    // end of the zone [m]
  double v;      // largest speed [m/s]
  SpeedBound bound;
};

/// Place and speed of a moment without acceleration.
struct Anchor {
  double s;  // place [m]
  double v;  // speed [m/s]
};

/// Change from a low to a high speed, without acceleration at either end. A descent is a ramp in
/// reverse.
class Ramp {
 public:
  Ramp(double low, double high, double acceleration, double jerk)
      : low_(low), high_(high), jerk_(jerk) {
    const double gain = high - low;
    peak_ = std::min(acceleration, std::sqrt(jerk * gain));
    bend_ = peak_ / jerk;
    hold_ = peak_ > 0.0 ? std::max(gain / peak_ - bend_, 0.0) : 0.0;
  }

  [[nodiscard]] double peak() const { return peak_; }
  [[nodiscard]] double bend() const { return bend_; }
  [[nodiscard]] double hold() const { return hold_; }

  /// Length of the ramp [m]: the speeds are symmetric about their mean.
  [[nodiscard]] double length() const { return (low_ + high_) / 2 * (2 * bend_ + hold_); }

  /// Distance from the slow end at which the speed is `v` [m].
  [[nodiscard]] double length_to(double v) const {
    if (v <= low_) return 0.0;
    if (v >= high_) return length();
    const double bent = peak_ * bend_ / 2;  // gain of speed in the first bend [m/s]
    if (v <= low_ + bent) return bend_from(low_, std::sqrt(2 * (v - low_) / jerk_));
    // The last bend mirrors the first one.
    if (v >= high_ - bent) {
      const double left = std::sqrt(2 * (high_ - v) / jerk_);
      return length() - left * (high_ - jerk_ * left * left / 6);
    }
    const double held = (v - low_ - bent) / peak_;
    return bend_from(low_, bend_) + held * (low_ + bent + v) / 2;
  }

 private:
  [[nodiscard]] double bend_from(double v, double t) const { return t * (v + jerk_ * t * t / 6); }

  double low_, high_, jerk_;
  double peak_;  // largest acceleration [m/s^2]
  // Time in which the acceleration grows to `peak_`, and in which it vanishes again [s].
  double bend_;
  double hold_;  // time for which the acceleration stays at `peak_` [s]
};

/// Drive from anchor `from` up to speed `top`, along at that speed, and down to anchor `to`.
struct Hump {
  Anchor from;
  Anchor to;
  double top;
  Ramp up;
  Ramp down;
};

/// Builds the drive of a stretch from humps.
class Smoother {
 public:
  Smoother(std::vector<Zone> zones, const DrivingLimits& limits, std::vector<SpeedKnot>& knots)
      : zones_(std::move(zones)),
        gain_(limits.max_acceleration),
        loss_(limits.max_braking.value_or(limits.max_acceleration)),
        jerk_(*limits.max_jerk),
        knots_(knots) {}

  /// Appends the drive between two anchors; one must exist.
  void drive(const Anchor& from, const Anchor& to) {
    if (!(from.s < to.s)) return;
    const Hump hump = highest(from, to);
    const double begin = from.s + hump.up.length();  // begin of the level part [m]
    const double end = to.s - hump.down.length();
    if (!(end - begin > rounding * (to.s - from.s))) {
      add(hump, begin);
    } else if (!drive_beside_low_zones(hump, begin, end)) {
      // No zone limits the level part, so one limits a ramp: the drive goes on from the end of the
      // ramp.
      if (from.s < begin || end < to.s) {
        climb(from, hump.up);
        drive({begin, hump.top}, {end, hump.top});
        descend({end, hump.top}, hump.down);
      } else {
        add(hump, begin);
      }
    }
  }

  [[nodiscard]] double duration() const { return t_; }

 private:
  static constexpr double rounding = 1e-9;
  // Halvings in the search for a top speed, which may be tiny.
  static constexpr int most_halvings = 500;

  [[nodiscard]] Hump hump(const Anchor& from, const Anchor& to, double top) const {
    return {from, to, top, Ramp(from.v, top, gain_, jerk_), Ramp(to.v, top, loss_, jerk_)};
  }

  /// Whether a hump fits between its anchors and below the zones.
  [[nodiscard]] bool fits(const Hump& hump) const {
    const double room = hump.to.s - hump.from.s;
    if (hump.up.length() + hump.down.length() > room) return false;
    for (auto zone = first_zone(hump.from.s); zone != zones_.end() && zone->begin < hump.to.s;
         ++zone) {
      if (zone->v >= hump.top) continue;
      const bool is_before = zone->end <= hump.from.s + hump.up.length_to(zone->v);
      const bool is_behind = zone->begin >= hump.to.s - hump.down.length_to(zone->v);
      if (!is_before && !is_behind) return false;
    }
    return true;
  }

  /// Highest hump that fits, found by bisection.
  [[nodiscard]] Hump highest(const Anchor& from, const Anchor& to) const {
    double low = std::max(from.v, to.v);
    double high = low;
    for (auto zone = first_zone(from.s); zone != zones_.end() && zone->begin < to.s; ++zone) {
      high = std::max(high, zone->v);
    }
    if (fits(hump(from, to, high))) return hump(from, to, high);
    for (int i = 0; i < most_halvings && high - low > 1e-12 * high; ++i) {
      const double middle = (low + high) / 2;
      (fits(hump(from, to, middle)) ? low : high) = middle;
    }
    return hump(from, to, low);
  }

  /// First zone that ends behind `s` [m].
  [[nodiscard]] std::vector<Zone>::const_iterator first_zone(double s) const {
    return std::ranges::upper_bound(zones_, s, {}, &Zone::end);
  }

  /// If zones limit the level part of a hump, the drive is level there and may be faster beside
  /// them. Returns false, and appends nothing, if there are no such zones.
  bool drive_beside_low_zones(const Hump& hump, double begin, double end) {
    Anchor last = hump.from;
    bool is_low = false;
    for (auto zone = first_zone(begin); zone != zones_.end() && zone->begin < end; ++zone) {
      if (zone->v > hump.top * (1 + rounding)) continue;
      is_low = true;
      const double first = std::max(zone->begin, begin);
      drive(last, {first, hump.top});
      last = {std::min(zone->end, end), hump.top};
      level(first, last.s, hump.top, zone->bound);
    }
    if (is_low) drive(last, hump.to);
    return is_low;
  }

  void add(const Hump& hump, double begin) {
    const double end = hump.to.s - hump.down.length();
    climb(hump.from, hump.up);
    level(begin, end, hump.top, SpeedBound::jerk);
    descend({end, hump.top}, hump.down);
  }

  void level(double begin, double end, double v, SpeedBound bound) {
    if (!(begin < end)) return;
    knots_.push_back({t_, begin, v, 0.0, 0.0, bound});
    t_ += (end - begin) / v;
  }

  void climb(const Anchor& from, const Ramp& ramp) {
    phases(from, ramp, 1.0, SpeedBound::acceleration);
  }
  void descend(const Anchor& from, const Ramp& ramp) {
    phases(from, ramp, -1.0, SpeedBound::braking);
  }

  /// Appends three phases: the acceleration grows, stays and vanishes.
  void phases(const Anchor& from, const Ramp& ramp, double sign, SpeedBound bound) {
    SpeedKnot knot{t_, from.s, from.v, 0.0, sign * jerk_, SpeedBound::jerk};
    const auto pass = [&](double duration) {
      if (!(duration > 0.0)) return;
      knots_.push_back(knot);
      knot.s += duration * (knot.v + duration * (knot.a / 2 + duration * knot.jerk / 6));
      knot.v += duration * (knot.a + duration * knot.jerk / 2);
      knot.t += duration;
    };
    pass(ramp.bend());
    knot = {knot.t, knot.s, knot.v, sign * ramp.peak(), 0.0, bound};
    pass(ramp.hold());
    knot = {knot.t, knot.s, knot.v, sign * ramp.peak(), -sign * jerk_, SpeedBound::jerk};
    pass(ramp.bend());
    t_ = knot.t;
  }

  std::vector<Zone> zones_;
  double gain_, loss_, jerk_;
  std::vector<SpeedKnot>& knots_;
  double t_ = 0.0;
};

/// Zones below caps. A cap that is not level becomes as many zones as keep speeds within 2 % of it.
std::vector<Zone> zones_below(std::span<const Cap> caps) {
  constexpr double step = 0.02;
  constexpr double most = 400;
  std::vector<Zone> zones;
  for (const Cap& cap : caps) {
    const double ratio = std::max(cap.first, cap.last) / std::min(cap.first, cap.last);
    const double count = std::clamp(std::ceil(std::log(ratio) / (2 * step)), 1.0, most);
    const double length = cap.end - cap.begin;
    for (double i = 0; i < count; ++i) {
      const double begin = cap.begin + length * (i / count);
      const double end = i + 1 < count ? cap.begin + length * ((i + 1) / count) : cap.end;
      const double first = cap.first + (cap.last - cap.first) * (i / count);
      const double last = cap.first + (cap.last - cap.first) * ((i + 1) / count);
      const double v = std::sqrt(std::min(first, last));
      if (!(begin < end)) continue;
      if (!zones.empty() && zones.back().v == v && zones.back().bound == cap.bound) {
        zones.back().end = end;
      } else {
        zones.push_back({begin, end, v, cap.bound});
      }
    }
  }
  return zones;
}

}  // namespace

double drive_stretch_smoothly(std::span<const Cap> caps, const DrivingLimits& limits,
                              std::vector<SpeedKnot>& knots) {
  SmoothDrive drive;
  Smoother smoother(zones_below(caps), limits, drive.knots);
  smoother.drive({caps.front().begin, 0.0}, {caps.back().end, 0.0});
  drive.duration = smoother.duration();
  // Below a single level cap a hump is the fastest drive.
  if (caps.size() > 1) drive = made_faster(std::move(drive), caps, limits);
  knots.insert(knots.end(), drive.knots.begin(), drive.knots.end());
  return drive.duration;
}

}  // namespace vandplan::speed
