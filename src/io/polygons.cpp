// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/polygons.h"

#include <fmt/format.h>

#include <vector>

namespace vandplan::io {

Point pair_from(const Document& file, const Node& node, const std::string& expected) {
  const std::vector<Node>& items = file.list(node, expected);
  if (items.size() != 2) {
    file.fail(node, fmt::format("has {} element{}, expected {}", items.size(),
                                items.size() == 1 ? "" : "s", expected));
  }
  return {file.number(items[0]), file.number(items[1])};
}

Polygon polygon_from(const Document& file, const Node& node) {
  const std::vector<Node>& items = file.list(node, "a polygon [[x, y], ...]");
  Polygon polygon;
  polygon.reserve(items.size());
  for (const Node& corner : items) polygon.push_back(pair_from(file, corner, "a corner [x, y]"));
  return polygon;
}

std::string yaml_of(const Polygon& polygon) {
  std::string corners;
  for (const auto& [x, y] : polygon) {
    corners += fmt::format("{}[{}, {}]", corners.empty() ? "" : ", ", x, y);
  }
  return '[' + corners + ']';
}

}  // namespace vandplan::io
