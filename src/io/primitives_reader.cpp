// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/primitives_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace io {
namespace {

constexpr double grid_rounding = 0.1;  // Largest rounding of a vertex [steps].
constexpr double tolerance = 0.5;      // Largest distance of a pose from its piece [steps].
constexpr double most_steps = 10'000.0;

/// Coordinate of the vertex at the end of the poses, along one axis [steps].
std::int32_t steps_of(double end, double step, int line, const FailAt& fail) {
  const double steps = end / step;
  const double whole = std::round(steps);
  if (!(std::abs(steps) <= most_steps)) {
    fail(line, fmt::format("ends {:g} m away, expected at most {:g} steps", end, most_steps));
  }
  if (std::abs(steps - whole) > grid_rounding) {
    fail(line,
         fmt::format("ends at {:g} m, expected a multiple of the resolution, {:g} m", end, step));
  }
  return static_cast<std::int32_t>(whole);
}

bool turns_on_the_spot(const SampledPrimitive& sampled, double step) {
  const Pose& last = sampled.poses.back();
  return sampled.from != sampled.to && std::hypot(last.x, last.y) < grid_rounding * step;
}

search::Primitive exact(const SampledPrimitive& sampled, const SampledPrimitives& all,
                        const FailAt& fail) {
  const Pose& last = sampled.poses.back();
  search::Primitive primitive{.from = sampled.from, .to = sampled.to};
  primitive.dx = steps_of(last.x, all.step, sampled.line, fail);
  primitive.dy = steps_of(last.y, all.step, sampled.line, fail);
  const auto heading = [&](std::int32_t i) { return all.headings[static_cast<std::size_t>(i)]; };
  const Pose begin{0.0, 0.0, heading(sampled.from)};
  const Pose end{primitive.dx * all.step, primitive.dy * all.step, heading(sampled.to)};
  const std::optional<Piece> piece =
      search::fitted_piece(begin, end, sampled.poses, tolerance * all.step);
  if (!piece) {
    fail(
        sampled.line,
        fmt::format("no arcs and lines of one gear pass its poses within {:g} m, expected a motion "
                    "that can be driven",
                    tolerance * all.step));
  }
  primitive.piece = *piece;
  return primitive;
}

}  // namespace

std::shared_ptr<const search::Primitives> exact(const SampledPrimitives& sampled,
                                                const FailAt& fail) {
  std::vector<search::Primitive> all;
  for (const SampledPrimitive& one : sampled.all) {
    // Only for robots that can turn on the spot.
    if (turns_on_the_spot(one, sampled.step)) continue;
    all.push_back(exact(one, sampled, fail));
    if (!sampled.in_reverse_too) continue;
    const search::Primitive& ahead = all.back();
    all.push_back({ahead.to, ahead.from, -ahead.dx, -ahead.dy, reversed(ahead.piece)});
  }
  try {
    return std::make_shared<const search::Primitives>(sampled.step, sampled.headings,
                                                      std::move(all));
  } catch (const InputError& error) {
    fail(1, error.where() + ": " + error.problem());
    throw;
  }
}

}  // namespace io

std::shared_ptr<const search::Primitives> read_primitives(const std::string& file) {
  if (file.ends_with(".json")) return io::read_nav2_primitives(file);
  if (file.ends_with(".mprim")) return io::read_sbpl_primitives(file);
  throw InputError(file, "is no file of primitives, expected .json (Nav2) or .mprim (SBPL)");
}

}  // namespace vandplan
