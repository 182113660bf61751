// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "speed/smooth_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "speed/smooth_optimum.h"

namespace vandplan::speed {
namespace {

constexpr std::size_t section = 30;  // number of phases whose jerks are corrected together

/// Places of a stretch [m], with the squared speed of a drive and the largest one [m^2/s^2].
struct Places {
  std::vector<double> s, u, most;

  void add(double place, double v, double largest) {
    s.push_back(place);
    u.push_back(v * v);
    most.push_back(largest);
  }
  void remove_last() {
    s.pop_back();
    u.pop_back();
    most.pop_back();
  }
};

/// State of the motion `t` seconds after a knot.
SpeedKnot later(SpeedKnot knot, double t) {
  knot.t += t;
  knot.s += t * (knot.v + t * (knot.a / 2 + t * knot.jerk / 6));
  knot.v += t * (knot.a + t * knot.jerk / 2);
  knot.a += t * knot.jerk;
  return knot;
}

/// Time after `knot` at which the drive is at `s` [s], within a phase of `duration` seconds. The
/// speed must not be negative.
double time_to(const SpeedKnot& knot, double duration, double s) {
  double low = 0.0;
  double high = duration;
  for (int i = 0; i < 60 && low < high; ++i) {
    const double middle = (low + high) / 2;
    (later(knot, middle).s < s ? low : high) = middle;
  }
  return high;
}

/// States of a drive, at increasing times and at increasing places.
class Follower {
 public:
  explicit Follower(const SmoothDrive& drive) : drive_(drive) {}

  [[nodiscard]] SpeedKnot at_time(double t) {
    while (i_ + 1 < drive_.knots.size() && drive_.knots[i_ + 1].t <= t) ++i_;
    return later(drive_.knots[i_], t - drive_.knots[i_].t);
  }
  [[nodiscard]] SpeedKnot at_place(double s) {
    while (j_ + 1 < drive_.knots.size() && drive_.knots[j_ + 1].s <= s) ++j_;
    const double end = j_ + 1 < drive_.knots.size() ? drive_.knots[j_ + 1].t : drive_.duration;
    return later(drive_.knots[j_], time_to(drive_.knots[j_], end - drive_.knots[j_].t, s));
  }

 private:
  const SmoothDrive& drive_;
  std::size_t i_ = 0;  // index of the knot before the last time
  std::size_t j_ = 0;  // index of the knot before the last place
};

/// Whether two neighbouring caps differ by more than tangents of one limit do.
bool jumps(const Cap& before, const Cap& next) {
  return std::abs(next.first - before.last) > 1e-3 * before.last;
}

/// Places at equal times of a drive, several while the acceleration builds up. Where caps jump
/// there is another place, and both caps hold there.
Places places_of(const SmoothDrive& drive, std::span<const Cap> caps, const DrivingLimits& limits) {
  constexpr double density = 5;
  // Places nearer to a jump are left out; unit: distance of two places.
  constexpr double close = 0.4;
  const double braking = limits.max_braking.value_or(limits.max_acceleration);
  const double build_up = std::min(limits.max_acceleration, braking) / *limits.max_jerk;
  const double count = std::clamp(std::ceil(density * drive.duration / build_up), 48.0, 400.0);
  Places places;
  places.add(caps.front().begin, 0.0, 0.0);
  Follower follower(drive);
  std::size_t cap = 0;
  std::size_t jump = 0;  // index of the last place where the caps jump
  for (double i = 1; i < count; ++i) {
    const SpeedKnot at = follower.at_time(drive.duration * (i / count));
    const double gap = close * at.v * drive.duration / count;
    for (; cap + 1 < caps.size() && caps[cap].end <= at.s; ++cap) {
      const double s = caps[cap].end;
      if (!jumps(caps[cap], caps[cap + 1])) continue;
      if (jump + 1 < places.s.size() && s - places.s.back() < gap) places.remove_last();
      const double most = std::min(caps[cap].last, caps[cap + 1].first);
      if (s > places.s.back()) places.add(s, follower.at_place(s).v, most);
      jump = places.s.size() - 1;
    }
    if (at.s - places.s.back() < gap) continue;
    places.add(at.s, at.v, caps[cap].first + caps[cap].slope() * (at.s - caps[cap].begin));
  }
  places.add(caps.back().end, 0.0, 0.0);
  return places;
}

/// Time span with constant jerk.
struct Phase {
  double t;  // duration [s]
  double jerk;
};

/// Phases of constant jerk: from standstill to the middle of the second way, then from middle to
/// middle.
std::vector<Phase> phases_of(const SmoothOptimum& optimum, std::size_t ways) {
  std::vector<Phase> phases;
  const auto add = [&](double t, double change) { phases.push_back({t, change / t}); };
  add(optimum.share_before(0) * optimum.time(0), optimum.acceleration(0));
  for (std::size_t i = 1; i < ways; ++i) {
    add(optimum.time_between(i - 1), optimum.acceleration(i) - optimum.acceleration(i - 1));
  }
  add(optimum.share_after(ways - 1) * optimum.time(ways - 1), -optimum.acceleration(ways - 1));
  return phases;
}

using Vector = std::array<double, 3>;

/// Change of acceleration, speed and place at the end by a jerk of 1 during a phase that ends
/// `left` seconds earlier.
Vector effect(const Phase& phase, double left) {
  const double t = phase.t;
  return {t, t * (left + t / 2), t * (left * left / 2 + left * t / 2 + t * t / 6)};
}

/// Changes the jerks of `phases` so that they lead from one state to another. The least change is a
/// parabola over the remaining time.
void lead(const SpeedKnot& from, const SpeedKnot& to, std::span<Phase> phases) {
  std::array<Vector, 3> sums{};
  double left = 0.0;
  for (const Phase& phase : phases) left += phase.t;
  SpeedKnot free = from;
  free.jerk = 0.0;
  free = later(free, left);
  Vector missing{to.a - free.a, to.v - free.v, to.s - free.s};
  std::vector<Vector> effects(phases.size());
  left = 0.0;
  for (std::size_t i = phases.size(); i-- > 0;) {
    effects[i] = effect(phases[i], left);
    for (std::size_t j = 0; j < 3; ++j) {
      missing[j] -= effects[i][j] * phases[i].jerk;
      for (std::size_t k = 0; k < 3; ++k) {
        sums[j][k] += effects[i][j] * effects[i][k] / phases[i].t;
      }
    }
    left += phases[i].t;
  }
  // Gaussian elimination; the matrix `sums` is positive definite.
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t k = j + 1; k < 3; ++k) {
      const double share = sums[k][j] / sums[j][j];
      for (std::size_t l = j; l < 3; ++l) sums[k][l] -= share * sums[j][l];
      missing[k] -= share * missing[j];
    }
  }
  for (std::size_t j = 3; j-- > 0;) {
    for (std::size_t k = j + 1; k < 3; ++k) missing[j] -= sums[j][k] * missing[k];
    missing[j] /= sums[j][j];
  }
  for (std::size_t i = 0; i < phases.size(); ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      phases[i].jerk += missing[j] * effects[i][j] / phases[i].t;
    }
  }
}

