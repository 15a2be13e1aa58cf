// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// SVG drawing; see picture.h.

#include "picture.h"

#include "exact_number.h"
#include "text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <map>

namespace near_pairs {
namespace {

// Colors of Okabe and Ito, which color-blind people can tell apart too.
const char* const pair_color = "#D55E00";
const char* const half_color = "#0072B2";
const char* const inset_color = "#0072B2";
const char* const set_colors[] = {"#555555", "#009E73"};

// Of components. The first is of points without a neighbor; the others take turns.
const char* const component_colors[] = {"#999999", "#D55E00", "#0072B2", "#009E73", "#CC79A7",
                                        "#E69F00", "#56B4E9"};

constexpr double main_left = 96, main_top = 64, main_width = 600, main_height = 520;
constexpr double least_main_width = 500, legend_width = 330, inset_side = 300, row_height = 24;
constexpr double title_size = 19;
constexpr std::size_t longest_names = 56, longest_distance = 40, longest_axis_name = 30; // letters
constexpr double shortest_line = 6;           // pixels: a shorter pair is a mark
constexpr std::size_t most_lines = 20000;     // more cannot be told apart anyway
constexpr std::size_t longest_path = 2000;    // characters: a program draws long ones slowly
constexpr std::ptrdiff_t most_inset_points = 250;
const double degree = std::acos(-1.) / 180;

// Where a point is drawn: at its x and y, or at its longitude and latitude.
Position position_of(const Scene& scene, std::size_t i)
{
  return scene.is_geographic ? Position{scene.column(i, 1), scene.column(i, 0)}
                             : Position{scene.coordinate(i, 0), scene.coordinate(i, 1)};
}

std::vector<std::string> short_names(const std::vector<std::string>& files)
{
  std::vector<std::string> names;
  for(const std::string& file : files)
    names.push_back(shortened(std::filesystem::path(file).filename().string(),
                              longest_names / files.size()));
  return names;
}

} // namespace

Picture::Picture(const Scene& scene, const Options& options, const std::string& distance)
  : scene_(scene), files_(short_names(options.files)),
    caption_("distance " + shortened(distance, longest_distance)), unit_(scene.unit),
    geographic_(options.geographic), reach_(reach_of(options)),
    units_per_position_(1), first_size_(scene.first_size.value_or(scene.size()))
{
  if(geographic_) { // lengths are drawn along the surface, in degrees
    reach_ = 2 * std::asin(std::min(1., reach_ / (2 * earth_radius))) / degree;
    units_per_position_ = earth_radius * degree;
  }
  positions_.reserve(scene.size());
  for(std::size_t i = 0; i < scene.size(); ++i)
    positions_.push_back(position_of(scene, i));
  const bool is_map = geographic_ || unit_ == "deg";
  const std::array<std::string, 3>& names = scene.names.front();
  axis_names_[0] = is_map ? "longitude (deg)" : shortened(names[0], longest_axis_name);
  axis_names_[1] = is_map ? "latitude (deg)" : shortened(names[1], longest_axis_name);
  if(scene.dimension == 3)
    caption_ += geographic_ ? ", along the chord" : ", in space; drawn without z";
  place_main_panel();
  has_inset_ = !positions_.empty() && reach_ > 0 && reach_ * main_.y_scale < shortest_line;
  if(has_inset_)
    place_inset();
}

// How many times shorter a degree of longitude is than a degree of latitude.
double Picture::aspect_at(double latitude) const
{
  return geographic_ ? std::max(0.05, std::cos(latitude * degree)) : 1;
}

void Picture::place_main_panel()
{
  Position low = {0, 0}, high = {0, 0};
  if(!positions_.empty())
    low = high = positions_.front();
  double latitudes = 0;
  for(const Position& p : positions_) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    latitudes += p.y;
  }
  const double aspect = aspect_at(latitudes / std::max<std::size_t>(positions_.size(), 1));
  const double width = (high.x - low.x) * aspect, height = high.y - low.y;
  double extent = std::max(width, height);
  if(extent == 0)
    extent = std::max({1., std::abs(low.x), std::abs(low.y)});
  const double least_room = extent / 30 + (scene_.cell ? reach_ / 2 : 0); // for halves of pairs
  const double x_room = (std::max(width, extent / 4) - width) / 2 + least_room;
  const double y_room = (std::max(height, extent / 4) - height) / 2 + least_room;
  main_.low = {low.x - x_room / aspect, low.y - y_room};
  main_.high = {high.x + x_room / aspect, high.y + y_room};
  main_.y_scale = std::min(main_width / (width + 2 * x_room), main_height / (height + 2 * y_room));
  main_.x_scale = main_.y_scale * aspect;
  check_window(main_);
  main_.left = std::max(main_left, y_axis_width(main_));
  main_.top = main_top;
}

