// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The scene and its pairs as an SVG drawing, seen from above: x and y, or longitude and latitude.
// Where pairs are too short to be seen they become marks, and an inset shows the densest place. If
// the scene repeats, a pair across the boundary is drawn as the halves at its two points.

#ifndef NEAR_PAIRS_PICTURE_H
#define NEAR_PAIRS_PICTURE_H

#include "groups.h"
#include "options.h"
#include "scene.h"
#include "svg.h"

#include <cstddef>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace near_pairs {

class Picture
{
public:
  Picture(const Scene& scene, const Options& options, const std::string& distance);

  // Colors points and pairs by their components; the groups must be finished. Call this before
  // write().
  void color_by(const Groups& groups);

  // Remembers what is to be drawn of the pair: the size of the drawing is bounded.
  void add_pair(std::size_t i, std::size_t j, const Offset& offset);

  void write(std::ostream& svg) const;

private:
  using Legend = std::vector<std::pair<std::string, std::string>>;

  struct Line // from a point: a pair, or a half of one
  {
    std::size_t point;
    Position end;
    bool is_half;
  };
  using Lines = std::vector<Line>;

  void add_line(const Line& line);
  std::string title() const;
  std::string counts() const;
  Legend legend() const;
  double legend_left() const;
  double legend_top() const;
  double right() const;
  double bottom() const;
  void place_main_panel();
  void place_inset();
  Position densest_place(double side) const;
  double aspect_at(double latitude) const;

  std::size_t color_of(std::size_t point) const;
  void write_points(std::ostream& svg, const Panel& panel, double size) const;
  std::string color_of(const Line& line) const;
  void write_lines(std::ostream& svg, const Panel& panel, const Lines& lines) const;
  void write_inset(std::ostream& svg) const;
  void write_legend(std::ostream& svg) const;

  const Scene& scene_;
  std::vector<std::string> files_; // their names, shortened
  std::string caption_;
  std::string axis_names_[2];
  std::string unit_;          // of the scale bar
  bool geographic_;
  double reach_;              // the distance, in the unit of the positions
  double units_per_position_; // of the distance: meters in a degree, or 1
  std::size_t first_size_;    // points of the first file
  std::vector<Position> positions_;

  std::vector<unsigned char> component_colors_; // of the points, or empty

  Panel main_;
  bool has_inset_ = false;
  Panel inset_;
  std::size_t pairs_ = 0;
  std::set<std::string> marks_; // pixels of the main panel, if there is an inset
  Lines main_lines_;            // of the main panel, if there is none
  Lines inset_lines_;
  bool has_halves_ = false;
  bool is_cut_ = false; // more lines were to be drawn than are
};

} // namespace near_pairs

#endif // NEAR_PAIRS_PICTURE_H
