// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/table_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <utility>
#include <vector>

#include "decimal.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

constexpr std::string_view magic = "vp-table";
constexpr std::uint32_t byte_order = 0x01020304;
constexpr std::uint32_t swapped_byte_order = 0x04030201;
constexpr std::uint32_t version = 1;
constexpr std::string_view content = "reeds-shepp-4d  ";
constexpr std::string_view units = "metre radian    ";
constexpr std::size_t checksum_at = 88;
constexpr std::size_t entries_at = 96;

template <class Unsigned>
void append(std::string& bytes, Unsigned value) {
  for (std::size_t i = 0; i < sizeof value; ++i) {
    bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFFU));
  }
}

template <class Unsigned>
Unsigned read_at(std::string_view bytes, std::size_t at) {
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof value; ++i) {
    value |= static_cast<Unsigned>(static_cast<Unsigned>(static_cast<unsigned char>(bytes[at + i]))
                                   << (8 * i));
  }
  return value;
}

double double_at(std::string_view bytes, std::size_t at) {
  return std::bit_cast<double>(read_at<std::uint64_t>(bytes, at));
}

// FNV-1a: every step is a bijection of the state, so a single altered byte never goes unseen.
std::uint64_t hash(std::uint64_t state, std::string_view bytes) noexcept {
  for (const char c : bytes) state = (state ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return state;
}

std::string quoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result.push_back(c >= ' ' && c <= '~' ? c : '?');
  return result + "'";
}

// Everything but the checksum; throws InputError for a header that is not ours.
void check_header(std::string_view bytes, const std::string& file) {
  const auto refuse = [&file](const std::string& problem) { throw InputError(file, problem); };
  if (!bytes.starts_with(magic)) refuse("not a table file: does not start with 'vp-table'");
  if (bytes.size() < entries_at) {
    refuse("truncated: " + std::to_string(bytes.size()) + " bytes, the header alone has " +
           std::to_string(entries_at));
  }
  const auto order = read_at<std::uint32_t>(bytes, 8);
  if (order == swapped_byte_order) refuse("big-endian, only little-endian files are read");
  if (order != byte_order) refuse("altered: the byte order mark is not one");
  if (const auto found = read_at<std::uint32_t>(bytes, 12); found != version) {
    refuse("version " + std::to_string(found) + " of the format, this program reads version " +
           std::to_string(version));
  }
  if (bytes.substr(16, 16) != content) {
    refuse("holds " + quoted(bytes.substr(16, 16)) + ", expected " + quoted(content));
  }
  if (bytes.substr(32, 16) != units) {
    refuse("units are " + quoted(bytes.substr(32, 16)) + ", expected " + quoted(units));
  }
}

void append_hex_float(std::string& text, float value) {
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::hex)
          .ptr;
  text.append("0x").append(buffer.data(), end).append("F");
}

bool is_identifier(std::string_view name) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return !name.empty() && is_letter(name[0]) &&
         std::ranges::all_of(name, [&](char c) { return is_letter(c) || is_digit(c); });
}

}  // namespace

std::string table_to_bytes(const HeuristicTable& table) {
  const HeuristicTableOptions& options = table.options();
  std::string bytes(magic);
  bytes.reserve(entries_at + table.entries().size_bytes());
  append(bytes, byte_order);
  append(bytes, version);
  bytes.append(content).append(units);
  append(bytes, std::bit_cast<std::uint64_t>(options.turning_radius));
  append(bytes, std::bit_cast<std::uint64_t>(options.extent));
  append(bytes, std::bit_cast<std::uint64_t>(options.step));
  append(bytes, static_cast<std::uint64_t>(options.heading_cells));
  append(bytes, static_cast<std::uint64_t>(table.entries().size()));
  append(bytes, std::uint64_t{0});  // the checksum
  for (const float entry : table.entries()) append(bytes, std::bit_cast<std::uint32_t>(entry));
  std::string checksum;
  append(checksum, table_checksum(bytes));
  bytes.replace(checksum_at, checksum.size(), checksum);
  return bytes;
}

std::uint64_t table_checksum(std::string_view bytes) noexcept {
  constexpr std::uint64_t start = 0xcbf29ce484222325U;
  const std::uint64_t head = hash(start, bytes.substr(0, checksum_at));
  return bytes.size() <= entries_at ? head : hash(head, bytes.substr(entries_at));
}

HeuristicTable table_from_bytes(std::string_view bytes, const std::string& file) {
  check_header(bytes, file);
  const auto count = read_at<std::uint64_t>(bytes, 80);
  const std::size_t held = (bytes.size() - entries_at) / sizeof(float);
  if (count > held || bytes.size() != entries_at + count * sizeof(float)) {
    throw InputError(file, (count > held ? "truncated: " : "longer than it says: ") +
                               std::to_string(bytes.size()) + " bytes, expected " +
                               std::to_string(entries_at) + " + 4 * " + std::to_string(count));
  }
  if (read_at<std::uint64_t>(bytes, checksum_at) != table_checksum(bytes)) {
    throw InputError(file, "altered: the checksum does not fit the content");
  }
  const auto heading_cells = read_at<std::uint64_t>(bytes, 72);
  const HeuristicTableOptions options{
      .extent = double_at(bytes, 56),
      .step = double_at(bytes, 64),
      .heading_cells = static_cast<int>(std::min<std::uint64_t>(heading_cells, 1U << 30)),
      .turning_radius = double_at(bytes, 48)};
  std::vector<float> entries(count);
  for (std::size_t i = 0; i < count; ++i) {
    entries[i] = std::bit_cast<float>(read_at<std::uint32_t>(bytes, entries_at + 4 * i));
  }
  try {
    return {options, std::move(entries)};
  } catch (const InputError& error) {
    throw InputError(file, error.what());
  }
}

std::string table_to_header(const HeuristicTable& table, std::string_view name) {
  if (!is_identifier(name)) throw InputError("name", quoted(name) + " is not a C++ identifier");
  const HeuristicTableOptions& options = table.options();
  std::string text =
      "// Reeds-Shepp lengths [m], written by vandplan. Row-major\n"
      "// entries[ix][iy][i_heading_node][i_heading_sample]: from a node at (ix, iy) * step to a\n"
      "// sample at the origin, headings from -pi to pi.\n"
      "#pragma once\n\nnamespace ";
  text.append(name).append(" {\n\n");
  const auto constant = [&text](std::string_view type, std::string_view what, double value) {
    text.append("inline constexpr ").append(type).append(" ").append(what).append(" = ");
    text.append(shortest_text(value)).append(";\n");
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

}  // namespace vandplan
