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
#include <optional>

#include "simd/circle_kernels.h"
#include "steering/continuous_bounds.h"
#include "steering/continuous_circles.h"
#include "steering/continuous_images.h"
#include "steering/continuous_kinds.h"
#include "steering/continuous_shortlists.h"

namespace vandplan::steering::looks {

using namespace families;

/// Limits of likely words of a steering (measured).
struct Room {
  double ramp;  ///< length of a clothoid to full lock [turning radii]
  double high;  ///< the cosine of the first or last angle of a word is at least -`high`
};

/// How far below 0 the first and the last angle of a word may be, as sines.
struct Lows {
  double first, last;
};

/// Whether the angle of an arrow is likely for an end of a word: from -`low` to a little more than
/// a quarter turn; in a word of three arcs to half a turn.
inline bool is_likely(const Arrow& arrow, double low, double high, bool is_three_arcs) {
  const double squared = arrow.squared();
  const double least = low * low + 1e-24;
  if (arrow.im < 0 && (arrow.re < 0 || arrow.im * arrow.im > least * squared)) return false;
  return arrow.re >= 0 || is_three_arcs || arrow.re * arrow.re <= high * high * squared;
}

/// Angles of a word by its circles, if they are likely, for steering between stops.
inline std::optional<Arcs> likely_arcs_at_stops(Formula formula, const CircleWord& circles,
                                                const Room& room, const Lows& lows) {
  const bool is_three_arcs = formula == Formula::l_r_l;
  if (!circles.exact || circles.line < -2 * room.ramp ||
      !is_likely(circles.first, lows.first, room.high, is_three_arcs) ||
      !is_likely(circles.last, lows.last, room.high, is_three_arcs)) {
    return std::nullopt;
  }
  return in_one_turn(circles.arcs());
}

/// Angles of a word by its circles, if they are likely, where the curvature never jumps.
inline std::optional<Arcs> likely_arcs(Formula formula, const CircleWord& circles, const Room& room,
                                       Lows lows) {
  if (circles.line < -1.05 * room.ramp) return std::nullopt;
  if (circles.line > 3 * room.ramp) {  // clothoids beside a long line move the turns but little
    lows.first = std::min(lows.first, 0.01 * room.ramp);
    lows.last = std::min(lows.last, 0.01 * room.ramp);
  }
  return likely_arcs_at_stops(formula, circles, room, lows);
}

/// A word by its circles: angles and estimated length.
struct NearWord {
  Arcs arcs;
  double length;
};

/// The word of a formula by its circles, where the curvature never jumps; nothing if there is none.
/// `simd::circle_words` gives the same for many words.
inline std::optional<NearWord> near_word(Formula formula, const WordFrame& frame,
                                         const Joints& joints, const Room& room, const Lows& lows) {
  const auto arcs = likely_arcs(formula, circles::word_of(formula, frame, joints), room, lows);
  if (!arcs) return std::nullopt;
  const auto& [first, inner, last] = bounds::small_turns_of(formula);
  const double wide = bounds::wide(arcs->inner);
  if (arcs->first < (first.least - wide) * room.ramp ||
      arcs->last < (last.least - wide) * room.ramp || arcs->inner < inner.least * room.ramp) {
    return std::nullopt;
  }
  return NearWord{*arcs, bounds::length_near(formula, *arcs, room.ramp)};
}

/// Largest length that a word with these angles by its circles may save [turning radii].
inline double most_saved_near(Formula formula, const images::Image& image, const Arcs& arcs,
                              double ramp) {
  const auto& [first, inner, last] = bounds::small_turns_of(formula);
  constexpr double vanishes = 1e-6;
  const bool has_ends =
      arcs.first > first.gone * ramp + vanishes && arcs.last > last.gone * ramp + vanishes;
  // If an end step vanishes, the step beside it may save as much as any word.
  const double most = image.view->most_saved();
  if (most == 0 || !has_ends) return most;
  const double wide = bounds::wide(arcs.inner);
  const auto saves = [&](const bounds::Small& turn, double arc, double by_turn) {
    const bool lacks_line = arcs.line < 0;
    const bool may_wind = bounds::may_wind(turn.least - wide, arc, by_turn / 2, ramp);
    const double may_save[] = {0, by_turn};  // a table: branches would be mispredicted
    return may_save[lacks_line || may_wind ? 1 : 0];
  };
  return saves(first, arcs.first, image.first_saves) + saves(last, arcs.last, image.last_saves);
}

/// An image that a search looks at: a row of the list in one frame.
struct Look {
  std::uint8_t row;
  std::uint8_t formula, word;  ///< indices of the word's formula, and of the word in that formula
};

namespace detail {

constexpr simd::SmallTurn small(const bounds::Small& turn) {
  return {turn.least, turn.lack, turn.growth, turn.most};
}

inline constexpr auto formulas = [] {
  std::array<simd::CircleFormula, simd::circle_formulas> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Steps& steps = all_steps[i];
    const Step& first = steps.list[0];
    const Step& last = steps.list[steps.count - 1];
    const auto& [begin, inner, end] = bounds::small_turns[i];
    all[i] = {first.gear, first.turn, last.gear, last.turn, small(begin), small(inner), small(end)};
  }
  return all;
}();

/// The image of a row: signs of its frame, and how far below 0 its end turns may be [ramps].
struct Sight {
  double x, y, half_turn, low_first, low_last;
  std::size_t formula;
};

inline constexpr auto sights = [] {
  std::array<Sight, shortlists::rolling_list.rows.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const shortlists::Likely& row = shortlists::rolling_list.rows[i];
    const auto& [x, y, half_turn] = row.symmetry;
    const auto sign = [](bool negative) { return negative ? -1.0 : 1.0; };
    all[i] = {sign(x),         sign(y),        sign(half_turn),
              row.first.rolls, row.last.rolls, static_cast<std::size_t>(kinds[row.kind].formula)};
  }
  return all;
}();

