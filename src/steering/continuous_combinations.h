// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// In which ways may a path begin and end if its wheels are bent there?

#include <optional>
#include <type_traits>

#include "steering/continuous_ends.h"
#include "steering/continuous_families.h"
#include "steering/continuous_turn.h"
#include "steering/continuous_word.h"

namespace vandplan::steering {

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

/// All ways to begin a path, each with every way to end it.
struct Combinations {
  UpToFour<WordTask> tasks;
  /// Segments driven before and after a word; of length 0 where the wheels are straight.
  struct Around {
    Segment first, last;
  };
  UpToFour<Around> around;
  std::size_t count = 0;
  Looked looked;  ///< which words the search considers
};

/// The way between two poses as if the wheels were straight there, worked out when it is needed.
class Direct {
 public:
  explicit Direct(const EndsTask& task) noexcept;

  const WordTask& task() noexcept;
  /// Length of the Reeds-Shepp path; no path is shorter, except for rounding.
  double length() noexcept { return task().sharp.arcs.length; }

  // The straight distance often decides, without the Reeds-Shepp path.
  bool is_shorter_than(double length) noexcept {
    return straight_ < length && this->length() < length;
  }
  bool is_at_least(double length) noexcept {
    return straight_ >= length || this->length() >= length;
  }

 private:
  const EndsTask& task_;
  double straight_;
  std::optional<WordTask> known_;
};

/// All ways to begin and to end the path of `task`, with `stops` in place of those of the task.
[[nodiscard]] Combinations combinations_of(const WordSolver& solver, const EndsTask& task,
                                           const Stops& stops, Direct& direct);

}  // namespace vandplan::steering
