// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "tables/table_export.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <vector>

#include "base/text.h"
#include "vandplan/input_error.h"

namespace vandplan::tables {
namespace {

constexpr std::size_t most_entries = std::size_t{1} << 24;  // More would overload a compiler.

void check_size(const HeuristicTable& table) {
  if (table.entries().size() <= most_entries) return;
  throw InputError("export", std::to_string(table.entries().size()) + " entries, as text at most " +
                                 std::to_string(most_entries));
}

void append_hex_float(std::string& text, float value) {
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::hex)
          .ptr;
  text.append("0x").append(buffer.data(), end).append("F");
}

}  // namespace

void check_identifier(std::string_view name) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (!name.empty() && is_letter(name[0]) &&
      std::ranges::all_of(name, [&](char c) { return is_letter(c) || is_digit(c); })) {
    return;
  }
  throw InputError("name", "\"" + std::string(name) + "\" is not a C++ identifier");
}

std::string table_to_header(const HeuristicTable& table, std::string_view name) {
  check_identifier(name);
  check_size(table);
  const HeuristicTableOptions& options = table.options();
  std::string text =
      "// Reeds-Shepp lengths [m], written by vandplan. Row-major\n"
      "// entries[ix][iy][i_heading_node][i_heading_sample]: from a node at (ix, iy) * step to a\n"
      "// sample at the origin, headings from -pi to pi.\n"
      "#pragma once\n\nnamespace ";
  text.append(name).append(" {\n\n");
  const auto constant = [&text](std::string_view type, std::string_view what, double value) {
    text.append("inline constexpr ").append(type).append(" ").append(what).append(" = ");
    text.append(base::shortest_text(value)).append(";\n");
  };
  constant("double", "turning_radius", options.turning_radius);
  constant("double", "extent", options.extent);
  constant("double", "step", options.step);
  constant("int", "heading_cells", options.heading_cells);
  constant("int", "positions", table.positions());
  constant("int", "headings", table.headings());
  text.append("\ninline constexpr float entries[] = {");
  for (std::size_t i = 0; i < table.entries().size(); ++i) {
    text.append(i % 6 == 0 ? "\n    " : " ");
    append_hex_float(text, table.entries()[i]);
    text.push_back(',');
  }
  return text.append("\n};\n\n}  // namespace ").append(name).append("\n");
}

// NOLINTNEXTLINE(readability-function-size): a loop for each coordinate
std::string table_to_csv(const HeuristicTable& table) {
  check_size(table);
  std::vector<std::string> positions, headings;
  for (int i = 0; i < table.positions(); ++i) {
    positions.push_back(base::shortest_text(table.node_of({i, 0, 0, 0}).x) + ",");
  }
  for (int i = 0; i < table.headings(); ++i) {
    headings.push_back(base::shortest_text(table.node_of({0, 0, i, 0}).heading) + ",");
  }
  std::string text = "x,y,heading_node,heading_sample,length\n";
  auto entry = table.entries().begin();  // row-major
  for (const std::string& x : positions) {
    for (const std::string& y : positions) {
      for (const std::string& node : headings) {
        for (const std::string& sample : headings) {
          text.append(x).append(y).append(node).append(sample);
          text.append(base::shortest_text(*entry++));
          text.push_back('\n');
        }
      }
    }
  }
  return text;
}

}  // namespace vandplan::tables
