// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// In which ways may a path begin and end whose wheels are bent there?

#include <optional>
#include <type_traits>

#include "steering/continuous_ends.h"
#include "steering/continuous_families.h"
#include "steering/continuous_turn.h"
#include "steering/continuous_word.h"

namespace vandplan::steering {

/// Room for four; what is not used costs nothing.
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

/// The ways to begin, each with every way to end.
struct Combinations {
  UpToFour<WordTask> tasks;
  /// What is driven before and after each word; of length zero if the wheels are straight.
  struct Around {
    Segment first, last;
  };
  UpToFour<Around> around;
  std::size_t count = 0;
  Looked looked;  ///< for a word of them
};

/// From pose to pose as if the wheels were straight there, for whoever asks.
class Direct {
 public:
  explicit Direct(const EndsTask& task) noexcept;

  const WordTask& task() noexcept;
  /// Of Reeds and Shepp: no path is shorter, but for rounding.
  double length() noexcept { return task().sharp.arcs.length; }

  // Where the straight line is as long there is no need to know more.
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

/// The ways to begin and to end of a task, where it stops at other places.
[[nodiscard]] Combinations combinations_of(const WordSolver& solver, const EndsTask& task,
                                           const Stops& stops, Direct& direct);

}  // namespace vandplan::steering
