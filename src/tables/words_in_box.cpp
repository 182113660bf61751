// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "tables/words_in_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simd/bound_grid.h"

namespace vandplan::tables {
namespace words_in_box {
namespace {

constexpr double pi = std::numbers::pi;

/// Circle pair whose centres differ by the poses' difference plus (x, y).
CirclePair circles_of(const Polar& box, Interval x, Interval y) {
  const Interval along = x * box.cos_bearing + y * box.sin_bearing;
  const Interval along_all = box.distance + along;
  CirclePair c;
  c.across = y * box.cos_bearing - x * box.sin_bearing;
  const Interval dx = box.distance * box.cos_bearing + x;
  const Interval dy = box.distance * box.sin_bearing + y;
  c.distance = square_root(meet(square(along_all) + square(c.across), square(dx) + square(dy)));
  c.directed = !contains_origin(along_all, c.across) && !contains_origin(dx, dy);
  if (c.directed) {
    c.lean = direction(along_all, c.across);
    c.direction = direction(dx, dy);
    const Interval other = c.lean + box.bearing;
    if (c.direction.width() + other.width() < 2 * pi) {  // Otherwise the whole turns are ambiguous.
      const double turns = std::round((c.direction.middle() - other.middle()) / (2 * pi));
      const Interval both = meet(c.direction, other + 2 * pi * turns);
      if (both.low <= both.high) c.direction = both;
    }
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

/// Whether another combination of signs gives the same word. One change of sign makes most formulas
/// a twin, but maps some to themselves.
bool is_repeated(const Word& word) {
  switch (word.left_word) {
    case lsl:
    case l_r_l:
      return word.y < 0;
    case lr_lr:
      return word.x < 0;
    case lsr:
    case l_rl_r:
    case l_rsl_r:
      return word.turn < 0;
    default:
      return false;
  }
}

/// Clips `range` to [low, high] and clears `untouched` if that changes it. False if nothing is
/// left.
bool cut(Interval& range, double low, double high, bool& untouched) {
  if (range.high < low - margin || range.low > high + margin) return false;
  if (range.low < low || range.high > high) untouched = false;
  range = {std::clamp(range.low, low, high), std::clamp(range.high, low, high)};
  return true;
}

/// Arc between the outer arcs, for centres at distance `d`.
Interval middle_arc(LeftWord left_word, Interval d) {
  if (left_word == lr_lr) {  // cos u = (2 + d) / 4
    const auto arc = [](double e) { return twice_arc_sine(std::sqrt((2 - e) / 8)); };
    return {arc(d.high), arc(d.low)};
  }
  if (left_word == l_rl_r) {  // cos u = (20 - d^2) / 16
    const auto arc = [](double e) {
      return twice_arc_sine(std::sqrt(std::clamp((e * e - 4) / 32, 0.0, 0.5)));
    };
    return increasing(d, arc);
  }
  return increasing(d * 0.25, twice_arc_sine);
}

/// Tilt atan(sin u / (2 - cos u)) over an interval; it is greatest at pi / 3.
Interval tilt_of(Interval u) {
  const auto tilt = [](double v) { return atan_2(sin_cos(v).sin, 2 - sin_cos(v).cos); };
  const Interval ends = hull(point(tilt(u.low)), point(tilt(u.high)));
  return u.low < pi / 3 && u.high > pi / 3 ? Interval{ends.low, pi / 6} : ends;
}

/// The angle plus the whole turns that bring it closest to [0, longest], the range of an arc. If
/// several whole turns reach that range, the result contains all of them.
Interval arc_of(Interval angle, double longest) {
  const double turns = std::round((longest / 2 - angle.middle()) / (2 * pi));
  Interval arc = angle + 2 * pi * turns;
  const Interval below = arc - 2 * pi;
  const Interval above = arc + 2 * pi;
  if (below.high >= -margin) arc.low = below.low;
  if (above.low <= longest + margin) arc.high = above.high;
  return arc;
}

}  // namespace

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

const Shape& shape_of(LeftWord left_word) { return shapes[left_word]; }

std::vector<Word> list_words() {
  std::vector<Word> words;
  for (int left_word = 0; left_word < 9; ++left_word) {
    for (int signs = 0; signs < 8; ++signs) {
      const Word word{static_cast<LeftWord>(left_word), (signs & 1) != 0 ? -1 : 1,
                      (signs & 2) != 0 ? -1 : 1, (signs & 4) != 0 ? -1 : 1};
      if (!is_repeated(word)) words.push_back(word);
    }
  }
  return words;
}

std::size_t circles_of(const Word& word) {
  if (shapes[word.left_word].same_side) return word.x == word.turn ? 0 : 1;
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

// NOLINTNEXTLINE(readability-function-size): the cases stand side by side
std::optional<Pieces> pieces_of(const Polar& box, LeftWord left_word, const View& view) {
  const CirclePair& c = *view.circles;
  const Shape& shape = shapes[left_word];
  Pieces p;
  p.everywhere = c.directed;
  Interval d = c.distance;
  if (!cut(d, shape.least, shape.most, p.everywhere)) return {};
  if (!shape.has_line) {
    p.middle = middle_arc(left_word, d);
    // Each other arc of a shortest path is at most as long as this one, and there are at most four
    // arcs. The path is at least as long as the distance and the turn.
    const double least = left_word == l_r_l ? 0.0 : std::max(box.distance.low, box.turn.low) / 4;
    if (!cut(p.middle, least, pi, p.everywhere)) return {};
    p.longest = left_word == l_r_l ? pi : p.middle.high;
  }
  const Interval u = p.middle;
  const Interval t = c.tilt;
  // Headings relative to the centres' line, after the first arc and before the last.
  Interval heading0, heading1;
  switch (left_word) {
    case lsl:
      p.rest = d;
      break;
    case lsr:
      p.tilt = heading0 = heading1 = t;
      p.rest = c.tangent;
      break;
    case l_rsl:
      p.tilt = t;
      heading0 = t + pi / 2;
      heading1 = t + pi;
      p.rest = c.tangent + (pi / 2 - 2);
      break;
    case l_rsr:
      heading0 = point(pi / 2);
      heading1 = point(pi);
      p.rest = d + (pi / 2 - 2);
      break;
    case l_rsl_r:
      p.tilt = t;
      heading0 = heading1 = t + pi / 2;
      p.rest = c.tangent + (pi - 4);
      break;
    case l_r_l:
      heading0 = pi - u * 0.5;
      heading1 = u * 0.5 + pi;
      p.rest = u;
      break;
    case lr_l:
      p.tilt = (pi - u) * 0.5;
      heading0 = u * 0.5;
      heading1 = -heading0;
      p.rest = u;
      break;
    case lr_lr:
      p.tilt = point(pi);
      heading0 = u + pi / 2;
      heading1 = pi / 2 - u;
      p.rest = u * 2.0;
      break;
    case l_rl_r:
      p.tilt = tilt_of(u);
      heading0 = heading1 = p.tilt + pi / 2;
      p.rest = u * 2.0;
      break;
  }
  const auto arc = [&p](Interval angle) {
    if (angle.width() > 1.0) p.everywhere = false;
    return arc_of(angle, p.longest);
  };
  p.first = arc(heading0 + view.direction + view.half_turn);
  p.last = arc((view.half_turn - heading1 - view.direction) * static_cast<double>(shape.last_turn));
  return p;
}

}  // namespace words_in_box

double distance_at(double radial) {
  return radial < 1.0 ? simd::radial_reach * radial / (1.0 - radial) : infinity;
}

double bearing_at(double side) { return atan_2(side, 1.0 - side); }

}  // namespace vandplan::tables
