// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "moving/yielding.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_set>
#include <utility>
#include <vector>

#include "moving/arrivals.h"
#include "moving/occupied.h"
#include "speed/moving_start.h"
#include "speed/way.h"

namespace vandplan::moving {
namespace {

constexpr double shortest_row = 0.5;  // largest length of a row on paths of up to 200 m [m]
// Number of rows on longer paths, besides those that knots of the fastest drive add.
constexpr double most_rows = 400;
// Duration of one wait, and width of a bin of times in a state's key [s].
constexpr double time_step = 0.25;
constexpr double speed_step = 0.1;       // width of a bin of speeds in a state's key [m/s]
constexpr double change_price = 0.05;    // cost of changing the speed [s per m/s]
constexpr double least_distance = 1e-6;  // least distance between two stations [m]
constexpr double fine = 0.05;            // `BoxLimits::finest` of a thorough search [m]
constexpr double coarse = 0.3;
constexpr double greed_of_haste = 1.5;
constexpr double endless = std::numeric_limits<double>::infinity();

/// Station of the path, with data of the fastest drive there.
struct Station {
  double s = 0.0;              // distance from the start of the path [m]
  double fastest = 0.0;        // square of the largest speed [m^2/s^2]
  double left = 0.0;           // least time from the station to the end of the path [s]
  double pause = 0.0;          // least time that the vehicle stands at the station [s]
  const Stop* stop = nullptr;  // stop of the fastest drive at the station, or null
};

/// A state of the search.
struct SearchState {
  std::size_t station = 0;
  double square = 0.0;  // square of the speed [m^2/s^2]
  double t = 0.0;       // time since the start of the drive [s]
  double cost = 0.0;    // cost-to-come: time plus the cost of changes of speed [s]
  std::int32_t parent = -1;
};

/// Entry of the open list. The order is: cheap first, then far along the path, then old.
struct Candidate {
  double bound;
  std::size_t station;
  std::int32_t state;

  bool operator<(const Candidate& other) const {
    if (bound != other.bound) return bound > other.bound;
    if (station != other.station) return station < other.station;
    return state > other.state;
  }
};

/// Squared speed at place `s` of a drive without jerk limit [m^2/s^2]; `s` follows knot `i`.
double square_at(const SpeedProfile& fastest, std::size_t i, double s) {
  const SpeedKnot& knot = fastest.knots[i];
  return std::max(knot.v * knot.v + 2 * knot.a * (s - knot.s), 0.0);
}

/// Time at which a drive without jerk limit is at place `s` [s]; `s` follows knot `i`.
double time_at(const SpeedProfile& fastest, std::size_t i, double s) {
  const SpeedKnot& knot = fastest.knots[i];
  const double v = knot.v + std::sqrt(square_at(fastest, i, s));
  return v > 0.0 ? knot.t + 2 * (s - knot.s) / v : knot.t;
}

/// Stations of a drive: its knots and evenly spaced places between them.
std::vector<Station> stations_of(const SpeedProfile& fastest) {
  const std::vector<SpeedKnot>& knots = fastest.knots;
  const double row = std::max(shortest_row, knots.back().s / most_rows);
  std::vector<Station> stations;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double way = knots[i + 1].s - knots[i].s;
    if (way <= 0.0) continue;
    const double count = std::ceil(way / row);
    for (double k = 0; k < count; ++k) {
      const double s = knots[i].s + k / count * way;
      if (!stations.empty() && s - stations.back().s < least_distance) continue;
      stations.push_back({s, square_at(fastest, i, s), fastest.duration - time_at(fastest, i, s)});
    }
  }
  stations.push_back({.s = knots.back().s});
  for (const Stop& stop : fastest.stops) {
    const auto near = std::ranges::min_element(
        stations, {}, [&](const Station& station) { return std::abs(station.s - stop.s); });
    near->fastest = 0.0;
    near->pause = stop.pause;
    near->stop = &stop;
  }
  return stations;
}

std::vector<double> places_of(const std::vector<Station>& stations) {
  std::vector<double> places;
  places.reserve(stations.size());
  for (const Station& station : stations) places.push_back(station.s);
  return places;
}

std::vector<StationTimes> station_times_of(const std::vector<Station>& stations) {
  std::vector<StationTimes> times;
  times.reserve(stations.size());
  for (const Station& station : stations) times.push_back({station.left, station.pause});
  return times;
}

/// Spans in which the vehicle can be in each row, on drives of at most `longest` seconds.
std::vector<TimeSpan> times_of(const std::vector<Station>& stations, double duration,
                               double longest) {
  constexpr double tolerance = 1e-6;  // enlargement of the spans for rounding [s]
  std::vector<TimeSpan> times;
  times.reserve(stations.size());
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    times.push_back({duration - stations[i].left - stations[i].pause - tolerance,
                     longest - stations[i + 1].left + tolerance});
  }
  times.back().end = forever;  // the vehicle stays in the last row
  return times;
}

