// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which path is shortest on open ground for a vehicle that may reverse?
//
// Reeds & Shepp 1990: a shortest path is one of 48 words of arcs and at most one line.
// Formulas: docs/algorithms/steering.md; proof and errata: docs/proofs/steering.md.

#include <span>
#include <vector>

#include "vandplan/geometry.h"
#include "vandplan/path.h"

namespace vandplan {

/// The shortest path from `from` to `to` with curvature -1/radius, 0 or 1/radius, in either gear.
/// The path from b to a is the path from a to b driven backwards, ties included. Throws InputError
/// naming "radius" unless it is finite and > 0 [m].
[[nodiscard]] Piece reeds_shepp(const Pose& from, const Pose& to, double radius);

/// The length of the shortest path, `reeds_shepp(from, to, radius)`, bit for bit [m]. Throws
/// InputError naming "radius" unless it is finite and > 0 [m].
[[nodiscard]] double reeds_shepp_length(const Pose& from, const Pose& to, double radius);

/// Lengths of the shortest paths from every node to one sample, in float, for ranking [m]: out[i]
/// belongs to node i. They have equal bits on every processor. They are within
/// 4e-6 * (length + radius) of the exact lengths between the poses as rounded to float. Far from
/// the origin that rounding alone is large (0.5 m at 6 000 km), so give poses near it.
///
/// Throws InputError naming "radius" unless it is finite and > 0 [m], or "nodes" unless all columns
/// have as many numbers as `out`.
void reeds_shepp_lengths(const PoseColumns& nodes, const Pose& sample, double radius,
                         std::span<float> out);

/// Lengths of the shortest paths of many pairs, `reeds_shepp_length(from[i], to[i], radius)`, bit
/// for bit [m]. Several are computed at a time where the processor has vectors of double. Either
/// side may be one pose for all. Throws InputError naming "radius" unless it is finite and > 0 [m],
/// or "from" or "to" if it has neither one pose nor as many as `out`.
void reeds_shepp_lengths(std::span<const Pose> from, std::span<const Pose> to, double radius,
                         std::span<double> out);

/// The paths of all of the 48 words that join the poses, shortest or not. Throws InputError naming
/// "radius" unless it is finite and > 0 [m].
[[nodiscard]] std::vector<Piece> reeds_shepp_words(const Pose& from, const Pose& to, double radius);

}  // namespace vandplan
