// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the vehicle from the nearest of many polygons, in the eyes of the judge?
//
// A tree of bars. Below its upper part, which sorts polygons, each polygon is a chain of sides that
// is halved again and again: parts of a chain lie together, and how often a ray crosses one shows
// at its ends unless the ray begins beside it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "judge/clearance.h"
#include "vandplan/geometry.h"

namespace vandplan::judge {

class PolygonTree {
 public:
  /// The polygons are only looked at: they must stay where they are as long as the tree is used.
  explicit PolygonTree(std::span<const Polygon> polygons);

  /// Between the closed body and the closed polygons [m], if the curvature is constant: at one
  /// position the distance, 0 if one holds the other; on a passage no more than that at any of its
  /// positions; never more than `most`.
  [[nodiscard]] double clearance(const View& view, const Outline& body, double most,
                                 Effort& effort) const;

  /// The first polygon that is at most so far from the body at a position [m], or holds it.
  [[nodiscard]] std::optional<std::size_t> first_within(double distance, const View& view,
                                                        const Outline& body) const;

  /// Sides of one polygon, one after the other; side i goes from corner i to the next.
  struct Chain {
    std::uint32_t polygon = 0;
    std::uint32_t first = 0;
    std::uint32_t sides = 0;
  };

  /// Polygons, or the chain of sides of one, and the bar that all of it is in.
  struct Node {
    Bar bar = {};
    std::uint32_t child = 0;  ///< the first of two that stand together; 0: none
    Chain chain = {};         ///< without sides where there are many polygons
  };

 private:
  class Search;

  [[nodiscard]] Point corner(const Chain& chain, std::uint32_t i) const;
  [[nodiscard]] bool is_crossed(const Node& node, const View& view) const;
  void find_holder(const Node& node, const View& view, std::size_t& first, Effort& effort) const;
  void find_within(double distance, const Node& node, const View& view, const Outline& body,
                   std::size_t& first) const;

  std::span<const Polygon> polygons_;
  std::vector<Node> nodes_;  ///< the first is the root
};

}  // namespace vandplan::judge
