// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How does a scenario of CommonRoad (Althoff, Koschi and Manzinger 2017; XML, 2018b and 2020a)
// become ours?
#include "io/commonroad.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "io/roads.h"
#include "io/site_shapes.h"
#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

using std::numbers::pi;

/// Vehicle 2 of CommonRoad's vehicle models, a BMW 320i. The body's middle is the centre of
/// gravity. Both accelerations at once stay within the circle of 11.5 m/s^2.
Vehicle bmw_320i() {
  constexpr double to_front_axle = 1.1561957064;  // From the centre of gravity [m].
  constexpr double to_rear_axle = 1.4227170936;
  constexpr double half_length = 4.508 / 2;
  Vehicle car{.wheelbase = to_front_axle + to_rear_axle,
              .front_overhang = half_length - to_front_axle,
              .rear_overhang = half_length - to_rear_axle,
              .width = 1.610};
  car.min_turning_radius = turning_radius(car.wheelbase, 1.066);
  car.limits.max_steering_rate = 0.4;
  car.limits.max_speed = {50.8, 13.6};
  car.limits.max_acceleration = 8.0;
  car.limits.max_lateral_acceleration = 8.0;
  return car;
}

Point point_from(const XmlFile& file, const XmlNode& node) {
  return {file.number_in(file.child(node, "x")), file.number_in(file.child(node, "y"))};
}

std::vector<Point> points_from(const XmlFile& file, const XmlNode& node) {
  std::vector<Point> points;
  for (const XmlNode point : node.children("point")) points.push_back(point_from(file, point));
  return points;
}

/// Points of a shape moved and turned by a pose.
Polygon placed(const Polygon& shape, const Pose& pose) {
  Polygon corners;
  for (const auto& [x, y] : shape) {
    const Pose at = compose(pose, {x, y, 0.0});
    corners.push_back({at.x, at.y});
  }
  return corners;
}

Point centre_of(const XmlFile& file, const XmlNode& shape) {
  const XmlNode centre = shape.child("center");
  return centre ? point_from(file, centre) : Point{};
}

double positive(const XmlFile& file, const XmlNode& node) {
  const double value = file.number_in(node);
  if (!(value > 0.0)) file.fail(node, fmt::format("is {}, expected more than 0 m", value));
  return value;
}

/// Polygon of a rectangle, circle or polygon. A circle has a polygon around it, or within it.
Polygon shape_from(const XmlFile& file, const XmlNode& node, bool around) {
  const std::string_view kind = node.name();
  if (kind == "rectangle") {
    const double x = positive(file, file.child(node, "length")) / 2;
    const double y = positive(file, file.child(node, "width")) / 2;
    const XmlNode turn = node.child("orientation");
    const Point centre = centre_of(file, node);
    return placed({{-x, -y}, {x, -y}, {x, y}, {-x, y}},
                  {centre.x, centre.y, turn ? file.number_in(turn) : 0.0});
  }
  if (kind == "circle") {
    return circle_shape(centre_of(file, node), positive(file, file.child(node, "radius")), around);
  }
  if (kind != "polygon") {
    file.fail(node, "is no shape that is covered, expected rectangle, circle or polygon");
  }
  Polygon corners = points_from(file, node);
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  if (corners.size() < 3) {
    file.fail(node, fmt::format("has {} corners, expected at least 3", corners.size()));
  }
  return corners;
}

/// The only shape of an obstacle.
Polygon shape_of(const XmlFile& file, const XmlNode& obstacle) {
  const XmlNode shape = file.child(obstacle, "shape");
  const XmlNode only = shape.first_child();
  if (!only || only.next_sibling()) file.fail(shape, "has no or several shapes, expected one");
  return shape_from(file, only, true);
}

std::string_view sign_of(const XmlNode& element) {
  return without_blanks(element.child("trafficSignID").text().get());
}

/// Whether an element of a traffic sign is a speed limit: 274 in Germany, R2-1 in the USA.
bool is_speed_limit(const XmlNode& element) { return is_any_of(sign_of(element), {"274", "R2-1"}); }

Pose pose_from(const XmlFile& file, const XmlNode& state) {
  const Point point = point_from(file, file.child(file.child(state, "position"), "point"));
  return {point.x, point.y, exact_from(file, file.child(state, "orientation"))};
}

/// Reads one scenario.
class CaseReader {
 public:
  CaseReader(const XmlFile& file, const CommonRoadCase& one)
      : file_(file),
        step_(time_step_of(file)),
        problem_(planning_problem(file, one.problem)),
        begin_(begin_of(file, problem_)),
        goals_(goal_places(file, problem_)) {}

