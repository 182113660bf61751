// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/smooth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "planners/anytime/shorten.h"
#include "search/route.h"
#include "steering/words.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace search;

constexpr std::array<std::string_view, 2> method_names = {"clothoids", "optimised"};
constexpr std::int64_t most_repairs = 20'000;
constexpr std::int64_t settling = 1000;  // trials that take out what repairs made longer
constexpr double sideways = 0.3;         // of trials that bring nothing, those that are kept

/// A place of the old path where the wheels are straight or the gear changes.
struct Via {
  Pose pose;
  double s;       // on the old path [m]
  GearSign next;  // the gear driven from there, if it changes; else 0
};

/// The places of a path where one piece may end and the next one begin, its ends among them.
std::vector<Via> vias_of(const Path& path) {
  std::vector<Via> vias = {{path.start, 0.0, 0}};
  Pose pose = path.start;
  double s = 0.0;
  const Segment* before = nullptr;
  for (const Segment& segment : path.segments) {
    if (segment.length == 0.0) continue;  // two places would be one
    const double length = std::abs(segment.length);
    const double end = curvature_at(segment, length);
    if (before != nullptr) {
      const bool changes = before->length * segment.length < 0.0;
      const double last = last_driven(*before).curvature;
      if (changes || last * segment.curvature < 0.0) {
        vias.push_back({pose, s, changes ? gear_of(segment) : 0});
      }
    }
    const bool is_line = segment.curvature == 0.0 && end == 0.0;
    if (is_line || segment.curvature * end < 0.0) {
      const double there =
          is_line ? length / 2 : length * segment.curvature / (segment.curvature - end);
      vias.push_back({advance(pose, part_of(segment, 0.0, there)), s + there, 0});
    }
    pose = advance(pose, segment);
    s += length;
    before = &segment;
  }
  vias.push_back({pose, s, 0});
  return vias;
}

/// A chain of pieces along an old path, some of which may be in the way of something.
class Chain {
 public:
  Chain(const Task& task, Connector& connector, const Path& old, std::uint64_t seed)
      : task_(task), connector_(connector), old_(old), rng_(seed), vias_(vias_of(old)) {
    vias_.front().pose = task.start;
    vias_.back().pose = task.goal;
  }

  /// Joins all places; false if two of them cannot be joined.
  bool join();
  /// One trial to free a leg.
  void repair();
  [[nodiscard]] bool is_free() const {
    return std::ranges::all_of(legs_, [](const Link& link) { return link.is_free; });
  }
  [[nodiscard]] Route route() const;

 private:
  struct Link {
    Piece piece;
    bool is_free = false;
  };

  [[nodiscard]] std::optional<std::vector<Link>> links(std::span<const Via> vias,
                                                       const Gears& around);
  [[nodiscard]] Via beside(double s, GearSign next);

  const Task& task_;
  Connector& connector_;
  const Path& old_;
  Rng rng_;
  std::vector<Via> vias_;
  std::vector<Link> legs_;  // from each place to the next
};

/// Pieces from place to place, between what is driven around them.
std::optional<std::vector<Chain::Link>> Chain::links(std::span<const Via> vias,
                                                     const Gears& around) {
  std::vector<Link> result;
  Driven before = around.before;
  for (std::size_t i = 0; i + 1 < vias.size(); ++i) {
    const bool is_last = i + 2 == vias.size();
    const Driven after = is_last ? around.after : Driven(vias[i + 1].next);
    const Pose& from = vias[i].pose;
    const std::optional<Piece> piece = connector_.steer(from, vias[i + 1].pose, {before, after});
    if (!piece) return std::nullopt;
    result.push_back({*piece, connector_.is_free(from, *piece)});
    before = last_driven(*piece);
  }
  return result;
}

bool Chain::join() {
  const Gears ends = gears_at_ends(task_, connector_.rule());
  auto all = links(vias_, ends);
  if (!all) {  // with straight wheels there is always a way
    for (Via& via : vias_) via.next = 0;
    all = links(vias_, ends);
  }
  if (!all) return false;
  legs_ = *std::move(all);
  return true;
}

/// A place near the old path, at a random scale.
Via Chain::beside(double s, GearSign next) {
  const double scale = std::exp2(uniform(-9.0, 0.0, rng_));
  const double reach = scale * connector_.radius();
  const Pose by{uniform(-reach, reach, rng_), uniform(-reach, reach, rng_),
                uniform(-scale, scale, rng_)};
  return {compose(pose_at(old_, s), by), s, next};
}

