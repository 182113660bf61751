// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/polygon_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include "judge/bars.h"

namespace vandplan::judge {
namespace {

using Chain = PolygonTree::Chain;
using Node = PolygonTree::Node;
using Nodes = PolygonTree::Nodes;
using Range = PolygonTree::Range;

constexpr std::uint32_t most_sides = 8;  // largest number of sides of a chain that is not halved
constexpr std::size_t many = 256;        // least number of items that are sorted into squares
// Largest number of points for which a narrow bar is searched.
constexpr std::size_t most_points = 256;
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Number of leaves of a chain with `sides` sides.
std::size_t chains_of(std::uint32_t sides) {
  if (sides <= most_sides) return 1;
  return chains_of(sides / 2) + chains_of(sides - sides / 2);
}

struct Item {
  Box box;
  std::uint32_t polygon = 0;
  std::uint32_t corners = 0;
};

Item item_of(std::span<const Polygon> polygons, std::uint32_t index) {
  const Polygon& polygon = polygons[index];
  Box box = Box::of(polygon[0]);
  for (const Point& corner : polygon) box.add(corner);
  return {box, index, static_cast<std::uint32_t>(polygon.size())};
}

/// Statistics of items from one pass over them.
struct Spread {
  Box box;              ///< box around all items
  Box middles;          ///< box around the middles of the items' boxes
  double longest;       ///< largest size of an item's box [m]
  std::size_t corners;  ///< number of corners of all items
};

Spread spread_of(std::span<const Item> items) {
  Spread spread{items[0].box, Box::of(items[0].box.middle()), 0.0, 0};
  for (const Item& item : items) {
    spread.box.add(item.box);
    spread.middles.add(item.box.middle());
    spread.longest = std::max(spread.longest, item.box.size());
    spread.corners += item.corners;
  }
  return spread;
}

/// Moves long items to the front, and returns their number. Mixed with others they would make every
/// bar long. Returns 0 if there are no long items, or only long ones.
std::size_t part_long(std::span<Item> items, const Spread& spread) {
  if (spread.longest <= spread.middles.size()) return 0;
  const auto end = std::partition(items.begin(), items.end(), [&](const Item& item) {
    return item.box.size() > spread.longest / 2;
  });
  return end == items.end() ? 0 : static_cast<std::size_t>(end - items.begin());
}

/// Splits items at the median of their middles along the wider axis.
std::size_t part_in_halves(std::span<Item> items, const Spread& spread) {
  const auto& [low, high] = spread.middles;
  const bool wide = high.x - low.x > high.y - low.y;
  const std::size_t half = items.size() / 2;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   [wide](const Item& a, const Item& b) {
                     const Point one = a.box.middle();
                     const Point other = b.box.middle();
                     return wide ? one.x < other.x : one.y < other.y;
                   });
  return half;
}

/// Splits items in two; returns the number of items in the first part.
std::size_t part(std::span<Item> items, const Spread& spread) {
  const std::size_t of_long = part_long(items, spread);
  return of_long > 0 ? of_long : part_in_halves(items, spread);
}

/// Grid of 8 x 8 squares around the middles of many items. Items are sorted along a Z curve: those
/// of a quarter, of a quarter of that, and so on, are adjacent.
class Squares {
 public:
  static constexpr std::size_t count = 64;

  Squares(std::span<Item> items, const Spread& spread, std::vector<Item>& buffer);

  /// Number of items in the squares before `square`.
  [[nodiscard]] std::size_t before(std::size_t square) const { return before_[square]; }
  /// Box around the items of the squares from `first` to `last` - 1, of which one must have items.
  [[nodiscard]] Box box(std::size_t first, std::size_t last) const;
  /// Whether one square has nearly all items, so that sorting gained nothing.
  [[nodiscard]] bool has_most() const;