/// Drive near the optimum: the jerk is constant from the middle of a way to the middle of the next
/// way.
SmoothDrive driven(const Places& places, const SmoothOptimum& optimum) {
  const std::size_t ways = places.s.size() - 1;
  std::vector<Phase> phases = phases_of(optimum, ways);
  SmoothDrive drive;
  SpeedKnot knot{.s = places.s.front(), .bound = SpeedBound::jerk};
  for (std::size_t first = 0; first < phases.size();) {
    // The section ends in the middle of a way, or at the end of the stretch.
    std::size_t next = first + section;
    SpeedKnot to{.s = places.s.back()};
    if (next + section < phases.size()) {
      const double t = optimum.time(next - 1) / 2;
      to = later(
          {0.0, places.s[next - 1], std::sqrt(places.u[next - 1]), optimum.acceleration(next - 1)},
          t);
    } else {
      next = phases.size();
    }
    lead(knot, to, std::span(phases).subspan(first, next - first));
    for (; first < next; ++first) {
      knot.jerk = phases[first].jerk;
      drive.knots.push_back(knot);
      knot = later(knot, phases[first].t);
    }
  }
  drive.duration = knot.t;
  return drive;
}

/// Checks whether drives keep the limits.
class Judge {
 public:
  Judge(std::span<const Cap> caps, const DrivingLimits& limits) : caps_(caps), limits_(limits) {}

  /// Largest squared speed in each phase of a drive, as a share of the cap.
  [[nodiscard]] std::vector<double> shares(const SmoothDrive& drive) const {
    return shares_if_slowed(drive, 1.0);
  }

  /// Factor by which the whole drive has to be slowed down to keep the limits. None if it goes
  /// backwards or ends at another state.
  [[nodiscard]] std::optional<double> slowness(const SmoothDrive& drive) const {
    const double loss = limits_.max_braking.value_or(limits_.max_acceleration);
    double slowness = 1.0;
    for (std::size_t i = 0; i < drive.knots.size(); ++i) {
      const SpeedKnot& knot = drive.knots[i];
      const bool is_last = i + 1 == drive.knots.size();
      const double hard = std::max(knot.a / limits_.max_acceleration, -knot.a / loss);
      slowness = std::max({slowness, std::sqrt(std::max(hard, 0.0)),
                           std::cbrt(std::abs(knot.jerk) / *limits_.max_jerk)});
      if (!(knot.v >= 0.0)) return std::nullopt;
      // Time after the knot at which the speed is least [s].
      const double turn = -knot.a / knot.jerk;
      const bool has_turn = knot.a < 0.0 && turn > 0.0 && turn < duration_of(drive, i);
      if (has_turn && (is_last ? knot.jerk <= 0.0 : later(knot, turn).v < 0.0)) return std::nullopt;
    }
    if (!ends_well(drive)) return std::nullopt;
    // The worst place changes when the drive is slowed down, so this is repeated.
    constexpr int most = 30;
    for (int i = 0; i < most; ++i) {
      const std::vector<double> shares = shares_if_slowed(drive, slowness);
      const double share = *std::ranges::max_element(shares);
      if (share <= 1.0) return slowness;
      slowness *= std::sqrt(share) * (1 + 1e-12);
    }
    return std::nullopt;
  }

