// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/estimates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "vandplan/steering.h"
#include "vandplan/tables.h"

namespace vandplan::search {
namespace {

void euclid(const Tree& tree, const Pose& sample, std::span<float> lengths) {
  const auto x = static_cast<float>(sample.x);
  const auto y = static_cast<float>(sample.y);
  const float* const nodes_x = tree.x().data();
  const float* const nodes_y = tree.y().data();
  float* const out = lengths.data();
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const float dx = nodes_x[i] - x;
    const float dy = nodes_y[i] - y;
    out[i] = std::sqrt(dx * dx + dy * dy);
  }
}

PoseColumns columns(const Tree& tree) { return {tree.x(), tree.y(), tree.heading()}; }

void from_table(int number, const Tree& tree, const Pose& sample, double radius,
                std::span<float> lengths) {
  thesis_table(number).distances(columns(tree), sample, radius, lengths);
}

// ---- one gear ----

/// A table of Dubins lengths on the grid of the thesis' table `number`.
HeuristicTable made_dubins_table(int number) {
  const HeuristicTable like = thesis_table(number);
  std::vector<float> entries(like.entries().size());
  const int positions = like.positions();
  const int headings = like.headings();
  const double radius = like.options().turning_radius;
  for (int x = 0; x < positions; ++x) {
    for (int y = 0; y < positions; ++y) {
      for (int i = 0; i < headings * headings; ++i) {
        const HeuristicTable::GridPoint point{x, y, i / headings, i % headings};
        entries[like.index_of(point)] =
            static_cast<float>(dubins_length(like.node_of(point), like.sample_of(point), radius));
      }
    }
  }
  return {like.options(), std::move(entries)};
}

template <int number>
const HeuristicTable& dubins_table() {
  static const HeuristicTable table = made_dubins_table(number);
  return table;
}

float turned(float heading) {
  constexpr auto half_turn = std::numbers::pi_v<float>;
  return heading < 0.0F ? heading + half_turn : heading - half_turn;
}

/// Headings of the nodes and the sample, turned by half a turn: reverse becomes forward.
struct Turned {
  Turned(const Tree& tree, const Pose& to)
      : headings(tree.heading().begin(), tree.heading().end()),
        sample{to.x, to.y, wrap_angle(to.heading + std::numbers::pi)} {
    std::ranges::transform(headings, headings.begin(), turned);
  }
  std::vector<float> headings;
  Pose sample;
};

void dubins_lengths(const PoseColumns& nodes, const Pose& sample, double radius,
                    std::span<float> lengths) {
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const Pose node{static_cast<double>(nodes.x[i]), static_cast<double>(nodes.y[i]),
                    static_cast<double>(nodes.heading[i])};
    lengths[i] = static_cast<float>(dubins_length(node, sample, radius));
  }
}

void forward_lengths(Estimate estimate, const PoseColumns& nodes, const Pose& sample, double radius,
                     std::span<float> lengths) {
  switch (estimate) {
    case Estimate::hlut_1:
      return dubins_table<1>().distances(nodes, sample, radius, lengths);
    case Estimate::hlut_2:
      return dubins_table<2>().distances(nodes, sample, radius, lengths);
    case Estimate::hlut_3:
      return dubins_table<3>().distances(nodes, sample, radius, lengths);
    case Estimate::hlut_4:
      return dubins_table<4>().distances(nodes, sample, radius, lengths);
    default:
      return dubins_lengths(nodes, sample, radius, lengths);
  }
}

/// Writes lower bounds of the lengths [m], in blocks of nodes that fit a buffer.
void bound(const Tree& tree, const Pose& sample, double radius, std::span<float> lengths) {
  std::array<float, 512> high;
  for (std::size_t i = 0; i < lengths.size(); i += high.size()) {
    const std::size_t count = std::min(high.size(), lengths.size() - i);
    const PoseColumns nodes{tree.x().subspan(i, count), tree.y().subspan(i, count),
                            tree.heading().subspan(i, count)};
    length_bounds(nodes, sample, radius, lengths.subspan(i, count), std::span(high).first(count));
  }
}

}  // namespace

Estimate estimate_named(std::string_view name) {
  return static_cast<Estimate>(std::ranges::find(estimate_names, name) - estimate_names.begin());
}

void estimate_lengths(Estimate estimate, const Tree& tree, const Pose& sample, double radius,
                      std::span<float> lengths) {
  switch (estimate) {
    case Estimate::euclid:
      return euclid(tree, sample, lengths);
    case Estimate::hlut_1:
      return from_table(1, tree, sample, radius, lengths);
    case Estimate::hlut_2:
      return from_table(2, tree, sample, radius, lengths);
    case Estimate::hlut_3:
      return from_table(3, tree, sample, radius, lengths);
    case Estimate::hlut_4:
      return from_table(4, tree, sample, radius, lengths);
    case Estimate::site:
    case Estimate::bound:
      return bound(tree, sample, radius, lengths);
    case Estimate::reeds_shepp:
      return reeds_shepp_lengths(columns(tree), sample, radius, lengths);
  }
}

void estimate_lengths_in(GearSign gear, Estimate estimate, const Tree& tree, const Pose& sample,
                         double radius, std::span<float> lengths) {
  if (estimate == Estimate::euclid || estimate == Estimate::bound || estimate == Estimate::site) {
    return estimate_lengths(estimate, tree, sample, radius, lengths);
  }
  if (gear > 0) return forward_lengths(estimate, columns(tree), sample, radius, lengths);
  const Turned turned(tree, sample);
  forward_lengths(estimate, {tree.x(), tree.y(), turned.headings}, turned.sample, radius, lengths);
}

}  // namespace vandplan::search