 private:
  std::array<std::size_t, count + 1> before_ = {};
  std::array<Box, count> boxes_ = {};
};

/// Counting sort; `buffer` holds the items meanwhile.
Squares::Squares(std::span<Item> items, const Spread& spread, std::vector<Item>& buffer) {
  constexpr std::uint32_t side = 8;
  const Box& around = spread.middles;
  const auto place = [](double v, double first, double last) {
    const double share = last > first ? (v - first) / (last - first) : 0.0;
    return std::min(static_cast<std::uint32_t>(share * side), side - 1);
  };
  const auto square_of = [&](const Item& item) -> std::size_t {
    const Point middle = item.box.middle();
    const std::uint32_t x = place(middle.x, around.low.x, around.high.x);
    const std::uint32_t y = place(middle.y, around.low.y, around.high.y);
    const auto spaced = [](std::uint32_t v) { return (v & 1U) | (v & 2U) << 1U | (v & 4U) << 2U; };
    return spaced(x) | spaced(y) << 1U;
  };
  buffer.assign(items.begin(), items.end());
  for (const Item& item : buffer) ++before_[square_of(item) + 1];
  std::partial_sum(before_.begin(), before_.end(), before_.begin());
  std::array<std::size_t, count + 1> next = before_;
  for (const Item& item : buffer) {
    const std::size_t square = square_of(item);
    if (next[square] == before_[square]) boxes_[square] = item.box;
    boxes_[square].add(item.box);
    items[next[square]++] = item;
  }
}

Box Squares::box(std::size_t first, std::size_t last) const {
  while (before_[first + 1] == before_[first]) ++first;
  Box box = boxes_[first];
  for (std::size_t i = first + 1; i < last; ++i) {
    if (before_[i + 1] > before_[i]) box.add(boxes_[i]);
  }
  return box;
}

bool Squares::has_most() const {
  for (std::size_t i = 0; i < count; ++i) {
    if (8 * (before_[i + 1] - before_[i]) > 7 * before_[count]) return true;
  }
  return false;
}

std::size_t add_children(Nodes& nodes, std::size_t node) {
  const std::size_t child = nodes.size();
  nodes[node].child = static_cast<std::uint32_t>(child);
  nodes.resize(child + 2);
  return child;
}

/// Builds the tree above the groups, and sorts the polygons into groups.
class Sorter {
 public:
  explicit Sorter(std::vector<Item> items) : items_(std::move(items)) {
    nodes_.emplace_back();
    sort(0, items_);
  }
  [[nodiscard]] std::vector<Item>& items() { return items_; }
  [[nodiscard]] Nodes& nodes() { return nodes_; }
  [[nodiscard]] std::vector<Range>& groups() { return groups_; }

 private:
  void sort(std::size_t node, std::span<Item> items);
  void sort_parts(std::size_t node, std::span<Item> items, std::size_t half);
  void sort_squares(std::size_t node, std::span<Item> items, const Squares& squares, Range of);

  std::vector<Item> items_;
  std::vector<Item> buffer_;
  Nodes nodes_;
  std::vector<Range> groups_;
};

void Sorter::sort(std::size_t node, std::span<Item> items) {
  const Spread spread = spread_of(items);
  nodes_[node].bar = bar_of(spread.box);
  if (items.size() == 1 || spread.corners <= most_points) {
    nodes_[node].group = static_cast<std::uint32_t>(groups_.size());
    groups_.push_back({static_cast<std::uint32_t>(items.data() - items_.data()),
                       static_cast<std::uint32_t>(items.size())});
    return;
  }
  if (const std::size_t of_long = part_long(items, spread)) return sort_parts(node, items, of_long);
  if (items.size() >= many) {
    const Squares squares(items, spread, buffer_);
    if (!squares.has_most()) return sort_squares(node, items, squares, {0, Squares::count});
  }
  sort_parts(node, items, part_in_halves(items, spread));
}

void Sorter::sort_parts(std::size_t node, std::span<Item> items, std::size_t half) {
  const std::size_t child = add_children(nodes_, node);
  sort(child, items.first(half));
  sort(child + 1, items.subspan(half));
}

/// Adds the tree of a range of squares: halves the range until one square is left, or few items.
void Sorter::sort_squares(std::size_t node, std::span<Item> items, const Squares& squares,
                          Range of) {
  const std::size_t first = of.first, last = of.first + of.count;
  const std::size_t begin = squares.before(first), end = squares.before(last);
  if (of.count == 1 || end - begin < many) return sort(node, items.subspan(begin, end - begin));
  const Range low{of.first, of.count / 2}, high{of.first + of.count / 2, of.count / 2};
  const std::size_t middle = squares.before(high.first);
  if (middle == begin) return sort_squares(node, items, squares, high);
  if (middle == end) return sort_squares(node, items, squares, low);
  nodes_[node].bar = bar_of(squares.box(first, last));
  const std::size_t child = add_children(nodes_, node);
  sort_squares(child, items, squares, low);
  sort_squares(child + 1, items, squares, high);
}

/// Builds the tree of a group.
class Builder {
 public:
  Builder(std::span<const Polygon> polygons, std::vector<Item> items);
  [[nodiscard]] Nodes nodes() && { return std::move(nodes_); }

