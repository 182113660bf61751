// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for Nav2: a costmap with the names that our plugins use.

#include <cmath>
#include <cstddef>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace nav2_costmap_2d {

class Costmap2D {
 public:
  using mutex_t = std::recursive_mutex;
  Costmap2D(unsigned int columns, unsigned int rows, double resolution, double x, double y)
      : costs(std::size_t{columns} * rows, 0),
        columns_(columns),
        rows_(rows),
        resolution_(resolution),
        x_(x),
        y_(y) {}
  std::vector<unsigned char> costs;

  [[nodiscard]] unsigned char* getCharMap() const {
    return const_cast<unsigned char*>(costs.data());  // NOLINT: as the original does
  }
  [[nodiscard]] unsigned int getSizeInCellsX() const { return columns_; }
  [[nodiscard]] unsigned int getSizeInCellsY() const { return rows_; }
  [[nodiscard]] double getResolution() const { return resolution_; }
  [[nodiscard]] double getOriginX() const { return x_; }
  [[nodiscard]] double getOriginY() const { return y_; }
  mutex_t* getMutex() { return &mutex_; }

 private:
  unsigned int columns_;
  unsigned int rows_;
  double resolution_;
  double x_;
  double y_;
  mutex_t mutex_;
};

class Costmap2DROS {
 public:
  explicit Costmap2DROS(Costmap2D& costmap) : costmap_(&costmap) {}
  std::vector<geometry_msgs::msg::Point> footprint;
  double radius = 0.0;                                          // 0: the footprint counts
  std::map<std::string, geometry_msgs::msg::Pose> frames = {};  // in "map", turned about z only

  Costmap2D* getCostmap() { return costmap_; }
  std::string getGlobalFrameID() { return "map"; }
  std::vector<geometry_msgs::msg::Point> getRobotFootprint() { return footprint; }
  bool getUseRadius() { return radius > 0.0; }
  double getRobotRadius() { return radius; }
  bool transformPoseToGlobalFrame(const geometry_msgs::msg::PoseStamped& input_pose,
                                  geometry_msgs::msg::PoseStamped& transformed_pose) {
    transformed_pose = input_pose;
    if (input_pose.header.frame_id == getGlobalFrameID()) return true;
    const auto frame = frames.find(input_pose.header.frame_id);
    if (frame == frames.end()) return false;
    const auto& [origin, turn] = frame->second;
    const auto& [at, q] = input_pose.pose;
    const double heading = 2 * std::atan2(turn.z, turn.w);
    const double c = std::cos(heading);
    const double s = std::sin(heading);
    transformed_pose.pose.position = {origin.x + c * at.x - s * at.y,
                                      origin.y + s * at.x + c * at.y, at.z};
    transformed_pose.pose.orientation = {0.0, 0.0, turn.z * q.w + turn.w * q.z,
                                         turn.w * q.w - turn.z * q.z};
    return true;
  }

 private:
  Costmap2D* costmap_;
};

}  // namespace nav2_costmap_2d