// Takes a window of 16 distances, and smaller ones until the points can be told apart.
void Picture::place_inset()
{
  for(double side = 16 * reach_; ; side /= 2) {
    const Position center = densest_place(side / 4);
    const double aspect = aspect_at(center.y);
    inset_.low = {center.x - side / aspect / 2, center.y - side / 2};
    inset_.high = {center.x + side / aspect / 2, center.y + side / 2};
    inset_.y_scale = inset_side / side;
    inset_.x_scale = inset_.y_scale * aspect;
    const auto count = std::count_if(positions_.begin(), positions_.end(),
                                     [&](Position p) { return inset_.shows(p); });
    if(count <= most_inset_points || side <= 6 * reach_)
      break;
  }
  inset_.left = legend_left();
  inset_.top = main_top;
}

// The mean of the points in the fullest cell of a grid with this side.
Position Picture::densest_place(double side) const
{
  const double aspect = aspect_at(main_.center().y);
  const auto cell = [&](Position p) {
    return std::make_pair(std::floor(p.x * aspect / side), std::floor(p.y / side));
  };
  std::map<std::pair<double, double>, std::size_t> counts;
  for(const Position& p : positions_)
    ++counts[cell(p)];
  const auto fullest = std::max_element(counts.begin(), counts.end(),
    [](const auto& a, const auto& b) { return a.second < b.second; });
  Position sum = {0, 0};
  for(const Position& p : positions_)
    if(cell(p) == fullest->first)
      sum = {sum.x + p.x, sum.y + p.y};
  return {sum.x / fullest->second, sum.y / fullest->second};
}

void Picture::add_pair(std::size_t i, std::size_t j, const Offset& offset)
{
  ++pairs_;
  if(offset == Offset{}) {
    add_line({i, positions_[j], false});
    return;
  }
  const std::array<double, 3> d = scene_.difference(i, j, offset);
  const Position a = positions_[i], b = positions_[j], half = {d[0] / 2, d[1] / 2};
  add_line({i, {a.x + half.x, a.y + half.y}, true});
  add_line({j, {b.x - half.x, b.y - half.y}, true});
}

void Picture::add_line(const Line& line)
{
  const Position begin = positions_[line.point];
  if(has_inset_) {
    const Position mark = main_.place(begin);
    marks_.insert(pixels({std::round(mark.x), std::round(mark.y)}));
    if(!inset_.shows(begin) && !inset_.shows(line.end))
      return;
  }
  Lines& lines = has_inset_ ? inset_lines_ : main_lines_;
  is_cut_ |= lines.size() == most_lines;
  if(is_cut_)
    return;
  lines.push_back(line);
  has_halves_ |= line.is_half;
}

void Picture::color_by(const Groups& groups)
{
  constexpr std::size_t turns = std::size(component_colors) - 1;
  for(std::size_t i = 0; i < positions_.size(); ++i)
    component_colors_.push_back(static_cast<unsigned char>(
      groups.neighbors(i) == 0 ? 0 : 1 + groups.component(i) % turns));
}

// Of a point, among the colors of components or of sets.
std::size_t Picture::color_of(std::size_t point) const
{
  if(!component_colors_.empty())
    return component_colors_[point];
  return point < first_size_ ? 0 : 1;
}

double Picture::legend_left() const
{
  return main_.left + std::max(main_.width(), least_main_width) + 44;
}

double Picture::legend_top() const
{
  return has_inset_ ? inset_.bottom() + 50 : main_top + 10;
}

std::string Picture::title() const
{
  return "Pairs of points of " + files_.front()
         + (files_.size() == 2 ? " and " + files_.back() : "");
}

std::string Picture::counts() const
{
  return "n = " + std::to_string(positions_.size()) + " points, k = " + std::to_string(pairs_)
         + " pairs, " + caption_;
}

double Picture::right() const
{
  const double heading = std::max(text_width(title(), title_size), text_width(counts()));
  return std::max(legend_left() + legend_width, main_.left + heading);
}

double Picture::bottom() const
{
  return std::max(main_.bottom() + 56, legend_top() + row_height * legend().size());
}

void Picture::write(std::ostream& svg) const
{
  svg << "<svg xmlns='http://www.w3.org/2000/svg' width='" << right() << "' height='" << bottom()
      << "' viewBox='0 0 " << right() << ' ' << bottom()
      << "' font-family='sans-serif' font-size='13' fill='#222'>\n"
      << "<rect width='100%' height='100%' fill='white'/>\n<defs><clipPath id='inset'><rect x='"
      << legend_left() << "' y='" << main_top << "' width='" << inset_side << "' height='"
      << inset_side << "'/></clipPath></defs>\n";
  write_text(svg, {main_.left, 30}, title(), "font-size='19'");
  write_text(svg, {main_.left, 51}, counts());
  write_axes(svg, main_, axis_names_[0], axis_names_[1]);
  if(has_inset_) {
    write_points(svg, main_, 1.6);
    if(component_colors_.empty())
      write_dots(svg, marks_, pair_color, 3);
    write_inset(svg);
  }
  else {
    write_lines(svg, main_, main_lines_);
    write_points(svg, main_, 3);
  }
  write_legend(svg);
  svg << "</svg>\n";
}

