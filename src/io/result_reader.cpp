// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/result_reader.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include <initializer_list>
#include <limits>
#include <utility>

#include "base/text.h"
#include "io/speeds_file.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace io;

PlanStatus status_from(const Document& file, const Node& node) {
  for (const PlanStatus status : plan_statuses()) {
    if (file.text(node) == name_of(status)) return status;
  }
  file.fail(node,
            fmt::format("is \"{}\", expected one of {}", file.text(node),
                        base::joined(plan_statuses(), [](PlanStatus s) { return name_of(s); })));
}

double curvature_from(const Document& file, const Node& node, double radius) {
  const Node* const turn = file.find(node, "turn");
  const Node* const curvature = file.find(node, "curvature");
  if ((turn == nullptr) == (curvature == nullptr)) {
    file.fail(node, fmt::format("has {}, expected either turn or curvature",
                                turn == nullptr ? "neither" : "both"));
  }
  if (curvature != nullptr) return file.number(*curvature);
  const std::string& word = file.text(*turn);
  if (word == "left") return 1.0 / radius;
  if (word == "right") return -1.0 / radius;
  if (word == "straight") return 0.0;
  file.fail(*turn, fmt::format("is \"{}\", expected left, straight or right", word));
}

Segment segment_from(const Document& file, const Node& node, double radius) {
  Segment segment{.curvature = curvature_from(file, node, radius),
                  .length = file.number(file.at(node, "length"))};
  if (const Node* const rate = file.find(node, "curvature_rate")) {
    if (file.find(node, "turn") != nullptr) {
      file.fail(*rate, "stands beside turn, expected it beside curvature");
    }
    segment.curvature_rate = file.number(*rate);
  }
  return segment;
}

Path path_from(const Document& file, const Node& node, double radius) {
  Path path{pose_from(file, file.at(node, "start")), {}};
  for (const Node& segment : file.list(file.at(node, "segments"), "a list of segments")) {
    path.segments.push_back(segment_from(file, segment, radius));
  }
  return path;
}

std::vector<CostSample> anytime_from(const Document& file, const Node& node) {
  std::vector<CostSample> samples;
  for (const Node& item : file.list(node, "a list of costs over time")) {
    samples.push_back({file.number(file.at(item, "time")), file.integer(file.at(item, "iteration")),
                       file.number(file.at(item, "cost"))});
  }
  return samples;
}

/// The tree of a result, whose lists were taken before.
TreeSnapshot tree_from(const Document& file, const Node& node, TreeSnapshot tree) {
  (void)file.list(file.at(node, "poses"), "a list of poses");
  const Node& parents = file.at(node, "parents");
  (void)file.list(parents, "a list of nodes");
  if (tree.parents.size() != tree.poses.size()) {
    file.fail(parents, fmt::format("has {} elements, expected one for each of the {} poses",
                                   tree.parents.size(), tree.poses.size()));
  }
  return tree;
}

/// Reads statistics, all of which may be missing.
void read_statistics(const Document& file, const Node& node, PlanResult& result,
                     ResultLists& lists) {
  if (const Node* const cost = file.find(node, "cost")) result.cost = file.number(*cost);
  if (const Node* const time = file.find(node, "time")) {
    if (const Node* const total = file.find(*time, "total")) {
      result.time_total = file.number(*total);
    }
  }
  if (const Node* const count = file.find(node, "iterations")) {
    result.iterations = file.integer(*count);
  }
  if (const Node* const count = file.find(node, "nodes")) {
    result.counters = {{"nodes", file.integer(*count)}};
  }
  if (const Node* const anytime = file.find(node, "anytime")) {
    result.anytime = anytime_from(file, *anytime);
  }
  if (const Node* const tree = file.find(node, "tree")) {
    result.tree = tree_from(file, *tree, std::move(lists.tree));
  }
}

/// Throws InputError for the first option whose value no planner accepts.
void expect_in_range(const Document& file, const Node& node, const PlanOptions& options) {
  try {
    validate(options);
  } catch (const InputError& error) {
    file.fail(file.at(node, error.where()), error.problem());
  }
}

/// Reads an option that rates a path. Null stands for one that was not set.
void read_option(const Document& file, const Node& given, const CommonOption& option,
                 PlanOptions& options) {
  if (given.kind == Node::Kind::nothing && option.is_optional) return;
  if (option.words.empty()) {
    option.set(options, base::shortest_text(file.number(given)));
    return;
  }
  try {
    option.set(options, file.text(given));
  } catch (const InputError& error) {
    file.fail(given, error.problem());
  }
}

