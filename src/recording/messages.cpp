// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "recording/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

namespace vandplan::recording {
namespace {

constexpr std::uint64_t second = 1'000'000'000;  // [ns]

/// A text as JSON. Bytes that are no UTF-8 become replacement characters.
std::string quoted_json(std::string_view text) {
  using Json = nlohmann::json;
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

template <typename... Values>
void put(std::string& json, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(json), format, std::forward<Values>(values)...);
}

void put_time(std::string& json, std::string_view key, std::uint64_t time) {
  put(json, R"("{}":{{"sec":{},"nsec":{}}})", key, time / second, time % second);
}

void put_place(std::string& json, const Place& place) {
  put(json, R"({{"x":{},"y":{},"z":{}}})", place.x, place.y, place.z);
}

/// Rotation about the axis that points up.
void put_rotation(std::string& json, double heading) {
  put(json, R"({{"x":0,"y":0,"z":{},"w":{}}})", std::sin(heading / 2), std::cos(heading / 2));
}

void put_pose(std::string& json, const Pose& pose) {
  json += R"({"position":)";
  put_place(json, {pose.x, pose.y, 0.0});
  json += R"(,"orientation":)";
  put_rotation(json, pose.heading);
  json += '}';
}

void put_colour(std::string& json, const Colour& colour) {
  put(json, R"("color":{{"r":{},"g":{},"b":{},"a":{}}})", colour.red, colour.green, colour.blue,
      colour.opacity);
}

/// Puts a list, with `put_item` for each of its items.
template <typename Items, typename PutItem>
void put_list(std::string& json, std::string_view key, const Items& items, PutItem put_item) {
  put(json, R"("{}":[)", key);
  const char* separator = "";
  for (const auto& item : items) {
    json += separator;
    put_item(item);
    separator = ",";
  }
  json += ']';
}

void put_points(std::string& json, const std::vector<Place>& points) {
  put_list(json, "points", points, [&](const Place& place) { put_place(json, place); });
}

void put_line(std::string& json, const Line& line) {
  put(json, R"({{"type":{},"pose":)", static_cast<int>(line.join));
  put_pose(json, line.pose);
  put(json, R"(,"thickness":{},"scale_invariant":false,)", line.thickness);
  put_points(json, line.points);
  json += ',';
  put_colour(json, line.colour);
  json += R"(,"colors":[],"indices":[]})";
}

void put_triangles(std::string& json, const Triangles& triangles) {
  json += R"({"pose":)";
  put_pose(json, triangles.pose);
  json += ',';
  put_points(json, triangles.points);
  json += ',';
  put_colour(json, triangles.colour);
  json += R"(,"colors":[],)";
  put_list(json, "indices", triangles.corners, [&](std::uint32_t i) { put(json, "{}", i); });
  json += '}';
}

void put_label(std::string& json, const Label& label) {
  json += R"({"pose":{"position":)";
  put_place(json, label.place);
  json += R"(,"orientation":{"x":0,"y":0,"z":0,"w":1}},"billboard":true,"font_size":16,)";
  json += R"("scale_invariant":true,)";
  put_colour(json, label.colour);
  put(json, R"(,"text":{}}})", quoted_json(label.text));
}

void put_entity(std::string& json, std::uint64_t time, const Entity& entity) {
  json += '{';
  put_time(json, "timestamp", time);
  put(json, R"(,"frame_id":"{}","id":{},)", entity.frame, quoted_json(entity.id));
  put_time(json, "lifetime", 0);  // For ever.
  put(json, R"(,"frame_locked":{},"metadata":[],"arrows":[],"cubes":[],"spheres":[],)",
      entity.moves_with_frame);
  json += R"("cylinders":[],"models":[],)";
  put_list(json, "lines", entity.lines, [&](const Line& line) { put_line(json, line); });
  json += ',';
  put_list(json, "triangles", entity.triangles,
           [&](const Triangles& triangles) { put_triangles(json, triangles); });
  json += ',';
  put_list(json, "texts", entity.labels, [&](const Label& label) { put_label(json, label); });
  json += '}';
}

/// Bytes in base64 (RFC 4648).
std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(bytes.size() / 3 * 4 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t j) {
      return i + j < bytes.size() ? std::uint32_t{bytes[i + j]} : 0U;
    };
    const std::uint32_t bits = byte(0) << 16U | byte(1) << 8U | byte(2);
    for (const unsigned shift : {18U, 12U, 6U, 0U}) text += digits[bits >> shift & 63U];
  }
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  return text.replace(text.size() - missing, missing, missing, '=');
}

