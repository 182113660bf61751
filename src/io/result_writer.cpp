// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a result written? (docs/formats.md)

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>

#include "base/escape.h"
#include "io/result_bytes.h"
#include "io/speeds_file.h"
#include "vandplan/input_error.h"
#include "vandplan/result_file.h"
#include "vandplan/vehicle.h"
#include "vandplan/version.h"

namespace vandplan {
namespace {

using Json = nlohmann::ordered_json;

constexpr double pose_distance = 0.1;  // Largest distance of neighbouring poses in a file [m].

Json json_of(const Pose& pose) { return {{"x", pose.x}, {"y", pose.y}, {"heading", pose.heading}}; }

/// JSON of a start, with the hitch angle if there is a trailer.
Json json_of_start(const Pose& pose, const Vehicle& vehicle, double hitch_angle) {
  Json json = json_of(pose);
  if (vehicle.trailer) json["hitch_angles"] = Json::array({hitch_angle});
  return json;
}

Json json_of(const Segment& segment, double radius) {
  Json json;
  if (segment.curvature_rate != 0.0) {
    json["curvature"] = segment.curvature;
    json["curvature_rate"] = segment.curvature_rate;
  } else if (segment.curvature == 0.0) {
    json["turn"] = "straight";
  } else if (std::abs(segment.curvature) == 1.0 / radius) {
    json["turn"] = segment.curvature > 0.0 ? "left" : "right";
  } else {
    json["curvature"] = segment.curvature;
  }
  json["length"] = segment.length;
  return json;
}

enum class Layout { lines, one_line };

/// Separator between the elements of a list or object on one line.
std::string_view comma_of(Layout layout) { return layout == Layout::one_line ? "," : ", "; }
std::string_view colon_of(Layout layout) { return layout == Layout::one_line ? ":" : ": "; }

/// Appends a number as `Json` writes it. A file may hold millions of numbers; JSON values for all
/// of them would be ten times slower.
void append_number(std::string& text, double value) {
  if (!std::isfinite(value)) {
    text += "null";
    return;
  }
  std::array<char, 64> digits;
  const char* const end =
      nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
}

/// JSON of a pose on a path. `hitch_angle` is null without a trailer.
std::string text_of(const PathPoint& point, const double* hitch_angle, Layout layout) {
  std::string text = "{";
  const auto append = [&](std::string_view key, double value) {
    if (text.back() != '{') text += comma_of(layout);
    text.append(key).append(colon_of(layout));
    append_number(text, value);
  };
  append(R"("s")", point.s);
  append(R"("x")", point.pose.x);
  append(R"("y")", point.pose.y);
  append(R"("heading")", point.pose.heading);
  if (hitch_angle != nullptr) {
    text.append(comma_of(layout)).append(R"("hitch_angles")").append(colon_of(layout)) += '[';
    append_number(text, *hitch_angle);
    text += ']';
  }
  append(R"("curvature")", point.curvature);
  text.append(comma_of(layout)).append(R"("direction")").append(colon_of(layout));
  return text.append(std::to_string(direction_of(point.gear))).append("}");
}

/// JSON of a node of a tree.
std::string text_of(const Pose& pose, Layout layout) {
  std::string text = "[";
  append_number(text, pose.x);
  text += comma_of(layout);
  append_number(text, pose.y);
  text += comma_of(layout);
  append_number(text, pose.heading);
  text += ']';
  return text;
}

/// Which long lists the records of a file contain.
struct Extent {
  bool poses = true;
  bool trees = true;
};

Extent extent_of(std::span<const ResultRecord> records) {
  double poses = 0.0;  // Upper bound on the poses of `sampled`.
  std::size_t nodes = 0;
  for (const ResultRecord& record : records) {
    if (record.result.tree) nodes += record.result.tree->poses.size();
    if (!record.result.path) continue;
    poses += 1.0;
    for (const Segment& segment : record.result.path->segments) {
      poses += std::max(1.0, std::ceil(std::abs(segment.length) / pose_distance));
    }
  }
  return {poses <= static_cast<double>(most_written_poses), nodes <= most_written_nodes};
}

/// Records of a file as JSON. Places of long lists stay open and are filled when the text is
/// written.
class Results {
 public:
  Results(std::span<const ResultRecord> records, Layout layout)
      : layout_(layout), extent_(extent_of(records)) {}