  void read(const CommonRoadCase& one, RoadScenario& result) {
    for (const XmlNode node : file_.root().children("lanelet")) add_lanelet(node);
    Scenario& scenario = result.file.scenario;
    scenario.name = name();
    scenario.description = "CommonRoad";
    scenario.vehicle = one.vehicle.value_or(bmw_320i());
    scenario.start = pose_from(file_, file_.child(problem_, "initialState"));
    for (const XmlNode place : goals_) scenario.goal_set.push_back(goal_from(place));
    for (const XmlNode node : file_.root().children()) add_thing(node, scenario);
    tell(result.file.warnings);
    try {
      add_roads(roads_, one.rules, result);
    } catch (const InputError& error) {
      blame(error);
    }
  }

 private:
  [[nodiscard]] std::string name() const {
    const std::string id = file_.root().attribute("benchmarkID").value();
    return id.empty() ? file_.stem() : id;
  }

  void add_lanelet(const XmlNode& node) {
    const std::string id = file_.text(node, "id");
    Lane lane{.name = "lanelet " + id,
              .left = points_from(file_, file_.child(node, "leftBound")),
              .right = points_from(file_, file_.child(node, "rightBound"))};
    if (lane.left.size() < 2 || lane.right.size() < 2) {
      file_.fail(node, "has a bound of fewer than 2 points, expected at least 2");
    }
    areas_[id] = outline(lane);
    const std::string type = node.child("laneletType").text().get();
    if (is_any_of(type, {"sidewalk", "crosswalk", "bicycleLane", "border", "restricted_area"})) {
      ++roads_.left_out["lanelet " + type];
      return;
    }
    for (const XmlNode both : node.children("userBidirectional")) {
      const std::string_view user = both.text().get();
      if (user == "vehicle" || user == "car") lane.is_one_way = false;
    }
    if (type == "parking") lane.is_one_way = false;
    lane.max_speed = speed_limit_of(node);
    if (node.child("stopLine")) ++roads_.left_out["stopLine"];
    roads_.lanes.push_back(std::move(lane));
  }

  /// The least speed limit of a lanelet [m/s], of its own (2018b) or of the signs it refers to.
  [[nodiscard]] std::optional<double> speed_limit_of(const XmlNode& lanelet) const {
    std::optional<double> least;
    const auto add = [&](const XmlNode& node) {
      const double speed = file_.number_in(node);
      if (!(speed > 0.0)) {
        file_.fail(node, fmt::format("is {}, expected a speed limit of more than 0 m/s", speed));
      }
      least = std::min(least.value_or(speed), speed);
    };
    if (const XmlNode own = lanelet.child("speedLimit")) add(own);
    for (const XmlNode part : lanelet.children("trafficSignRef")) {
      const std::string id = file_.text(part, "ref");
      const XmlNode sign = file_.root().find_child_by_attribute("trafficSign", "id", id.c_str());
      if (!sign) file_.fail(part, "has a ref to no trafficSign of the file");
      for (const XmlNode element : sign.children("trafficSignElement")) {
        if (is_speed_limit(element)) add(file_.child(element, "additionalValue"));
      }
    }
    return least;
  }

  /// Goal at a place of a goal state.
  [[nodiscard]] GoalRegion goal_from(const XmlNode& place) const {
    GoalRegion region{.heading = any_heading};
    if (const XmlNode turn = place.parent().parent().child("orientation")) {
      const auto [first, last] = interval_from(file_, turn);
      if (last - first < 2 * pi) region.heading = {first, last};
    }
    const std::string_view kind = place.name();
    if (kind == "point") {
      const Point point = point_from(file_, place);
      region.x = {point.x, point.x};
      region.y = {point.y, point.y};
    } else if (kind == "lanelet") {
      const auto area = areas_.find(file_.text(place, "ref"));
      if (area == areas_.end()) file_.fail(place, "has a ref to no lanelet of the file");
      region.area = area->second;
    } else {
      region.area = shape_from(file_, place, false);
    }
    return region;
  }

  /// Adds an obstacle, standing or moving, if the element is one.
  void add_thing(const XmlNode& node, Scenario& scenario) {
    const std::string_view kind = node.name();
    const std::string_view role = node.child("role").text().get();
    if (kind == "environmentObstacle") {
      roads_.obstacles.push_back({shape_of(file_, node), file_.place_of(node)});
    } else if (kind == "staticObstacle" || (kind == "obstacle" && role == "static")) {
      const Pose pose = pose_from(file_, file_.child(node, "initialState"));
      roads_.obstacles.push_back({placed(shape_of(file_, node), pose), file_.place_of(node)});
    } else if (kind == "dynamicObstacle" || kind == "obstacle") {
      scenario.moving.push_back(moving_from(node));
      moving_.push_back(node);
    } else if (kind == "trafficSign") {
      for (const XmlNode element : node.children("trafficSignElement")) {
        if (is_speed_limit(element)) continue;
        ++roads_.left_out[fmt::format("trafficSign {}", sign_of(element))];
      }
    } else if (is_any_of(kind, {"phantomObstacle", "trafficLight", "intersection"})) {
      ++roads_.left_out[std::string(kind)];
    }
  }