/// Blocks of `block` x `block` cells, each as its worst cell, row by row.
std::vector<std::uint8_t> blocks_of(const OccupancyGrid& grid, std::int32_t block,
                                    std::int32_t columns) {
  constexpr std::array<std::uint8_t, 3> values = {0, 100, 50};  // In the order of `Cell`.
  const std::int32_t rows = (grid.rows + block - 1) / block;
  const auto width = static_cast<std::size_t>(columns);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(rows) * width);
  const Cell* cell = grid.cells->data();
  for (std::int32_t row = 0; row < grid.rows; ++row) {
    std::uint8_t* const line = bytes.data() + static_cast<std::size_t>(row / block) * width;
    for (std::int32_t column = 0; column < grid.columns; ++column, ++cell) {
      std::uint8_t& byte = line[column / block];
      byte = std::max(byte, values[static_cast<std::size_t>(*cell)]);
    }
  }
  return bytes;
}

}  // namespace

std::string scene_message(std::uint64_t time, const SceneChange& change) {
  std::string json = "{";
  put_list(json, "deletions", change.gone, [&](const std::string& id) {
    json += '{';
    put_time(json, "timestamp", time);
    put(json, R"(,"type":0,"id":{}}})", quoted_json(id));
  });
  json += ',';
  put_list(json, "entities", change.entities,
           [&](const Entity& entity) { put_entity(json, time, entity); });
  return json + '}';
}

std::string transform_message(std::uint64_t time, const FramePose& frame) {
  std::string json = "{";
  put_time(json, "timestamp", time);
  put(json, R"(,"parent_frame_id":"{}","child_frame_id":"{}","translation":)", frame.parent,
      frame.child);
  put_place(json, {frame.pose.x, frame.pose.y, 0.0});
  json += R"(,"rotation":)";
  put_rotation(json, frame.pose.heading);
  return json + '}';
}

std::string poses_message(std::uint64_t time, std::string_view frame, std::span<const Pose> poses) {
  std::string json = "{";
  put_time(json, "timestamp", time);
  put(json, R"(,"frame_id":"{}",)", frame);
  put_list(json, "poses", poses, [&](const Pose& pose) { put_pose(json, pose); });
  return json + '}';
}

std::string log_message(std::uint64_t time, Level level, std::string_view text) {
  std::string json = "{";
  put_time(json, "timestamp", time);
  put(json, R"(,"level":{},"message":{},"name":"vandplan","file":"","line":0}})",
      static_cast<int>(level), quoted_json(text));
  return json;
}

std::string motion_message(std::uint64_t time, const DriveMoment& m) {
  std::string json = "{";
  put_time(json, "timestamp", time);
  put(json, R"(,"s":{},"x":{},"y":{},"heading":{},"direction":{},"v":{},"steering_angle":{},)", m.s,
      m.pose.x, m.pose.y, m.pose.heading, direction_of(m.gear), m.v, m.steering_angle);
  put(json, R"("wanted_steering":{},"wanted_acceleration":{},"lateral_error":{},)",
      m.wanted_steering, m.wanted_acceleration, m.lateral_error);
  put(json, R"("heading_error":{})", m.heading_error);
  if (m.hitch_angle) put(json, R"(,"hitch_angle":{})", *m.hitch_angle);
  return json + '}';
}

std::string improvement_message(std::uint64_t time, const CostSample& sample) {
  std::string json = "{";
  put_time(json, "timestamp", time);
  put(json, R"(,"time":{},"iteration":{},"cost":{}}})", sample.time, sample.iteration, sample.cost);
  return json;
}

std::string grid_message(std::uint64_t time, std::string_view frame, const OccupancyGrid& grid,
                         std::int32_t most) {
  const std::int32_t block = (std::max(grid.columns, grid.rows) + most - 1) / most;
  const std::int32_t columns = (grid.columns + block - 1) / block;
  std::string json = "{";
  put_time(json, "timestamp", time);
  put(json, R"(,"frame_id":"{}","pose":)", frame);
  put_pose(json, grid.origin);
  put(json, R"(,"column_count":{},"cell_size":{{"x":{},"y":{}}},)", columns,
      block * grid.resolution, block * grid.resolution);
  put(json, R"("row_stride":{},"cell_stride":1,)", columns);
  json += R"("fields":[{"name":"occupancy","offset":0,"type":1}],"data":")";
  return json + base64(blocks_of(grid, block, columns)) + "\"}";
}

}  // namespace vandplan::recording
