// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/tables.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/require.h"
#include "base/text.h"
#include "geometry/pose_columns.h"
#include "simd/table_kernels.h"
#include "tables/table_options.h"
#include "vandplan/input_error.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double most_entries = 0x1p28;  // 1 GiB of floats; an index fits in 32 bits

// Throws InputError unless a length is 1e-6 to 1e6 m. Quotients of two such lengths fit a float.
void require_length(const char* where, double given) {
  base::require(given > 0.0, where, given, "more than 0 m");
  base::require(given >= 1e-6 && given <= 1e6, where, given, "0.000001 to 1000000 m");
}

// Number of grid points along x, equal to that along y. Throws InputError if an option is out of
// range.
int checked_positions(const HeuristicTableOptions& options) {
  const auto& [extent, step, heading_cells, radius] = options;
  require_length("extent", extent);
  require_length("step", step);
  base::require(heading_cells >= 1, "heading_cells", heading_cells, "at least 1");
  require_length("turning_radius", radius);
  const double cells = std::round(extent / step);
  base::require(cells >= 1.0 && std::abs(cells * step - extent) <= 1e-9 * extent, "extent", extent,
                "a multiple of the step");
  const double plane = (cells + 1.0) * (heading_cells + 1.0);
  if (plane * plane > most_entries) {
    throw InputError("step", "the table would hold " + base::shortest_text(plane * plane) +
                                 " entries, expected at most " + base::shortest_text(most_entries));
  }
  return static_cast<int>(cells) + 1;
}

std::size_t entry_count(int positions, int headings) {
  const auto plane = static_cast<std::size_t>(positions) * static_cast<std::size_t>(headings);
  return plane * plane;
}

double heading_at(int index, int heading_cells) { return -pi + 2 * pi * index / heading_cells; }

simd::TableView view_of(const HeuristicTable& table, double radius) {
  const HeuristicTableOptions& options = table.options();
  return {.entries = table.entries().data(),
          .positions = table.positions(),
          .headings = table.headings(),
          .extent = static_cast<float>(options.extent),
          .cells_per_metre = static_cast<float>(1.0 / options.step),
          .cells_per_radian = static_cast<float>(options.heading_cells / (2 * pi)),
          .to_table = static_cast<float>(options.turning_radius / radius),
          .from_table = static_cast<float>(radius / options.turning_radius)};
}

}  // namespace

std::size_t tables::checked_entries(const HeuristicTableOptions& options) {
  return entry_count(checked_positions(options), options.heading_cells + 1);
}

HeuristicTableOptions thesis_table_options(int number) {
  static constexpr std::array<HeuristicTableOptions, 4> tables{{
      {.extent = 10.0, .step = 1.0, .heading_cells = 8, .turning_radius = 7.0},
      {.extent = 20.0, .step = 1.0, .heading_cells = 8, .turning_radius = 7.0},
      {.extent = 10.0, .step = 1.0, .heading_cells = 24, .turning_radius = 7.0},
      {.extent = 30.0, .step = 1.0, .heading_cells = 24, .turning_radius = 7.0},
  }};
  base::require(number >= 1 && number <= 4, "number", number, "1 to 4");
  return tables[static_cast<std::size_t>(number) - 1];
}

// NOLINTNEXTLINE(readability-function-size): a loop for each coordinate
HeuristicTable::HeuristicTable(const HeuristicTableOptions& options)
    : options_(options), positions_(checked_positions(options)) {
  std::vector<float> entries(entry_count(positions(), headings()));
  const double radius = options.turning_radius;
  for (int x = 0; x < positions(); ++x) {
    for (int y = 0; y < positions(); ++y) {
      for (int node = 0; node < headings(); ++node) {
        const Pose from = node_of({x, y, node, 0});
        for (int sample = 0; sample < headings(); ++sample) {
          const GridPoint point{x, y, node, sample};
          entries[index_of(point)] =
              static_cast<float>(reeds_shepp_length(from, sample_of(point), radius));
        }
      }
    }
  }
  storage_ = std::make_shared<const std::vector<float>>(std::move(entries));
  entries_ = *storage_;
}

HeuristicTable::HeuristicTable(const HeuristicTableOptions& options, std::vector<float> entries)
    : HeuristicTable(options, std::span<const float>(entries)) {
  storage_ = std::make_shared<const std::vector<float>>(std::move(entries));
  entries_ = *storage_;
}

HeuristicTable::HeuristicTable(const HeuristicTableOptions& options, std::span<const float> entries)
    : options_(options), positions_(checked_positions(options)), entries_(entries) {
  const std::size_t expected = entry_count(positions(), headings());
  if (entries.size() != expected) {
    throw InputError("entries", std::to_string(entries.size()) + " given, the options ask for " +
                                    std::to_string(expected));
  }
}

std::size_t HeuristicTable::index_of(const GridPoint& point) const noexcept {
  const int index = simd::table_index({positions(), headings()},
                                      {point.x, point.y, point.heading_node, point.heading_sample});
  return static_cast<std::size_t>(index);
}

Pose HeuristicTable::node_of(const GridPoint& point) const noexcept {
  return {point.x * options_.step, point.y * options_.step,
          heading_at(point.heading_node, options_.heading_cells)};
}

Pose HeuristicTable::sample_of(const GridPoint& point) const noexcept {
  return {0.0, 0.0, heading_at(point.heading_sample, options_.heading_cells)};
}

double HeuristicTable::distance(const Pose& node, const Pose& sample, double radius) const {
  base::require_radius(radius);
  // The difference is taken in double, so that poses may be far from the origin.
  return static_cast<double>(simd::table_distance(
      view_of(*this, radius), static_cast<float>(node.x - sample.x),
      static_cast<float>(node.y - sample.y), static_cast<float>(wrap_angle(node.heading)),
      static_cast<float>(wrap_angle(sample.heading))));
}

void HeuristicTable::distances(const PoseColumns& nodes, const Pose& sample, double radius,
                               std::span<float> out) const {
  base::require_radius(radius);
  geometry::expect_columns(nodes, out.size());
  const simd::TableSample to{static_cast<float>(sample.x), static_cast<float>(sample.y),
                             static_cast<float>(wrap_angle(sample.heading))};
  simd::table_distances(view_of(*this, radius), nodes.x, nodes.y, nodes.heading, to, out);
}

}  // namespace vandplan
