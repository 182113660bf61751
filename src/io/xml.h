// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which elements does an XML file contain, and on which lines?

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace vandplan::io {

using XmlNode = pugi::xml_node;

/// An XML file. A query for a missing or wrong value throws an InputError "file:line: element: what
/// is wrong, what was expected".
class XmlFile {
 public:
  /// Reads the file; "-" is standard input. Throws InputError unless it is XML with this root
  /// element. `expected`: what the file should be, "a map of Lanelet2".
  XmlFile(const std::string& file, const char* root, const std::string& expected);

  [[nodiscard]] XmlNode root() const { return root_; }
  /// Name of the file without folder and ending; "site" for standard input.
  [[nodiscard]] std::string stem() const;

  /// First child with that name. Throws if there is none.
  [[nodiscard]] XmlNode child(const XmlNode& node, const char* name) const;
  /// Text of an attribute. Throws if there is none.
  [[nodiscard]] std::string text(const XmlNode& node, const char* attribute) const;
  /// Attribute as a finite number. Throws if there is none.
  [[nodiscard]] double number(const XmlNode& node, const char* attribute) const;
  /// Attribute as a finite number; `otherwise` if there is none.
  [[nodiscard]] double number_or(const XmlNode& node, const char* attribute,
                                 double otherwise) const;
  /// Text within the element as a finite number.
  [[nodiscard]] double number_in(const XmlNode& node) const;

  /// File and line at which the element begins: "map.osm:12".
  [[nodiscard]] std::string place_of(const XmlNode& node) const;
  /// Text as a finite number; `what` introduces it in errors.
  [[nodiscard]] double number_from(const XmlNode& node, const std::string& what,
                                   std::string_view text) const;
  /// Throws an InputError that names the element.
  [[noreturn]] void fail(const XmlNode& node, const std::string& problem) const;

 private:
  [[nodiscard]] std::string line_at(std::ptrdiff_t offset) const;

  std::string file_;
  std::vector<std::ptrdiff_t> line_ends_;  // Offsets of line ends in the file.
  pugi::xml_document document_;
  XmlNode root_;
};

/// Whether a word is one of a list.
[[nodiscard]] inline bool is_any_of(std::string_view word,
                                    std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Text without blanks around it.
[[nodiscard]] std::string_view without_blanks(std::string_view text);

/// Value of a tag `<tag k="key" v="value"/>`, as OpenStreetMap has them; empty if there is none.
[[nodiscard]] std::string_view tag(const XmlNode& node, std::string_view key);

}  // namespace vandplan::io