  [[nodiscard]] Layout layout() const { return layout_; }

  using Add = std::function<void(std::string_view element)>;
  struct LongList {
    bool is_flat;                         ///< Whether the elements go on one line.
    std::function<void(const Add&)> all;  ///< Calls `Add` with the text of each element.
  };

  Json json_of_record(const Vehicle& vehicle, double hitch_angle, const ResultRecord& record);
  /// List of the next open place. Places are visited in their order.
  const LongList& next_list() { return lists_.at(next_++); }

 private:
  Json json_of_path(const Path& path, const Vehicle& vehicle, double hitch_angle);
  Json json_of_tree(const TreeSnapshot& tree);
  Json open_place(LongList list) {
    lists_.push_back(std::move(list));
    return Json::value_t::discarded;
  }

  Layout layout_;
  Extent extent_;
  std::vector<LongList> lists_;
  std::size_t next_ = 0;
};

Json Results::json_of_path(const Path& path, const Vehicle& vehicle, double hitch_angle) {
  Json segments = Json::array();
  for (const Segment& segment : path.segments) {
    segments.push_back(json_of(segment, vehicle.min_turning_radius));
  }
  Json json = {{"start", json_of_start(path.start, vehicle, hitch_angle)},
               {"segments", std::move(segments)}};
  if (!extent_.poses) return json;
  json["poses"] =
      open_place({false, [&path, &vehicle, hitch_angle, layout = layout_](const Add& add) {
                    std::vector<double> angles;
                    if (vehicle.trailer) {
                      angles = sampled_hitch_angles(vehicle, path, hitch_angle, pose_distance);
                    }
                    std::size_t i = 0;
                    for (const PathPoint& point : sampled(path, pose_distance)) {
                      add(text_of(point, vehicle.trailer ? &angles[i++] : nullptr, layout));
                    }
                  }});
  return json;
}

Json Results::json_of_tree(const TreeSnapshot& tree) {
  Json json;
  json["poses"] = open_place({false, [&tree, layout = layout_](const Add& add) {
                                for (const Pose& pose : tree.poses) add(text_of(pose, layout));
                              }});
  json["parents"] = open_place({true, [&tree](const Add& add) {
                                  for (const std::int32_t parent : tree.parents)
                                    add(std::to_string(parent));
                                }});
  return json;
}

Json time_of(const PlanResult& result) {
  Json time = {{"total", result.time_total}};
  if (!result.anytime.empty()) time["first_solution"] = result.anytime.front().time;
  return time;
}

Json anytime_of(const PlanResult& result) {
  Json json = Json::array();
  for (const CostSample& sample : result.anytime) {
    json.push_back({{"time", sample.time}, {"iteration", sample.iteration}, {"cost", sample.cost}});
  }
  return json;
}

Json options_of(const PlanOptions& options) {
  Json json = Json::object();
  for (const CommonOption& option : common_options()) {
    json[std::string(option.name)] = Json::parse(option.get(options));
  }
  for (const auto& [name, value] : options.planner.values())
    json[name] = Json::parse(vandplan::json_of(value));
  return json;
}

Json counters_of(const PlanResult& result) {
  Json json = Json::object();
  for (const Counter& counter : result.counters) json[counter.name] = counter.value;
  return json;
}

Json build_of(const BuildInfo& build) {
  return {
      {"version", build.version}, {"compiler", build.compiler}, {"build_type", build.build_type}};
}

Json json_of(const Hit& hit) {
  Json json = {{"what", name_of(hit.kind)}};
  if (has_index(hit.kind)) json["index"] = hit.index;
  if (hit.cell) json["cell"] = {{"x", hit.cell->x}, {"y", hit.cell->y}};
  return json;
}

Json json_of(const ReachedGoal& goal) {
  return {{"index", goal.index},
          {"x", goal.pose.x},
          {"y", goal.pose.y},
          {"heading", goal.pose.heading}};
}

Json json_of(const std::vector<PassedVia>& passed) {
  Json list = Json::array();
  for (const auto& [s, pose] : passed) {
    list.push_back({{"s", s}, {"x", pose.x}, {"y", pose.y}, {"heading", pose.heading}});
  }
  return list;
}

Json heading_of(const ResultRecord& record) {
  return {{"format", "vandplan-result/1"},
          {"scenario", record.scenario},
          {"planner", record.planner},
          {"seed", record.options.budget.seed}};
}

Json Results::json_of_record(const Vehicle& vehicle, double hitch_angle,
                             const ResultRecord& record) {
  const PlanResult& result = record.result;
  Json json = heading_of(record);
  if (record.distance) json["distance"] = *record.distance;
  json["status"] = name_of(result.status);
  if (!result.reason.empty()) json["reason"] = result.reason;
  if (result.hit) json["hit"] = json_of(*result.hit);
  if (result.path) {
    json["length"] = length(result.path->segments);
    json["cost"] = result.cost;
    if (result.lower_bound > 0.0) {
      json["bound"] = *result.lower_bound;
      json["gap"] = result.cost / *result.lower_bound - 1.0;
    }
    json["gear_changes"] = gear_changes(result.path->segments);
    if (result.speeds) json["duration"] = result.speeds->duration;
    if (result.goal) json["goal"] = json_of(*result.goal);
    if (!result.via.empty()) json["via"] = json_of(result.via);
    if (result.check) {
      json["reverse_length"] = result.check->reverse_length;
      // JSON has no infinity, the clearance without obstacles.
      const std::optional<double>& clearance = result.check->clearance;
      if (clearance && std::isfinite(*clearance)) json["clearance"] = *clearance;
    }
  }
  json["time"] = time_of(result);
  json["iterations"] = result.iterations;
  json["nodes"] = counter(result, "nodes");
  json["counters"] = counters_of(result);
  json["anytime"] = anytime_of(result);
  if (result.path) json["path"] = json_of_path(*result.path, vehicle, hitch_angle);
  if (result.speeds) json["speeds"] = io::json_of(*result.speeds);
  if (result.tree && extent_.trees) json["tree"] = json_of_tree(*result.tree);
  json["options"] = options_of(record.options);
  json["build"] = build_of(build_info());
  return json;
}

/// Whether a value goes on one line, because none of its elements contains anything.
bool is_flat(const Json& json) {
  return std::none_of(json.begin(), json.end(), [](const Json& item) {
    return item.is_discarded() || (item.is_structured() && !item.empty());
  });
}

std::string text_of_scalar(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return json.is_string() ? base::json_text(text) : text;
}

/// Writes JSON piece by piece: flat values on one line, others with one element a line; or
/// everything on one line.
class Writer {
 public:
  Writer(Results& results, const TextSink& sink)
      : results_(results), is_compact_(results.layout() == Layout::one_line), sink_(sink) {}

