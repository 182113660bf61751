// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/tables.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "base/text.h"
#include "tables/table_bytes.h"
#include "tables/table_options.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

namespace table_bytes = tables::table_bytes;

using table_bytes::Head;

static_assert(table_file_head_size == table_bytes::head_size);

/// Options of a table of lengths. Throws InputError naming `file` for numbers out of range.
HeuristicTableOptions options_of(const Head& head, const std::string& file) {
  const auto [radius, extent, step, heading_cells] = head.parameters;
  const HeuristicTableOptions options{
      .extent = std::bit_cast<double>(extent),
      .step = std::bit_cast<double>(step),
      .heading_cells = static_cast<int>(std::min<std::uint64_t>(heading_cells, 1U << 30)),
      .turning_radius = std::bit_cast<double>(radius)};
  std::size_t expected = 0;
  try {
    expected = tables::checked_entries(options);
  } catch (const InputError& error) {
    throw InputError(file, error.what());
  }
  if (head.count != expected) {
    throw InputError(file, "entries: " + std::to_string(head.count) +
                               " are there, the options ask for " + std::to_string(expected));
  }
  return options;
}

/// Dimensions of a table of bounds. Throws InputError naming `file` for numbers out of range.
BoundTableInfo bounds_of(const Head& head, const std::string& file) {
  const auto require = [&file](bool holds, const char* where, const std::string& given,
                               const char* expected) {
    if (holds) return;
    throw InputError(file, std::string(where) + ": is " + given + ", expected " + expected);
  };
  const auto length = [&](std::size_t at) { return std::bit_cast<double>(head.parameters[at]); };
  const auto part = [&](int at) { return static_cast<int>(head.parameters[3] >> at & 0xFFFFU); };
  const double radius = length(0), reach = length(1), unit = length(2);
  require(radius == 1.0, "turning_radius", base::shortest_text(radius), "1");
  require(reach >= 1e-6 && reach <= 1e6, "reach", base::shortest_text(reach),
          "0.000001 to 1000000");
  require(unit > 0.0 && unit <= 1.0, "unit", base::shortest_text(unit), "more than 0, at most 1");
  const BoundTableInfo info{part(0), part(16), part(32),
                            static_cast<std::size_t>(head.count * head.kind->entry_size)};
  const auto cells = static_cast<std::uint64_t>(info.radial_cells) *
                     static_cast<std::uint64_t>(info.side_cells) *
                     static_cast<std::uint64_t>(info.turn_cells);
  require(part(48) >= 1, "slope_step", std::to_string(part(48)), "at least 1");
  require(cells == head.count && cells > 0, "entries", std::to_string(head.count),
          "one for each cell");
  return info;
}

}  // namespace

std::string table_to_bytes(const HeuristicTable& table) {
  const HeuristicTableOptions& options = table.options();
  std::string bytes =
      table_bytes::start_of({.kind = &table_bytes::lengths,
                             .parameters = {std::bit_cast<std::uint64_t>(options.turning_radius),
                                            std::bit_cast<std::uint64_t>(options.extent),
                                            std::bit_cast<std::uint64_t>(options.step),
                                            static_cast<std::uint64_t>(options.heading_cells)},
                             .count = table.entries().size()});
  bytes.reserve(bytes.size() + table.entries().size_bytes());
  for (const float entry : table.entries()) {
    table_bytes::append(bytes, std::bit_cast<std::uint32_t>(entry));
  }
  table_bytes::seal(bytes);
  return bytes;
}

HeuristicTable table_from_bytes(std::string_view bytes, const std::string& file) {
  const Head head = table_bytes::checked_head(bytes, file);
  if (head.kind != &table_bytes::lengths) {
    throw InputError(file, "holds bounds of lengths, expected lengths");
  }
  const HeuristicTableOptions options = options_of(head, file);
  std::vector<float> entries(static_cast<std::size_t>(head.count));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto word = table_bytes::read_at<std::uint32_t>(bytes, table_bytes::head_size + 4 * i);
    entries[i] = std::bit_cast<float>(word);
    if (entries[i] >= 0.0F && std::isfinite(entries[i])) continue;
    throw InputError(file, "entries[" + std::to_string(i) + "]: is " +
                               base::shortest_text(entries[i]) + ", expected a length");
  }
  return {options, std::move(entries)};
}

TableFileHead table_file_head(std::string_view start, const std::string& file) {
  const Head head = table_bytes::head_of(start, file);
  TableFileHead result;
  result.entries = head.count;
  result.bytes = table_bytes::head_size + head.count * head.kind->entry_size;
  result.checksum = head.checksum;
  if (head.kind == &table_bytes::bounds) {
    result.content = TableFileHead::Content::bounds;
    result.bounds = bounds_of(head, file);
  } else {
    result.options = options_of(head, file);
  }
  return result;
}

void check_table_file(std::string_view bytes, const std::string& file) {
  (void)table_bytes::checked_head(bytes, file);
}

}  // namespace vandplan
