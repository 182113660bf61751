// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "base/trigonometry.h"
#include "steering/words.h"

namespace vandplan::steering {
namespace {

constexpr int most_rounds = 8;
constexpr double damping = 1e-9;  // relative; an error that no length can change stays

using Vector = std::array<double, 3>;  // x, y [m] and heading [rad]

/// Offset from the end of a piece to the pose where it should end, in the world's frame.
Vector missing(const Pose& end, const Pose& to) {
  return {to.x - end.x, to.y - end.y, wrap_angle(to.heading - end.heading)};
}

bool is_within(const Vector& missing, const Closing& closing) {
  return std::hypot(missing[0], missing[1]) <= closing.position &&
         std::abs(missing[2]) <= closing.heading;
}

/// A few segments in an array of fixed size, without allocation.
struct Chain {
  std::array<Segment, most_mended> segments{};
  std::size_t count = 0;
};

/// Poses at which the segments of a chain begin, and the pose at its end.
struct Driven {
  std::array<Pose, most_mended + 1> poses;

  Driven(const Pose& from, const Chain& chain) {
    poses[0] = from;
    for (std::size_t i = 0; i < chain.count; ++i) {
      poses[i + 1] = advance(poses[i], chain.segments[i]);
    }
  }
};

/// Derivative of the end of a chain by the length of segment `i`. The end moves along the heading
/// at the end of the segment, and swings around that place. 0 for a clothoid, which stays as it is.
Vector slope(const Chain& chain, const Driven& driven, std::size_t i) {
  const Segment& segment = chain.segments[i];
  if (segment.curvature_rate != 0.0) return {};
  const Pose& at = driven.poses[i + 1];
  const Pose& end = driven.poses[chain.count];
  const double gear = segment.length < 0.0 ? -1.0 : 1.0;
  const double turn = gear * segment.curvature;
  const auto [sin, cos] = base::sin_cos(at.heading);
  return {gear * cos - turn * (end.y - at.y), gear * sin + turn * (end.x - at.x), turn};
}

/// The solution of a symmetric positive definite 3 x 3 system, lower triangle given, by Cholesky.
Vector solved(const std::array<Vector, 3>& m, const Vector& right) {
  std::array<Vector, 3> l{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = m[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
      l[i][j] = i == j ? std::sqrt(std::max(sum, 1e-300)) : sum / l[j][j];
    }
  }
  Vector x = right;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < i; ++k) x[i] -= l[i][k] * x[k];
    x[i] /= l[i][i];
  }
  for (std::size_t i = 3; i-- > 0;) {
    for (std::size_t k = i + 1; k < 3; ++k) x[i] -= l[k][i] * x[k];
    x[i] /= l[i][i];
  }
  return x;
}

using Changes = std::array<double, most_mended>;

/// The least change of all lengths that brings the end nearer by `missing`: J' (J J' + d)^-1 e.
Changes least_change(const Chain& chain, const Driven& driven, const Vector& missing) {
  std::array<Vector, most_mended> columns;
  std::array<Vector, 3> square{};
  for (std::size_t s = 0; s < chain.count; ++s) {
    columns[s] = slope(chain, driven, s);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j <= i; ++j) square[i][j] += columns[s][i] * columns[s][j];
    }
  }
  const double trace = square[0][0] + square[1][1] + square[2][2];
  for (std::size_t i = 0; i < 3; ++i) square[i][i] += damping * trace;
  const Vector weights = solved(square, missing);
  Changes change{};
  for (std::size_t s = 0; s < chain.count; ++s) {
    for (std::size_t i = 0; i < 3; ++i) change[s] += columns[s][i] * weights[i];
  }
  return change;
}

/// The chain with changed lengths. A segment whose length would become 0 or negative is left out.
Chain changed(const Chain& chain, const Changes& change) {
  Chain result;
  for (std::size_t s = 0; s < chain.count; ++s) {
    Segment segment = chain.segments[s];
    const double size = std::abs(segment.length) + change[s];
    if (size <= 0.0) continue;
    segment.length = std::copysign(size, segment.length);
    result.segments[result.count++] = segment;
  }
  return result;
}

// Gauss-Newton until rounding ends it. The chain whose end is nearest to the pose wins.
std::optional<Chain> mended(const Pose& from, const Pose& to, const Chain& chain,
                            const Closing& closing) {
  Chain trial = chain;
  std::optional<Chain> best;
  double least = 0.0;
  for (int round = 0; round < most_rounds; ++round) {
    const Driven driven(from, trial);
    const Vector off = missing(driven.poses[trial.count], to);
    const double square = off[0] * off[0] + off[1] * off[1] + off[2] * off[2];
    if (is_within(off, closing)) {
      const bool settled = best && square > 0.25 * least;
      if (!best || square < least) {
        best = trial;
        least = square;
      }
      if (settled) break;
    }
    if (trial.count == 0 || square == 0.0) break;
    trial = changed(trial, least_change(trial, driven, off));
  }
  if (best) best = changed(*best, Changes{});
  return best;
}

Chain chain_of(std::span<const Segment> segments) {
  Chain chain;
  for (const Segment& segment : segments) chain.segments[chain.count++] = segment;
  return chain;
}

}  // namespace

std::optional<Piece> mended(const Pose& from, const Pose& to, const Piece& piece,
                            const Closing& closing) {
  const std::optional<Chain> chain = mended(from, to, chain_of(piece.view()), closing);
  if (!chain) return std::nullopt;
  Piece result;
  for (std::size_t i = 0; i < chain->count; ++i) {
    result.segments[result.count++] = chain->segments[i];
    result.length += std::abs(chain->segments[i].length);
  }
  return result;
}

std::optional<std::vector<Segment>> mended(const Pose& from, const Pose& to,
                                           std::span<const Segment> segments,
                                           const Closing& closing) {
  assert(segments.size() <= most_mended);
  const std::optional<Chain> chain = mended(from, to, chain_of(segments), closing);
  if (!chain) return std::nullopt;
  return std::vector<Segment>(chain->segments.data(), chain->segments.data() + chain->count);
}

}  // namespace vandplan::steering
