// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for Nav2: a costmap with the names that our plugins use.

#include <cstddef>
#include <geometry_msgs/msg/pose.hpp>
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
  double radius = 0.0;  // 0: the footprint counts

  Costmap2D* getCostmap() { return costmap_; }
  std::string getGlobalFrameID() { return "map"; }
  std::vector<geometry_msgs::msg::Point> getRobotFootprint() { return footprint; }
  bool getUseRadius() { return radius > 0.0; }
  double getRobotRadius() { return radius; }

 private:
  Costmap2D* costmap_;
};

}  // namespace nav2_costmap_2d
