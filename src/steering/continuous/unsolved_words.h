// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which word does Newton's method solve next?

#include <array>
#include <cstddef>
#include <limits>

#include "steering/continuous/candidate.h"

namespace vandplan::steering::continuous {

/// A word that Newton's method has to find.
struct UnsolvedWord {
  Candidate candidate;
  Arcs guess, second_guess;
  bool has_second;
  double lower_bound;  ///< practical bound of the length of its path, windings included
};

/// The unsolved words of a search.
class UnsolvedWords {
 public:
  /// Adds a word, whose guess the caller fills in; null if the list is full.
  UnsolvedWord* add(const Candidate& candidate, double lower_bound) {
    if (count_ == list_.size()) return nullptr;
    UnsolvedWord& word = list_[count_++];
    word.candidate = candidate;
    word.has_second = false;
    word.lower_bound = lower_bound;
    return &word;
  }

  /// The word with the least bound, each word once only; null if no bound is below `best`.
  const UnsolvedWord* next(double best) {
    constexpr double same = 1e-9;  // bounds this near are equal: the word added first wins
    std::size_t least = 0;
    for (std::size_t i = 1; i < count_; ++i) {
      if (list_[i].lower_bound < list_[least].lower_bound - same) least = i;
    }
    if (count_ == 0 || list_[least].lower_bound >= best) return nullptr;
    list_[least].lower_bound = std::numeric_limits<double>::infinity();
    return &list_[least];
  }

  void clear() { count_ = 0; }

 private:
  std::array<UnsolvedWord, 160> list_;
  std::size_t count_ = 0;
};

}  // namespace vandplan::steering::continuous
