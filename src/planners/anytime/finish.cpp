// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/finish.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/splice.h"
#include "planners/anytime/shorten.h"
#include "planners/anytime/strokes.h"
#include "planners/commands/shorten_drive.h"
#include "planners/commands/wheels.h"
#include "search/wheels.h"
#include "steering/words.h"

namespace vandplan::anytime {
namespace {

constexpr int trials_for_fewer_changes = 1000;  // trials of `with_fewer_changes`
constexpr std::size_t tidy_reach = 7;  // segments on either side that make up for what is left out

using Segments = std::vector<Segment>;

class Tidier {
 public:
  Tidier(Connector& connector, const LocalPose& start, Segments segments)
      : connector_(connector),
        segments_(merged(segments)),
        poses_{start},
        is_continuous_(connector.continuous() != nullptr),
        crumb_(commands::crumb_length(connector.radius())) {
    take_poses(0);
    cost_ = cost_between(0, segments_.size(), segments_);
  }

  void drop_crumbs();
  [[nodiscard]] const Segments& segments() const { return segments_; }

 private:
  [[nodiscard]] double cost_between(std::size_t first, std::size_t last,
                                    std::span<const Segment> segments);
  void take_poses(std::size_t first);
  [[nodiscard]] bool is_free(LocalPose from, std::span<const Segment> segments);
  [[nodiscard]] bool drop(std::size_t first, std::size_t last, double limit);
  [[nodiscard]] std::size_t end_of_crumbs(std::size_t first) const;

  Connector& connector_;
  Segments segments_;
  std::vector<LocalPose> poses_;  // pose before each segment, and the last one
  double cost_ = 0.0;             // cost of the path
  bool is_continuous_;
  double crumb_;
};

/// Cost of `segments` in place of the segments [first, last) of the path, with the changes at both
/// ends.
double Tidier::cost_between(std::size_t first, std::size_t last,
                            std::span<const Segment> segments) {
  const CostRule& rule = connector_.rule();
  Driven driven = first == 0 ? rule.initial_gear : last_driven(segments_[first - 1]);
  const double sum = drive_cost(rule, segments, driven);
  const Driven next = last == segments_.size()
                          ? Driven(rule.final_gear)
                          : Driven{gear_of(segments_[last]), segments_[last].curvature};
  return sum + search::change_cost(rule, driven, next) +
         connector_.clearance_cost(poses_[first], segments);
}

/// Computes the poses behind the segments from `first` on.
void Tidier::take_poses(std::size_t first) {
  poses_.resize(segments_.size() + 1);
  for (std::size_t i = first; i < segments_.size(); ++i) {
    poses_[i + 1] = advance(poses_[i], segments_[i]);
  }
}

bool Tidier::is_free(LocalPose from, std::span<const Segment> segments) {
  for (const Segment& segment : segments) {
    if (!connector_.is_free(from, segment)) return false;
    from = advance(from, segment);
  }
  return true;
}

// Leaves the segments [first, last) out if their neighbours make up for that: the poses on either
// side stay, the path is free and costs at most `limit`.
bool Tidier::drop(std::size_t first, std::size_t last, double limit) {
  std::size_t low = first - std::min(first, tidy_reach);
  std::size_t high = std::min(segments_.size(), last + tidy_reach);
  while (high - last + first - low > steering::most_mended) {
    if (first - low > high - last) {
      ++low;
    } else {
      --high;
    }
  }
  const std::span<const Segment> all(segments_);
  const std::span<const Segment> around = all.subspan(low, high - low);
  Segments rest(around.begin(), around.end());
  base::splice(rest, first - low, last - low, {});
  rest = merged(rest);
  const std::optional<Segments> mended =
      steering::mended(poses_[low], poses_[high], rest, steering::on_the_way);
  if (!mended) return false;
  // With fewer segments the curvature could jump.
  if (is_continuous_ && mended->size() != rest.size()) return false;
  // The segments on either side may merge with what is new.
  const std::size_t begin = low - std::min<std::size_t>(low, 1);
  const std::size_t end = std::min(high + 1, segments_.size());
  const std::span<const Segment> old = all.subspan(begin, end - begin);
  Segments changed(old.begin(), old.end());
  base::splice(changed, low - begin, high - begin, *mended);
  changed = merged(changed);
  if (changed.size() >= old.size()) return false;
  const double cost = cost_ - cost_between(begin, end, old) + cost_between(begin, end, changed);
  if (cost > limit || !is_free(poses_[low], *mended)) return false;
  base::splice(segments_, begin, end, changed);
  cost_ = cost;
  take_poses(begin);
  return true;
}

/// Index behind the crumbs that begin at `first` and can be left out together; `first` if there are
/// none. Where the curvature is continuous, it must be the same before them and behind them.
std::size_t Tidier::end_of_crumbs(std::size_t first) const {
  constexpr double same = 1e-12;  // difference of curvatures that is rounding [1/m]
  if (!is_continuous_) return first + 1;
  const auto last_curvature = [](const Segment& s) { return curvature_at(s, std::abs(s.length)); };
  const auto gear = gear_of(segments_[first]);
  const double before =
      first > 0 ? last_curvature(segments_[first - 1]) : segments_[first].curvature;
  for (std::size_t i = first; i < segments_.size(); ++i) {
    if (std::abs(segments_[i].length) >= crumb_ || gear_of(segments_[i]) != gear) break;
    const double after =
        i + 1 < segments_.size() ? segments_[i + 1].curvature : last_curvature(segments_[i]);
    if (std::abs(after - before) <= same) return i + 1;
  }
  return first;
}

// Leaves out crumbs, the shortest first, until none can go.
void Tidier::drop_crumbs() {
  const double limit = (1 + commands::crumb_slack) * cost_;
  bool dropped = true;
  while (dropped) {
    std::vector<std::size_t> crumbs;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (std::abs(segments_[i].length) < crumb_) crumbs.push_back(i);
    }
    std::stable_sort(crumbs.begin(), crumbs.end(), [&](std::size_t a, std::size_t b) {
      return std::abs(segments_[a].length) < std::abs(segments_[b].length);
    });
    dropped = std::any_of(crumbs.begin(), crumbs.end(), [&](std::size_t i) {
      const std::size_t end = end_of_crumbs(i);
      return end > i && drop(i, end, limit);
    });
  }
}

}  // namespace

