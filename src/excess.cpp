// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "excess.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "simd/bound_grid.h"
#include "vandplan/reeds_shepp.h"

namespace vandplan {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
// What rounding may do to an angle or a length: far more than it does.
constexpr double margin = 1e-7;
// Beyond this distance the slopes of words with a line are computed relative to it.
constexpr double far = 2.5;

Interval point(double value) { return {value, value}; }

/// Two turning circles: centre of the last one as seen from that of the first.
struct Circles {
  Interval distance;
  Interval direction;
  Interval lean;    ///< direction - bearing
  Interval across;  ///< component of the difference across the bearing
  Interval cos_lean;
  Interval stretch;  ///< distance of the poses / distance of the centres, when they are far apart
  Interval tangent;  ///< length of the inner tangent, where there is one
  Interval tilt;     ///< between the inner tangent and the line of the centres
  bool directed = true;  ///< the centres differ everywhere in the box
};

/// A box of pairs in polar coordinates of the mean frame.
struct Polar {
  Interval distance;
  Interval nearness;  ///< 1 / distance
  Interval bearing;
  Interval turn;
  Interval cos_bearing, sin_bearing;
  // By symmetry every word looks at one of these: left to left, right to right, left to right,
  // right to left.
  std::array<Circles, 4> circles;
};

/// The centres differ by the poses' difference and (x, y).
Circles circles_of(const Polar& box, Interval x, Interval y) {
  const Interval along = x * box.cos_bearing + y * box.sin_bearing;
  const Interval along_all = box.distance + along;
  Circles c;
  c.across = y * box.cos_bearing - x * box.sin_bearing;
  const Interval dx = box.distance * box.cos_bearing + x;
  const Interval dy = box.distance * box.sin_bearing + y;
  c.distance = square_root(meet(square(along_all) + square(c.across), square(dx) + square(dy)));
  c.directed = !contains_origin(along_all, c.across) && !contains_origin(dx, dy);
  if (c.directed) {
    c.lean = direction(along_all, c.across);
    c.direction = direction(dx, dy);
    const Interval other = c.lean + box.bearing;
    const double turns = std::round((c.direction.middle() - other.middle()) / (2 * pi));
    const Interval both = meet(c.direction, other + 2 * pi * turns);
    if (both.low <= both.high) c.direction = both;
  } else {
    c.lean = c.direction = {-pi, pi};
  }
  c.cos_lean = cosine(c.lean);
  if (box.distance.low > far) {
    c.stretch =
        inverse(square_root(square(1.0 + along * box.nearness) + square(c.across * box.nearness)));
  }
  c.tangent = square_root(square(c.distance) - 4.0);
  c.tilt = {atan_2(2.0, c.tangent.high), atan_2(2.0, c.tangent.low)};
  return c;
}

/// With the circles that `wanted` asks for.
Polar polar(const PairBox& box, const std::array<bool, 4>& wanted) {
  Polar p;
  p.distance = increasing(box.radial, distance_at);
  p.distance.high = std::min(p.distance.high, 1e12);
  p.nearness = {1.0 / p.distance.high, p.distance.low > 0.0 ? 1.0 / p.distance.low : 1e12};
  p.bearing = increasing(box.side, bearing_at);
  p.turn = box.turn * pi;
  p.cos_bearing = {sin_cos(p.bearing.high).cos, sin_cos(p.bearing.low).cos};
  p.sin_bearing = {sin_cos(p.bearing.low).sin, sin_cos(p.bearing.high).sin};
  const Interval s = Interval{sin_cos(p.turn.low / 2).sin, sin_cos(p.turn.high / 2).sin} * 2.0;
  const Interval c = Interval{sin_cos(p.turn.high / 2).cos, sin_cos(p.turn.low / 2).cos} * 2.0;
  const Interval zero = point(0.0);
  if (wanted[0]) p.circles[0] = circles_of(p, -s, zero);
  if (wanted[1]) p.circles[1] = circles_of(p, s, zero);
  if (wanted[2]) p.circles[2] = circles_of(p, zero, -c);
  if (wanted[3]) p.circles[3] = circles_of(p, zero, c);
  return p;
}

/// The nine formulas of docs/algorithms/steering.md, each beginning with a left turn forward: l and
/// r are arcs, c a cusp, s a line.
enum Formula { lsl, lsr, lrcl, lcrcl, lrclr, lcrlcr, lcrsl, lcrsr, lcrslcr };

/// How much of the costate points along the heading at an end of the path, seen from the outer arc.
enum class End { cos_arc, sin_arc, sin_rest };

/// What a formula is, apart from its angles.
struct Shape {
  bool same_side;      ///< begins and ends with a left turn
  double least, most;  ///< distances of the centres for which it can be shortest
  bool has_line;
  End first_end, last_end;
  int last_turn;  ///< which way the last arc turns the vehicle: 1 counter-clockwise
};

constexpr double sqrt_8 = 2 * std::numbers::sqrt2;
const std::array<Shape, 9> shapes{{
    {true, 0, infinity, true, End::cos_arc, End::cos_arc, 1},
    {false, 2, infinity, true, End::cos_arc, End::cos_arc, -1},
    {true, 0, sqrt_8, false, End::sin_rest, End::sin_arc, -1},
    {true, 0, 4, false, End::cos_arc, End::cos_arc, 1},
    {false, 0, 2, false, End::sin_rest, End::sin_rest, 1},
    {false, 2, std::sqrt(20.0), false, End::sin_arc, End::sin_arc, -1},
    {true, sqrt_8, infinity, true, End::sin_arc, End::cos_arc, -1},
    {false, 2, infinity, true, End::sin_arc, End::cos_arc, 1},
    {false, std::sqrt(20.0), infinity, true, End::sin_arc, End::sin_arc, -1},
}};

/// One of the 48 words: a formula looked at with the signs of x, y and turn changed.
struct Word {
  Formula formula;
  int x, y, turn;
};

/// Changing one sign gives most formulas a twin, and some the same word again.
bool is_repeated(const Word& word) {
  switch (word.formula) {
    case lsl:
    case lcrcl:
      return word.y < 0;
    case lrclr:
      return word.x < 0;
    case lsr:
    case lcrlcr:
    case lcrslcr:
      return word.turn < 0;
    default:
      return false;
  }
}

std::vector<Word> list_words() {
  std::vector<Word> words;
  for (int formula = 0; formula < 9; ++formula) {
    for (int signs = 0; signs < 8; ++signs) {
      const Word word{static_cast<Formula>(formula), (signs & 1) != 0 ? -1 : 1,
                      (signs & 2) != 0 ? -1 : 1, (signs & 4) != 0 ? -1 : 1};
      if (!is_repeated(word)) words.push_back(word);
    }
  }
  return words;
}

/// What a formula looks at, after the signs were changed.
struct View {
  const Circles* circles;
  Interval direction;
  Interval half_turn;
  int handed;  ///< -1 when left and right were exchanged in the plane
};

/// Which of `Polar::circles` a word looks at.
std::size_t circles_of(const Word& word) {
  if (shapes[word.formula].same_side) return word.x == word.turn ? 0 : 1;
  return word.y > 0 ? 2 : 3;
}

View view_of(const Polar& box, const Word& word) {
  const std::size_t which = circles_of(word);
  View view{&box.circles[which], box.circles[which].direction, box.turn * 0.5, word.x * word.y};
  if (word.x < 0) view.direction = pi - view.direction;
  if (word.y < 0) view.direction = -view.direction;
  if (word.turn < 0) view.half_turn = -view.half_turn;
  return view;
}

/// A word over a box.
struct Pieces {
  Interval tilt;            ///< of the costate, from the direction of the centres
  Interval first, last;     ///< outer arcs
  Interval middle;          ///< an arc between them, of words without a line
  Interval rest;            ///< everything between the outer arcs
  double longest = pi / 2;  ///< what an outer arc of a shortest path can be
  bool everywhere = true;   ///< the formula is smooth in the whole box