void Picture::write_points(std::ostream& svg, const Panel& panel, double size) const
{
  std::set<std::string> places[std::size(component_colors)]; // of the points of each color
  for(std::size_t i = 0; i < positions_.size(); ++i)
    if(panel.shows(positions_[i]))
      places[color_of(i)].insert(pixels(panel.place(positions_[i])));
  const auto colors = component_colors_.empty() ? set_colors : component_colors;
  for(std::size_t color = 0; color < std::size(places); ++color)
    if(!places[color].empty())
      write_dots(svg, places[color], colors[color], color != 0 && has_inset_ ? 2 * size : size);
}

std::string Picture::color_of(const Line& line) const
{
  if(!component_colors_.empty())
    return component_colors[color_of(line.point)];
  return line.is_half ? half_color : pair_color;
}

// A pair across the 180th meridian would run around the map: it is left out.
void Picture::write_lines(std::ostream& svg, const Panel& panel, const Lines& lines) const
{
  std::map<std::string, std::string> paths; // of each color
  const auto write = [&](const std::string& color, std::string& path) {
    svg << "<path fill='none' stroke-opacity='0.7' stroke='" << color << "' d='" << path
        << "'/>\n";
    path.clear();
  };
  for(const Line& line : lines) {
    const Position begin = positions_[line.point];
    if(geographic_ && std::abs(begin.x - line.end.x) >= 180)
      continue;
    const std::string color = color_of(line);
    std::string& path = paths[color];
    path += 'M' + pixels(panel.place(begin)) + 'L' + pixels(panel.place(line.end));
    if(path.size() > longest_path)
      write(color, path);
  }
  for(auto& [color, path] : paths)
    if(!path.empty())
      write(color, path);
}

void Picture::write_inset(std::ostream& svg) const
{
  const Position center = main_.place(inset_.center());
  svg << "<circle cx='" << center.x << "' cy='" << center.y << "' r='9' fill='none' stroke='"
      << inset_color << "' stroke-width='2'/>\n<g clip-path='url(#inset)'>\n";
  write_lines(svg, inset_, inset_lines_);
  write_points(svg, inset_, 3);
  svg << "</g>\n";
  write_frame(svg, inset_, inset_color);
  write_scale_bar(svg, inset_, units_per_position_, unit_);
  write_text(svg, {inset_.left, main_top - 13}, "detail around "
             + short_number(inset_.center().x, 6) + ", " + short_number(inset_.center().y, 6));
}

// The rows of the legend: a shape, and what it means.
Picture::Legend Picture::legend() const
{
  const auto dot = [](const char* color, double radius) {
    return "<circle r='" + short_number(radius) + "' fill='" + color + "'/>";
  };
  const bool has_components = !component_colors_.empty();
  const auto line = [](const std::string& color) {
    return "<path d='M-10 0h20' stroke-width='1.5' stroke='" + color + "'/>";
  };
  const std::string color = has_components ? component_colors[1] : pair_color;
  Legend rows;
  if(has_components) {
    rows.emplace_back(dot(component_colors[0], 1.6), "point without a neighbor");
    rows.emplace_back(dot(component_colors[1], 3), "point of a component; colors take turns");
  }
  else
    for(std::size_t set = 0; set < files_.size(); ++set)
      rows.emplace_back(dot(set_colors[set], 1.6),
                        files_.size() == 1 ? "point" : "point of " + files_[set]);
  if(has_inset_ && !has_components)
    rows.emplace_back(dot(pair_color, 2.5), "place with at least one pair");
  rows.emplace_back(line(color), has_inset_ ? "pair, in the detail" : "pair");
  if(has_halves_ && !has_components)
    rows.emplace_back(line(half_color), "half of a pair across the boundary");
  if(has_inset_)
    rows.emplace_back(std::string("<circle r='9' fill='none' stroke-width='2' stroke='")
                      + inset_color + "'/>", "the densest place, in the detail");
  if(is_cut_)
    rows.emplace_back("", "only " + std::to_string(most_lines) + " lines are drawn");
  return rows;
}

void Picture::write_legend(std::ostream& svg) const
{
  const double x = legend_left() + 12;
  double y = legend_top();
  for(const auto& [shape, text] : legend()) {
    svg << "<g transform='translate(" << x << ' ' << y << ")'>" << shape << "</g>\n";
    write_text(svg, {x + 22, y + 5}, text);
    y += row_height;
  }
}

} // namespace near_pairs
