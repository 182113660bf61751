// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "table_source.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "vandplan/files.h"

namespace vandplan::app {
namespace {

using Json = nlohmann::ordered_json;
using Content = TableFileHead::Content;

/// Name of the thesis' table with these options, such as "hlut-4"; none if there is none.
std::optional<std::string> thesis_name(const HeuristicTableOptions& options) {
  for (int number = 1; number <= 4; ++number) {
    if (thesis_table_options(number) == options) return fmt::format("hlut-{}", number);
  }
  return std::nullopt;
}

}  // namespace

std::optional<int> thesis_number(const std::string& name) {
  for (int number = 1; number <= 4; ++number) {
    if (name == fmt::format("hlut-{}", number)) return number;
  }
  return std::nullopt;
}

TableSource table_source(const std::string& name) {
  TableSource source{name == "-" ? "standard input" : name, {}, {}};
  if (const auto number = thesis_number(name)) {
    source.bytes = table_to_bytes(thesis_table(*number));
  } else {
    source.bytes = name == bounds_name ? bound_table_to_bytes() : read_table_file(name);
  }
  source.head = table_file_head(source.bytes, source.name);
  return source;
}

void add_table_flag(CLI::App& command, std::optional<std::string>& table) {
  command.add_option("--table", table, "Table for estimate=table, see `vandplan table build`")
      ->type_name("FILE");
}

std::shared_ptr<const HeuristicTable> table_of_user(const std::optional<std::string>& table) {
  if (!table) return nullptr;
  const TableSource source = table_source(*table);
  return std::make_shared<const HeuristicTable>(table_from_bytes(source.bytes, source.name));
}

std::string heading_step_text(const HeuristicTableOptions& options) {
  const int half = options.heading_cells / 2;
  if (options.heading_cells % 2 == 0 && half > 1) return fmt::format("pi/{}", half);
  return fmt::format("{:.6g} rad", 2 * std::numbers::pi / options.heading_cells);
}

std::string checksum_text(const TableFileHead& head) {
  return fmt::format("{:016x}", head.checksum);
}

std::string text_of(const TableFileHead& head) {
  std::string text;
  if (head.content == Content::bounds) {
    const auto& [radial, side, turn, bytes] = head.bounds;
    text = fmt::format(
        "bounds of Reeds-Shepp lengths\n"
        "  turning radius  any: made for 1, lengths scale\n"
        "  cells           {} of the distance, {} of the bearing, {} of the turn\n",
        radial, side, turn);
  } else {
    const HeuristicTableOptions& options = head.options;
    const auto name = thesis_name(options);
    text = fmt::format(
        "Reeds-Shepp lengths{}\n"
        "  turning radius  {} m\n"
        "  x and y         0 to {} m in steps of {} m: {} positions each\n"
        "  both headings   -pi to pi in steps of {}: {} each\n",
        name ? fmt::format(", the thesis' {}", *name) : "", options.turning_radius, options.extent,
        options.step, std::lround(options.extent / options.step) + 1, heading_step_text(options),
        options.heading_cells + 1);
  }
  return text + fmt::format(
                    "  entries         {}\n"
                    "  file            {} bytes, little-endian, checksum {}\n",
                    head.entries, head.bytes, checksum_text(head));
}

Json json_of(const TableFileHead& head) {
  Json json;
  if (head.content == Content::bounds) {
    json["content"] = "bounds of Reeds-Shepp lengths";
    json["turning_radius"] = 1.0;
    json["cells"] = {{"radial", head.bounds.radial_cells},
                     {"side", head.bounds.side_cells},
                     {"turn", head.bounds.turn_cells}};
  } else {
    const HeuristicTableOptions& options = head.options;
    json["content"] = "Reeds-Shepp lengths";
    const auto name = thesis_name(options);
    json["thesis_table"] = name ? Json(*name) : Json();
    json["turning_radius"] = options.turning_radius;
    json["extent"] = options.extent;
    json["step"] = options.step;
    json["positions"] = static_cast<int>(std::lround(options.extent / options.step)) + 1;
    json["heading_cells"] = options.heading_cells;
    json["headings"] = options.heading_cells + 1;
  }
  json["entries"] = head.entries;
  json["bytes"] = head.bytes;
  json["checksum"] = checksum_text(head);
  return json;
}

}  // namespace vandplan::app
