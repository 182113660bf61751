// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "recording/schemas.h"

#include <initializer_list>
#include <string_view>
#include <utility>

namespace vandplan::recording {
namespace {

std::string object_of(std::initializer_list<std::pair<std::string_view, std::string>> members) {
  std::string properties;
  for (const auto& [name, schema] : members) {
    properties.append(properties.empty() ? "\"" : ",\"").append(name).append("\":").append(schema);
  }
  return R"({"type":"object","properties":{)" + properties + "}}";
}

std::string list_of(const std::string& item) { return R"({"type":"array","items":)" + item + "}"; }

/// Schemas that others are made of.
struct Parts {
  std::string number = R"({"type":"number"})";
  std::string integer = R"({"type":"integer"})";
  std::string count = R"({"type":"integer","minimum":0})";
  std::string flag = R"({"type":"boolean"})";
  std::string text = R"({"type":"string"})";
  std::string bytes = R"({"type":"string","contentEncoding":"base64"})";
  std::string time = object_of({{"sec", count}, {"nsec", count}});
  std::string vector = object_of({{"x", number}, {"y", number}, {"z", number}});
  std::string quaternion = object_of({{"x", number}, {"y", number}, {"z", number}, {"w", number}});
  std::string pose = object_of({{"position", vector}, {"orientation", quaternion}});
  std::string colour = object_of({{"r", number}, {"g", number}, {"b", number}, {"a", number}});
};

std::string schema_of_entity(const Parts& p) {
  const std::string line = object_of({{"type", p.count},
                                      {"pose", p.pose},
                                      {"thickness", p.number},
                                      {"scale_invariant", p.flag},
                                      {"points", list_of(p.vector)},
                                      {"color", p.colour}});
  const std::string triangles = object_of({{"pose", p.pose},
                                           {"points", list_of(p.vector)},
                                           {"color", p.colour},
                                           {"indices", list_of(p.count)}});
  const std::string label = object_of({{"pose", p.pose},
                                       {"billboard", p.flag},
                                       {"font_size", p.number},
                                       {"scale_invariant", p.flag},
                                       {"color", p.colour},
                                       {"text", p.text}});
  return object_of({{"timestamp", p.time},
                    {"frame_id", p.text},
                    {"id", p.text},
                    {"lifetime", p.time},
                    {"frame_locked", p.flag},
                    {"lines", list_of(line)},
                    {"triangles", list_of(triangles)},
                    {"texts", list_of(label)}});
}

std::string schema_of_grid(const Parts& p) {
  return object_of(
      {{"timestamp", p.time},
       {"frame_id", p.text},
       {"pose", p.pose},
       {"column_count", p.count},
       {"cell_size", object_of({{"x", p.number}, {"y", p.number}})},
       {"row_stride", p.count},
       {"cell_stride", p.count},
       {"fields", list_of(object_of({{"name", p.text}, {"offset", p.count}, {"type", p.count}}))},
       {"data", p.bytes}});
}

std::string schema_of_motion(const Parts& p) {
  return object_of({{"timestamp", p.time},
                    {"s", p.number},
                    {"x", p.number},
                    {"y", p.number},
                    {"heading", p.number},
                    {"direction", p.integer},
                    {"v", p.number},
                    {"steering_angle", p.number},
                    {"wanted_steering", p.number},
                    {"wanted_acceleration", p.number},
                    {"lateral_error", p.number},
                    {"heading_error", p.number},
                    {"hitch_angle", p.number}});
}

Schemas made_schemas() {
  const Parts p;
  const std::string deletion =
      object_of({{"timestamp", p.time}, {"type", p.count}, {"id", p.text}});
  return {
      .scene = {"foxglove.SceneUpdate", object_of({{"deletions", list_of(deletion)},
                                                   {"entities", list_of(schema_of_entity(p))}})},
      .grid = {"foxglove.Grid", schema_of_grid(p)},
      .poses = {"foxglove.PosesInFrame",
                object_of(
                    {{"timestamp", p.time}, {"frame_id", p.text}, {"poses", list_of(p.pose)}})},
      .transform = {"foxglove.FrameTransform", object_of({{"timestamp", p.time},
                                                          {"parent_frame_id", p.text},
                                                          {"child_frame_id", p.text},
                                                          {"translation", p.vector},
                                                          {"rotation", p.quaternion}})},
      .log = {"foxglove.Log", object_of({{"timestamp", p.time},
                                         {"level", p.count},
                                         {"message", p.text},
                                         {"name", p.text},
                                         {"file", p.text},
                                         {"line", p.count}})},
      .motion = {"vandplan.Motion", schema_of_motion(p)},
      .improvement = {"vandplan.Improvement", object_of({{"timestamp", p.time},
                                                         {"time", p.number},
                                                         {"iteration", p.count},
                                                         {"cost", p.number}})}};
}

}  // namespace

const Schemas& schemas() {
  static const Schemas all = made_schemas();
  return all;
}

}  // namespace vandplan::recording
