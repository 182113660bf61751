// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/smooth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "planners/anytime/chain.h"
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

bool is_at(const Pose& pose, const Pose& goal) {
  return std::hypot(pose.x - goal.x, pose.y - goal.y) <= steering::at_goal.position &&
         std::abs(wrap_angle(pose.heading - goal.heading)) <= steering::at_goal.heading;
}

/// The cost of the path itself, if it can be driven as it is; as far as rounding tells.
std::optional<double> cost_as_it_is(const Task& task, Connector& connector, const Path& old) {
  Driven before = gears_at_ends(task, connector.rule()).before;
  Pose pose = old.start;
  for (const Segment& segment : old.segments) {
    if (!anytime::may_follow(connector, before, segment)) return std::nullopt;
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
  anytime::Chain chain(task, connector, old, stream_seed(options.budget.seed, 0));
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
                         .style = Style::driver,
                         .honours_steering = true,
                         .anytime = method == SmoothMethod::optimised},
          .options = {},
          .function = [path, method](const Task& task, const PlanOptions& options) {
            return smoothed(task, options, path, method);
          }};
}

}  // namespace vandplan
