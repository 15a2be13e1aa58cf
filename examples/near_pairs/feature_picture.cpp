// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The drawing of features; see feature_picture.h.

#include "feature_picture.h"

#include "error.h"
#include "summary.h"
#include "svg.h"
#include "text.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <string>

namespace near_pairs {
namespace {

// Colors of Okabe and Ito, which color-blind people can tell apart too.
const char* const feature_pair_color = "#D55E00";
const char* const file_colors[] = {"#555555", "#009E73"};

constexpr double margin = 96, top = 64, most_width = 700, most_height = 620;
constexpr double least_width = 560, legend_row_height = 24;

template <class Function>
void for_each_vertex(const std::vector<std::vector<Feature>>& files, Function function)
{
  for(const std::vector<Feature>& features : files)
    for(const Feature& feature : features) {
      for(const Vertices& line : feature.lines)
        std::for_each(line.begin(), line.end(), function);
      for(const std::vector<Vertices>& rings : feature.polygons)
        for(const Vertices& ring : rings)
          std::for_each(ring.begin(), ring.end(), function);
    }
}

Panel panel_of(const std::vector<std::vector<Feature>>& files)
{
  const double most = std::numeric_limits<double>::max();
  Position low = {most, most}, high = {-most, -most};
  for_each_vertex(files, [&](const Vertex& vertex) {
    low = {std::min(low.x, vertex[0]), std::min(low.y, vertex[1])};
    high = {std::max(high.x, vertex[0]), std::max(high.y, vertex[1])};
  });
  if(low.x > high.x)
    low = high = {0, 0};
  const double extent = std::max({high.x - low.x, high.y - low.y});
  const double room = extent > 0 ? extent / 30 : std::max({1., std::abs(low.x), std::abs(low.y)});
  Panel panel;
  panel.low = {low.x - room, low.y - room};
  panel.high = {high.x + room, high.y + room};
  panel.x_scale = panel.y_scale = std::min(most_width / (high.x - low.x + 2 * room),
                                           most_height / (high.y - low.y + 2 * room));
  check_window(panel);
  panel.left = std::max(margin, y_axis_width(panel));
  panel.top = top;
  return panel;
}

std::string path_of(const Panel& panel, const Vertices& vertices)
{
  std::string path;
  for(const Vertex& vertex : vertices)
    path += (path.empty() ? 'M' : 'L') + pixels(panel.place({vertex[0], vertex[1]}));
  return path;
}

void draw_feature(std::ostream& svg, const Panel& panel, const Feature& feature, const char* color)
{
  for(const std::vector<Vertices>& rings : feature.polygons) {
    std::string path;
    for(const Vertices& ring : rings)
      path += path_of(panel, ring) + 'Z';
    svg << "<path fill='" << color << "' fill-opacity='0.25' fill-rule='evenodd' stroke='" << color
        << "' d='" << path << "'/>\n";
  }
  for(const Vertices& line : feature.lines)
    if(line.size() > 1)
      svg << "<path fill='none' stroke='" << color << "' d='" << path_of(panel, line) << "'/>\n";
}

// Points of one color are drawn together, and each place once.
void draw_points(std::ostream& svg, const Panel& panel, const std::vector<Feature>& features,
                 const std::vector<bool>& in_pairs, bool which, const char* color)
{
  std::set<std::string> places;
  for(std::size_t i = 0; i < features.size(); ++i)
    for(const Vertices& line : features[i].lines)
      if(in_pairs[i] == which && line.size() == 1)
        places.insert(pixels(panel.place({line[0][0], line[0][1]})));
  if(!places.empty())
    write_dots(svg, places, color, 3);
}

std::string name_of(const std::string& file)
{
  return shortened(std::filesystem::path(file).filename().string(), 40);
}

void draw_feature_legend(std::ostream& svg, const Options& options, double x, double y)
{
  const auto row = [&](const char* color, const std::string& text) {
    svg << "<circle cx='" << x << "' cy='" << y << "' r='5' fill='" << color << "'/>\n";
    write_text(svg, {x + 14, y + 5}, text);
    y += legend_row_height;
  };
  for(std::size_t file = 0; file < options.files.size(); ++file)
    row(file_colors[file], "feature of " + name_of(options.files[file]));
  row(feature_pair_color, "feature in a pair");
}

} // namespace

void draw_features(std::ostream& svg, const std::vector<std::vector<Feature>>& files,
                   const std::vector<std::vector<bool>>& in_pairs, const Options& options,
                   std::size_t pairs)
{
  const Panel panel = panel_of(files);
  const std::string title = "Pairs of features of " + name_of(options.files.front())
    + (files.size() == 2 ? " and " + name_of(options.files.back()) : "");
  const std::string counts = "k = " + std::to_string(pairs) + " pairs, "
    + (options.overlap ? "overlap" : "distance " + shortened(distance_in_words(options, ""), 40));
  const double width
    = panel.left + std::max({panel.width(), least_width, text_width(title, 19), text_width(counts)})
      + 30;
  const double legend_top = panel.bottom() + 76;
  const double height = legend_top + legend_row_height * (files.size() + 1);
  svg << "<svg xmlns='http://www.w3.org/2000/svg' width='" << width << "' height='" << height
      << "' viewBox='0 0 " << width << ' ' << height
      << "' font-family='sans-serif' font-size='13' fill='#222'>\n"
      << "<rect width='100%' height='100%' fill='white'/>\n";
  write_text(svg, {panel.left, 30}, title, "font-size='19'");
  write_text(svg, {panel.left, 51}, counts);
  write_axes(svg, panel, "x", "y");
  for(const bool which : {false, true}) // those in pairs lie above the others
    for(std::size_t file = 0; file < files.size(); ++file) {
      const char* const color = which ? feature_pair_color : file_colors[file];
      for(std::size_t i = 0; i < files[file].size(); ++i)
        if(in_pairs[file][i] == which)
          draw_feature(svg, panel, files[file][i], color);
      draw_points(svg, panel, files[file], in_pairs[file], which, color);
    }
  draw_feature_legend(svg, options, panel.left + 6, legend_top);
  svg << "</svg>\n";
}

} // namespace near_pairs
