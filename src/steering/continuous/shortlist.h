// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words of continuous steering may be the shortest, given the Reeds-Shepp word?

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "steering/continuous/shortlist_rows.h"
#include "steering/word.h"

namespace vandplan::steering::continuous::shortlists {

/// Gear and side of a step. Bit 1: reverse, bit 0: right; `no_letter`: there is no step.
using Letter = unsigned;
inline constexpr Letter no_letter = 4;
constexpr Letter letter_of(double gear, double side) {
  return (gear < 0 ? 2U : 0U) + (side < 0 ? 1U : 0U);
}
/// Bits of a letter that a symmetry changes.
constexpr Letter flips_of(const Symmetry& symmetry) {
  return (symmetry.swaps_gears() ? 2U : 0U) + (symmetry.swaps_sides() ? 1U : 0U);
}

struct EndLetters {
  Letter first, last;
};

constexpr EndLetters worked_out_letters(const Steps& steps, const Symmetry& symmetry) {
  const Step& begin = steps.list[symmetry.swaps_ends() ? steps.count - 1 : 0];
  const Step& end = steps.list[symmetry.swaps_ends() ? 0 : steps.count - 1];
  const Letter flips = flips_of(symmetry);
  return {letter_of(begin.gear, begin.turn) ^ flips, letter_of(end.gear, end.turn) ^ flips};
}

inline constexpr auto all_end_letters = [] {
  std::array<std::array<EndLetters, 8>, formula_count> letters{};
  for (std::size_t formula = 0; formula < formula_count; ++formula) {
    for (std::size_t i = 0; i < 8; ++i) {
      const Symmetry symmetry{(i & 4) != 0, (i & 2) != 0, (i & 1) != 0};
      letters[formula][i] = worked_out_letters(all_steps[formula], symmetry);
    }
  }
  return letters;
}();

/// First and last letter of the word of a formula under a symmetry.
constexpr EndLetters end_letters_of(Formula formula, const Symmetry& symmetry) {
  const auto& [x, y, half_turn] = symmetry;
  const std::size_t i = (x ? 4U : 0U) + (y ? 2U : 0U) + (half_turn ? 1U : 0U);
  return all_end_letters[static_cast<std::size_t>(formula)][i];
}

/// Bits in which a letter at an end of a word differs from the one that drives the winding back;
/// `no_letter` if there is no winding.
constexpr Letter beside(Letter letter, Letter back) {
  return back == no_letter ? no_letter : letter ^ back;
}

/// A set of the rows of a shortlist, a bit for each.
using RowSet = std::uint64_t;

/// Words that may be the shortest, and all sets of rows that a search asks for.
struct Shortlist {
  std::array<Row, 35> rows{};
  RowSet likely{};      ///< rows that may be shortest without a winding driven back
  RowSet arcs{};        ///< rows of words without a line
  RowSet half_turns{};  ///< likely rows that may turn by half a turn and more
  std::array<RowSet, 5> by_first_letter{};  ///< rows by the first letters of their words
  std::array<RowSet, 5> by_last_letter{};   ///< rows by the last letters of their words
  /// Rows that may be shortest, by the formula of the Reeds-Shepp word and by the letters that
  /// drive the first and the last winding back.
  std::array<std::array<std::array<RowSet, 5>, 5>, 9> candidates{};

  /// The entry of `beside_windings` for a row; empty if there is none.
  using Beside = std::span<const BesideWindings>;

  /// Whether a row may be shortest for a formula. `back`: the letters that drive the windings back.
  /// `windings`: entry of the row beside windings; empty if `plain` and `saving` decide.
  static constexpr bool is_candidate(const Row& row, const EndLetters& ends, const EndLetters& back,
                                     std::size_t formula, Beside windings) {
    const bool saves = ends.first == back.first || ends.last == back.last;
    unsigned set = static_cast<unsigned>(saves ? row.saving : row.plain) >> formula;
    if (!windings.empty()) {
      const unsigned pair = 5U * beside(ends.first, back.first) + beside(ends.last, back.last);
      set = windings[0][formula] >> pair;
    }
    return (set & 1U) != 0;
  }

  constexpr void add(std::size_t i, const Row& row, Beside windings) {
    const Steps& steps = all_steps[static_cast<std::size_t>(row.formula)];
    const RowSet bit = RowSet{1} << i;
    rows[i] = row;
    if (steps.list[1].turn != 0 && steps.list[2].turn != 0) arcs |= bit;
    const EndLetters ends = end_letters_of(row.formula, row.symmetry);
    by_first_letter[ends.first] |= bit;
    by_last_letter[ends.last] |= bit;
    for (std::size_t formula = 0; formula < 9; ++formula) {
      add_candidate(i, row, ends, formula, windings);
    }
  }

  /// Adds row `i` to `candidates` for one formula of the Reeds-Shepp word.
  constexpr void add_candidate(std::size_t i, const Row& row, const EndLetters& ends,
                               std::size_t formula, Beside windings) {
    for (Letter first = 0; first <= no_letter; ++first) {
      for (Letter last = 0; last <= no_letter; ++last) {
        const Beside asked = first != no_letter || last != no_letter ? windings : Beside();
        if (is_candidate(row, ends, {first, last}, formula, asked)) {
          candidates[formula][first][last] |= RowSet{1} << i;
        }
      }
    }
  }
};

template <std::size_t n>
constexpr Shortlist shortlist_of(const std::array<Row, n>& likely, Shortlist::Beside windings) {
  Shortlist list;
  for (std::size_t i = 0; i < n + saving_rows.size(); ++i) {
    list.add(i, i < n ? likely[i] : saving_rows[i - n],
             windings.empty() ? windings : windings.subspan(i, 1));
  }
  list.likely = (RowSet{1} << n) - 1;
  list.half_turns = RowSet{1} << 3 | RowSet{1} << 7;  // r_lsl, lr_lr
  return list;
}

inline constexpr Shortlist rolling_shortlist = shortlist_of(rolling_rows, beside_windings);
inline constexpr Shortlist standing_shortlist = shortlist_of(standing_rows, {});
inline constexpr Shortlist leg_shortlist = shortlist_of(leg_rows, {});

}  // namespace vandplan::steering::continuous::shortlists
