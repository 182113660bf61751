// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/ghosts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "base/trigonometry.h"
#include "moving/encounters.h"
#include "vandplan/input_error.h"
#include "vandplan/vehicle.h"

namespace vandplan::in_time {
namespace {

constexpr double time_step = 0.5;     // spacing of the times of ghosts [s]
constexpr double passing_time = 3.0;  // span of a passing ghost before and after the meeting [s]
constexpr double outline_step = 1.0;  // spacing of the outlines of a ghost [s]
constexpr double max_outlines = 24;   // most outlines of a ghost and an obstacle, less one
constexpr double first_delay = 2.0;   // how much later a ghost begins at first [s]
constexpr double growth = 0.5;        // growth of later delays, as a share of the delay so far
constexpr double forever = std::numeric_limits<double>::infinity();

/// The outline of an obstacle at a time, in the frame of the task; empty if it has left.
Polygon outline_at(const MovingObstacle& obstacle, double t) {
  const std::optional<Pose> pose = pose_at(obstacle, t);
  Polygon there;
  if (!pose) return there;
  const auto [sin, cos] = base::sin_cos(pose->heading);
  for (const auto& [x, y] : obstacle.outline) {
    there.push_back({pose->x + cos * x - sin * y, pose->y + sin * x + cos * y});
  }
  return there;
}

/// Collects the outlines of ghosts, each once. An outline that the vehicle would touch at the start
/// is left out: the vehicle is elsewhere then.
class Outlines {
 public:
  Outlines(const Task& task, double margin)
      : task_(task),
        path_{task.start, {}},
        encounters_({path_, task.vehicle}, task.moving, margin) {}

  void add(const Ghost& ghost) {
    for (std::size_t i = 0; i < task_.moving.size(); ++i) {
      if (ghost.obstacle.value_or(i) == i) add(i, ghost);
    }
  }

  [[nodiscard]] const std::vector<Polygon>& all() const { return outlines_; }

 private:
  void add(std::size_t i, const Ghost& ghost) {
    const MovingObstacle& obstacle = task_.moving[i];
    const double last = std::max(obstacle.trajectory.back().t, 0.0);
    if (ghost.begin > last && obstacle.after == Afterwards::leaves) return;
    const double begin = std::clamp(ghost.begin, 0.0, last);
    const double end = std::clamp(ghost.end, 0.0, last);
    const double count = std::clamp(std::ceil((end - begin) / outline_step), 1.0, max_outlines);
    for (double k = 0; k <= count; ++k) {
      const double t = begin + (end - begin) * k / count;
      if (encounters_.gap(i, start_state(task_), t, 1.0) <= 0.0) continue;
      Polygon outline = outline_at(obstacle, t);
      const bool is_new = std::ranges::find(outlines_, outline) == outlines_.end();
      if (!outline.empty() && is_new) outlines_.push_back(std::move(outline));
    }
  }

  const Task& task_;
  const Path path_;  // to stay where it starts
  const moving::Encounters encounters_;
  std::vector<Polygon> outlines_;
};

/// Whether a ghost has no outline that `whole` lacks.
bool is_part_of(const Ghost& ghost, const Ghost& whole) {
  const bool is_of_whole = !whole.obstacle || ghost.obstacle == whole.obstacle;
  return is_of_whole && whole.begin <= ghost.begin && ghost.end <= whole.end;
}

/// Whether ghosts have no outline that `whole` lacks.
bool are_part_of(const Ghosts& ghosts, const Ghosts& whole) {
  return std::ranges::all_of(ghosts, [&](const Ghost& ghost) {
    return std::ranges::any_of(whole, [&](const Ghost& other) { return is_part_of(ghost, other); });
  });
}

}  // namespace

Ghosts ghosts_at(const Meeting& meeting) {
  const double t = std::round(meeting.t / time_step) * time_step;
  const std::size_t i = meeting.obstacle;
  return {
      {i, t, t}, {{}, forever, forever}, {i, t - passing_time, t + passing_time}, {i, t, forever}};
}

std::optional<Ghosts> TriedGhosts::with(const Ghosts& ghosts, Ghost more) {
  for (;;) {
    if (are_part_of({more}, ghosts)) return std::nullopt;
    Ghosts all = ghosts;
    std::erase_if(all, [&](const Ghost& known) { return is_part_of(known, more); });
    all.push_back(more);
    if (!is_blocked(all)) {
      const auto is_same = [&](const Ghosts& known) {
        return are_part_of(known, all) && are_part_of(all, known);
      };
      if (std::ranges::any_of(tried_, is_same)) return std::nullopt;
      tried_.push_back(all);
      return all;
    }
    if (!begin_later(more)) return std::nullopt;
  }
}

std::optional<Ghosts> TriedGhosts::begun_later(Ghosts ghosts) {
  Ghost last = ghosts.back();
  ghosts.pop_back();
  if (!begin_later(last)) return std::nullopt;
  return with(ghosts, last);
}

/// Delays a ghost that lasts for ever. False if there is none, or nothing of it would be left.
bool TriedGhosts::begin_later(Ghost& ghost) const {
  if (!ghost.obstacle || ghost.end < forever) return false;
  const double more = std::max(first_delay, growth * ghost.delay);
  ghost.begin += more;
  ghost.delay += more;
  return ghost.begin <= moving_[*ghost.obstacle].trajectory.back().t;
}

bool TriedGhosts::is_blocked(const Ghosts& ghosts) const {
  return std::ranges::any_of(blocked_,
                             [&](const Ghosts& known) { return are_part_of(known, ghosts); });
}

std::optional<Task> task_around(const Task& task, const Ghosts& ghosts,
                                const ClearanceOptions& clearance) {
  Outlines outlines(task, clearance.margin);
  std::size_t before = 0;
  for (const Ghost& ghost : ghosts) {
    before = outlines.all().size();
    outlines.add(ghost);
  }
  if (outlines.all().size() == before) return std::nullopt;
  try {
    auto world = std::make_shared<const World>(*task.world, outlines.all());
    const Problem problem = make_problem(std::move(world), task.vehicle, task.start, task.goal,
                                         task.curvatures, task.hitch_angles);
    Task around = task_of(problem, clearance, task.steering);
    around.last_stretch = task.last_stretch;
    around.via = task.via;
    around.moving = task.moving;
    const CollisionChecker& checker = *around.checker;
    if (checker.is_free(start_state(task)) && checker.is_free(goal_state(task))) return around;
  } catch (const InputError&) {
    // By a rounding error a turned outline may touch itself. It is no obstacle then.
  }
  return std::nullopt;
}

}  // namespace vandplan::in_time
