// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words of continuous steering may be the shortest, given the Reeds-Shepp word?

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "steering/continuous_kinds.h"
#include "steering/continuous_shortlist_rows.h"
#include "steering/word.h"

namespace vandplan::steering::shortlists {

/// Gear (bit 1: reverse) and side (bit 0: right) of a step; `no_way`: there is no step.
using Way = unsigned;
inline constexpr Way no_way = 4;
constexpr Way way_of(double gear, double side) {
  return (gear < 0 ? 2U : 0U) + (side < 0 ? 1U : 0U);
}
/// Bits of a way that a symmetry changes.
constexpr Way flips_of(const Symmetry& symmetry) {
  return (symmetry.swaps_gears() ? 2U : 0U) + (symmetry.swaps_sides() ? 1U : 0U);
}

struct Ways {
  Way first, last;
};

constexpr Ways worked_out_ways(const Steps& steps, const Symmetry& symmetry) {
  const Step& begin = steps.list[symmetry.swaps_ends() ? steps.count - 1 : 0];
  const Step& end = steps.list[symmetry.swaps_ends() ? 0 : steps.count - 1];
  const Way flips = flips_of(symmetry);
  return {way_of(begin.gear, begin.turn) ^ flips, way_of(end.gear, end.turn) ^ flips};
}

inline constexpr auto all_ways = [] {
  std::array<std::array<Ways, 8>, kinds.size()> ways{};
  for (std::size_t formula = 0; formula < kinds.size(); ++formula) {
    for (std::size_t i = 0; i < 8; ++i) {
      const Symmetry symmetry{(i & 4) != 0, (i & 2) != 0, (i & 1) != 0};
      ways[formula][i] = worked_out_ways(all_steps[formula], symmetry);
    }
  }
  return ways;
}();

/// Ways in which a word of a kind begins and ends under a symmetry.
constexpr Ways ways_of(const Kind& kind, const Symmetry& symmetry) {
  const auto& [x, y, half_turn] = symmetry;
  const std::size_t i = (x ? 4U : 0U) + (y ? 2U : 0U) + (half_turn ? 1U : 0U);
  return all_ways[static_cast<std::size_t>(kind.formula)][i];
}

/// Bits in which the way at an end of a word differs from the way that drives the winding back;
/// `no_way` if there is no winding.
constexpr Way beside(Way way, Way back) { return back == no_way ? no_way : way ^ back; }

/// A set of the rows of a list, a bit for each.
using Rows = std::uint64_t;

/// Images of words, and all sets of rows that a search asks for.
struct List {
  std::array<Likely, 35> rows{};
  Rows likely{};                    ///< rows that may be shortest without driving a winding back
  Rows arcs{};                      ///< rows of words without a line
  Rows half_turns{};                ///< likely rows that may turn by half a turn and more
  std::array<Rows, 5> first_way{};  ///< rows by the way in which their words begin
  std::array<Rows, 5> last_way{};   ///< rows by the way in which their words end
  /// Rows worth a look, by formula of the Reeds-Shepp word and by the ways that drive the first and
  /// the last winding back.
  std::array<std::array<std::array<Rows, 5>, 5>, 9> here{};

  /// The entry of `beside_windings` for a row; empty if there is none.
  using Beside = std::span<const BesideWindings>;

  /// Whether a row is worth a look for a formula. `back`: the ways that drive the windings back.
  /// `windings`: entry of the row beside windings; empty if `here` and `saving` decide.
  static constexpr bool is_worth_a_look(const Likely& row, const Ways& ways, const Ways& back,
                                        std::size_t formula, Beside windings) {
    const bool saves = ways.first == back.first || ways.last == back.last;
    unsigned set = static_cast<unsigned>(saves ? row.saving : row.here) >> formula;
    if (!windings.empty()) {
      const unsigned way = 5U * beside(ways.first, back.first) + beside(ways.last, back.last);
      set = windings[0][formula] >> way;
    }
    return (set & 1U) != 0;
  }

  constexpr void add(std::size_t i, const Likely& row, Beside windings) {
    const Steps& steps = all_steps[static_cast<std::size_t>(kinds[row.kind].formula)];
    const Rows bit = Rows{1} << i;
    rows[i] = row;
    if (steps.list[1].turn != 0 && steps.list[2].turn != 0) arcs |= bit;
    const Ways ways = ways_of(kinds[row.kind], row.symmetry);
    first_way[ways.first] |= bit;
    last_way[ways.last] |= bit;
    for (std::size_t formula = 0; formula < 9; ++formula) {
      mark(i, row, ways, formula, windings);
    }
  }

  /// Marks in `here` for which ways row `i` is worth a look, for one formula.
  constexpr void mark(std::size_t i, const Likely& row, const Ways& ways, std::size_t formula,
                      Beside windings) {
    for (Way first = 0; first <= no_way; ++first) {
      for (Way last = 0; last <= no_way; ++last) {
        const Beside asked = first != no_way || last != no_way ? windings : Beside();
        if (is_worth_a_look(row, ways, {first, last}, formula, asked)) {
          here[formula][first][last] |= Rows{1} << i;
        }
      }
    }
  }
};

template <std::size_t n>
constexpr List list_of(const std::array<Likely, n>& likely, List::Beside windings) {
  List list;
  for (std::size_t i = 0; i < n + saving_images.size(); ++i) {
    list.add(i, i < n ? likely[i] : saving_images[i - n],
             windings.empty() ? windings : windings.subspan(i, 1));
  }
  list.likely = (Rows{1} << n) - 1;
  list.half_turns = Rows{1} << 3 | Rows{1} << 7;  // r_lsl, lr_lr
  return list;
}

inline constexpr List rolling_list = list_of(rolling, beside_windings);
inline constexpr List standing_list = list_of(standing, {});
inline constexpr List leg_list = list_of(legs, {});

}  // namespace vandplan::steering::shortlists
