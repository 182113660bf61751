// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/steering.h"

#include <cmath>
#include <string>
#include <utility>

#include "base/require.h"
#include "geometry/pose_columns.h"
#include "simd/length_kernels.h"
#include "simd/pair_kernels.h"
#include "steering/mean_frame.h"
#include "steering/reeds_shepp_formulas.h"
#include "steering/word.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace steering::reeds_shepp_formulas;
using steering::Circles, steering::MeanFrame, steering::mean_frame;
using steering::piece_of, steering::Symmetry, steering::without_noise;

/// The frame with all signs positive.
Circles folded(const MeanFrame& f) {
  return Circles({std::abs(f.x), std::abs(f.y), std::abs(f.half_turn)});
}

/// The symmetry that undoes `folded`. For the frame from the other end, in which all signs are
/// opposite, it differs in all three. A 0 has the sign of the first of the three that is not 0.
Symmetry unfolding(const MeanFrame& f) {
  const bool backwards = f.x != 0 ? f.x < 0 : f.y != 0 ? f.y < 0 : f.half_turn < 0;
  const auto is_negative = [&](double v) { return v != 0 ? v < 0 : backwards; };
  return {backwards, is_negative(f.y), is_negative(f.half_turn)};
}

/// Poses as kernels see them: three numbers for each pose.
std::span<const double> numbers(std::span<const Pose> poses) {
  static_assert(sizeof(Pose) == 3 * sizeof(double));
  if (poses.empty()) return {};
  return {&poses.front().x, 3 * poses.size()};
}

}  // namespace

double reeds_shepp_length(const Pose& from, const Pose& to, double radius) {
  base::require_radius(radius);
  return shortest(folded(mean_frame(from, to, radius))).arcs.length * radius;
}

Piece reeds_shepp(const Pose& from, const Pose& to, double radius) {
  base::require_radius(radius);
  const MeanFrame frame = mean_frame(from, to, radius);
  const auto [formula, arcs] = shortest(folded(frame));
  return piece_of(formula, without_noise(formula, arcs), unfolding(frame), radius);
}

void reeds_shepp_lengths(const PoseColumns& nodes, const Pose& sample, double radius,
                         std::span<float> out) {
  base::require_radius(radius);
  geometry::expect_columns(nodes, out.size());
  const simd::LengthSample to{static_cast<float>(sample.x), static_cast<float>(sample.y),
                              static_cast<float>(wrap_angle(sample.heading))};
  simd::reeds_shepp_lengths(nodes.x, nodes.y, nodes.heading, to, static_cast<float>(radius), out);
}

void reeds_shepp_lengths(std::span<const Pose> from, std::span<const Pose> to, double radius,
                         std::span<double> out) {
  base::require_radius(radius);
  for (const auto& [where, size] : {std::pair("from", from.size()), std::pair("to", to.size())}) {
    if (size == 1 || size == out.size()) continue;
    throw InputError(where, "has " + std::to_string(size) + " poses, expected one or " +
                                std::to_string(out.size()));
  }
  simd::exact_lengths(numbers(from), numbers(to), radius, out);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!std::isnan(out[i])) continue;
    out[i] = reeds_shepp_length(from[from.size() == 1 ? 0 : i], to[to.size() == 1 ? 0 : i], radius);
  }
}

}  // namespace vandplan
