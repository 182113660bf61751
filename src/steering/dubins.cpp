// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/steering.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "base/require.h"
#include "base/trigonometry.h"
#include "steering/mean_frame.h"

namespace vandplan {
namespace {

using base::atan_2;
using steering::Circles, steering::MeanFrame, steering::mean_frame;

constexpr double pi = std::numbers::pi;

/// Arcs and line of a word at unit radius, first to last.
struct DubinsWord {
  std::array<int, 3> turns;  ///< 1 left, 0 straight, -1 right
  std::array<double, 3> lengths;
};

/// The angle in [0, 2 pi). An angle that rounding pushed below 0 by at most `noise` becomes 0.
double full_angle(double angle, double noise) {
  const double wrapped = angle - 2 * pi * std::floor(angle / (2 * pi));
  return wrapped < 2 * pi - noise ? wrapped : 0.0;
}

/// Bound of the rounding error of a turning circle's centre [turning radii].
constexpr double position_noise = 1e-14;

// Angles and lengths as in docs/algorithms/steering.md; the first turn is to the left. Words that
// begin to the right are those of the mirrored frame.

std::optional<DubinsWord> same_sides(const Circles& p) {  // LSL
  const double x = p.x - 2 * p.s;
  const double d = std::sqrt(x * x + p.y * p.y);
  const double noise = position_noise / d;
  const double turn = full_angle(2 * p.a, position_noise);
  double t = full_angle(atan_2(p.y, x) + p.a, noise);
  if (t > turn && t - turn <= noise) t = turn;
  return DubinsWord{{1, 0, 1}, {t, d, t <= turn ? turn - t : turn - t + 2 * pi}};
}

std::optional<DubinsWord> other_sides(const Circles& p) {  // LSR
  if (p.lr < -position_noise) return {};
  const double y = p.y - 2 * p.c;
  const double d = std::sqrt(std::max(p.lr, 0.0));
  const double h = atan_2(y * d + 2 * p.x, p.x * d - 2 * y);
  const double noise = position_noise / std::max(d, 1e-4);
  return DubinsWord{{1, 0, -1}, {full_angle(h + p.a, noise), d, full_angle(h - p.a, noise)}};
}

std::optional<DubinsWord> three_arcs(const Circles& p) {  // LRL
  const double x = p.x - 2 * p.s;
  const double squared = x * x + p.y * p.y;
  if (squared > 16) return {};
  const double d = std::sqrt(squared);
  const double half = pi - atan_2(d, std::sqrt(16 - squared));
  const double h = atan_2(p.y, x);
  const double noise = position_noise / std::max(d, 1e-4);
  return DubinsWord{
      {1, -1, 1}, {full_angle(h + p.a + half, noise), 2 * half, full_angle(p.a - h + half, noise)}};
}

Circles mirrored(const Circles& p) {
  Circles result = p;
  result.y = -p.y;
  result.a = -p.a;
  result.s = -p.s;
  std::swap(result.lr, result.rl);
  return result;
}

DubinsWord mirrored(DubinsWord word) {
  for (int& turn : word.turns) turn = -turn;
  return word;
}

Piece piece_of(const DubinsWord& word, double radius) {
  Piece piece;
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = word.lengths[i] * radius;
    if (length == 0.0) continue;
    piece.segments[piece.count++] = {word.turns[i] / radius, length};
    piece.length += length;
  }
  return piece;
}

/// Calls `take` with each word that exists, in the order of `dubins_words`.
template <typename Take>
void for_each_word(const MeanFrame& frame, Take take) {
  const Circles circles(frame);
  const Circles mirror = mirrored(circles);
  const auto take_if = [&](const std::optional<DubinsWord>& word) {
    if (word) take(*word);
  };
  const auto take_mirrored_if = [&](const std::optional<DubinsWord>& word) {
    if (word) take(mirrored(*word));
  };
  take_if(same_sides(circles));           // LSL
  take_mirrored_if(same_sides(mirror));   // RSR
  take_if(other_sides(circles));          // LSR
  take_mirrored_if(other_sides(mirror));  // RSL
  take_mirrored_if(three_arcs(mirror));   // RLR
  take_if(three_arcs(circles));           // LRL
}

}  // namespace

Piece dubins(const Pose& from, const Pose& to, double radius) {
  base::require_radius(radius);
  const MeanFrame frame = mean_frame(from, to, radius);
  std::optional<DubinsWord> best;
  double least = 0.0;
  for_each_word(frame, [&](const DubinsWord& word) {
    const double length = word.lengths[0] + word.lengths[1] + word.lengths[2];
    if (best && length >= least) return;
    best = word;
    least = length;
  });
  return piece_of(*best, radius);  // LSL exists for every pair
}

double dubins_length(const Pose& from, const Pose& to, double radius) {
  return dubins(from, to, radius).length;
}

std::vector<Piece> dubins_words(const Pose& from, const Pose& to, double radius) {
  base::require_radius(radius);
  std::vector<Piece> words;
  for_each_word(mean_frame(from, to, radius),
                [&](const DubinsWord& word) { words.push_back(piece_of(word, radius)); });
  return words;
}

}  // namespace vandplan
