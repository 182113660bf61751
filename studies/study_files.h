// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which files does a study write? Numbers as CSV, and a script that draws them.

#include <span>
#include <string>
#include <vector>

#include "vandplan/path.h"

namespace vandplan::studies {

struct TextFile {
  std::string name;
  std::string content;
};

/// Files of a study. `gnuplot SCRIPT`, called in their folder, makes the pictures.
struct StudyFiles {
  std::vector<TextFile> data;  ///< CSV files; the first line has the names of the columns
  TextFile script;
  std::vector<std::string> pictures;  ///< names of the pictures that the script makes
};

/// Size of a picture: PNG in pixels, SVG in points.
struct Canvas {
  std::string name;  ///< name of the files, without extension
  int width = 1200;
  int height = 600;
};

/// Files of a study with a script that draws `body` (gnuplot commands) twice, as NAME.png and
/// NAME.svg.
[[nodiscard]] StudyFiles study_files(const Canvas& canvas, std::vector<TextFile> data,
                                     const std::string& body);

/// Colours that colour-blind people can tell apart (Okabe and Ito 2008), in gnuplot's notation.
namespace study_colour {
inline constexpr const char* blue = "#0072b2";
inline constexpr const char* orange = "#d55e00";
inline constexpr const char* green = "#009e73";
inline constexpr const char* purple = "#b34d8c";
inline constexpr const char* ink = "#21262e";
inline constexpr const char* grey = "#8a929c";
}  // namespace study_colour

/// Appends a path as lines "LABELS,x,y,heading,direction", with both ends of every segment.
void append_path(std::string& csv, const std::string& labels, const Path& path);

/// Commands that draw the path with two labels from such a file: forward solid, reverse dashed.
[[nodiscard]] std::string plot_of_path(const std::string& file, int first, int second,
                                       const std::string& colour);

/// Command that draws a pose as an arrow of length `length` [m].
[[nodiscard]] std::string arrow_at(const Pose& pose, double length, const std::string& colour);

/// Word of a path with sides and gears, such as "L+ S+ R-".
[[nodiscard]] std::string word_of(std::span<const Segment> segments);

}  // namespace vandplan::studies
