// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the vehicle from the nearest of many polygons, in the eyes of the judge?
//
// A tree of bars. Below its upper part, which sorts polygons, each polygon is a chain of sides that
// is halved again and again: parts of a chain lie together, and how often a ray crosses one shows
// at its ends unless the ray begins beside it. What is below a few polygons is made when somebody
// looks there for the first time: most paths pass by most of a large site.

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
    /// Where there is neither: those of that place in `groups_`.
    std::uint32_t group = 0;
  };

  /// A tree whose root is the first of them.
  using Nodes = std::vector<Node>;

  /// Some polygons, those from one place in a list to another.
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };

 private:
  class Search;

  /// The tree of a group, from the moment that somebody asks for it. May be used from several
  /// threads at once: those who come at the same time make the same.
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
  std::vector<std::uint32_t> order_;  ///< of the polygons: those of a group stand together
  std::vector<Range> ranges_;         ///< of each group
  std::unique_ptr<Group[]> groups_;
  Nodes nodes_;  ///< above the groups
};

}  // namespace vandplan::judge
