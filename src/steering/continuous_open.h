// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which word does Newton's method solve next?

#include <array>
#include <cstddef>
#include <limits>

#include "steering/continuous_images.h"
#include "steering/continuous_kinds.h"

namespace vandplan::steering::open_words {

using namespace families;

/// A word that Newton's method has to find.
struct Open {
  Formula formula;
  images::Image image;
  Arcs guess, second_guess;
  bool has_second;
  double bound;  ///< practical bound of the length of its path, windings included
};

/// The open words of a search.
class OpenWords {
 public:
  /// Adds a word, whose guess the caller fills in; null if there is no room.
  Open* add(Formula formula, const images::Image& image, double bound) {
    if (count_ == list_.size()) return nullptr;
    Open& open = list_[count_++];
    open.formula = formula;
    open.image = image;
    open.has_second = false;
    open.bound = bound;
    return &open;
  }

  /// The word with the least bound, each word once only; null if no bound is below `best`.
  const Open* next(double best) {
    constexpr double same = 1e-9;  // bounds this near are equal: the word added first wins
    std::size_t least = 0;
    for (std::size_t i = 1; i < count_; ++i) {
      if (list_[i].bound < list_[least].bound - same) least = i;
    }
    if (count_ == 0 || list_[least].bound >= best) return nullptr;
    list_[least].bound = std::numeric_limits<double>::infinity();
    return &list_[least];
  }

  void clear() { count_ = 0; }

 private:
  std::array<Open, 160> list_;
  std::size_t count_ = 0;
};

}  // namespace vandplan::steering::open_words