bool is_interrupted(const Traffic& traffic) {
  return traffic.is_interrupted && traffic.is_interrupted();
}

class YieldingSearch {
 public:
  YieldingSearch(const Encounters& encounters, const SpeedProfile& fastest,
                 const DrivingLimits& limits, const Traffic& traffic)
      : stations_(stations_of(fastest)),
        occupied_(encounters, places_of(stations_),
                  times_of(stations_, fastest.duration, traffic.longest),
                  {.most_boxes = traffic.most_states, .finest = traffic.is_hasty ? coarse : fine}),
        arrivals_(occupied_, station_times_of(stations_)),
        rise_(2 * limits.max_acceleration),
        fall_(2 * limits.max_braking.value_or(limits.max_acceleration)),
        latest_(occupied_.last_change() + fastest.duration + time_step),
        longest_(traffic.longest),
        greed_(traffic.is_hasty ? greed_of_haste : 1.0) {}

  /// Index of the last state of the cheapest drive; none if no drive is found within the limits.
  [[nodiscard]] std::optional<std::int32_t> run(const Traffic& traffic) {
    constexpr std::int64_t states_between_questions = 64;
    const double begin = stations_.front().pause;
    const double square = traffic.start_speed * traffic.start_speed;
    if (is_standing_free(0, 0.0, begin)) push({.square = square, .t = begin}, begin);
    while (!queue_.empty() && looked_ < traffic.most_states) {
      if (looked_ % states_between_questions == 0 && is_interrupted(traffic)) break;
      const std::int32_t i = queue_.top().state;
      queue_.pop();
      const SearchState state = states_[static_cast<std::size_t>(i)];
      if (!seen_.insert(key_of(state)).second) continue;
      ++looked_;
      if (state.station + 1 == stations_.size()) return i;
      expand(state, i);
    }
    return std::nullopt;
  }

  [[nodiscard]] std::int64_t looked() const noexcept { return looked_ + occupied_.boxes(); }
  /// Whether a limit ended the search before it had expanded every state it can reach.
  [[nodiscard]] bool is_cut_off(const Traffic& traffic) const noexcept {
    return !queue_.empty() || occupied_.boxes() >= traffic.most_states;
  }
  [[nodiscard]] const std::vector<Station>& stations() const noexcept { return stations_; }

  /// States of the drive that ends in state `last`, from its start on.
  [[nodiscard]] std::vector<SearchState> chain(std::int32_t last) const {
    std::vector<SearchState> states;
    for (std::int32_t i = last; i >= 0; i = states_[static_cast<std::size_t>(i)].parent) {
      states.push_back(states_[static_cast<std::size_t>(i)]);
    }
    std::ranges::reverse(states);
    return states;
  }

 private:
  void expand(const SearchState& from, std::int32_t index) {
    const Station& here = stations_[from.station];
    if (from.square == 0.0) wait(from, index);
    const Station& next = stations_[from.station + 1];
    const double way = next.s - here.s;
    const double most = std::min(from.square + rise_ * way, next.fastest);
    const double hardest = std::max(from.square - fall_ * way, 0.0);
    // `speed::profile_from` lets a vehicle that comes too fast brake slightly harder than its
    // limit.
    const double least = std::min(hardest, most);
    if (hardest > most * (1 + 1e-2) + 1e-9) return;
    const double even = std::clamp(from.square, least, most);
    go(from, index, most);
    if (even != most) go(from, index, even);
    if (least != even) go(from, index, least);
  }

