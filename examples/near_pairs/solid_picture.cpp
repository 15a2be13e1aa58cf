// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The drawing of solids; see solid_picture.h.

#include "solid_picture.h"

#include "summary.h"
#include "svg.h"
#include "text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace near_pairs {
namespace {

// Colors of Okabe and Ito, which color-blind people can tell apart too.
const char* const solid_pair_color = "#D55E00";
const char* const set_of_solids_colors[] = {"#555555", "#009E73"};

constexpr double left_of_views = 96, top_of_views = 64, between_views = 60;
constexpr double widest_view = 700, highest_view = 420, least_width_of_text = 560;
constexpr double height_of_row = 24;
constexpr double cosine_of_sharp = 0.9; // of the angle between the normals of two triangles

using Vector = std::array<double, 3>;

Vector difference(const Vector& p, const Vector& q)
{
  return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
}

double product(const Vector& u, const Vector& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

// Of length 1, or 0 if the triangle has no area.
Vector normal_of(const Vector& p, const Vector& q, const Vector& r)
{
  const Vector u = difference(p, q), v = difference(p, r);
  Vector normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                   u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(product(normal, normal));
  for(double& component : normal)
    component /= length > 0 ? length : 1;
  return normal;
}

// The normals of the triangles at an edge, for a triangle that goes along it from its lesser end.
using Edges = std::map<std::pair<Vector, Vector>, std::vector<Vector>>;

Edges edges_of(const Mesh& mesh)
{
  Edges edges;
  for(const auto& [i, j, k] : mesh.triangles) {
    const Vector corners[] = {mesh.points[i], mesh.points[j], mesh.points[k]};
    const Vector normal = normal_of(corners[0], corners[1], corners[2]);
    if(product(normal, normal) == 0)
      continue;
    for(int corner = 0; corner < 3; ++corner) {
      const Vector& p = corners[corner];
      const Vector& q = corners[(corner + 1) % 3];
      edges[std::minmax(p, q)].push_back(
        p < q ? normal : Vector{-normal[0], -normal[1], -normal[2]});
    }
  }
  return edges;
}

// Seen along an axis of space, from its positive or its negative side.
struct View
{
  int x, y, depth; // axes
  Panel panel;

  Position place(const Vector& p) const { return panel.place({p[x], p[y]}); }

  // Whether an edge is sharp, or part of an outline. Two triangles of a surface go along their edge
  // in opposite directions.
  bool shows(const std::vector<Vector>& normals) const
  {
    if(normals.size() != 2)
      return true;
    return -product(normals[0], normals[1]) < cosine_of_sharp
           || normals[0][depth] * normals[1][depth] >= 0;
  }
};

// What is drawn of solids of one color, each line once.
std::string path_of(const View& view, const std::vector<Feature>& solids,
                    const std::vector<bool>& in_pairs, bool which)
{
  std::set<std::string> lines;
  for(std::size_t i = 0; i < solids.size(); ++i)
    if(in_pairs[i] == which)
      for(const auto& [ends, normals] : edges_of(solids[i].mesh))
        if(view.shows(normals)) {
          auto from = pixels(view.place(ends.first)), to = pixels(view.place(ends.second));
          if(from != to)
            lines.insert('M' + std::min(from, to) + 'L' + std::max(from, to));
        }
  std::string path;
  for(const std::string& line : lines)
    path += line;
  return path;
}

void draw_view(std::ostream& svg, const View& view, const std::vector<std::vector<Feature>>& sets,
               const std::vector<std::vector<bool>>& in_pairs)
{
  for(const bool which : {false, true}) // those in pairs lie above the others
    for(std::size_t set = 0; set < sets.size(); ++set)
      svg << "<path fill='none' stroke='" << (which ? solid_pair_color : set_of_solids_colors[set])
          << "' stroke-width='" << (which ? 1.2 : 0.6) << "' d='"
          << path_of(view, sets[set], in_pairs[set], which) << "'/>\n";
}

// The views have one scale, and the second one is below the first.
std::array<View, 2> views_of(const std::vector<std::vector<Feature>>& sets)
{
  const double most = std::numeric_limits<double>::max();
  Vector low = {most, most, most}, high = {-most, -most, -most};
  for(const std::vector<Feature>& solids : sets)
    for(const Feature& solid : solids)
      for(const Vector& point : solid.mesh.points)
        for(int axis = 0; axis < 3; ++axis) {
          low[axis] = std::min(low[axis], point[axis]);
          high[axis] = std::max(high[axis], point[axis]);
        }
  const Vector extent = difference(low, high);
  const double longest = *std::max_element(extent.begin(), extent.end());
  const double room = longest > 0 ? longest / 30 : std::max(1., std::abs(low[0]));
  std::array<View, 2> views = {View{0, 1, 2, {}}, View{0, 2, 1, {}}};
  const double scale
    = std::min({widest_view / (extent[0] + 2 * room), highest_view / (extent[1] + 2 * room),
                highest_view / (extent[2] + 2 * room)});
  double top = top_of_views, left = left_of_views;
  for(View& view : views) {
    view.panel.low = {low[view.x] - room, low[view.y] - room};
    view.panel.high = {high[view.x] + room, high[view.y] + room};
    view.panel.x_scale = view.panel.y_scale = scale;
    check_window(view.panel);
    view.panel.top = top;
    top = view.panel.bottom() + between_views;
    left = std::max(left, y_axis_width(view.panel));
  }
  for(View& view : views)
    view.panel.left = left;
  return views;
}

std::string name_of_file(const std::string& file)
{
  return shortened(std::filesystem::path(file).filename().string(), 40);
}

// The two files of two sets, or one set.
std::vector<std::string> names_of_sets(std::size_t sets, const Options& options)
{
  if(options.files.size() > 2)
    return {std::to_string(options.files.size()) + " files"};
  std::vector<std::string> names;
  for(std::size_t set = 0; set < sets; ++set)
    names.push_back(name_of_file(options.files[set]));
  return names;
}

void draw_legend(std::ostream& svg, const std::vector<std::string>& names, double x, double y)
{
  const auto row = [&](const char* color, const std::string& text) {
    svg << "<circle cx='" << x << "' cy='" << y << "' r='5' fill='" << color << "'/>\n";
    write_text(svg, {x + 14, y + 5}, text);
    y += height_of_row;
  };
  for(std::size_t set = 0; set < names.size(); ++set)
    row(set_of_solids_colors[set], "solid of " + names[set]);
  row(solid_pair_color, "solid in a pair");
}

} // namespace

void draw_solids(std::ostream& svg, const std::vector<std::vector<Feature>>& sets,
                 const std::vector<std::vector<bool>>& in_pairs, const Options& options,
                 std::size_t pairs)
{
  const std::array<View, 2> views = views_of(sets);
  const Panel& above = views[0].panel;
  const std::vector<std::string> names = names_of_sets(sets.size(), options);
  const std::string title = "Pairs of solids of " + names.front()
                            + (names.size() == 2 ? " and " + names.back() : "");
  const std::string counts = "k = " + std::to_string(pairs) + " pairs, distance "
    + shortened(distance_in_words(options, ""), 40) + "; from above, and from the front";
  const double legend_top = views[1].panel.bottom() + 76;
  const double height = legend_top + height_of_row * (names.size() + 1);
  const double width
    = above.left
      + std::max({above.width(), least_width_of_text, text_width(title, 19), text_width(counts)})
      + 30;
  svg << "<svg xmlns='http://www.w3.org/2000/svg' width='" << width << "' height='" << height
      << "' viewBox='0 0 " << width << ' ' << height
      << "' font-family='sans-serif' font-size='13' fill='#222'>\n"
      << "<rect width='100%' height='100%' fill='white'/>\n";
  write_text(svg, {above.left, 30}, title, "font-size='19'");
  write_text(svg, {above.left, 51}, counts);
  for(const View& view : views) {
    write_axes(svg, view.panel, "x", view.y == 1 ? "y" : "z");
    draw_view(svg, view, sets, in_pairs);
  }
  draw_legend(svg, names, above.left + 6, legend_top);
  svg << "</svg>\n";
}

} // namespace near_pairs
