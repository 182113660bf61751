// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "collision/disc_trace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/convex.h"

namespace vandplan::collision {
namespace {

constexpr double shortest_look = 1.0;  // Shorter parts stay undecided [m].
constexpr double most_discs = 8.0;

/// Largest radius of discs in a row that a body contains; negative if a centre is outside.
double covered(const Polygon& corners, double first, double step, int count) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count; ++i) {
    least = std::min(least, -geometry::signed_distance(corners, {first + i * step, 0.0}));
  }
  return least;
}

DiscRow disc_row(const Shape& shape, double margin, int count) {
  const Footprint& body = shape.box;
  const double half_step = (body.front + body.rear) / (2 * count);
  const double first = half_step - body.rear;
  const double inner = shape.corners.empty() ? std::min(half_step, body.half_width)
                                             : covered(shape.corners, first, 2 * half_step, count);
  return {.first = first,
          .step = 2 * half_step,
          .count = count,
          .furthest = std::max(std::abs(first), std::abs(body.front - half_step)),
          .outer = std::hypot(half_step, body.half_width) + end_margin + margin,
          .inner = inner - end_margin + margin};
}

class Tracer {
 public:
  Tracer(const geometry::DistanceField& field, double side, const DiscRows& discs,
         const PlacedSegment& placed)
      : field_(field), side_(side), per_metre_(1 / side), discs_(discs), placed_(placed) {
    // Distance that may be driven before a centre has moved by one metre [m].
    const auto pace = [&](const DiscRow& row) {
      const double turned = placed.curvature * row.furthest;
      return 1 / std::sqrt(1 + turned * turned);
    };
    one_pace_ = pace(discs.one);
    slim_pace_ = pace(discs.slim);
  }

  /// Looks at the middle of the segment, then at the middles of undecided parts, longest parts
  /// first. So an obstacle across the segment is found soon.
  void run(DiscTrace& trace) {
    open_[open_count_++] = {0, placed_.length};
    for (std::size_t i = 0; i < open_count_; ++i) {
      const auto [begin, end] = open_[i];
      const double middle = (begin + end) / 2;
      const double wanted = (end - begin) / 2;
      const double room = clear_around(middle, wanted);
      trace.is_hit = is_hit_;
      if (is_hit_) return;
      if (room >= wanted) continue;
      const double clear = std::max(room, 0.0);
      leave({begin, middle - clear}, trace);
      leave({middle + clear, end}, trace);
    }
  }

 private:
  /// Distance before and behind a place that is clear [m]; at least `wanted` if that much is.
  /// Negative if the place itself may not be clear.
  double clear_around(double place, double wanted) {
    const Placement axle = placed_.at(place);
    const double clear = one_pace_ * room(discs_.one, axle);
    if (clear >= wanted || is_hit_ || discs_.slim.count == 1) return clear;
    return std::max(clear, slim_pace_ * room(discs_.slim, axle));
  }

  /// Distance that the discs may move in any direction without touching a blocked cell [m].
  double room(const DiscRow& row, const Placement& axle) {
    double room = std::numeric_limits<double>::infinity();
    for (int i = 0; i < row.count && !is_hit_; ++i) {
      const double ahead = row.first + i * row.step;
      const Point centre{(axle.position.x + ahead * axle.heading.x) * per_metre_,
                         (axle.position.y + ahead * axle.heading.y) * per_metre_};
      const double least = field_.at_least(centre) * side_;
      room = std::min(room, least - row.outer);
      is_hit_ = least < row.inner && field_.around(centre).most * side_ < row.inner;
    }
    return room;
  }

  void leave(const Part& part, DiscTrace& trace) {
    if (part.end - part.begin > shortest_look && open_count_ < open_.size()) {
      open_[open_count_++] = part;
    } else {
      trace.doubtful[trace.doubtful_count++] = part;
    }
  }

  const geometry::DistanceField& field_;
  double side_;       // Side of a cell [m].
  double per_metre_;  // Cells in a metre.
  const DiscRows& discs_;
  const PlacedSegment& placed_;
  double one_pace_;
  double slim_pace_;
  bool is_hit_ = false;
  std::size_t open_count_ = 0;
  std::array<Part, DiscTrace::most_looks> open_;
};

/// Sorts the undecided parts and joins neighbours.
void merge_doubtful(DiscTrace& trace) {
  const auto begin = trace.doubtful.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(trace.doubtful_count);
  std::sort(begin, end, [](const Part& a, const Part& b) { return a.begin < b.begin; });
  std::size_t merged = 0;
  for (auto part = begin; part != end; ++part) {
    if (merged > 0 && part->begin <= trace.doubtful[merged - 1].end) {
      trace.doubtful[merged - 1].end = part->end;
    } else {
      trace.doubtful[merged++] = *part;
    }
  }
  trace.doubtful_count = merged;
}

}  // namespace

DiscRows::DiscRows(const Shape& body, double margin) noexcept : one(disc_row(body, margin, 1)) {
  const double slimness = (body.box.front + body.box.rear) / (2 * body.box.half_width);
  slim = disc_row(body, margin, static_cast<int>(std::clamp(std::ceil(slimness), 1.0, most_discs)));
}

DiscTrace trace_discs(const geometry::DistanceField& field, double side, const DiscRows& discs,
                      const PlacedSegment& placed) noexcept {
  DiscTrace trace;
  Tracer(field, side, discs, placed).run(trace);
  merge_doubtful(trace);
  return trace;
}

}  // namespace vandplan::collision
