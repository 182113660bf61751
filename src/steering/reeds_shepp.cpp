// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/reeds_shepp.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "simd/length_kernels.h"
#include "steering/mean_frame.h"
#include "steering/reeds_shepp_formulas.h"

namespace vandplan {
namespace {

using namespace steering::reeds_shepp_formulas;
using steering::Circles, steering::MeanFrame, steering::mean_frame;

/// One turn or line of a word.
struct Step {
  double turn;       ///< 1 left, 0 straight, -1 right
  double gear;       ///< 1 forward, -1 reverse
  std::size_t part;  ///< of `Arcs`: 0 first, 1 inner, 2 line, 3 last
};

struct Steps {
  std::array<Step, 5> list{};
  std::size_t count = 0;
  bool same_sense = false;  ///< the first and the last step turn the heading the same way
};

/// From turns and gears, such as "L+R-L+".
constexpr Steps steps_from(std::string_view text) {
  Steps steps;
  steps.count = text.size() / 2;
  for (std::size_t i = 0; i < steps.count; ++i) {
    const double turn = text[2 * i] == 'L' ? 1 : text[2 * i] == 'R' ? -1 : 0;
    const std::size_t part = i == 0 ? 0 : i == steps.count - 1 ? 3 : turn == 0 ? 2 : 1;
    steps.list[i] = {turn, text[2 * i + 1] == '+' ? 1.0 : -1.0, part};
  }
  const Step& last = steps.list[steps.count - 1];
  steps.same_sense = steps.list[0].turn * steps.list[0].gear == last.turn * last.gear;
  return steps;
}

const Steps& steps_of(Formula formula) {
  static constexpr Steps steps[] = {
      steps_from("L+S+L+"),      // 8.1
      steps_from("L+S+R+"),      // 8.2
      steps_from("L+R-L+"),      // 8.3
      steps_from("R-L+R+"),      // 8.4
      steps_from("L-R-L+R+"),    // 8.7
      steps_from("R-L+R+L-"),    // 8.8
      steps_from("R-L+S+R+"),    // 8.9
      steps_from("R-L+S+L+"),    // 8.10
      steps_from("R-L+S+R+L-"),  // 8.11
  };
  return steps[static_cast<std::size_t>(formula)];
}

/// Which signs of the mean frame change; each change maps paths onto paths.
struct Symmetry {
  bool x, y, half_turn;

