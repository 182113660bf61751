// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a map of ROS' map_server read? (docs/formats.md)

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "io/document.h"
#include "io/image.h"
#include "vandplan/input_error.h"
#include "vandplan/io.h"

namespace vandplan {
namespace {

constexpr std::size_t largest_image = std::size_t{256} << 20;  // bytes

enum class Mode { trinary, scale, raw };

/// How the brightness of a pixel says what a cell is.
struct Rule {
  Mode mode = Mode::trinary;
  bool negate = false;
  double occupied_thresh = 0.65;
  double free_thresh = 0.196;
};

Mode mode_from(const Document& file, const Node& node) {
  const std::string& text = file.text(node);
  if (text == "trinary") return Mode::trinary;
  if (text == "scale") return Mode::scale;
  if (text == "raw") return Mode::raw;
  file.fail(node, "is \"" + text.substr(0, 40) + "\", expected trinary, scale or raw");
}

bool flag_from(const Document& file, const Node& node) {
  const std::string& text = file.text(node);
  if (text == "0" || text == "false") return false;
  if (text == "1" || text == "true") return true;
  file.fail(node, "is \"" + text.substr(0, 40) + "\", expected 0 or 1");
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

Cell cell_between(const Rule& rule, double occupancy) {
  if (occupancy > rule.occupied_thresh) return Cell::occupied;
  return occupancy < rule.free_thresh ? Cell::free : Cell::unknown;
}

/// As map_server does it; what it calls neither free nor occupied is unknown to us.
Cell cell_of(const Rule& rule, double brightness) {
  const double occupancy = rule.negate ? brightness : 1.0 - brightness;
  if (rule.mode == Mode::raw) {
    const double percent = std::round(brightness * 255);
    return percent > 100 ? Cell::unknown : cell_between(rule, percent / 100);
  }
  const Cell cell = cell_between(rule, occupancy);
  if (rule.mode == Mode::trinary || cell != Cell::unknown) return cell;
  const double part = (occupancy - rule.free_thresh) / (rule.occupied_thresh - rule.free_thresh);
  const double percent = std::rint(part * 100);
  return percent == 0 ? Cell::free : percent == 100 ? Cell::occupied : Cell::unknown;
}

Image image_of(const Document& file, const std::string& map, Mode mode) {
  const Node& node = file.at(file.root(), "image");
  const std::filesystem::path path = std::filesystem::path(map).parent_path() / file.text(node);
  const Alpha alpha = mode == Mode::trinary ? Alpha::averaged
                      : mode == Mode::scale ? Alpha::marked
                                            : Alpha::ignored;
  try {
    return image_from(read_file(path.string(), largest_image), path.string(), alpha);
  } catch (const InputError& error) {
    file.fail(node, error.what());
  }
}

std::vector<Cell> cells_of(const Image& image, const Rule& rule) {
  // Few brightnesses, many pixels.
  std::vector<Cell> cell_of_brightness;
  for (std::uint32_t i = 0; i <= image.white; ++i) {
    cell_of_brightness.push_back(cell_of(rule, static_cast<double>(i) / image.white));
  }
  std::vector<Cell> cells;
  cells.reserve(image.pixels.size());
  const auto columns = static_cast<std::size_t>(image.columns);
  for (std::size_t row = static_cast<std::size_t>(image.rows); row-- > 0;) {  // the top one last
    for (std::size_t i = row * columns; i < (row + 1) * columns; ++i) {
      const std::uint32_t pixel = image.pixels[i];
      cells.push_back(pixel == Image::transparent ? Cell::unknown : cell_of_brightness[pixel]);
    }
  }
  return cells;
}

}  // namespace

std::string map_to_pgm(const OccupancyGrid& grid) {
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

OccupancyGrid read_map(const std::string& name) {
  const Document file = parse_yaml(read_file(name, largest_text), name);
  const Node& root = file.root();
  file.allow_only(
      root, {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"});
  OccupancyGrid grid;
  grid.resolution = file.number(file.at(root, "resolution"));
  if (!(grid.resolution > 0)) {
    file.fail("resolution", fmt::format("is {}, expected more than 0 m", grid.resolution));
  }
  const Node& origin = file.at(root, "origin");
  const std::vector<Node>& place = file.list(origin, "[x, y, yaw]");
  if (place.size() != 3) {
    file.fail(origin, fmt::format("has {} elements, expected [x, y, yaw]", place.size()));
  }
  grid.origin = {file.number(place[0]), file.number(place[1]), file.number(place[2])};
  const Rule rule = rule_from(file);
  const Image image = image_of(file, name, rule.mode);
  grid.columns = image.columns;
  grid.rows = image.rows;
  grid.cells = std::make_shared<const std::vector<Cell>>(cells_of(image, rule));
  return grid;
}

}  // namespace vandplan