 private:
  void sort(std::size_t node, std::span<Item> items);
  void halve(std::size_t chain);
  [[nodiscard]] Bar bar_around(std::span<const Item> items);
  [[nodiscard]] Bar bar_around(const Chain& chain);

  std::span<const Polygon> polygons_;
  Nodes nodes_;
  std::vector<Point> points_;  // points of the bar that is being built
};

Builder::Builder(std::span<const Polygon> polygons, std::vector<Item> items) : polygons_(polygons) {
  std::size_t chains = 0;
  for (const Item& item : items) chains += chains_of(item.corners);
  nodes_.reserve(2 * chains - 1);
  nodes_.emplace_back();
  sort(0, items);
}

void Builder::sort(std::size_t node, std::span<Item> items) {
  if (items.size() == 1) {
    nodes_[node].chain = {items[0].polygon, 0, items[0].corners};
    return halve(node);
  }
  nodes_[node].bar = bar_around(items);
  const std::size_t half = part(items, spread_of(items));
  const std::size_t child = add_children(nodes_, node);
  sort(child, items.first(half));
  sort(child + 1, items.subspan(half));
}

void Builder::halve(std::size_t chain) {
  nodes_[chain].bar = bar_around(nodes_[chain].chain);
  const auto [polygon, first, sides] = nodes_[chain].chain;
  if (sides <= most_sides) return;
  const std::size_t child = add_children(nodes_, chain);
  const std::uint32_t half = sides / 2;
  nodes_[child].chain = {polygon, first, half};
  nodes_[child + 1].chain = {polygon, first + half, sides - half};
  halve(child);
  halve(child + 1);
}

Bar Builder::bar_around(std::span<const Item> items) {
  points_.clear();
  for (const Item& item : items) {
    const Polygon& polygon = polygons_[item.polygon];
    points_.insert(points_.end(), polygon.begin(), polygon.end());
  }
  return bar_of(points_);
}

Bar Builder::bar_around(const Chain& chain) {
  const std::span<const Point> polygon = polygons_[chain.polygon];
  // Index of the last corner; beyond the last corner of the polygon it means the first.
  const std::size_t end = std::size_t{chain.first} + chain.sides;
  const auto corners =
      polygon.subspan(chain.first, std::min(end + 1, polygon.size()) - chain.first);
  const Point& last = polygon[end % polygon.size()];
  if (chain.sides >= most_points) {
    Box box = Box::of(last);
    for (const Point& corner : corners) box.add(corner);
    return bar_of(box);
  }
  points_.assign(corners.begin(), corners.end());
  points_.push_back(last);
  return bar_of(points_);
}

}  // namespace

/// Search for the nearest polygon on one passage.
class PolygonTree::Search {
 public:
  Search(const PolygonTree& tree, const View& view, const Outline& body, double most,
         Effort& effort)
      : tree_(tree), view_(view), body_(body), least_(most), effort_(effort) {}

  [[nodiscard]] double least() const { return std::max(0.0, least_); }

  /// Lowers `least` to the clearance of the polygons in a node.
  void look(const Nodes& nodes, const Node& node);

 private:
  [[nodiscard]] double measure(const Bar& seen_bar) {
    ++effort_.visited;
    return clearance_of_bar(view_.passage, body_, seen_bar, least_);
  }
  void look_at_sides(const Chain& chain);

  const PolygonTree& tree_;
  const View& view_;
  const Outline& body_;
  double least_;
  Effort& effort_;
};