  [[nodiscard]] Circles of(Circles p) const {
    if (x) p.x = -p.x;
    if (y) {
      p.y = -p.y;
      std::swap(p.lr, p.rl);
    }
    if (half_turn) {
      p.a = -p.a;
      p.s = -p.s;
    }
    return p;
  }
  [[nodiscard]] bool swaps_gears() const { return x; }
  [[nodiscard]] bool swaps_sides() const { return x != half_turn; }
  [[nodiscard]] bool swaps_ends() const { return (x != y) != half_turn; }
};

/// A word at `radius` as `symmetry` makes it; parts of no length are left out.
Piece piece_of(Formula formula, const Arcs& arcs, const Symmetry& symmetry, double radius) {
  const Steps& steps = steps_of(formula);
  const double parts[] = {arcs.first, arcs.inner, arcs.line, arcs.last};
  const double curvature = symmetry.swaps_sides() ? -1 / radius : 1 / radius;
  const double scale = symmetry.swaps_gears() ? -radius : radius;
  Piece piece;
  piece.length = arcs.length * radius;
  for (std::size_t i = 0; i < steps.count; ++i) {
    const Step& step = steps.list[symmetry.swaps_ends() ? steps.count - 1 - i : i];
    const double part = parts[step.part];
    if (part <= 0) continue;
    piece.segments[piece.count++] = {step.turn * curvature, step.gear * part * scale};
  }
  return piece;
}

/// Takes back what rounding pushed below zero on the border between two words; the sum of all
/// turns stays the same.
Arcs without_noise(Formula formula, Arcs arcs) {
  double& lesser = arcs.first < arcs.last ? arcs.first : arcs.last;
  double& greater = arcs.first < arcs.last ? arcs.last : arcs.first;
  if (lesser < 0) {
    greater += steps_of(formula).same_sense ? lesser : -lesser;
    lesser = 0;
  }
  return arcs;
}

/// The frame with all signs positive.
Circles folded(const MeanFrame& f) {
  return Circles({std::abs(f.x), std::abs(f.y), std::abs(f.half_turn)});
}

/// What undoes `folded`. For the frame from the other end, in which all signs are opposite, it
/// differs in all three, zeros included: the first of the three that is not zero counts.
Symmetry unfolding(const MeanFrame& f) {
  const bool backwards = f.x != 0 ? f.x < 0 : f.y != 0 ? f.y < 0 : f.half_turn < 0;
  const auto is_negative = [&](double v) { return v != 0 ? v < 0 : backwards; };
  return {backwards, is_negative(f.y), is_negative(f.half_turn)};
}

}  // namespace

double reeds_shepp_length(const Pose& from, const Pose& to, double radius) noexcept {
  return shortest(folded(mean_frame(from, to, radius))).arcs.length * radius;
}

Piece reeds_shepp(const Pose& from, const Pose& to, double radius) noexcept {
  const MeanFrame frame = mean_frame(from, to, radius);
  const auto [formula, arcs] = shortest(folded(frame));
  return piece_of(formula, without_noise(formula, arcs), unfolding(frame), radius);
}

void reeds_shepp_lengths(const PoseColumns& nodes, const Pose& sample, double radius,
                         std::span<float> out) noexcept {
  assert(nodes.x.size() == out.size() && nodes.y.size() == out.size() &&
         nodes.heading.size() == out.size());
  const simd::LengthSample to{static_cast<float>(sample.x), static_cast<float>(sample.y),
                              static_cast<float>(wrap_angle(sample.heading))};
  simd::reeds_shepp_lengths(nodes.x, nodes.y, nodes.heading, to, static_cast<float>(radius), out);
}

namespace {

/// What `reeds_shepp_words` needs to know of a formula.
struct Kind {
  Formula formula;
  Arcs (*arcs)(const Circles&);
  bool (*exists)(const Circles&);
  Symmetry own;  ///< maps the word onto itself; none for a word that has eight images
};

double from_left_to_left(const Circles& p) { return (p.x - 2 * p.s) * (p.x - 2 * p.s) + p.y * p.y; }
double from_right_to_right(const Circles& p) {
  return (p.x + 2 * p.s) * (p.x + 2 * p.s) + p.y * p.y;
}

constexpr Symmetry none{false, false, false};
constexpr Symmetry in_x{true, false, false};
constexpr Symmetry in_y{false, true, false};
constexpr Symmetry in_half_turn{false, false, true};

constexpr Kind kinds[] = {
    {Formula::lsl, lsl, [](const Circles&) { return true; }, in_y},
    {Formula::lsr, lsr, [](const Circles& p) { return p.lr >= 0; }, in_half_turn},
    {Formula::l_r_l, l_r_l, [](const Circles& p) { return from_left_to_left(p) <= 16; }, in_y},
    {Formula::r_lr, r_lr, [](const Circles& p) { return from_right_to_right(p) <= 16; }, none},
    {Formula::lr_lr, lr_lr, [](const Circles& p) { return p.lr <= 0; }, in_x},
    {Formula::r_lr_l, r_lr_l, [](const Circles& p) { return p.rl >= 0 && p.rl <= 32; },
     in_half_turn},
    {Formula::r_lsr, r_lsr, [](const Circles& p) { return from_right_to_right(p) >= 8; }, none},
    {Formula::r_lsl, r_lsl, [](const Circles& p) { return p.rl >= 0; }, none},
    {Formula::r_lsr_l, r_lsr_l, [](const Circles& p) { return p.rl >= 16; }, in_half_turn},
};

/// In [0, 2 pi), but what rounding pushed below zero stays there.
double in_one_turn(double arc) {
  constexpr double full = 2 * std::numbers::pi;
  const double wrapped = arc - full * std::floor(arc / full);
  return wrapped < full - 1e-12 ? wrapped : wrapped - full;
}

}  // namespace

std::vector<Piece> reeds_shepp_words(const Pose& from, const Pose& to, double radius) {
  const Circles circles(mean_frame(from, to, radius));
  std::vector<Piece> words;
  for (const Kind& kind : kinds) {
    for (const bool x : {false, true}) {
      for (const bool y : {false, true}) {
        for (const bool half_turn : {false, true}) {
          if ((x && kind.own.x) || (y && kind.own.y) || (half_turn && kind.own.half_turn)) continue;
          const Symmetry symmetry{x, y, half_turn};
          const Circles image = symmetry.of(circles);
          if (!kind.exists(image)) continue;
          Arcs arcs = kind.arcs(image);
          arcs.first = in_one_turn(arcs.first);
          arcs.last = in_one_turn(arcs.last);
          words.push_back(
              piece_of(kind.formula, without_noise(kind.formula, arcs), symmetry, radius));
          words.back().length = length(words.back().view());
        }
      }
    }
  }
  return words;
}

}  // namespace vandplan
