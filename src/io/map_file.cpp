// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a map of ROS' map_server read? (docs/formats.md)
//
// The rules are those of http://wiki.ros.org/map_server (ROS 1) and of nav2_map_server's map_io.cpp
// (ROS 2). Where they differ, a comment states the choice.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <span>
#include <utility>

#include "io/document.h"
#include "io/image_file.h"
#include "io/map_file.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/problem.h"

namespace vandplan {
namespace {

using namespace io;

enum class Mode { trinary, scale, raw };

/// Rule that turns the brightness of a pixel into a cell.
struct Rule {
  Mode mode = Mode::trinary;
  bool negate = false;
  double occupied_thresh = 0.0;
  double free_thresh = 0.0;
};

std::string lower(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

Mode mode_from(const Document& file, const Node& node) {
  const std::string text = lower(file.text(node));
  if (text == "trinary") return Mode::trinary;
  if (text == "scale") return Mode::scale;
  if (text == "raw") return Mode::raw;
  file.fail(node, "is \"" + file.text(node).substr(0, 40) + "\", expected trinary, scale or raw");
}

/// A flag: 0, 1 or a boolean word of YAML.
bool flag_from(const Document& file, const Node& node) {
  constexpr std::array<const char*, 5> no = {"0", "false", "no", "off", "n"};
  constexpr std::array<const char*, 5> yes = {"1", "true", "yes", "on", "y"};
  const std::string text = lower(file.text(node));
  if (std::find(no.begin(), no.end(), text) != no.end()) return false;
  if (std::find(yes.begin(), yes.end(), text) != yes.end()) return true;
  file.fail(node, "is \"" + file.text(node).substr(0, 40) + "\", expected 0 or 1");
}

double threshold_from(const Document& file, const Node& node) {
  const double value = file.number(node);
  if (value < 0 || value > 1) file.fail(node, fmt::format("is {}, expected 0 to 1", value));
  return value;
}

Rule rule_from(const Document& file) {
  const Node& root = file.root();
  Rule rule;
  if (const Node* const mode = file.find(root, "mode")) rule.mode = mode_from(file, *mode);
  rule.negate = flag_from(file, file.at(root, "negate"));
  rule.occupied_thresh = threshold_from(file, file.at(root, "occupied_thresh"));
  rule.free_thresh = threshold_from(file, file.at(root, "free_thresh"));
  if (rule.free_thresh > rule.occupied_thresh) {
    file.fail(file.at(root, "free_thresh"),
              fmt::format("is {}, expected no more than occupied_thresh", rule.free_thresh));
  }
  return rule;
}

/// Cell of an occupancy. The thresholds belong to neither side, as in ROS 1 and nav2 before 2025.
Cell cell_between(const Rule& rule, double occupancy) {
  if (occupancy > rule.occupied_thresh) return Cell::occupied;
  return occupancy < rule.free_thresh ? Cell::free : Cell::unknown;
}

std::uint32_t darkness_of(const Rule& rule, std::uint32_t brightness, std::uint32_t white) {
  return rule.negate ? brightness : white - brightness;
}

/// Cell of a brightness between 0 and `white`. Values between the thresholds, which map_server
/// grades in mode `scale`, are unknown.
Cell cell_of(const Rule& rule, std::uint32_t brightness, std::uint32_t white) {
  if (rule.mode == Mode::raw) {  // Without regard to `negate`, as in nav2.
    const double percent = std::round(255.0 * brightness / white);
    return percent > 100 ? Cell::unknown : cell_between(rule, percent / 100);
  }
  // A single division, so that 51 of 255 is not below a threshold of 0.2.
  const std::uint32_t part = darkness_of(rule, brightness, white);
  return cell_between(rule, static_cast<double>(part) / white);
}

/// Occupancy of a brightness in percent, as nav2_map_server publishes it.
std::uint8_t percent_of(const Rule& rule, std::uint32_t brightness, std::uint32_t white) {
  if (rule.mode == Mode::raw) {
    const double percent = std::round(255.0 * brightness / white);
    return percent > 100 ? Mask::unknown : static_cast<std::uint8_t>(percent);
  }
  const Cell cell = cell_of(rule, brightness, white);
  if (cell == Cell::free) return 0;
  if (cell == Cell::occupied) return 100;
  if (rule.mode == Mode::trinary) return Mask::unknown;
  const double share =
      static_cast<double>(darkness_of(rule, brightness, white)) / white - rule.free_thresh;
  const double all = rule.occupied_thresh - rule.free_thresh;
  return all > 0 ? static_cast<std::uint8_t>(std::rint(100 * share / all)) : 0;
}

/// Cells of an image, filled as its rows arrive: the top row first, which has the largest y.
struct Cells {
  std::int32_t columns = 0;
  std::int32_t rows = 0;
  std::vector<Cell> cells;
  std::size_t missing = 0;  // Number of cells, from the first on, that have not arrived yet.
  bool has_grey = false;  // Whether a pixel has the grey that map_saver writes for unknown ground.
  // Cell and occupancy of each brightness, since pixels are many and brightnesses few.
  std::vector<Cell> cell_of_brightness;
  std::vector<std::uint8_t> percent_of_brightness;
  std::vector<std::uint8_t>* percents = nullptr;  // of all cells; filled if not null

  void take(const Rule& rule, const io::ImageShape& shape,
            std::span<const std::uint32_t> brightness) {
    if (cell_of_brightness.empty()) {
      columns = shape.columns;
      rows = shape.rows;
      for (std::uint32_t i = 0; i <= shape.white; ++i) {
        cell_of_brightness.push_back(cell_of(rule, i, shape.white));
        percent_of_brightness.push_back(percent_of(rule, i, shape.white));
      }
      missing = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
      cells.resize(missing);
      if (percents != nullptr) percents->resize(missing);
    }
    missing -= brightness.size();
    if (shape.white == 255 && !has_grey) has_grey = std::ranges::count(brightness, 205U) > 0;
    std::ranges::transform(
        brightness, cells.begin() + static_cast<std::ptrdiff_t>(missing), [&](std::uint32_t pixel) {
          return pixel == io::transparent_pixel ? Cell::unknown : cell_of_brightness[pixel];
        });
    if (percents == nullptr) return;
    std::ranges::transform(brightness, percents->begin() + static_cast<std::ptrdiff_t>(missing),
                           [&](std::uint32_t pixel) {
                             return pixel == io::transparent_pixel ? Mask::unknown
                                                                   : percent_of_brightness[pixel];
                           });
  }
};

Cells cells_from(const Document& file, const std::string& map, const Rule& rule,
                 std::vector<std::uint8_t>* percents) {
  const Node& node = file.at(file.root(), "image");
  if (file.text(node).empty()) file.fail(node, "is empty, expected the name of a PGM or PNG image");
  const std::filesystem::path path = std::filesystem::path(map).parent_path() / file.text(node);
  const io::Alpha alpha = rule.mode == Mode::raw ? io::Alpha::ignored : io::Alpha::marked;
  Cells cells;
  cells.percents = percents;
  try {
    io::FileReader image(path.string());
    io::read_image(image, alpha,
                   [&](const io::ImageShape& shape, std::span<const std::uint32_t> brightness) {
                     cells.take(rule, shape, brightness);
                   });
  } catch (const InputError& error) {
    file.fail(node, error.what());
  }
  return cells;
}

}  // namespace

std::string map_to_pgm(const OccupancyGrid& grid) {
  check_map(grid);
  std::string text = fmt::format("P5\n{} {}\n255\n", grid.columns, grid.rows);
  text.reserve(text.size() + grid.cells->size());
  for (std::int32_t row = grid.rows; row-- > 0;) {
    for (std::int32_t column = 0; column < grid.columns; ++column) {
      const std::size_t at =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
          static_cast<std::size_t>(column);
      const Cell cell = (*grid.cells)[at];
      const int brightness = cell == Cell::free ? 254 : cell == Cell::occupied ? 0 : 205;
      text += static_cast<char>(brightness);
    }
  }
  return text;
}

std::string map_to_yaml(const OccupancyGrid& grid, const std::string& image) {
  return fmt::format(
      "image: \"{}\"\nresolution: {}\norigin: [{}, {}, {}]\nnegate: 0\noccupied_thresh: 0.65\n"
      "free_thresh: 0.196\nmode: trinary\n",
      image, grid.resolution, grid.origin.x, grid.origin.y, grid.origin.heading);
}

std::string mask_to_pgm(const Mask& mask) {
  if (!mask.percents) return map_to_pgm(mask.map);
  check_map(mask.map);
  std::string text = fmt::format("P5\n{} {}\n255\n", mask.map.columns, mask.map.rows);
  const auto columns = static_cast<std::size_t>(mask.map.columns);
  for (std::size_t row = static_cast<std::size_t>(mask.map.rows); row-- > 0;) {
    for (std::size_t i = row * columns; i < (row + 1) * columns; ++i) {
      text += static_cast<char>((*mask.percents)[i]);
    }
  }
  return text;
}

std::string mask_to_yaml(const Mask& mask, const std::string& image) {
  std::string text = map_to_yaml(mask.map, image);
  if (mask.percents) text.replace(text.rfind("trinary"), 7, "raw");
  return text;
}

bool is_map(const std::string& name) {
  const Document file = parse_yaml(read_file(name, largest_text), name);
  return file.root().kind == Node::Kind::map && file.find(file.root(), "image") != nullptr;
}

OccupancyGrid read_map(const std::string& name) {
  std::vector<std::string> warnings;
  return io::map_from(name, warnings);
}

OccupancyGrid io::map_from(const std::string& name, std::vector<std::string>& warnings,
                           std::vector<std::uint8_t>* percents) {
  const Document file = parse_yaml(read_file(name, largest_text), name);
  const Node& root = file.root();
  if (file.find(root, "image") == nullptr) {
    file.fail(root, "key \"image\" is missing, expected a map of ROS' map_server");
  }
  OccupancyGrid grid;  // Unknown keys are ignored, as map_server does.
  grid.resolution = file.number(file.at(root, "resolution"));
  const Node& origin = file.at(root, "origin");
  const std::vector<Node>& place = file.list(origin, "[x, y, yaw]");
  if (place.size() != 3) {
    file.fail(origin, fmt::format("has {} elements, expected [x, y, yaw]", place.size()));
  }
  grid.origin = {file.number(place[0]), file.number(place[1]), file.number(place[2])};
  const Rule rule = rule_from(file);
  Cells cells = cells_from(file, name, rule, percents);
  if (cells.has_grey && rule.mode != Mode::raw && cell_of(rule, 205, 255) == Cell::free) {
    const Node& free_thresh = file.at(root, "free_thresh");
    warnings.push_back(file.place_of(free_thresh) +
                       ": frees pixels of 205, which map_saver writes for unknown ground; 0.196 "
                       "keeps them unknown");
  }
  grid.columns = cells.columns;
  grid.rows = cells.rows;
  grid.cells = std::move(cells.cells);
  try {
    check_map(grid);
  } catch (const InputError& error) {  // Error keys begin with "map.".
    file.fail(std::string_view(error.where()).substr(4), error.problem());
  }
  return grid;
}

OccupancyGrid io::map_named(const Document& file, const Node& node, const std::string& where,
                            std::vector<std::string>& warnings,
                            std::vector<std::uint8_t>* percents) {
  const auto path = std::filesystem::path(where).parent_path() / file.text(node);
  try {
    return map_from(path.string(), warnings, percents);
  } catch (const InputError& error) {
    if (error.where() != path.string()) throw;  // The error is in the map, not in opening the file.
    file.fail(node, error.what());
  }
}

}  // namespace vandplan
