// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "io/document.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan::io {

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

XmlFile::XmlFile(const std::string& file, const char* root, const std::string& expected)
    : file_(file == "-" ? "standard input" : file) {
  const std::string text = read_file(file, largest_text);
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
    line_ends_.push_back(static_cast<std::ptrdiff_t>(at));
  }
  constexpr std::ptrdiff_t most = 2 * most_values;  // An element takes 56 bytes, an attribute 40.
  if (std::count_if(text.begin(), text.end(), [](char c) { return c == '<' || c == '='; }) > most) {
    throw InputError(file_, fmt::format("has more than {} signs < and =, expected no more", most));
  }
  const pugi::xml_parse_result parsed = document_.load_buffer(text.data(), text.size());
  if (!parsed) {
    throw InputError(line_at(parsed.offset),
                     fmt::format("is no XML ({}), expected {}", parsed.description(), expected));
  }
  root_ = document_.document_element();
  if (std::string_view(root_.name()) != root) {
    fail(root_, fmt::format("is the root, expected {} with the root {}", expected, root));
  }
}

std::string XmlFile::stem() const {
  return file_ == "standard input" ? "site" : std::filesystem::path(file_).stem().string();
}

XmlNode XmlFile::child(const XmlNode& node, const char* name) const {
  const XmlNode found = node.child(name);
  if (!found) fail(node, fmt::format("has no {}, expected one", name));
  return found;
}

std::string XmlFile::text(const XmlNode& node, const char* attribute) const {
  const pugi::xml_attribute found = node.attribute(attribute);
  if (!found) fail(node, fmt::format("has no attribute {}, expected one", attribute));
  return found.value();
}

double XmlFile::number(const XmlNode& node, const char* attribute) const {
  return number_from(node, fmt::format("has {} ", attribute), text(node, attribute));
}

double XmlFile::number_or(const XmlNode& node, const char* attribute, double otherwise) const {
  return node.attribute(attribute) ? number(node, attribute) : otherwise;
}

double XmlFile::number_in(const XmlNode& node) const {
  return number_from(node, "is ", node.text().get());
}

double XmlFile::number_from(const XmlNode& node, const std::string& what,
                            std::string_view text) const {
  const std::string_view digits = without_blanks(text);
  const std::string_view number = digits.starts_with('+') ? digits.substr(1) : digits;
  double value = 0.0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc() || end != number.data() + number.size() || !std::isfinite(value)) {
    fail(node, fmt::format("{}\"{}\", expected a number", what, digits.substr(0, 40)));
  }
  return value;
}

std::string XmlFile::line_at(std::ptrdiff_t offset) const {
  const auto ends_before = std::lower_bound(line_ends_.begin(), line_ends_.end(), offset);
  return fmt::format("{}:{}", file_, ends_before - line_ends_.begin() + 1);
}

std::string XmlFile::place_of(const XmlNode& node) const { return line_at(node.offset_debug()); }

void XmlFile::fail(const XmlNode& node, const std::string& problem) const {
  throw InputError(place_of(node), fmt::format("{}: {}", node.name(), problem));
}

std::string_view tag(const XmlNode& node, std::string_view key) {
  for (const XmlNode child : node.children("tag")) {
    if (child.attribute("k").value() == key) return child.attribute("v").value();
  }
  return {};
}

}  // namespace vandplan::io