void PolygonTree::Search::look(const Nodes& nodes, const Node& node) {
  if (node.chain.sides > 0 && node.child == 0) return look_at_sides(node.chain);
  if (node.child == 0) {
    const Nodes& group = tree_.nodes_of(node.group, effort_);
    return look(group, group[0]);
  }
  const Node* near = &nodes[node.child];
  const Node* far = near + 1;
  double to_near = measure(judge::seen(view_, near->bar));
  double to_far = measure(judge::seen(view_, far->bar));
  if (to_far < to_near) {
    std::swap(near, far);
    std::swap(to_near, to_far);
  }
  if (least_ > 0 && to_near < least_) look(nodes, *near);
  if (least_ > 0 && to_far < least_) look(nodes, *far);
}

void PolygonTree::Search::look_at_sides(const Chain& chain) {
  Point a = judge::seen(view_, tree_.corner(chain, 0));
  for (std::uint32_t i = 1; i <= chain.sides && least_ > 0; ++i) {
    const Point b = judge::seen(view_, tree_.corner(chain, i));
    least_ = std::min(least_, measure({a, b}));
    a = b;
  }
}

template <typename Make>
const Nodes& PolygonTree::Group::nodes(Make make) {
  const Nodes* known = nodes_.load(std::memory_order_acquire);
  if (known != nullptr) return *known;
  auto made = std::make_unique<const Nodes>(make());
  const bool is_first = nodes_.compare_exchange_strong(known, made.get());
  return is_first ? *made.release() : *known;
}

PolygonTree::PolygonTree(std::span<const Polygon> polygons) : polygons_(polygons) {
  if (polygons.empty()) return;
  std::vector<Item> items;
  items.reserve(polygons.size());
  for (std::uint32_t i = 0; i < polygons.size(); ++i) items.push_back(item_of(polygons, i));
  Sorter sorter(std::move(items));
  order_.reserve(polygons.size());
  for (const Item& item : sorter.items()) order_.push_back(item.polygon);
  ranges_ = std::move(sorter.groups());
  groups_ = std::make_unique<Group[]>(ranges_.size());
  nodes_ = std::move(sorter.nodes());
}

const Nodes& PolygonTree::nodes_of(std::uint32_t group, Effort& effort) const {
  return groups_[group].nodes([&] {
    const auto [first, count] = ranges_[group];
    std::vector<Item> items;
    for (const std::uint32_t polygon : std::span(order_).subspan(first, count)) {
      items.push_back(item_of(polygons_, polygon));
    }
    Nodes nodes = Builder(polygons_, std::move(items)).nodes();
    effort.made += nodes.size();
    return nodes;
  });
}

double PolygonTree::clearance(const View& view, const Outline& body, double most,
                              Effort& effort) const {
  if (nodes_.empty()) return most;
  Search search(*this, view, body, most, effort);
  search.look(nodes_, nodes_[0]);
  if (search.least() == 0) return 0;
  // The body holds its rear axle. If no side touches the body, it is in a polygon exactly if the
  // axle is.
  std::size_t holder = none;
  find_holder(nodes_, nodes_[0], view, holder, effort);
  return holder == none ? search.least() : 0;
}

std::optional<std::size_t> PolygonTree::first_within(double distance, const View& view,
                                                     const Outline& body) const {
  if (nodes_.empty()) return std::nullopt;
  std::size_t first = none;
  Effort effort;
  find_within(distance, nodes_, nodes_[0], view, body, first, effort);
  find_holder(nodes_, nodes_[0], view, first, effort);
  return first == none ? std::nullopt : std::optional(first);
}

Point PolygonTree::corner(const Chain& chain, std::uint32_t i) const {
  const Polygon& polygon = polygons_[chain.polygon];
  const std::size_t index = std::size_t{chain.first} + i;
  return polygon[index == polygon.size() ? 0 : index];
}