  [[nodiscard]] Interval length() const { return first + rest + last; }
  [[nodiscard]] bool can_be_shortest() const {
    const auto fits = [this](Interval arc) {
      return arc.high >= -margin && arc.low <= longest + margin;
    };
    return fits(first) && fits(last);
  }
};

/// Cuts `range` to [low, high] and notes it. False if nothing is left.
bool cut(Interval& range, double low, double high, bool& untouched) {
  if (range.high < low - margin || range.low > high + margin) return false;
  if (range.low < low || range.high > high) untouched = false;
  range = {std::clamp(range.low, low, high), std::clamp(range.high, low, high)};
  return true;
}

/// The arc between the outer ones for centres at `d`.
Interval middle_arc(Formula formula, Interval d) {
  if (formula == lrclr) {  // cos u = (2 + d) / 4
    const auto arc = [](double e) { return twice_arc_sine(std::sqrt((2 - e) / 8)); };
    return {arc(d.high), arc(d.low)};
  }
  if (formula == lcrlcr) {  // cos u = (20 - d^2) / 16
    const auto arc = [](double e) {
      return twice_arc_sine(std::sqrt(std::clamp((e * e - 4) / 32, 0.0, 0.5)));
    };
    return increasing(d, arc);
  }
  return increasing(d * 0.25, twice_arc_sine);
}

/// atan(sin u / (2 - cos u)), greatest at pi / 3.
Interval tilt_of(Interval u) {
  const auto tilt = [](double v) { return atan_2(sin_cos(v).sin, 2 - sin_cos(v).cos); };
  const Interval ends = hull(point(tilt(u.low)), point(tilt(u.high)));
  return u.low < pi / 3 && u.high > pi / 3 ? Interval{ends.low, pi / 6} : ends;
}

/// None if no path of the word is shortest anywhere in the box for want of circles.
std::optional<Pieces> pieces_of(const Polar& box, Formula formula, const View& view) {
  const Circles& c = *view.circles;
  const Shape& shape = shapes[formula];
  Pieces p;
  p.everywhere = c.directed;
  Interval d = c.distance;
  if (!cut(d, shape.least, shape.most, p.everywhere)) return {};
  if (!shape.has_line) {
    p.middle = middle_arc(formula, d);
    // Every other arc of a shortest path is at most as long, and there are at most four; the path
    // is no shorter than the distance or the turn.
    const double least = formula == lcrcl ? 0.0 : std::max(box.distance.low, box.turn.low) / 4;
    if (!cut(p.middle, least, pi, p.everywhere)) return {};
    p.longest = formula == lcrcl ? pi : p.middle.high;
  }
  const Interval u = p.middle;
  const Interval t = c.tilt;
  Interval heading0, heading1;  // after the first arc and before the last, from the centres' line
  switch (formula) {
    case lsl:
      p.rest = d;
      break;
    case lsr:
      p.tilt = heading0 = heading1 = t;
      p.rest = c.tangent;
      break;
    case lcrsl:
      p.tilt = t;
      heading0 = t + pi / 2;
      heading1 = t + pi;
      p.rest = c.tangent + (pi / 2 - 2);
      break;
    case lcrsr:
      heading0 = point(pi / 2);
      heading1 = point(pi);
      p.rest = d + (pi / 2 - 2);
      break;
    case lcrslcr:
      p.tilt = t;
      heading0 = heading1 = t + pi / 2;
      p.rest = c.tangent + (pi - 4);
      break;
    case lcrcl:
      heading0 = pi - u * 0.5;
      heading1 = u * 0.5 + pi;
      p.rest = u;
      break;
    case lrcl:
      p.tilt = (pi - u) * 0.5;
      heading0 = u * 0.5;
      heading1 = -heading0;
      p.rest = u;
      break;
    case lrclr:
      p.tilt = point(pi);
      heading0 = u + pi / 2;
      heading1 = pi / 2 - u;
      p.rest = u * 2.0;
      break;
    case lcrlcr:
      p.tilt = tilt_of(u);
      heading0 = heading1 = p.tilt + pi / 2;
      p.rest = u * 2.0;
      break;
  }
  // The angle plus whole turns that comes closest to what an arc can be.
  const auto arc = [&p](Interval angle) {
    const double turns = std::round((p.longest / 2 - angle.middle()) / (2 * pi));
    if (angle.width() > 1.0) p.everywhere = false;
    return angle + 2 * pi * turns;
  };
  p.first = arc(heading0 + view.direction + view.half_turn);
  p.last = arc((view.half_turn - heading1 - view.direction) * static_cast<double>(shape.last_turn));
  return p;
}

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

/// How the coordinates of the grid stretch across the box.
struct Chart {
  Interval radial_to_distance;  ///< d distance / d radial
  Interval radial_to_nearness;  ///< the same / distance^2
  Interval side_to_bearing;     ///< d bearing / d side
};

using Slopes = std::array<Interval, 3>;

/// Slopes of length - distance for one word.
Slopes slopes_of(const Polar& box, const Chart& chart, const Word& word, const View& view,
                 const Pieces& p) {
  if (word.formula == lcrcl) {
    return {-chart.radial_to_distance, point(0.0), point(pi * word.turn)};
  }
  const Circles& c = *view.circles;
  const Shape& shape = shapes[word.formula];
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
  double lead = 0.0;    ///< its length in the centre - the shortest
  bool counts = false;  ///< it is shortest somewhere, as far as we can tell
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
  constexpr double reach = kernels::radial_reach;
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

/// No path from the centre on which only words with slopes in `all` are shortest reaches a pair for
/// which the candidate is.
bool stays_longer(const Candidate& candidate, const Slopes& all, const std::array<double, 3>& half,
                  double excess, const Polar& box) {
  double gain = 0.0;  // of the candidate on the others
  double rise = 0.0;  // of length - distance
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval slope = candidate.slopes[i];
    gain += half[i] * std::max(all[i].high - slope.low, slope.high - all[i].low);
    rise += half[i] * std::max(all[i].high, -all[i].low);
  }
  const Pieces& p = candidate.pieces;
  if (p.everywhere && candidate.lead > gain + margin) return true;
  const double least = std::max(p.first.low, 0.0) + p.rest.low + std::max(p.last.low, 0.0);
  return least - box.distance.high > excess + rise + margin;
}

}  // namespace