 private:
  static double duration_of(const SmoothDrive& drive, std::size_t i) {
    const bool is_last = i + 1 == drive.knots.size();
    return (is_last ? drive.duration : drive.knots[i + 1].t) - drive.knots[i].t;
  }

  /// Whether the drive stands at the end of the stretch, up to rounding.
  [[nodiscard]] bool ends_well(const SmoothDrive& drive) const {
    constexpr double rounding = 1e-10;
    const std::size_t last = drive.knots.size() - 1;
    const SpeedKnot end = later(drive.knots[last], duration_of(drive, last));
    const double length = caps_.back().end - caps_.front().begin;
    return std::abs(end.s - caps_.back().end) <= rounding * (1 + length) &&
           std::abs(end.v) <= rounding && std::abs(end.a) <= rounding * limits_.max_acceleration;
  }

  [[nodiscard]] std::vector<double> shares_if_slowed(const SmoothDrive& drive,
                                                     double slowness) const {
    const double square = slowness * slowness;
    std::vector<double> shares(drive.knots.size());
    std::size_t cap = 0;
    for (std::size_t i = 0; i < drive.knots.size(); ++i) {
      const SpeedKnot& knot = drive.knots[i];
      const auto look = [&](double t) {
        const SpeedKnot at = later(knot, t);
        const double most = caps_[cap].first + caps_[cap].slope() * (at.s - caps_[cap].begin);
        shares[i] = std::max(shares[i], at.v * at.v / (square * most));
      };
      const double end = duration_of(drive, i);
      const double place = later(knot, end).s;
      for (double t = 0.0;;) {
        const bool ends_here = cap + 1 == caps_.size() || place <= caps_[cap].end;
        const double next = ends_here ? end : time_to(knot, end, caps_[cap].end);
        // The speed is furthest above the cap where both have the same slope, or at the ends.
        const double touch = (caps_[cap].slope() / 2 * square - knot.a) / knot.jerk;
        look(t);
        look(next);
        if (t < touch && touch < next) look(touch);
        if (ends_here) break;
        t = next;
        ++cap;
      }
    }
    return shares;
  }

  std::span<const Cap> caps_;
  const DrivingLimits& limits_;
};

/// Sets the limit that bounds each phase. If no limit is nearly reached, it is the jerk elsewhere.
void name_bounds(std::span<const double> shares, std::span<const Cap> caps,
                 const DrivingLimits& limits, SmoothDrive& drive) {
  constexpr double nearly = 0.98;
  const double loss = limits.max_braking.value_or(limits.max_acceleration);
  std::size_t cap = 0;
  for (std::size_t i = 0; i < drive.knots.size(); ++i) {
    SpeedKnot& knot = drive.knots[i];
    while (cap + 1 < caps.size() && caps[cap].end <= knot.s) ++cap;
    if (std::abs(knot.jerk) >= nearly * *limits.max_jerk) {
      knot.bound = SpeedBound::jerk;
    } else if (knot.a >= nearly * limits.max_acceleration) {
      knot.bound = SpeedBound::acceleration;
    } else if (-knot.a >= nearly * loss) {
      knot.bound = SpeedBound::braking;
    } else {
      knot.bound = shares[i] >= nearly ? caps[cap].bound : SpeedBound::jerk;
    }
  }
}

SmoothDrive slowed(SmoothDrive drive, double slowness) {
  for (SpeedKnot& knot : drive.knots) {
    knot.t *= slowness;
    knot.v /= slowness;
    knot.a /= slowness * slowness;
    knot.jerk /= slowness * slowness * slowness;
  }
  drive.duration *= slowness;
  return drive;
}

}  // namespace

SmoothDrive made_faster(SmoothDrive drive, std::span<const Cap> caps, const DrivingLimits& limits) {
  constexpr int rounds = 2;
  constexpr double enough = 1.001;
  Places places = places_of(drive, caps, limits);
  const std::size_t ways = places.s.size() - 1;
  if (ways < 4) return drive;
  SmoothOptimum optimum(places.s, places.most, limits);
  const Judge judge(caps, limits);
  for (int round = 0; round < rounds && optimum.improve(places.u); ++round) {
    SmoothDrive faster = driven(places, optimum);
    const std::optional<double> slowness = judge.slowness(faster);
    if (!slowness) break;
    const std::vector<double> shares = judge.shares(faster);
    if (*slowness * faster.duration < drive.duration) {
      drive = slowed(std::move(faster), *slowness);
      name_bounds(shares, caps, limits, drive);
    }
    if (*slowness <= enough) break;
    // The next round has lower caps where the drive was above them.
    for (std::size_t i = 1; i < ways; ++i) {
      if (shares[i] > 1.0) optimum.lower(i, shares[i]);
    }
  }
  return drive;
}

}  // namespace vandplan::speed
