// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a study leave behind: numbers as CSV, and a script that makes pictures of them?

#include <span>
#include <string>
#include <vector>

#include "vandplan/path.h"

namespace vandplan::studies {

struct TextFile {
  std::string name;
  std::string content;
};

/// The files of a study. `gnuplot SCRIPT`, called where they are, makes the pictures.
struct StudyFiles {
  std::vector<TextFile> data;  ///< CSV, a line of names first
  TextFile script;
  std::vector<std::string> pictures;  ///< names of the files that the script makes
};

/// A picture as PNG [pixels] and as SVG [points].
struct Canvas {
  std::string name;  ///< of the files, without ending
  int width = 1200;
  int height = 600;
};

/// With a script that draws `body` (commands of gnuplot) twice, as NAME.png and as NAME.svg.
[[nodiscard]] StudyFiles study_files(const Canvas& canvas, std::vector<TextFile> data,
                                     const std::string& body);

/// Colours that stay apart for the colour-blind (Okabe and Ito 2008), as gnuplot takes them.
namespace study_colour {
inline constexpr const char* blue = "#0072b2";
inline constexpr const char* orange = "#d55e00";
inline constexpr const char* green = "#009e73";
inline constexpr const char* purple = "#b34d8c";
inline constexpr const char* ink = "#21262e";
inline constexpr const char* grey = "#8a929c";
}  // namespace study_colour

/// A path as lines "LABELS,x,y,heading,direction", both ends of every segment among them.
void append_path(std::string& csv, const std::string& labels, const Path& path);

/// Commands that draw the path with these labels out of such a file: forward solid, reverse dashed.
[[nodiscard]] std::string plot_of_path(const std::string& file, int first, int second,
                                       const std::string& colour);

/// A command that draws a pose as an arrow `length` long [m].
[[nodiscard]] std::string arrow_at(const Pose& pose, double length, const std::string& colour);

/// "L+ S+ R-": sides and gears of a path.
[[nodiscard]] std::string word_of(std::span<const Segment> segments);

}  // namespace vandplan::studies