/// Reads the options that rate a path. Without prices the cost is the length.
void read_options(const Document& file, const Node& node, PlanOptions& options) {
  for (const CommonOption& option : common_options()) {
    const Node* const given = file.find(node, option.name);
    if (given == nullptr || option.part == OptionPart::budget) continue;
    read_option(file, *given, option, options);
  }
  expect_in_range(file, node, options);
}

/// Options that have a value, by name.
std::vector<Setting> stated_options(const Node& options) {
  std::vector<Setting> stated;
  for (std::size_t i = 0; i < options.items.size(); ++i) {
    const Node& value = options.items[i];
    if (value.kind == Node::Kind::scalar) stated.push_back({options.keys[i].text, value.text});
  }
  return stated;
}

/// Whether the planner's cost is the length, whatever the options say.
bool goes_by_length(const std::string& planner) {
  const std::optional<Planner> known = find_planner(planner);
  return known && !known->can(Capability::prices);
}

std::optional<StatedCost> cost_from(const Document& file, const Node& node,
                                    const ResultRecord& record) {
  const Node* const cost = file.find(node, "cost");
  if (cost == nullptr) return std::nullopt;
  StatedCost stated{.cost = file.number(*cost)};
  if (!goes_by_length(record.planner)) stated.rule = record.options.cost;
  if (const Node* const bound = file.find(node, "bound")) stated.lower_bound = file.number(*bound);
  if (const Node* const gap = file.find(node, "gap")) stated.gap = file.number(*gap);
  return stated;
}

PathClaims claims_from(const Document& file, const Node& node, ResultLists& lists) {
  PathClaims claims;
  if (const Node* const length = file.find(node, "length")) claims.length = file.number(*length);
  if (const Node* const changes = file.find(node, "gear_changes")) {
    const std::uint64_t count = file.count(*changes);
    if (count > std::numeric_limits<int>::max()) {
      file.fail(*changes, fmt::format("is {}, expected a count of gear changes", count));
    }
    claims.gear_changes = static_cast<int>(count);
  }
  const Node& start = file.at(file.at(node, "path"), "start");
  claims.start_hitch_angle = hitch_angle_from(file, start);
  if (const Node* const poses = file.find(file.at(node, "path"), "poses")) {
    (void)file.list(*poses, "a list of poses");
    claims.poses = std::move(lists.poses);
  }
  return claims;
}

/// Goal of a set that the path ends at. In a line for a pair, `goal` is only a pose and gives none.
std::optional<ReachedGoal> goal_from(const Document& file, const Node& node) {
  const Node* const goal = file.find(node, "goal");
  const Node* const index = goal == nullptr ? nullptr : file.find(*goal, "index");
  if (index == nullptr) return std::nullopt;
  return ReachedGoal{file.count(*index), pose_from(file, *goal)};
}

/// Places where the path passes the scenario's vias.
std::vector<PassedVia> via_from(const Document& file, const Node& node) {
  std::vector<PassedVia> passed;
  const Node* const via = file.find(node, "via");
  if (via == nullptr) return passed;
  for (const Node& item : file.list(*via, "a list of places")) {
    passed.push_back({file.number(file.at(item, "s")), pose_from(file, item)});
  }
  return passed;
}

/// Scenario, planner and seed of a result.
ResultRecord run_from(const Document& file, const Node& node) {
  ResultRecord record;
  if (const Node* const name = file.find(node, "scenario")) record.scenario = file.text(*name);
  if (const Node* const name = file.find(node, "planner")) record.planner = file.text(*name);
  if (const Node* const seed = file.find(node, "seed"))
    record.options.budget.seed = file.count(*seed);
  return record;
}

/// Reads the rules that the path must obey, and the claims that follow from them.
void read_rules(const Document& file, const Node& node, ResultRecord& record) {
  record.options.cost = shortest_style;
  record.stated.emplace();
  if (const Node* const options = file.find(node, "options")) {
    read_options(file, *options, record.options);
    record.stated = stated_options(*options);
  }
  record.result.rule = record.options.cost;
  record.claims.clearance = record.options.clearance;
  record.claims.steering = record.options.steering.value_or(Steering::reeds_shepp);
  record.claims.gears = record.options.cost.gears;
}