OptionInfo min_stroke_option() {
  return {.name = "min_stroke",
          .summary = "least distance between gear changes, if there is room [m]",
          .default_value = 0.0,
          .least = 0.0,
          .most = 100.0};
}

std::vector<Segment> tidied(Connector& connector, const LocalPose& start,
                            std::vector<Segment> segments) {
  Tidier tidier(connector, start, std::move(segments));
  tidier.drop_crumbs();
  return tidier.segments();
}

search::Route Finisher::with_fewer_changes(const search::Route& best, double shortest,
                                           std::uint64_t seed, search::Budget& budget) const {
  if (has_prices() || best.legs.size() < 2) return best;
  CostRule rule = pricing_.rule();
  rule.gear_change_cost = 1e-8;  // so small that it only breaks ties [m]
  Connector connector(task_, rule);
  Route route = best;
  route.cost = cost_of(rule, route);
  Shortener shortener(connector, std::move(route), seed);
  for (int i = 0; i < trials_for_fewer_changes && !budget.is_interrupted() && budget.next(); ++i) {
    shortener.step();
  }
  Route tidied = shortener.route();
  tidied.cost = cost_of(pricing_.rule(), tidied);
  return tidied.cost <= shortest * (1 + 1e-9) ? tidied : best;
}

std::vector<Segment> Finisher::raw(const Drive& best) const {
  if (best.commands.empty() || !best.segments.empty()) return best.segments;
  commands::DriveShortener drive(task_, pricing_.rule(), best.commands, 0);
  if (rules_.is_continuous) drive.drop_crumbs();
  return drive.segments();
}

std::optional<Drive> Finisher::drivable(const Drive& best, const std::vector<Segment>& raw,
                                        bool is_optimal) const {
  if (rules_.is_finished) {
    if (rules_.stroke == 0.0) return std::nullopt;
    const double cost = best.cost - planning::price_of_lack(raw, rules_.stroke);
    return Drive{.segments = raw, .cost = cost};
  }
  const bool is_bent = !best.commands.empty();
  const double stroke = rules_.stroke;
  const CostRule& rule = pricing_.rule();
  if (stroke == 0.0 && !is_bent && !has_prices()) return std::nullopt;
  Connector connector(task_, rule);
  Drive drivable{.segments = raw};
  if (stroke > 0.0) {
    const bool is_along = best.route && path_of(*best.route).segments == raw;
    const Route legs = is_along ? *best.route : legs_along({task_.start, raw}, task_.goal);
    const DrivenBeside beside = driven_at_ends(task_, rule.initial_gear);
    drivable.segments = path_of(with_strokes(connector, beside, legs, stroke)).segments;
  }
  if (!rules_.is_continuous || (has_prices() && !is_optimal)) {
    std::vector<Segment> neat = tidied(connector, task_.start, drivable.segments);
    const auto lack = [&](std::span<const Segment> s) {
      return planning::price_of_lack(s, stroke);
    };
    if (lack(neat) <= lack(drivable.segments)) drivable.segments = std::move(neat);
  }
  if (stroke == 0.0 && !is_bent && drivable.segments == raw) return std::nullopt;
  drivable.cost = pricing_.cost(drivable.segments,
                                connector.clearance_cost(start_state(task_), drivable.segments));
  return drivable;
}

std::optional<Drive> Finisher::finished(const Drive& best, const std::vector<Segment>& raw,
                                        bool is_optimal) const {
  std::optional<Drive> neat = drivable(best, raw, is_optimal);
  if (!neat || !rules_.slack) return neat;
  return neat->cost > best.cost * (1 + *rules_.slack) ? std::nullopt : std::move(neat);
}

}  // namespace vandplan::anytime