double distance_at(double radial) {
  return radial < 1.0 ? kernels::radial_reach * radial / (1.0 - radial) : infinity;
}

double bearing_at(double side) { return atan_2(side, 1.0 - side); }

Excess excess_over(const PairBox& box, const WordSet& among) {
  static const std::vector<Word> words = list_words();
  std::array<bool, 4> wanted{};
  for (std::size_t i = 0; i < words.size(); ++i) wanted[circles_of(words[i])] |= among[i];
  const Polar whole = polar(box, wanted);
  const Polar centre = polar(centre_of(box), wanted);
  const double shortest = shortest_length(centre);
  Excess excess{.at_centre = shortest - centre.distance.low};
  if (whole.distance.low == 0.0 && whole.turn.low == 0.0) {
    excess.words = among;  // equal poses: sideways the length grows like a square root
    excess.bounded = false;
    return excess;
  }
  const Chart chart = chart_of(box);
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!among[i]) continue;
    const View view = view_of(whole, words[i]);
    const std::optional<Pieces> pieces = pieces_of(whole, words[i].formula, view);
    if (!pieces || !pieces->can_be_shortest()) continue;
    Candidate candidate{i, *pieces, slopes_of(whole, chart, words[i], view, *pieces)};
    const auto there = pieces_of(centre, words[i].formula, view_of(centre, words[i]));
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

}  // namespace vandplan