Hit hit_from(const Document& file, const Node& node) {
  Hit hit;
  const Node& what = file.at(node, "what");
  const std::string name = file.text(what);
  const std::optional<HitKind> kind = hit_kind_named(name);
  if (!kind) {
    file.fail(what,
              fmt::format("is \"{}\", expected obstacles, kerbs, map, bounds, inside, zones or "
                          "masks",
                          name));
  }
  hit.kind = *kind;
  if (const Node* const index = file.find(node, "index")) hit.index = file.count(*index);
  if (const Node* const cell = file.find(node, "cell")) {
    hit.cell = {file.number(file.at(*cell, "x")), file.number(file.at(*cell, "y"))};
  }
  return hit;
}

ResultRecord record_from(const Document& file, const Node& node, double radius,
                         ResultLists& lists) {
  ResultRecord record = run_from(file, node);
  if (const Node* const metres = file.find(node, "distance")) {
    record.distance = file.number(*metres);
  }
  PlanResult& result = record.result;
  if (const Node* const reason = file.find(node, "reason")) result.reason = file.text(*reason);
  if (const Node* const hit = file.find(node, "hit")) result.hit = hit_from(file, *hit);
  const Node* const path = file.find(node, "path");
  const Node* const status = file.find(node, "status");
  if (status == nullptr && path == nullptr) (void)file.at(node, "status");
  result.status = status != nullptr ? status_from(file, *status) : PlanStatus::solved;
  if (path != nullptr && result.status != PlanStatus::solved) {
    file.fail(*path, fmt::format("is given though the status is {}, expected none",
                                 name_of(result.status)));
  }
  if (result.status == PlanStatus::solved) {
    result.path = path_from(file, file.at(node, "path"), radius);
    if (const Node* const speeds = file.find(node, "speeds")) {
      result.speeds = speeds_from(file, *speeds);
    }
    record.claims = claims_from(file, node, lists);
    record.claims.goal = result.goal = goal_from(file, node);
    record.claims.via = result.via = via_from(file, node);
    read_rules(file, node, record);
    record.claims.cost = cost_from(file, node, record);
  }
  read_statistics(file, node, result, lists);
  return record;
}

void expect_format(const Document& file, const Node& node) {
  const Node& format = file.at(node, "format");
  if (file.text(format) == "vandplan-result/1") return;
  file.fail(format, fmt::format("is \"{}\", expected \"vandplan-result/1\"", format.text));
}

}  // namespace

namespace io {

std::vector<ResultRecord> records_from(const Document& file, const ScenarioFile& scenario,
                                       ListTaker& lists) {
  const Node& root = file.root();
  expect_format(file, root);
  const double radius = scenario.scenario.vehicle.min_turning_radius;
  const Node* const goals = file.find(root, "goals");
  if (!scenario.is_row()) {
    if (goals != nullptr) file.fail(*goals, "is a row, expected the scenario's one goal");
    return {record_from(file, root, radius, lists.of(ListTaker::alone))};
  }
  const std::vector<Node>& items = file.list(file.at(root, "goals"), "a list of results");
  if (items.size() != scenario.size()) {
    file.fail(*goals, fmt::format("has {} elements, expected the scenario's {} goals", items.size(),
                                  scenario.size()));
  }
  std::vector<ResultRecord> records;
  records.reserve(items.size());
  for (const Node& item : items) {
    records.push_back(record_from(file, item, radius, lists.of(records.size())));
  }
  if (const Node* const furthest = file.find(root, "furthest")) {
    StatedFurthest stated;
    if (furthest->kind != Node::Kind::nothing) stated.distance = file.number(*furthest);
    for (ResultRecord& record : records) record.furthest = stated;
  }
  return records;
}

PairRecord pair_record_from(const Document& file, double radius, ListTaker& lists) {
  const Node& root = file.root();
  expect_format(file, root);
  PairRecord record;
  record.pair = file.count(file.at(root, "pair"));
  record.poses = {pose_from(file, file.at(root, "start")), pose_from(file, file.at(root, "goal"))};
  try {
    check_poses(record.poses.start, record.poses.goal);
  } catch (const InputError& error) {
    file.fail(error.where(), error.problem());
  }
  record.record = record_from(file, root, radius, lists.of(ListTaker::alone));
  return record;
}

ResultRecord pattern_from(const Document& head) {
  expect_format(head, head.root());
  ResultRecord pattern = run_from(head, head.root());
  read_rules(head, head.root(), pattern);
  pattern.claims.cost = StatedCost{};
  if (!goes_by_length(pattern.planner)) pattern.claims.cost->rule = pattern.options.cost;
  return pattern;
}

}  // namespace io

std::vector<Setting> stored_options(const ResultRecord& record) {
  return record.stated ? *record.stated : settings_of(record.options);
}

}  // namespace vandplan
