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

constexpr std::int64_t most_entries = 60'000;  // with those that stay empty
constexpr int look_every = 64;                 // vertices
constexpr float unknown = std::numeric_limits<float>::infinity();

/// A primitive that ends with some heading, in the reverse order of driving.
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

/// Steps in each direction that a table may have, at least those of the longest primitive.
std::int32_t reach_of(const Primitives& primitives) {
  const auto headings = static_cast<double>(primitives.headings().size());
  const double side = std::sqrt(static_cast<double>(most_entries) / headings);
  const double least = std::ceil(primitives.longest() / primitives.step());
  return static_cast<std::int32_t>(std::clamp(least, (side - 1) / 2, 200.0));
}

/// A vertex and the way from it.
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
    float& known = lengths_[index_of(vertex)];  // its way is no shorter than to its corner
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
  // A sum in float may be above the sum of the lengths by some roundings.
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
          if (!table->is_whole()) throw Interrupted();  // so that it is not kept
          return table;
        }));
  } catch (const Interrupted&) {
    return nullptr;
  }
}

}  // namespace vandplan::search