/// Whether the kernel has room for all words. Four tasks look at each row once, and once more at
/// some of the first ten in the frame the other way round.
constexpr bool has_room() {
  std::array<std::size_t, simd::circle_formulas> counts{};
  for (std::size_t i = 0; i < sights.size(); ++i) {
    counts[sights[i].formula] += i < shortlists::rolling.size() ? 8 : 4;
  }
  return *std::max_element(counts.begin(), counts.end()) <= simd::CircleWords::most;
}
static_assert(has_room());

}  // namespace detail

/// Images in the order in which a search looks at them, and their words.
class Looks {
 public:
  Looks() {
    for (simd::CircleWords& words : words_) words.count = 0;
  }

  /// Adds rows as images of a frame.
  void add(shortlists::Rows rows, const WordFrame& frame, double ramp) {
    for (; rows != 0; rows &= rows - 1) {
      const auto row = static_cast<std::uint8_t>(std::countr_zero(rows));
      const detail::Sight& sight = detail::sights[row];
      simd::CircleWords& words = words_[sight.formula];
      const std::size_t i = words.count++;
      words.x[i] = frame.x * sight.x;
      words.y[i] = frame.y * sight.y;
      words.sin[i] = frame.s * sight.half_turn;
      words.cos[i] = frame.c;
      words.low_first[i] = ramp * sight.low_first;
      words.low_last[i] = ramp * sight.low_last;
      list_[count_++] = {row, static_cast<std::uint8_t>(sight.formula),
                         static_cast<std::uint8_t>(i)};
    }
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const Look& operator[](std::size_t i) const { return list_[i]; }

  /// Works out all words. Returns false in a build without vectors of double.
  bool work_out(const Joints& joints, const Room& room) {
    return simd::circle_words(
        words_, detail::formulas,
        {joints.ahead, joints.aside, joints.reach, joints.skew, room.ramp, room.high});
  }

  /// Estimated length of the word of a look, without windings; infinity if there is no word.
  [[nodiscard]] double length(const Look& look) const {
    return words_[look.formula].length[look.word];
  }
  [[nodiscard]] Arcs arcs(const Look& look) const {
    const simd::CircleWords& words = words_[look.formula];
    const std::size_t i = look.word;
    return {0, words.first[i], words.inner[i], words.line[i], words.last[i]};
  }

 private:
  std::array<simd::CircleWords, simd::circle_formulas> words_;
  std::array<Look, 180> list_;
  std::size_t count_ = 0;
};

}  // namespace vandplan::steering::looks
