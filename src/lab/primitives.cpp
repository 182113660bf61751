// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/graphs.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/derived.h"
#include "vandplan/input_error.h"
#include "vandplan/search.h"

namespace vandplan::search {
namespace {

constexpr std::size_t max_headings = 1024;
constexpr std::int32_t max_steps = 10'000;
constexpr double largest_step = 1e6;  // [m]

void check_headings(const std::vector<double>& headings) {
  if (headings.empty() || headings.size() > max_headings) {
    throw InputError("headings", "are " + std::to_string(headings.size()) + ", expected 1 to " +
                                     std::to_string(max_headings));
  }
  std::vector<double> sorted = headings;
  std::ranges::sort(sorted);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (!std::isfinite(sorted[i])) throw InputError("headings", "are not all finite");
    if (i > 0 && sorted[i] - sorted[i - 1] < Primitives::closing) {
      throw InputError("headings", "are the same twice, expected different ones");
    }
  }
}

void check_primitive(const Primitive& primitive, double step, const std::vector<double>& headings) {
  const auto count = static_cast<std::int32_t>(headings.size());
  const auto is_heading = [&](std::int32_t index) { return index >= 0 && index < count; };
  if (!is_heading(primitive.from) || !is_heading(primitive.to)) {
    throw InputError("", "has a heading that there is not");
  }
  if (std::max(std::abs(primitive.dx), std::abs(primitive.dy)) > max_steps) {
    throw InputError("", "leads further than " + std::to_string(max_steps) + " steps");
  }
  if (primitive.piece.count == 0) throw InputError("", "has no segments");
  const double heading = headings[static_cast<std::size_t>(primitive.from)];
  const Pose end = end_of({0.0, 0.0, heading}, primitive.piece);
  const double off = std::hypot(end.x - primitive.dx * step, end.y - primitive.dy * step);
  const double turn = end.heading - headings[static_cast<std::size_t>(primitive.to)];
  const double far = std::max(1.0, std::hypot(primitive.dx, primitive.dy) * step);
  if (!(off <= Primitives::closing * far) || !(std::abs(wrap_angle(turn)) <= Primitives::closing)) {
    throw InputError("", "does not end at its vertex");
  }
}

}  // namespace

Primitives::Primitives(double step, std::vector<double> headings, std::vector<Primitive> all)
    : step_(step),
      headings_(std::move(headings)),
      all_(std::move(all)),
      derived_(std::make_unique<base::Derived>()) {
  if (!(step > 0.0 && step <= largest_step)) {
    throw InputError("step", "is out of range, expected more than 0 m and at most 1000 km");
  }
  for (double& heading : headings_) heading = wrap_angle(heading);
  check_headings(headings_);
  if (all_.empty()) throw InputError("primitives", "are none, expected one at least");
  for (std::size_t i = 0; i < all_.size(); ++i) {
    try {
      check_primitive(all_[i], step_, headings_);
    } catch (const InputError& error) {
      throw InputError("primitives[" + std::to_string(i) + "]", error.problem());
    }
    longest_ = std::max(longest_, all_[i].piece.length);
    for (const Segment& segment : all_[i].piece.view()) {
      const double end = curvature_at(segment, std::abs(segment.length));
      largest_curvature_ =
          std::max({largest_curvature_, std::abs(segment.curvature), std::abs(end)});
    }
  }
  std::ranges::stable_sort(all_, {}, &Primitive::from);
  for (std::int32_t heading = 0; heading <= static_cast<std::int32_t>(headings_.size());
       ++heading) {
    const auto begin = std::ranges::lower_bound(all_, heading, {}, &Primitive::from);
    first_.push_back(static_cast<std::int32_t>(begin - all_.begin()));
  }
}

Primitives::~Primitives() = default;

}  // namespace vandplan::search
