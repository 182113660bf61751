// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/lattice_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "base/derived.h"

namespace vandplan::search {
namespace {

constexpr std::int64_t most_entries = 60'000;  // size of a table, unused entries included
constexpr int look_every = 64;                 // vertices between two calls of `is_interrupted`
constexpr float unknown = std::numeric_limits<float>::infinity();

/// A primitive seen from its end: index of its first heading, steps in x and y, length [m].
struct Back {
  std::int32_t from, dx, dy;
  float length;
};

std::vector<std::vector<Back>> by_end(const Primitives& primitives) {
  std::vector<std::vector<Back>> into(primitives.headings().size());
  for (const Primitive& p : primitives.all()) {
    into[static_cast<std::size_t>(p.to)].push_back(
        {p.from, p.dx, p.dy, static_cast<float>(p.piece.length)});
  }
  return into;
}

/// Largest |x| and |y| of a table [steps]: what `most_entries` allows, or the longest primitive if
/// it is longer; at most 200.
std::int32_t reach_of(const Primitives& primitives) {
  const auto headings = static_cast<double>(primitives.headings().size());
  const double side = std::sqrt(static_cast<double>(most_entries) / headings);
  const double least = std::ceil(primitives.longest() / primitives.step());
  return static_cast<std::int32_t>(std::clamp(least, (side - 1) / 2, 200.0));
}

/// A vertex in the open list, and the length of the way from the vertex [m].
struct Reached {
  float length;
  Vertex vertex;
  bool operator<(const Reached& other) const { return length > other.length; }
};

}  // namespace

std::int32_t heading_ahead(const Primitives& primitives) {
  const auto headings = primitives.headings();
  const auto ahead = std::ranges::min_element(headings, {}, [](double h) { return std::abs(h); });
  return static_cast<std::int32_t>(ahead - headings.begin());
}

LatticeTable::LatticeTable(const Primitives& primitives,
                           const std::function<bool()>& is_interrupted)
    : headings_(static_cast<std::int32_t>(primitives.headings().size())),
      reach_(reach_of(primitives)),
      most_(reach_ * primitives.step() * (1 - 1e-6)) {
  const auto side = static_cast<std::size_t>(2 * reach_ + 1);
  lengths_.assign(side * side * primitives.headings().size(), unknown);
  const std::vector<std::vector<Back>> into = by_end(primitives);
  std::priority_queue<Reached> open;
  const auto reach = [&](const Vertex& vertex, float length) {
    if (static_cast<double>(length) >= most_) return;
    // The index is in range: a way below `most_` stays within `reach_` steps.
    float& known = lengths_[index_of(vertex)];
    if (length >= known) return;
    known = length;
    open.push({length, vertex});
  };
  reach({0, 0, heading_ahead(primitives)}, 0.0F);
  while (!open.empty()) {
    const Reached last = open.top();
    open.pop();
    if (last.length != lengths_[index_of(last.vertex)]) continue;
    if (size_++ % look_every == 0 && is_interrupted()) return;
    for (const Back& p : into[static_cast<std::size_t>(last.vertex.heading)]) {
      reach({last.vertex.x - p.dx, last.vertex.y - p.dy, p.from}, last.length + p.length);
    }
  }
  // A sum in float may exceed the exact sum by some roundings; bounds must not exceed it.
  constexpr float less = 1.0F - 1e-5F;
  most_ *= static_cast<double>(less);
  const auto most = static_cast<float>(most_);
  most_ = static_cast<double>(most);
  for (float& length : lengths_) length = std::min(length * less, most);
  is_whole_ = true;
}

std::shared_ptr<const LatticeTable> table_of(const Primitives& primitives,
                                             const std::function<bool()>& is_interrupted) {
  struct Interrupted {};
  try {
    return std::static_pointer_cast<const LatticeTable>(primitives.derived().find_or_make(
        typeid(LatticeTable), [](const void*) { return true; },
        [&]() -> std::shared_ptr<const void> {
          auto table = std::make_shared<const LatticeTable>(primitives, is_interrupted);
          if (!table->is_whole()) throw Interrupted();  // a table that is not whole is not kept
          return table;
        }));
  } catch (const Interrupted&) {
    return nullptr;
  }
}

}  // namespace vandplan::search
