// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Parts of an SVG drawing; see svg.h.

#include "svg.h"

#include "error.h"
#include "text.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace near_pairs {
namespace {

// Names of files and columns may have any bytes, and an SVG file may not.
std::string escaped(const std::string& text)
{
  std::string result;
  for(char letter : readable(text))
    result += letter == '&' ? "&amp;" : letter == '<' ? "&lt;" : std::string(1, letter);
  return result;
}

// 1, 2 or 5 times a power of ten, at most `length`.
double round_length(double length)
{
  const double power = std::pow(10., std::floor(std::log10(length)));
  return length >= 5 * power ? 5 * power : length >= 2 * power ? 2 * power : power;
}

// The multiples of a round length in a window, about 90 pixels apart. None if the window is so
// narrow or so wide that doubles cannot tell its parts.
std::vector<double> ticks(double low, double high, double width)
{
  const double step = round_length((high - low) * 90 / width);
  const double first = std::ceil(low / step);
  const double count = std::floor(high / step) - first + 1;
  std::vector<double> places;
  for(int i = 0; i < count && count <= width; ++i)
    places.push_back((first + i) * step);
  return places;
}

void write_x_axis(std::ostream& svg, const Panel& panel, const std::string& name)
{
  for(double tick : ticks(panel.low.x, panel.high.x, panel.width())) {
    const double x = panel.place({tick, 0}).x;
    svg << "<path d='M" << x << ' ' << panel.bottom() << "v5' stroke='#222'/>\n";
    write_text(svg, {x, panel.bottom() + 19}, short_number(tick), "text-anchor='middle'");
  }
  write_text(svg, {panel.left + panel.width() / 2, panel.bottom() + 40}, name,
             "text-anchor='middle'");
}

void write_y_axis(std::ostream& svg, const Panel& panel, const std::string& name)
{
  for(double tick : ticks(panel.low.y, panel.high.y, panel.height())) {
    const double y = panel.place({0, tick}).y;
    svg << "<path d='M" << panel.left << ' ' << y << "h-5' stroke='#222'/>\n";
    write_text(svg, {panel.left - 8, y + 4}, short_number(tick), "text-anchor='end'");
  }
  svg << "<g transform='translate(" << panel.left - y_axis_width(panel) + 18 << ' '
      << panel.top + panel.height() / 2 << ") rotate(-90)'>\n";
  write_text(svg, {0, 0}, name, "text-anchor='middle'");
  svg << "</g>\n";
}

} // namespace

void check_window(const Panel& panel)
{
  const double most_scale = 1e303; // ticks of a hundred times as much are beyond doubles
  for(double scale : {panel.x_scale, panel.y_scale})
    if(!(scale < most_scale && scale > 1 / most_scale))
      throw Error("--picture: the scene is too wide or too narrow to be drawn");
}

std::string short_number(double value, int digits)
{
  std::ostringstream text;
  text.precision(digits);
  text << value + 0.; // 0 instead of -0
  return text.str();
}

std::string pixels(Position p)
{
  return short_number(std::round(10 * p.x) / 10) + " " + short_number(std::round(10 * p.y) / 10);
}

double text_width(const std::string& text, double font_size)
{
  return 0.62 * font_size * letters(text);
}

void write_text(std::ostream& svg, Position p, const std::string& text, const char* style)
{
  svg << "<text x='" << p.x << "' y='" << p.y << "' " << style << ">" << escaped(text)
      << "</text>\n";
}

void write_dots(std::ostream& svg, const std::set<std::string>& places, const char* color,
                double size)
{
  svg << "<path stroke-linecap='round' stroke='" << color << "' stroke-width='" << size
      << "' d='";
  for(const std::string& place : places)
    svg << 'M' << place << "h0";
  svg << "'/>\n";
}

void write_frame(std::ostream& svg, const Panel& panel, const char* color)
{
  svg << "<rect x='" << panel.left << "' y='" << panel.top << "' width='" << panel.width()
      << "' height='" << panel.height() << "' fill='none' stroke='" << color << "'/>\n";
}

void write_axes(std::ostream& svg, const Panel& panel, const std::string& x_name,
                const std::string& y_name)
{
  write_frame(svg, panel, "#222");
  write_x_axis(svg, panel, x_name);
  write_y_axis(svg, panel, y_name);
}

double y_axis_width(const Panel& panel)
{
  double longest = 0;
  for(double tick : ticks(panel.low.y, panel.high.y, panel.height()))
    longest = std::max(longest, text_width(short_number(tick)));
  return longest + 40;
}

void write_scale_bar(std::ostream& svg, const Panel& panel, double factor,
                     const std::string& unit)
{
  const double length = round_length((panel.high.y - panel.low.y) * factor / 3);
  const double width = length / factor * panel.y_scale;
  const double y = panel.bottom() + 14;
  svg << "<path fill='none' stroke='#222' stroke-width='2' d='M" << panel.left << ' ' << y - 5
      << "v10m0 -5h" << width << "m0 -5v10'/>\n";
  write_text(svg, {panel.left + width + 8, y + 5}, short_number(length) + " " + unit);
}

} // namespace near_pairs