void PolygonTree::find_within(double distance, const Nodes& nodes, const Node& node,
                              const View& view, const Outline& body, std::size_t& first,
                              Effort& effort) const {
  const double more = distance + std::numeric_limits<double>::min();
  const auto is_within = [&](const Bar& bar) {
    return clearance_of_bar(view.passage, body, judge::seen(view, bar), more) <= distance;
  };
  if (!is_within(node.bar) || (node.chain.sides > 0 && node.chain.polygon >= first)) return;
  if (node.child != 0) {
    find_within(distance, nodes, nodes[node.child], view, body, first, effort);
    find_within(distance, nodes, nodes[node.child + 1], view, body, first, effort);
    return;
  }
  if (node.chain.sides == 0) {
    const Nodes& group = nodes_of(node.group, effort);
    return find_within(distance, group, group[0], view, body, first, effort);
  }
  for (std::uint32_t i = 0; i < node.chain.sides; ++i) {
    if (is_within({corner(node.chain, i), corner(node.chain, i + 1)})) first = node.chain.polygon;
  }
}

namespace {

// Bars are enlarged by many times the rounding error of a double (`slack` of bars.cpp). So
// positions rounded to double suffice for the next two functions.

/// Whether a bar contains a point. A bar is convex, so polygons in it contain no point outside it.
bool holds(const Bar& bar, const Point& p) {
  const double dx = bar.b.x - bar.a.x;
  const double dy = bar.b.y - bar.a.y;
  const double squared = dx * dx + dy * dy;
  const double along = (p.x - bar.a.x) * dx + (p.y - bar.a.y) * dy;
  const double part = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
  const double x = p.x - bar.a.x - part * dx;
  const double y = p.y - bar.a.y - part * dy;
  return x * x + y * y <= bar.radius * bar.radius;
}

/// Projection of a bar onto an axis [m].
struct Span {
  double low, high;
};

Span across(const Bar& bar) {
  return {std::min(bar.a.x, bar.b.x) - bar.radius, std::max(bar.a.x, bar.b.x) + bar.radius};
}

Span along(const Bar& bar) {
  return {std::min(bar.a.y, bar.b.y) - bar.radius, std::max(bar.a.y, bar.b.y) + bar.radius};
}

bool holds(const Span& span, double value) { return span.low <= value && value <= span.high; }

}  // namespace

/// Whether a ray from the axle along the x axis crosses an odd number of sides of a node's chain.
bool PolygonTree::is_crossed(const Nodes& nodes, const Node& node, const View& view) const {
  const Span x = across(node.bar);
  if (x.high < view.axle.x || !holds(along(node.bar), view.axle.y)) return false;
  const Position& from = view.passage.middle;
  const Chain& chain = node.chain;
  const auto is_above = [&](std::uint32_t i) { return corner(chain, i).y > from.y; };
  // If the whole chain is ahead, the ray crosses it as often as the whole line does.
  if (x.low > view.axle.x) return is_above(0) != is_above(chain.sides);
  if (node.child != 0) {
    return is_crossed(nodes, nodes[node.child], view) !=
           is_crossed(nodes, nodes[node.child + 1], view);
  }
  bool odd = false;
  for (std::uint32_t i = 0; i < chain.sides; ++i) {
    if (is_above(i) == is_above(i + 1)) continue;
    const Point a = corner(chain, i);
    const Point b = corner(chain, i + 1);
    const Real part = (from.y - a.y) / (static_cast<Real>(b.y) - a.y);
    if (a.x + part * (static_cast<Real>(b.x) - a.x) > from.x) odd = !odd;
  }
  return odd;
}

/// Lowers `first` to the first polygon of a node that holds the rear axle.
void PolygonTree::find_holder(const Nodes& nodes, const Node& node, const View& view,
                              std::size_t& first, Effort& effort) const {
  ++effort.visited;
  if (!holds(node.bar, view.axle)) return;
  if (node.chain.sides > 0) {
    if (node.chain.polygon < first && is_crossed(nodes, node, view)) first = node.chain.polygon;
    return;
  }
  if (node.child == 0) {
    const Nodes& group = nodes_of(node.group, effort);
    return find_holder(group, group[0], view, first, effort);
  }
  find_holder(nodes, nodes[node.child], view, first, effort);
  find_holder(nodes, nodes[node.child + 1], view, first, effort);
}

}  // namespace vandplan::judge
