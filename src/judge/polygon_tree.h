// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the vehicle from the nearest of many polygons, in the eyes of the judge?
//
// A tree of bars. The upper part sorts polygons. Below it each polygon is a chain of sides, which
// is halved again and again. The ends of a chain tell how often a ray crosses it, unless the ray
// begins beside the chain. The tree of a few polygons is built when it is first needed, because
// most paths pass by most of a large site.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "judge/clearance.h"
#include "vandplan/geometry.h"

namespace vandplan::judge {

class PolygonTree {
 public:
  /// `polygons` are kept by reference.
  explicit PolygonTree(std::span<const Polygon> polygons);

  /// Distance between the closed body and the closed polygons [m], if the curvature is constant; 0
  /// if one contains the other. On a passage it is a lower bound for all positions. Values are cut
  /// off at `most`.
  [[nodiscard]] double clearance(const View& view, const Outline& body, double most,
                                 Effort& effort) const;

  /// First polygon that is at most `distance` [m] from the body at a position, or contains it.
  [[nodiscard]] std::optional<std::size_t> first_within(double distance, const View& view,
                                                        const Outline& body) const;

  /// Consecutive sides of one polygon; side i goes from corner i to the next corner.
  struct Chain {
    std::uint32_t polygon = 0;
    std::uint32_t first = 0;
    std::uint32_t sides = 0;
  };

  /// Node of the tree: several polygons or a chain of sides, and a bar that contains them.
  struct Node {
    Bar bar = {};
    std::uint32_t child = 0;  ///< index of the first of two adjacent children; 0: none
    Chain chain = {};         ///< chain of sides; it has no sides if the node has several polygons
    /// Index into `groups_`, if the node has neither children nor a chain.
    std::uint32_t group = 0;
  };

  /// Nodes of a tree; the first one is the root.
  using Nodes = std::vector<Node>;

  /// Range of polygons in a list.
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };

 private:
  class Search;

  /// Tree of a group of polygons, which is built on first use. It may be used by several threads at
  /// once: threads that come at the same time build equal trees, of which one is kept.
  class Group {
   public:
    Group() = default;
    ~Group() { delete nodes_.load(); }
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;

    template <typename Make>
    const Nodes& nodes(Make make);

   private:
    std::atomic<const Nodes*> nodes_ = nullptr;
  };

  [[nodiscard]] const Nodes& nodes_of(std::uint32_t group, Effort& effort) const;
  [[nodiscard]] Point corner(const Chain& chain, std::uint32_t i) const;
  [[nodiscard]] bool is_crossed(const Nodes& nodes, const Node& node, const View& view) const;
  void find_holder(const Nodes& nodes, const Node& node, const View& view, std::size_t& first,
                   Effort& effort) const;
  void find_within(double distance, const Nodes& nodes, const Node& node, const View& view,
                   const Outline& body, std::size_t& first, Effort& effort) const;

  std::span<const Polygon> polygons_;
  /// Order of the polygons, in which those of a group are adjacent.
  std::vector<std::uint32_t> order_;
  std::vector<Range> ranges_;  ///< range of `order_` of each group
  std::unique_ptr<Group[]> groups_;
  Nodes nodes_;  ///< nodes above the groups
};

}  // namespace vandplan::judge