  void wait(const SearchState& from, std::int32_t index) {
    if (from.t > latest_) return;
    SearchState to = from;
    to.t += time_step;
    to.parent = index;
    if (is_standing_free(from.station, from.t, to.t)) push(to, to.t - from.t);
  }

  void go(const SearchState& from, std::int32_t index, double square) {
    const Station& next = stations_[from.station + 1];
    const double speeds = std::sqrt(from.square) + std::sqrt(square);
    if (speeds == 0.0) return;
    const double way = next.s - stations_[from.station].s;
    SearchState to{from.station + 1, square, from.t + 2 * way / speeds, from.cost, index};
    if (!occupied_.is_free(from.station, from.t, to.t)) return;
    const bool is_end = to.station + 1 == stations_.size();
    if (is_end && !occupied_.is_free_from(from.station, to.t)) return;
    if (!is_end && next.stop != nullptr) {
      const double goes_on = to.t + next.pause;
      if (!is_standing_free(to.station, to.t, goes_on)) return;
      to.t = goes_on;
    }
    const double change = std::abs(std::sqrt(from.square) - std::sqrt(square));
    push(to, to.t - from.t + change_price * change);
  }

  /// A vehicle may stand at a station if one of the two rows beside it is free.
  [[nodiscard]] bool is_standing_free(std::size_t station, double begin, double end) const {
    const bool before = station > 0 && occupied_.is_free(station - 1, begin, end);
    return before || occupied_.is_free(station, begin, end);
  }

  void push(SearchState state, double cost) {
    state.cost += cost;
    const double arrival = arrivals_.earliest(state.station, state.t);
    if (!(arrival <= longest_) || arrival == endless) return;
    if (seen_.contains(key_of(state))) return;
    const double bound = state.cost + greed_ * (arrival - state.t);
    queue_.push({bound, state.station, static_cast<std::int32_t>(states_.size())});
    states_.push_back(state);
  }

  /// Key of a state; states with the same key are duplicates. Standing differs from the slowest
  /// speeds.
  [[nodiscard]] static std::uint64_t key_of(const SearchState& state) {
    const double speed = state.square > 0.0 ? 1.0 + std::sqrt(state.square) / speed_step : 0.0;
    const double time = state.t / time_step;
    return static_cast<std::uint64_t>(state.station) << 44 |
           static_cast<std::uint64_t>(speed) << 32 | static_cast<std::uint64_t>(time);
  }

  std::vector<Station> stations_;
  Occupied occupied_;
  Arrivals arrivals_;
  double rise_, fall_;  // largest rise and fall of the squared speed per metre [m/s^2]
  double latest_;       // last time at which the search begins to wait [s]
  double longest_;      // longest duration of a drive [s]
  double greed_;        // weight of the estimated time to the end
  std::vector<SearchState> states_;
  std::priority_queue<Candidate> queue_;
  std::unordered_set<std::uint64_t> seen_;
  std::int64_t looked_ = 0;
};

/// Builds the speed profile of a chain of states, with its stops.
class Writer {
 public:
  Writer(const std::vector<Station>& stations, const Path& path)
      : stations_(stations), way_(path) {}

  [[nodiscard]] SpeedProfile written(const std::vector<SearchState>& states) {
    stand(states.front(), stations_.front().pause);
    for (std::size_t i = 1; i < states.size(); ++i) {
      const SearchState& from = states[i - 1];
      const SearchState& to = states[i];
      if (from.station == to.station) {
        stand(to, to.t - from.t);
      } else {
        drive(from, to);
      }
    }
    profile_.knots.push_back({.t = t_, .s = stations_.back().s});
    profile_.duration = t_;
    return std::move(profile_);
  }

 private:
  void drive(const SearchState& from, const SearchState& to) {
    const Station& here = stations_[from.station];
    const Station& next = stations_[to.station];
    const double way = next.s - here.s;
    const double v = std::sqrt(from.square);
    const double a = (to.square - from.square) / (2 * way);
    const SpeedBound bound = a > 0.0   ? SpeedBound::acceleration
                             : a < 0.0 ? SpeedBound::braking
                                       : SpeedBound::max_speed;
    profile_.knots.push_back({.t = t_, .s = here.s, .v = v, .a = a, .bound = bound});
    t_ += 2 * way / (v + std::sqrt(to.square));
    const bool is_end = to.station + 1 == stations_.size();
    if (!is_end && next.stop != nullptr) stand(to, next.pause);
  }