  void write_all(const Json& json) {
    write(json, "");
    text_ += '\n';
    sink_(text_);
  }

 private:
  /// Brackets around elements that are being written.
  struct Frame {
    bool is_flat;
    std::string indent;
    bool is_begun = false;
  };

  void write(const Json& json, const std::string& indent) {
    if (!json.is_structured() || json.empty()) {
      text_ += text_of_scalar(json);
      return;
    }
    Frame frame{is_flat(json), indent};
    text_ += json.is_object() ? '{' : '[';
    for (const auto& [key, value] : json.items()) {
      begin_element(frame);
      if (json.is_object()) text_ += text_of_scalar(Json(key)) + (is_compact_ ? ":" : ": ");
      if (value.is_discarded()) {
        write(results_.next_list(), indent + "  ");
      } else {
        write(value, indent + "  ");
      }
    }
    end(frame, json.is_object() ? '}' : ']');
  }

  void write(const Results::LongList& list, const std::string& indent) {
    Frame frame{list.is_flat, indent};
    text_ += '[';
    list.all([&](std::string_view element) {
      begin_element(frame);
      text_ += element;
      if (text_.size() < most_kept) return;
      sink_(text_);
      text_.clear();
    });
    end(frame, ']');
  }

  void begin_element(Frame& frame) {
    const bool has_lines = !frame.is_flat && !is_compact_;
    if (std::exchange(frame.is_begun, true)) text_ += has_lines || is_compact_ ? "," : ", ";
    if (has_lines) text_.append("\n").append(frame.indent).append("  ");
  }

