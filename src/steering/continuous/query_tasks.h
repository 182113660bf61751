// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words join two poses if the wheels are bent there?
//
// A winding straightens the wheels in either gear, at either end. So there are up to four tasks.

#include <optional>
#include <type_traits>

#include "steering/continuous/word_search.h"
#include "steering/continuous/word_task.h"
#include "vandplan/geometry.h"
#include "vandplan/steering.h"

namespace vandplan::steering::continuous {

/// A query at unit radius. The first pose is at the origin, under its heading in the world.
struct UnitQuery {
  Pose from, to;
  Stops stops;
  double start_curvature = 0.0, goal_curvature = 0.0;  ///< 0 where the vehicle stands
  double cutoff = 0.0;  ///< longer paths are of no use [turning radii]
};

/// The query at unit radius between two finite poses [m].
[[nodiscard]] UnitQuery unit_query(const ContinuousSteering& steering, const Pose& from,
                                   const Pose& to, const ContinuousQuery& query);

/// An array of four values, not initialised, so that unused ones cost nothing.
template <typename T>
class UpToFour {
 public:
  UpToFour() noexcept {}  // NOLINT(modernize-use-equals-default): a union has no default of its own
  T& operator[](std::size_t i) { return list_[i]; }
  const T& operator[](std::size_t i) const { return list_[i]; }
  [[nodiscard]] const T* data() const { return list_; }

 private:
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  union {
    T list_[4];
  };
};

/// All ways to begin a path, each with every way to end it: tasks between straight wheels.
struct QueryTasks {
  UpToFour<WordTask> tasks;
  /// Windings as segments driven before and after a word; of length 0 where there is none.
  struct WindingSegments {
    Segment first, last;
  };
  UpToFour<WindingSegments> windings;
  std::size_t count = 0;
  SearchBreadth breadth;  ///< which words the search considers
};

/// The task between two poses as if the wheels were straight there, made when it is needed.
class DirectTask {
 public:
  explicit DirectTask(const UnitQuery& query) noexcept;

  const WordTask& task() noexcept;
  /// Length of the Reeds-Shepp path; no path is shorter, except for rounding.
  double length() noexcept { return task().reeds_shepp.arcs.length; }

  // The straight distance often decides, without the Reeds-Shepp path.
  bool is_shorter_than(double length) noexcept {
    return straight_ < length && this->length() < length;
  }
  bool is_at_least(double length) noexcept {
    return straight_ >= length || this->length() >= length;
  }

 private:
  const UnitQuery& query_;
  double straight_;
  std::optional<WordTask> made_;
};

/// The tasks of a query, with `stops` in place of those of the query.
[[nodiscard]] QueryTasks tasks_of(const WordSolver& solver, const UnitQuery& query,
                                  const Stops& stops, DirectTask& direct);

}  // namespace vandplan::steering::continuous