  void stand(const SearchState& state, double pause) {
    const Station& here = stations_[state.station];
    std::vector<Stop>& stops = profile_.stops;
    const bool has_stopped = !stops.empty() && stops.back().s == here.s;
    if (pause > 0.0 && !(has_stopped && stops.back().pause > 0.0)) {
      profile_.knots.push_back({.t = t_, .s = here.s});
    }
    if (has_stopped) {
      stops.back().pause += pause;
    } else if (here.stop != nullptr) {
      stops.push_back({t_, here.s, pause, here.stop->curvature_before, here.stop->curvature_after});
    } else if (pause > 0.0) {
      const double curvature = way_.at(here.s, true).curvature;
      stops.push_back({t_, here.s, pause, curvature, curvature});
    }
    profile_.standing += pause;
    t_ += pause;
  }

  const std::vector<Station>& stations_;
  speed::Way way_;
  SpeedProfile profile_;
  double t_ = 0.0;
};

/// The fastest drive, delayed until it meets no moving obstacle. One trial counts as
/// `states_of_try` states.
Yielding begun_later(const Course& course, const SpeedProfile& fastest, const Traffic& traffic) {
  constexpr double longest_wait = 500;  // largest delay of the start [s]
  constexpr std::int64_t states_of_try = 100;
  const double latest = std::min({end_of_motion(traffic.moving) + time_step, longest_wait,
                                  traffic.longest - fastest.duration});
  const double curvature = traffic.start_curvature;
  Yielding yielding;
  for (double wait = time_step; wait <= latest && !is_interrupted(traffic); wait += time_step) {
    if (yielding.states >= traffic.most_states) {
      yielding.is_cut_off = true;
      return yielding;
    }
    yielding.states += states_of_try;
    SpeedProfile speeds = fastest;
    for (SpeedKnot& knot : speeds.knots) knot.t += wait;
    for (Stop& stop : speeds.stops) stop.t += wait;
    speeds.knots.insert(speeds.knots.begin(), SpeedKnot{});
    speeds.stops.insert(speeds.stops.begin(), {0.0, 0.0, wait, curvature, curvature});
    speeds.duration += wait;
    speeds.standing += wait;
    if (first_meeting(course, speeds, traffic.moving, traffic.margin)) continue;
    yielding.speeds = std::move(speeds);
    return yielding;
  }
  return yielding;
}

}  // namespace

Yielding yielding_speeds(const Path& path, const Vehicle& vehicle, const Traffic& traffic) {
  std::optional<SpeedProfile> unhindered = speed::profile_from(
      path, vehicle, {traffic.start_curvature, traffic.start_speed, traffic.limits});
  if (!unhindered) return {};
  const SpeedProfile& fastest = *unhindered;
  const Course course{path, vehicle, traffic.start_hitch_angle};
  const std::optional<Meeting> met = first_meeting(course, fastest, traffic.moving, traffic.margin);
  if (!met) return {*std::move(unhindered)};
  Yielding yielding{.met = met};
  if (fastest.knots.back().s <= 0.0) return yielding;
  if (fastest.duration > traffic.longest || traffic.most_states <= 0) return yielding;
  if (vehicle.limits.max_jerk && traffic.start_speed == 0.0) {
    yielding = begun_later(course, fastest, traffic);
    yielding.met = met;
    return yielding;
  }
  const Encounters encounters(course, traffic.moving, traffic.margin);
  YieldingSearch search(encounters, fastest, vehicle.limits, traffic);
  const std::optional<std::int32_t> last = search.run(traffic);
  yielding.states = search.looked();
  yielding.is_cut_off = !last && search.is_cut_off(traffic);
  if (last) yielding.speeds = Writer(search.stations(), path).written(search.chain(*last));
  return yielding;
}

}  // namespace vandplan::moving
