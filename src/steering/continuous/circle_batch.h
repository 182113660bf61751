// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which circles do the words of a search have, where the curvature never jumps?
//
// The circles of all words are worked out at once, by the kernel of simd/circle_kernels.h.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "simd/circle_kernels.h"
#include "steering/continuous/circle_word.h"
#include "steering/continuous/estimates.h"
#include "steering/continuous/shortlist.h"

namespace vandplan::steering::continuous {

/// A candidate of a batch: a row of the shortlist in one frame.
struct BatchEntry {
  std::uint8_t row;
  std::uint8_t formula, word;  ///< indices of the word's formula, and of the word in that formula
};

namespace detail {

constexpr simd::SmallTurn small(const SmallTurn& turn) {
  return {turn.min_angle, turn.lack, turn.growth, turn.max_lack};
}

inline constexpr auto formulas = [] {
  std::array<simd::CircleFormula, simd::circle_formulas> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Steps& steps = all_steps[i];
    const Step& first = steps.list[0];
    const Step& last = steps.list[steps.count - 1];
    const auto& [begin, inner, end] = small_turns[i];
    all[i] = {first.gear, first.turn, last.gear, last.turn, small(begin), small(inner), small(end)};
  }
  return all;
}();

/// A row of the shortlist: the signs of its mirrored frame, and how far below 0 its end turns may
/// be [ramps].
struct MirroredRow {
  double x, y, half_turn, slack_first, slack_last;
  std::size_t formula;
};

inline constexpr auto mirrored_rows = [] {
  std::array<MirroredRow, shortlists::rolling_shortlist.rows.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const shortlists::Row& row = shortlists::rolling_shortlist.rows[i];
    const auto& [x, y, half_turn] = row.symmetry;
    const auto sign = [](bool negative) { return negative ? -1.0 : 1.0; };
    all[i] = {sign(x),         sign(y),        sign(half_turn),
              row.first.rolls, row.last.rolls, static_cast<std::size_t>(row.formula)};
  }
  return all;
}();

/// Whether all words fit into the kernel's arrays. Four tasks try each row once, and some of the
/// first ten once more with the opposite turn.
constexpr bool fits_kernel() {
  std::array<std::size_t, simd::circle_formulas> counts{};
  for (std::size_t i = 0; i < mirrored_rows.size(); ++i) {
    counts[mirrored_rows[i].formula] += i < shortlists::rolling_rows.size() ? 8 : 4;
  }
  return *std::max_element(counts.begin(), counts.end()) <= simd::CircleWords::capacity;
}
static_assert(fits_kernel());

}  // namespace detail

/// Candidates in the order in which a search tries them, and their words.
class CircleBatch {
 public:
  CircleBatch() {
    for (simd::CircleWords& words : words_) words.count = 0;
  }

  /// Adds rows in a frame.
  void add(shortlists::RowSet rows, const WordFrame& frame, double ramp) {
    for (; rows != 0; rows &= rows - 1) {
      const auto row = static_cast<std::uint8_t>(std::countr_zero(rows));
      const detail::MirroredRow& signs = detail::mirrored_rows[row];
      simd::CircleWords& words = words_[signs.formula];
      const std::size_t i = words.count++;
      words.x[i] = frame.x * signs.x;
      words.y[i] = frame.y * signs.y;
      words.sin[i] = frame.s * signs.half_turn;
      words.cos[i] = frame.c;
      words.slack_first[i] = ramp * signs.slack_first;
      words.slack_last[i] = ramp * signs.slack_last;
      list_[count_++] = {row, static_cast<std::uint8_t>(signs.formula),
                         static_cast<std::uint8_t>(i)};
    }
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const BatchEntry& operator[](std::size_t i) const { return list_[i]; }

  /// Works out all words. Returns false in a build without vectors of double.
  bool work_out(const Joints& joints, const AngleLimits& limits) {
    return simd::circle_words(
        words_, detail::formulas,
        {joints.ahead, joints.aside, joints.reach, joints.skew, limits.ramp, limits.high});
  }

  /// Estimated length of the word of an entry, without windings; infinity if there is no word.
  [[nodiscard]] double length(const BatchEntry& entry) const {
    return words_[entry.formula].length[entry.word];
  }
  [[nodiscard]] Arcs arcs(const BatchEntry& entry) const {
    const simd::CircleWords& words = words_[entry.formula];
    const std::size_t i = entry.word;
    return {0, words.first[i], words.inner[i], words.line[i], words.last[i]};
  }

 private:
  std::array<simd::CircleWords, simd::circle_formulas> words_;
  std::array<BatchEntry, 180> list_;
  std::size_t count_ = 0;
};

}  // namespace vandplan::steering::continuous