  [[nodiscard]] MovingObstacle moving_from(const XmlNode& node) const {
    MovingObstacle obstacle{.outline = shape_of(file_, node), .after = Afterwards::leaves};
    const XmlNode initial = file_.child(node, "initialState");
    const XmlNode trajectory = file_.child(node, "trajectory");
    obstacle.trajectory.push_back(row_from(initial));
    for (const XmlNode state : trajectory.children("state")) {
      obstacle.trajectory.push_back(row_from(state));
    }
    return obstacle;
  }

  [[nodiscard]] TimedPose row_from(const XmlNode& state) const {
    const double steps = exact_from(file_, file_.child(state, "time")) - begin_;
    return {steps * step_, pose_from(file_, state)};
  }

  void tell(std::vector<std::string>& warnings) const {
    if (problem_.find_child([](const XmlNode& node) {
          return node.name() == std::string_view("goalState") &&
                 (node.child("time") || node.child("velocity"));
        })) {
      warnings.push_back("left out: times and speeds of goals; a drive ends where it stands");
    }
    const XmlNode velocity = problem_.child("initialState").child("velocity");
    if (velocity && exact_from(file_, velocity) != 0.0) {
      warnings.push_back(
          fmt::format("left out: the initial velocity of {} m/s; a drive starts from rest",
                      exact_from(file_, velocity)));
    }
  }

  /// Rethrows an error of the scenario, naming the element that caused it.
  [[noreturn]] void blame(const InputError& error) const {
    const std::string& key = error.where();
    const std::size_t at = key.find('[');
    const std::size_t index =
        at == std::string::npos ? 0 : std::strtoull(key.c_str() + at + 1, nullptr, 10);
    XmlNode node = file_.root();
    if (key.starts_with("start")) node = problem_.child("initialState");
    if (key.starts_with("goal") && index < goals_.size()) node = goals_[index];
    if (key.starts_with("moving") && index < moving_.size()) node = moving_[index];
    if (node == file_.root() && key.find(':') != std::string::npos) throw error;
    file_.fail(node, key + " " + error.problem());
  }

  const XmlFile& file_;
  double step_;  // Duration of a time step [s].
  XmlNode problem_;
  double begin_;                               // Time step at which the vehicle starts.
  std::vector<XmlNode> goals_;                 // Places of the set of goals.
  std::vector<XmlNode> moving_ = {};           // Elements of the moving obstacles.
  std::map<std::string, Polygon> areas_ = {};  // Outlines of lanelets by id.
  Roads roads_ = {};
};

}  // namespace

XmlNode planning_problem(const XmlFile& file, const std::string& id) {
  std::vector<XmlNode> found;
  std::string ids;
  for (const XmlNode node : file.root().children("planningProblem")) {
    const std::string own = file.text(node, "id");
    ids += (ids.empty() ? "" : ", ") + own;
    if (id.empty() || own == id) found.push_back(node);
  }
  if (found.size() == 1) return found.front();
  if (ids.empty()) file.fail(file.root(), "has no planningProblem, expected one");
  file.fail(file.root(),
            fmt::format("has planning problems {}, expected --problem with one of these", ids));
}

double begin_of(const XmlFile& file, const XmlNode& problem) {
  return exact_from(file, file.child(file.child(problem, "initialState"), "time"));
}

double time_step_of(const XmlFile& file) {
  const double step = file.number(file.root(), "timeStepSize");
  if (step > 0.0) return step;
  file.fail(file.root(), fmt::format("has timeStepSize {}, expected more than 0 s", step));
}

std::vector<XmlNode> goal_places(const XmlFile& file, const XmlNode& problem) {
  std::vector<XmlNode> places;
  for (const XmlNode state : problem.children("goalState")) {
    const XmlNode position = state.child("position");
    if (!position.first_child()) {
      file.fail(state,
                "has no position, expected one: a goal of time or speed alone is not "
                "covered");
    }
    for (const XmlNode place : position.children()) places.push_back(place);
  }
  if (places.empty()) file.fail(problem, "has no goalState, expected one at least");
  return places;
}

double exact_from(const XmlFile& file, const XmlNode& node) {
  return file.number_in(file.child(node, "exact"));
}

Interval interval_from(const XmlFile& file, const XmlNode& node) {
  if (node.child("exact")) return {exact_from(file, node), exact_from(file, node)};
  return {file.number_in(file.child(node, "intervalStart")),
          file.number_in(file.child(node, "intervalEnd"))};
}

}  // namespace vandplan::io

namespace vandplan {

RoadScenario read_commonroad(const CommonRoadCase& one) {
  const io::XmlFile file(one.file, "commonRoad", "a scenario of CommonRoad");
  RoadScenario result;
  io::CaseReader(file, one).read(one, result);
  return result;
}

}  // namespace vandplan