  void end(const Frame& frame, char bracket) {
    if (frame.is_begun && !frame.is_flat && !is_compact_) text_.append("\n").append(frame.indent);
    text_ += bracket;
  }

  // Size of the text that is kept [bytes].
  static constexpr std::size_t most_kept = std::size_t{1} << 16;

  Results& results_;
  bool is_compact_;
  const TextSink& sink_;
  std::string text_;
};

/// Everything that `write` passes to its sink, as one text.
template <class Write>
std::string collected(const Write& write) {
  std::string text;
  write([&text](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace

std::optional<double> furthest_reached(const std::vector<ResultRecord>& records) {
  std::optional<double> furthest;
  for (const ResultRecord& record : records) {
    if (record.result.path) furthest = std::max(furthest, record.distance);
  }
  return furthest;
}

void write_results(const ScenarioFile& file, const std::vector<ResultRecord>& records,
                   const TextSink& sink) {
  if (records.empty()) throw InputError("records", "are none, expected one at least");
  const Vehicle& vehicle = file.scenario.vehicle;
  const double hitch_angle = file.scenario.hitch_angles.start;
  Results results(records, Layout::lines);
  Json json;
  if (file.is_row()) {
    json = heading_of(records.front());
    json["goals"] = Json::array();
    for (const ResultRecord& record : records) {
      json["goals"].push_back(results.json_of_record(vehicle, hitch_angle, record));
    }
    const std::optional<double> furthest = furthest_reached(records);
    json["furthest"] = furthest ? Json(*furthest) : Json();
  } else {
    json = results.json_of_record(vehicle, hitch_angle, records.front());
  }
  Writer(results, sink).write_all(json);
}

std::string results_to_json(const ScenarioFile& file, const std::vector<ResultRecord>& records) {
  return collected([&](const TextSink& sink) { write_results(file, records, sink); });
}

void write_result_line(std::size_t pair, const Problem& problem, const ResultRecord& record,
                       const TextSink& sink) {
  Results results({&record, 1}, Layout::one_line);
  Json json = {{"pair", pair}};
  json["start"] = json_of(problem.start());
  json["goal"] = json_of(problem.goal());
  Json result = results.json_of_record(problem.vehicle(), problem.hitch_angles().start, record);
  for (auto& [key, value] : result.get_ref<Json::object_t&>()) json[key] = std::move(value);
  Writer(results, sink).write_all(json);
}

std::string result_to_json_line(std::size_t pair, const Problem& problem,
                                const ResultRecord& record) {
  return collected([&](const TextSink& sink) { write_result_line(pair, problem, record, sink); });
}

std::string io::head_text(const ResultRecord& pattern) {
  Json json = heading_of(pattern);
  json["options"] = options_of(pattern.options);
  json["build"] = build_of(build_info());
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace vandplan
