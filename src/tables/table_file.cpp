// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/table_file.h"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "tables/table_bytes.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

namespace table_bytes = tables::table_bytes;

using table_bytes::Head;

static_assert(table_file_head_size == table_bytes::head_size);

HeuristicTableOptions options_of(const Head& head) {
  const auto [radius, extent, step, heading_cells] = head.parameters;
  return {.extent = std::bit_cast<double>(extent),
          .step = std::bit_cast<double>(step),
          .heading_cells = static_cast<int>(std::min<std::uint64_t>(heading_cells, 1U << 30)),
          .turning_radius = std::bit_cast<double>(radius)};
}

BoundTableInfo bounds_of(const Head& head) {
  const auto cells = [&](int at) { return static_cast<int>(head.parameters[3] >> at & 0xFFFFU); };
  return {cells(0), cells(16), cells(32), head.count * head.kind->entry_size};
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
  std::vector<float> entries(head.count);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto word = table_bytes::read_at<std::uint32_t>(bytes, table_bytes::head_size + 4 * i);
    entries[i] = std::bit_cast<float>(word);
  }
  try {
    return {options_of(head), std::move(entries)};
  } catch (const InputError& error) {
    throw InputError(file, error.what());
  }
}

TableFileHead table_file_head(std::string_view start, const std::string& file) {
  const Head head = table_bytes::head_of(start, file);
  TableFileHead result;
  result.entries = head.count;
  result.bytes = table_bytes::head_size + head.count * head.kind->entry_size;
  result.checksum = head.checksum;
  if (head.kind == &table_bytes::bounds) {
    result.content = TableFileHead::Content::bounds;
    result.bounds = bounds_of(head);
  } else {
    result.options = options_of(head);
  }
  return result;
}

void check_table_file(std::string_view bytes, const std::string& file) {
  (void)table_bytes::checked_head(bytes, file);
}

}  // namespace vandplan