/// Moves an end of a leg that is not free, or makes a place in its middle.
void Chain::repair() {
  std::vector<std::size_t> blocked;
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    if (!legs_[i].is_free) blocked.push_back(i);
  }
  const std::size_t leg = blocked[rng_() % blocked.size()];
  const bool inserts = legs_.size() == 1 || uniform01(rng_) < 0.3;
  const bool moves_end = leg == 0 || (leg + 1 < legs_.size() && rng_() % 2 == 0);
  const std::size_t first = inserts || moves_end ? leg : leg - 1;
  const std::size_t last = inserts ? leg + 1 : first + 2;  // the leg after those that change
  const Via& from = vias_[first];
  const Via& to = vias_[last];
  const Via between = inserts ? beside(uniform(from.s, to.s, rng_), 0)
                              : beside(vias_[first + 1].s, vias_[first + 1].next);
  const Gears ends = gears_at_ends(task_, connector_.rule());
  const Gears around{first == 0 ? ends.before : last_driven(legs_[first - 1].piece),
                     last == legs_.size() ? ends.after : first_driven(legs_[last].piece)};
  const std::array<Via, 3> trial = {from, between, to};
  const auto fresh = links(trial, around);
  if (!fresh) return;
  const auto begin = legs_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = legs_.begin() + static_cast<std::ptrdiff_t>(last);
  const auto is_blocked = [](const Link& link) { return !link.is_free; };
  const auto was = std::count_if(begin, end, is_blocked);
  const auto is = std::count_if(fresh->begin(), fresh->end(), is_blocked);
  if (is > was || (is == was && uniform01(rng_) > sideways)) return;
  legs_.insert(legs_.erase(begin, end), fresh->begin(), fresh->end());
  const auto at = vias_.begin() + static_cast<std::ptrdiff_t>(first) + 1;
  if (inserts) {
    vias_.insert(at, between);
  } else {
    *at = between;
  }
}

Route Chain::route() const {
  Route route{vias_.front().pose, {}, 0.0};
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    route.legs.push_back({legs_[i].piece, vias_[i + 1].pose});
  }
  price(connector_, route);
  return route;
}

bool is_at(const Pose& pose, const Pose& goal) {
  return std::hypot(pose.x - goal.x, pose.y - goal.y) <= steering::at_goal.position &&
         std::abs(wrap_angle(pose.heading - goal.heading)) <= steering::at_goal.heading;
}

/// The cost of the path itself, if it can be driven as it is; as far as rounding tells.
std::optional<double> cost_as_it_is(const Task& task, Connector& connector, const Path& old) {
  Driven before = gears_at_ends(task, connector.rule()).before;
  Pose pose = old.start;
  for (const Segment& segment : old.segments) {
    const Driven after{gear_of(segment), segment.curvature};
    const bool jumps = std::abs(after.curvature - before.curvature) * connector.radius() >
                       straight_wheels;  // not if it is not known
    if (jumps && !connector.may_jump(before, after)) return std::nullopt;
    if (!connector.is_free(pose, segment)) return std::nullopt;
    before = last_driven(segment);
    pose = advance(pose, segment);
  }
  const double last = gears_at_ends(task, connector.rule()).after.curvature;
  if (std::abs(last - before.curvature) * connector.radius() > straight_wheels) return std::nullopt;
  if (!is_at(pose, task.goal)) return std::nullopt;
  Driven driven = connector.rule().initial_gear;
  return drive_cost(connector.rule(), old.segments, driven) +
         connector.clearance_cost(old.start, old.segments);
}

// The steps of docs/algorithms/smooth.md.
PlannerAnswer smoothed(const Task& task, const PlanOptions& options, const Path& path,
                       SmoothMethod method) {
  Budget budget(options.budget);
  Connector connector(task, cost_rule(options.cost));
  const Path old{task.start, path.segments};
  PlannerAnswer answer;
  const std::optional<double> kept = cost_as_it_is(task, connector, old);  // [1]
  double least = kept.value_or(std::numeric_limits<double>::infinity());
  const auto take = [&](std::vector<Segment> segments, double cost) {
    answer.segments = std::move(segments);
    answer.anytime.push_back({budget.elapsed(), budget.iterations(), cost});
    answer.status = PlanStatus::solved;
  };
  if (kept) take(path.segments, *kept);
  Chain chain(task, connector, old, stream_seed(options.budget.seed, 0));
  const bool is_joined = chain.join();  // [2]
  bool is_free = is_joined && chain.is_free();
  const std::int64_t repairs = is_joined ? most_repairs : 0;
  for (std::int64_t i = 0; i < repairs && !is_free && budget.next(); ++i) {  // [3]
    chain.repair();
    is_free = chain.is_free();
  }
  if (is_free && !(kept && method == SmoothMethod::clothoids)) {
    anytime::Shortener shortener(connector, chain.route(), stream_seed(options.budget.seed, 1));
    const auto offer = [&] {
      if (shortener.cost() >= least) return;
      const Route route = shortener.route();
      least = route.cost;
      take(path_of(route).segments, route.cost);
    };
    offer();
    for (std::int64_t i = 0; method == SmoothMethod::optimised || i < settling; ++i) {  // [4]
      if (!budget.next()) break;
      if (shortener.step()) offer();
    }
  }
  answer.iterations = budget.iterations();
  if (answer.segments) return answer;
  answer.status = budget.exhausted().value_or(PlanStatus::no_path);
  answer.reason = "no way along the path was found that the wheels can follow";
  return answer;
}

}  // namespace

SmoothMethod smooth_method_named(std::string_view name) {
  const auto found = std::ranges::find(method_names, name);
  if (found == method_names.end()) {
    throw InputError("method", "\"" + std::string(name) + "\" is not clothoids or optimised");
  }
  return static_cast<SmoothMethod>(found - method_names.begin());
}

Planner smoother(const Path& path, SmoothMethod method) {
  const auto name = method_names[static_cast<std::size_t>(method)];
  return {.name = "smooth-" + std::string(name),
          .summary = "keeps to the way of a path",
          .properties = {.family = "smooth",
                         .honours_prices = true,
                         .honours_steering = true,
                         .anytime = method == SmoothMethod::optimised},
          .options = {},
          .function = [path, method](const Task& task, const PlanOptions& options) {
            return smoothed(task, options, path, method);
          }};
}

}  // namespace vandplan
