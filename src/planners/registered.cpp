// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/registered.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "path/finite.h"
#include "planners/anytime/finish.h"
#include "planners/default_search.h"
#include "planners/in_time.h"
#include "planners/plan_to_set.h"
#include "search/route.h"
#include "sites/way.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/site_table.h"

namespace vandplan::planning {
namespace {

constexpr double shares_of_known = 1e3;  // most places of a known path that are looked at
constexpr double finest = 1e-3;          // least distance between them [m]

/// The part of a known path between its places that are nearest to two poses, the second one behind
/// the first.
Path part_between(const Path& known, const LocalPose& from, const LocalPose& to) {
  const std::vector<PathPoint> points = sampled(known, finest + length(known) / shares_of_known);
  const auto nearest = [&](auto begin, const Pose& pose) {
    return std::min_element(begin, points.end(), [&](const PathPoint& a, const PathPoint& b) {
      return std::hypot(a.pose.x - pose.x, a.pose.y - pose.y) <
             std::hypot(b.pose.x - pose.x, b.pose.y - pose.y);
    });
  };
  const auto first = nearest(points.begin(), from);
  const auto last = nearest(first, to);
  return {first->pose, search::part_of(known.segments, first->s, last->s)};
}

/// Plans with the default planner. A known path counts only if no obstacle moves.
PlannerAnswer plan_by_default(const Task& task, const PlanOptions& options,
                              const anytime::Given& given) {
  if (given.site != nullptr) sites::expect_serves(*given.site, task, options);
  if (!task.moving.empty()) return in_time::plan(task, options, given.sources);
  if (task.goal_set.empty()) {
    const auto search = default_search(task, options, 0.0, given);
    while (search->advance()) {
    }
    return search->answer();
  }
  const auto search_to = [&given, &task](const Task& to, const PlanOptions& round,
                                         const Path* nearby) {
    const Path* known = nearby != nullptr ? nearby : given.known;
    Path part;
    if (known != nullptr && known == given.known && !task.via.empty()) {
      // A whole path is no way from one via to the next.
      part = part_between(*known, to.start, to.goal);
      known = part.segments.empty() ? nullptr : &part;
    }
    return default_search(to, round, 0.0,
                          {.known = known, .site = given.site, .sources = given.sources});
  };
  return plan_to_set(task, options, 0.0, search_to);
}

Planner anytime_planner() {
  return {.name = "anytime",
          .summary = "lattice searches, every path shortened",
          .properties = {.family = "anytime",
                         .capabilities = {Capability::prices, Capability::time, Capability::gears,
                                          Capability::steering, Capability::steering_of_rigs,
                                          Capability::threads, Capability::target_gap,
                                          Capability::moving, Capability::trailers,
                                          Capability::goal_sets, Capability::via, Capability::site},
                         .style = Style::driver,
                         .anytime = true},
          // `region` is taken as by all planners, and changes nothing: no poses are drawn.
          .options = {region_option(), anytime::min_stroke_option()},
          .function = [](const Task& task, const PlanOptions& options) {
            return plan_by_default(task, options, {.site = options.site.get()});
          }};
}

}  // namespace

OptionInfo region_option() {
  return {.name = "region",
          .summary = "sampling region",
          .default_value = std::string("bounds"),
          .words = {"bounds", "scene"}};
}

std::vector<Planner> registered_planners() {
  std::vector<Planner> planners = {anytime_planner()};
  for (Planner& planner : laboratory()) planners.push_back(std::move(planner));
  return planners;
}

}  // namespace vandplan::planning

namespace vandplan {
namespace {

constexpr std::int64_t max_source_share = 10'000;  // most iterations of a source in a round

}  // namespace

Planner warm_started(const Path& path) {
  path::check_finite(path);
  Planner planner = default_planner();
  planner.function = [path](const Task& task, const PlanOptions& options) {
    const Path known{to_local(*task.world, path.start), path.segments};
    return planning::plan_by_default(task, options, {.known = &known, .site = options.site.get()});
  };
  return planner;
}

Planner with_sources(std::vector<NamedSource> sources) {
  for (const NamedSource& source : sources) {
    if (!source.make) throw InputError("source " + source.name, "has nothing that makes it");
    if (source.share < 1 || source.share > max_source_share) {
      throw InputError("source " + source.name, "share: expected 1 to " +
                                                    std::to_string(max_source_share) + ", not " +
                                                    std::to_string(source.share));
    }
  }
  Planner planner = default_planner();
  planner.function = [sources = std::move(sources)](const Task& task, const PlanOptions& options) {
    return planning::plan_by_default(task, options,
                                     {.site = options.site.get(), .sources = sources});
  };
  return planner;
}

}  // namespace vandplan
