// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "tables/excess.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "simd/bound_grid.h"
#include "tables/words_in_box.h"
#include "vandplan/steering.h"

namespace vandplan::tables {
namespace {

using namespace words_in_box;

constexpr double pi = std::numbers::pi;

Interval along_heading(End end, Interval arc, Interval middle, Interval size) {
  switch (end) {
    case End::cos_arc:
      return cosine(arc);
    case End::sin_arc:
      return sine(arc) * size;
    default:
      return sine(middle - arc) * size;
  }
}

/// Derivatives of polar coordinates by the coordinates of the grid, over a box.
struct Chart {
  Interval radial_to_distance;  ///< d distance / d radial
  Interval radial_to_nearness;  ///< d (1 / distance) / d radial, positive.
  Interval side_to_bearing;     ///< d bearing / d side
};

using Slopes = std::array<Interval, 3>;

/// Slopes of length - distance for one word, along radial, side and turn.
Slopes slopes_of(const Polar& box, const Chart& chart, const Word& word, const View& view,
                 const Pieces& p) {
  if (word.left_word == l_r_l) {
    return {-chart.radial_to_distance, point(0.0), point(pi * word.turn)};
  }
  const CirclePair& c = *view.circles;
  const Shape& shape = shape_of(word.left_word);
  const double handed = view.handed;
  const Interval size = shape.has_line ? point(1.0) : inverse(sine(p.middle));
  const Interval push = c.directed ? c.lean * handed + p.tilt : Interval{-pi, pi};
  const Interval cos_push = cosine(push);
  Interval across = box.distance * (size * sine(push));
  Interval along = (size * cos_push - 1.0) * chart.radial_to_distance;
  if (shape.has_line && box.distance.low > far) {
    const bool tilted = p.tilt.high > 0.0;
    const Interval lean = c.across * handed * (tilted ? cosine(p.tilt) : point(1.0));
    across = meet(across, c.stretch * (lean + c.cos_lean * (tilted ? 2.0 : 0.0)));
    along = -(square(across) * inverse(cos_push + 1.0) * chart.radial_to_nearness);
  }
  const Interval end0 = 1.0 - along_heading(shape.first_end, p.first, p.middle, size);
  const Interval end1 = 1.0 - along_heading(shape.last_end, p.last, p.middle, size);
  const Interval turn = (end0 + end1 * static_cast<double>(shape.last_turn)) * (pi / 2);
  return {along, across * chart.side_to_bearing * handed, turn * static_cast<double>(word.turn)};
}

/// A word that may be shortest somewhere in the box.
struct Candidate {
  std::size_t word;
  Pieces pieces;
  Slopes slopes;
  double lead = 0.0;    ///< Length of the word in the centre - shortest length there.
  bool counts = false;  ///< Whether the word may be shortest somewhere, as far as is known yet.
};

PairBox centre_of(const PairBox& box) {
  return {point(box.radial.middle()), point(box.side.middle()), point(box.turn.middle())};
}

double shortest_length(const Polar& centre) {
  const double half = centre.turn.low / 2;
  const double x = centre.distance.low * centre.cos_bearing.low;
  const double y = centre.distance.low * centre.sin_bearing.low;
  return reeds_shepp_length({0.0, 0.0, -half}, {x, y, half}, 1.0);
}

Chart chart_of(const PairBox& box) {
  constexpr double reach = simd::radial_reach;
  const auto distance = [](double radial) { return reach / ((1 - radial) * (1 - radial)); };
  const auto nearness = [](double radial) { return 1 / (reach * radial * radial); };
  return {increasing(box.radial, distance),
          {nearness(box.radial.high), nearness(box.radial.low)},
          1.0 + sine(increasing(box.side, bearing_at) * 2.0)};
}

Slopes hull_of_counting(const std::vector<Candidate>& candidates) {
  Slopes all;
  all.fill({infinity, -infinity});
  for (const Candidate& candidate : candidates) {
    if (!candidate.counts) continue;
    for (std::size_t i = 0; i < 3; ++i) all[i] = hull(all[i], candidate.slopes[i]);
  }
  return all;
}

/// Whether the candidate becomes shortest on no way from the centre to a pair of the box, as long
/// as the slopes of the shortest word lie in `all`. `half`: half the sides of the box.
bool stays_longer(const Candidate& candidate, const Slopes& all, const std::array<double, 3>& half,
                  double excess, const Polar& box) {
  double gain = 0.0;  // Most that the candidate can gain on the other words.
  double rise = 0.0;  // Most that length - distance can rise.
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval slope = candidate.slopes[i];
    gain += half[i] * std::max(all[i].high - slope.low, slope.high - all[i].low);
    rise += half[i] * std::max(all[i].high, -all[i].low);
  }
  const Pieces& p = candidate.pieces;
  constexpr double slack = 3 * margin;  // A length is a sum of three pieces.
  if (p.everywhere && candidate.lead > gain + slack) return true;
  return p.least() - box.distance.high > excess + rise + slack;
}

}  // namespace

Excess excess_over(const PairBox& box, const WordSet& among) {
  static const std::vector<Word> words = list_words();
  std::array<bool, 4> wanted{};
  for (std::size_t i = 0; i < words.size(); ++i) wanted[circles_of(words[i])] |= among[i];
  const Polar whole = polar(box, wanted);
  const Polar centre = polar(centre_of(box), wanted);
  const double shortest = shortest_length(centre);
  Excess excess{.at_centre = shortest - centre.distance.low};
  if (whole.distance.low == 0.0 && whole.turn.low == 0.0) {
    excess.words = among;  // Near equal poses the length grows like a square root sideways.
    excess.bounded = false;
    return excess;
  }
  const Chart chart = chart_of(box);
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!among[i]) continue;
    const View view = view_of(whole, words[i]);
    const std::optional<Pieces> pieces = pieces_of(whole, words[i].left_word, view);
    if (!pieces || !pieces->can_be_shortest()) continue;
    Candidate candidate{i, *pieces, slopes_of(whole, chart, words[i], view, *pieces)};
    const auto there = pieces_of(centre, words[i].left_word, view_of(centre, words[i]));
    candidate.lead = there ? there->length().low - shortest : -infinity;
    candidate.counts = there && there->can_be_shortest() && candidate.lead < margin;
    candidates.push_back(candidate);
  }
  const std::array<double, 3> half{box.radial.width() / 2, box.side.width() / 2,
                                   box.turn.width() / 2};
  for (bool settled = false; !settled;) {
    settled = true;
    excess.slopes = hull_of_counting(candidates);
    for (Candidate& candidate : candidates) {
      if (candidate.counts ||
          stays_longer(candidate, excess.slopes, half, excess.at_centre, whole)) {
        continue;
      }
      candidate.counts = true;
      settled = false;
    }
  }
  for (const Candidate& candidate : candidates) excess.words[candidate.word] = candidate.counts;
  return excess;
}

double excess_at(double radial, double side, double turn) {
  const Polar there = polar({point(radial), point(side), point(turn)}, {});
  return shortest_length(there) - there.distance.low;
}

}  // namespace vandplan::tables
